// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "estimation/linearisation.hpp"

namespace taut {

/// The column of a number as a further unknown: its entries in the matrix and on the right side.
struct Linearisation::ScoreColumn {
    BorderedFactor::Vector entries;  ///< with all unknowns
    Eigen::VectorXd
        force_rates;        ///< of the force measurements, times the roots of their weights (m)
    Points surveyed_rates;  ///< of the surveyed places (3 x n)
    Points pulls;           ///< S times these
    double misfit = 0.0;    ///< on the right side
};

void Linearisation::add_edge_to_score(ScoreColumn& column, int edge, const EdgeVariation& variation,
                                      const Iterate& iterate,
                                      const Observations& observations) const {
    if (m_model->slack[edge]) {
        return;
    }
    const EdgeRates e = m_model->rates(edge, iterate);
    const double weight = observations.tension_weights(edge);
    const double rate = add_to_column(edge, e, variation, 0.0, weight, column.entries.inner);
    column.entries.border += weight * rate * m_measured_rates.row(edge).transpose();
    column.force_rates(edge) += std::sqrt(weight) * rate;
    column.misfit += weight * rate *
                     (observations.tension(edge) - e.tension -
                      observations.tension_bias.row(edge).dot(iterate.common));
}

/// (boundary): g = b - e' x and I = F - E' Z E, the row of the number as a free unknown.
Linearisation::Score Linearisation::score_of(const std::vector<ScoreColumn>& columns) const {
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
        const BorderedFactor::Vector varied = m_matrix->solve(column.entries);
        for (Eigen::Index k = 0; k < count; ++k) {
            result.information(k, i) -= dot(columns[k].entries.inner, varied.inner) +
                                        columns[k].entries.border.dot(varied.border);
        }
    }
    return result;
}

/// The same of numbers that change an edge with one free node and nothing else but the survey: all
/// entries are multipliers of that node, for which the inverse is known, or in the border. Nothing
/// for other edges.
/// @param of_survey the score by the survey of what the numbers move
/// @param in_border its entries there (border x numbers)
std::optional<Linearisation::Score> Linearisation::score_at_one_node(
    int edge, const std::vector<EdgeVariation>& variations, const Score& of_survey,
    const Eigen::MatrixXd& in_border, const Covariance& covariance, const Iterate& iterate,
    const Observations& observations) const {
    const auto [s, t] = m_model->numbering().local.edges[edge];
    const int node = std::min(s, t);
    const int free_count = m_model->numbering().local.free_count;
    if (node >= free_count || std::max(s, t) < free_count || m_model->slack[edge] ||
        observations.tension_weights(edge) > 0.0) {
        return std::nullopt;
    }
    const double sign = s < t ? 1.0 : -1.0;
    const EdgeRates e = m_model->rates(edge, iterate);
    Eigen::Matrix3Xd forces(3, std::ssize(variations));
    for (Eigen::Index k = 0; k < forces.cols(); ++k) {
        forces.col(k) = sign * m_multiplier_unit * e.force_by(variations[k]);
    }
    return Score{
        .gradient = of_survey.gradient - forces.transpose() * m_multipliers.col(node),
        .information = of_survey.information -
                       m_matrix->inverse_at(node, covariance.multipliers[node], forces, in_border)};
}

Linearisation::ScoreColumn Linearisation::empty_score_column() const {
    return {.entries = empty_vector(),
            .force_rates = Eigen::VectorXd::Zero(m_model->net().edge_count()),
            .surveyed_rates = Points::Zero(3, m_model->net().node_count()),
            .pulls = Points::Zero(3, m_model->net().node_count())};
}

Linearisation::Score Linearisation::score_of_edge(int edge, const Covariance& covariance,
                                                  const Iterate& iterate,
                                                  const Observations& observations) const {
    const EdgeVariation longer{.length = 1.0};
    const Score of_survey{.gradient = Eigen::VectorXd::Zero(1),
                          .information = Eigen::MatrixXd::Zero(1, 1)};
    if (auto score = score_at_one_node(edge, {longer}, of_survey,
                                       Eigen::MatrixXd::Zero(m_model->common.count(), 1),
                                       covariance, iterate, observations)) {
        return *std::move(score);
    }
    ScoreColumn column = empty_score_column();
    add_edge_to_score(column, edge, longer, iterate, observations);
    return score_of({std::move(column)});
}

Linearisation::Score Linearisation::score_of_support(int node, const std::vector<int>& edges,
                                                     const Covariance& covariance,
                                                     const Iterate& iterate,
                                                     const Observations& observations) const {
    const auto variation_of = [&](int edge, int k) -> EdgeVariation {
        const double sign = m_model->net().edges()[edge][0] == node ? 1.0 : -1.0;
        return {.motion = sign * Eigen::Vector3d::Unit(k)};
    };
    const Eigen::Matrix3d weight = observations.weight(node);
    const Eigen::Vector3d misfit = observations.form.col(node) - iterate.form.col(node);
    Eigen::MatrixXd in_border(m_model->common.count(), 3);
    for (int i = 0; i < m_model->common.count(); ++i) {
        in_border.row(i) = weight * m_model->common.support_rate(i, node);
    }
    if (edges.size() == 1) {
        const auto along = [&](int k) { return variation_of(edges[0], k); };
        const Score of_survey{.gradient = weight * misfit, .information = weight};
        if (auto score = score_at_one_node(edges[0], {along(0), along(1), along(2)}, of_survey,
                                           in_border, covariance, iterate, observations)) {
            return *std::move(score);
        }
    }
    std::vector<ScoreColumn> columns;
    for (int k = 0; k < 3; ++k) {
        ScoreColumn& column = columns.emplace_back(empty_score_column());
        for (const int edge : edges) {
            add_edge_to_score(column, edge, variation_of(edge, k), iterate, observations);
        }
        column.surveyed_rates(k, node) = 1.0;
        column.pulls.col(node) = weight.col(k);
        column.misfit += weight.col(k).dot(misfit);
        column.entries.border += in_border.col(k);
    }
    return score_of(columns);
}

Linearisation::Score Linearisation::score_of_survey(const std::vector<Points>& rates,
                                                    const Iterate& iterate,
                                                    const Observations& observations) const {
    const Points misfit = observations.form - iterate.form;
    std::vector<ScoreColumn> columns;
    for (const Points& rate : rates) {
        ScoreColumn& column = columns.emplace_back(empty_score_column());
        column.surveyed_rates = rate;
        column.pulls = observations.weighted(rate);
        column.misfit = column.pulls.cwiseProduct(misfit).sum();
        column.entries.inner.places =
            m_length_unit * column.pulls(Eigen::all, m_model->numbering().nodes);
        for (int k = 0; !m_model->are_supports_uncertain() && k < m_model->common.count(); ++k) {
            for (const int node : m_model->net().supports()) {
                column.entries.border(k) +=
                    m_model->common.support_rate(k, node).dot(column.pulls.col(node));
            }
        }
    }
    return score_of(columns);
}

Linearisation::Score Linearisation::score_of_loads(const Points& loads) const {
    ScoreColumn column = empty_score_column();
    column.entries.inner.multipliers =
        -m_multiplier_unit * loads(Eigen::all, m_model->numbering().free_nodes);
    return score_of({std::move(column)});
}

}  // namespace taut
