// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "estimation/linearised_statics.hpp"

namespace taut {

/// The column of a number as a further unknown: its entries in the matrix and on the right side.
struct LinearisedStatics::ScoreColumn {
    BorderedFactor::Vector entries;  ///< with all unknowns
    Eigen::VectorXd
        force_rates;        ///< of the force measurements, times the roots of their weights (m)
    Points surveyed_rates;  ///< of the surveyed places (3 x n)
    Points pulls;           ///< S times these
    double misfit = 0.0;    ///< on the right side
};

BorderedFactor::Vector LinearisedStatics::empty_vector() const {
    return {.inner = {.places = Eigen::Matrix3Xd::Zero(3, std::ssize(m_nodes)),
                      .lengths = Eigen::VectorXd::Zero(m_net.edge_count()),
                      .multipliers = Eigen::Matrix3Xd::Zero(3, m_local.free_count)},
            .border = Eigen::VectorXd::Zero(m_common.count())};
}

void LinearisedStatics::add_edge_to_score(ScoreColumn& column, int edge,
                                          const EdgeVariation& variation, const Iterate& iterate,
                                          const Observations& observations) const {
    if (m_slack[edge]) {
        return;
    }
    const EdgeRates e = rates(edge, iterate);
    const double weight = observations.tension_weights(edge);
    const double rate = add_to_column(edge, e, variation, weight, column.entries.inner);
    column.entries.border += weight * rate * m_tension_rates.row(edge).transpose();
    column.force_rates(edge) += std::sqrt(weight) * rate;
    column.misfit += weight * rate * (observations.tension(edge) - e.tension);
}

/// (boundary): g = b - e' x and I = F - E' Z E, the row of the number as a free unknown.
LinearisedStatics::Score LinearisedStatics::score_of(
    const std::vector<ScoreColumn>& columns) const {
    const auto count = std::ssize(columns);
    Score result{.gradient = Eigen::VectorXd::Zero(count),
                 .information = Eigen::MatrixXd::Zero(count, count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const ScoreColumn& column = columns[i];
        const BorderedFactor::Inner& entries = column.entries.inner;
        result.gradient(i) = column.misfit - entries.multipliers.cwiseProduct(m_multipliers).sum();
        for (Eigen::Index k = 0; k < count; ++k) {
            result.information(i, k) = column.force_rates.dot(columns[k].force_rates) +
                                       column.surveyed_rates.cwiseProduct(columns[k].pulls).sum();
        }
    }
    for (Eigen::Index i = 0; i < count; ++i) {
        const ScoreColumn& column = columns[i];
        const BorderedFactor::Vector varied = m_matrix.solve(column.entries);
        for (Eigen::Index k = 0; k < count; ++k) {
            result.information(k, i) -= dot(columns[k].entries.inner, varied.inner) +
                                        columns[k].entries.border.dot(varied.border);
        }
    }
    return result;
}

/// The same where all entries are multipliers of one node, for which the inverse is known.
/// @param forces of the columns at the node
LinearisedStatics::Score LinearisedStatics::score_at(int local,
                                                     const Eigen::Matrix3Xd& forces) const {
    return {.gradient = -forces.transpose() * m_multipliers.col(local),
            .information = -forces.transpose() * m_covariance.multipliers[local] * forces};
}

LinearisedStatics::ScoreColumn LinearisedStatics::empty_score_column() const {
    return {.entries = empty_vector(),
            .force_rates = Eigen::VectorXd::Zero(m_net.edge_count()),
            .surveyed_rates = Points::Zero(3, m_net.node_count()),
            .pulls = Points::Zero(3, m_net.node_count())};
}

LinearisedStatics::Score LinearisedStatics::score_of_edge(int edge, const Iterate& iterate,
                                                          const Observations& observations) const {
    const auto [s, t] = m_local.edges[edge];
    if (m_slack[edge]) {
        return {.gradient = Eigen::VectorXd::Zero(1), .information = Eigen::MatrixXd::Zero(1, 1)};
    }
    const EdgeVariation longer{.length = 1.0};
    const bool has_one_free_node = std::max(s, t) >= m_local.free_count;
    if (has_one_free_node && !(observations.tension_weights(edge) > 0.0)) {
        const double sign = s < t ? 1.0 : -1.0;
        return score_at(std::min(s, t), sign * force_of(rates(edge, iterate), longer));
    }
    ScoreColumn column = empty_score_column();
    add_edge_to_score(column, edge, longer, iterate, observations);
    return score_of({std::move(column)});
}

LinearisedStatics::Score LinearisedStatics::score_of_support(
    int node, const std::vector<int>& edges, const Iterate& iterate,
    const Observations& observations) const {
    const auto variation_of = [&](int edge, int k) -> EdgeVariation {
        const double sign = m_net.edges()[edge][0] == node ? 1.0 : -1.0;
        return {.motion = sign * Eigen::Vector3d::Unit(k)};
    };
    const Eigen::Matrix3d weight = observations.weight(node);
    const auto is_measured = [&](int edge) { return observations.tension_weights(edge) > 0.0; };
    if (edges.size() == 1 && weight.isZero() && !is_measured(edges[0]) && !m_slack[edges[0]]) {
        const auto [s, t] = m_local.edges[edges[0]];
        if (std::min(s, t) < m_local.free_count) {
            const EdgeRates of_edge = rates(edges[0], iterate);
            Eigen::Matrix3d forces;
            for (int k = 0; k < 3; ++k) {
                forces.col(k) = (s < t ? 1.0 : -1.0) * force_of(of_edge, variation_of(edges[0], k));
            }
            return score_at(std::min(s, t), forces);
        }
    }
    const Eigen::Vector3d misfit = observations.form.col(node) - iterate.form.col(node);
    std::vector<ScoreColumn> columns;
    for (int k = 0; k < 3; ++k) {
        ScoreColumn& column = columns.emplace_back(empty_score_column());
        for (const int edge : edges) {
            add_edge_to_score(column, edge, variation_of(edge, k), iterate, observations);
        }
        column.surveyed_rates(k, node) = 1.0;
        column.pulls.col(node) = weight.col(k);
        column.misfit += weight.col(k).dot(misfit);
        for (int i = 0; i < m_common.count(); ++i) {
            column.entries.border(i) += weight.col(k).dot(m_common.support_rate(i, node));
        }
    }
    return score_of(columns);
}

LinearisedStatics::Score LinearisedStatics::score_of_survey(
    const std::vector<Points>& rates, const Iterate& iterate,
    const Observations& observations) const {
    const Points misfit = observations.form - iterate.form;
    std::vector<ScoreColumn> columns;
    for (const Points& rate : rates) {
        ScoreColumn& column = columns.emplace_back(empty_score_column());
        column.surveyed_rates = rate;
        column.pulls = observations.weighted(rate);
        column.misfit = column.pulls.cwiseProduct(misfit).sum();
        column.entries.inner.places = m_length_unit * column.pulls(Eigen::all, m_nodes);
        for (int k = 0; !are_supports_uncertain() && k < m_common.count(); ++k) {
            for (const int node : m_net.supports()) {
                column.entries.border(k) +=
                    m_common.support_rate(k, node).dot(column.pulls.col(node));
            }
        }
    }
    return score_of(columns);
}

}  // namespace taut
