// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/linearised_statics.hpp"

#include <algorithm>
#include <cmath>

#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// Part of a node's axial stiffness that keeps a loose node in its place.
constexpr double smallest_relative_stiffness = 1e-10;

std::vector<bool> interior_flags(const CableNet& net) {
    std::vector<bool> flags(net.edge_count(), false);
    for (const int edge : net.interior_edges()) {
        flags[edge] = true;
    }
    return flags;
}

/// The stretch that an edge's tension stands for, and its derivative by the extension.
struct Stretch {
    double value;
    double rate;
};

/// (rounded-law); without a width the extension itself. As quotients, so that no digits are lost
/// where the edge is far from taut.
Stretch stretch(double extension, double width) {
    if (!(width > 0.0)) {
        return {.value = extension, .rate = 1.0};
    }
    const double root = std::hypot(extension, 2.0 * width);
    const double value =
        extension > 0.0 ? 0.5 * (root + extension) : 2.0 * width * width / (root - extension);
    return {.value = value, .rate = value / root};
}

}  // namespace

bool LawBlur::agrees_with(const LawBlur& other) const {
    constexpr double settled = 0.1;
    return ((strain_stds - other.strain_stds).array().abs() <= settled * other.strain_stds.array())
        .all();
}

LawBlur blur_by(const CableNet& net, double extension_std) {
    if (net.is_linear()) {
        return {};
    }
    return {.strain_stds = extension_std * net.unstressed_lengths().cwiseInverse(),
            .missed = Eigen::VectorXd::Zero(net.interior_edge_count())};
}

LinearisedStatics::LinearisedStatics(const CableNet& net)
    : m_net(net),
      m_local(number_for_elimination(net)),
      m_local_of(net.node_count()),
      m_interior_of(net.edge_count(), -1),
      m_free_nodes(m_local.node_of.begin(), m_local.node_of.begin() + m_local.free_count),
      m_slack(net.edge_count(), false),
      m_matrix(m_local, interior_flags(net)) {
    for (size_t i = 0; i < m_local.node_of.size(); ++i) {
        m_local_of[m_local.node_of[i]] = static_cast<int>(i);
    }
    for (size_t i = 0; i < net.interior_edges().size(); ++i) {
        m_interior_of[net.interior_edges()[i]] = static_cast<int>(i);
    }
}

/// docs/theory.md, (edge rates)
LinearisedStatics::EdgeRates LinearisedStatics::rates(int edge, const Iterate& iterate) const {
    const auto [s, t] = m_net.edges()[edge];
    const int i = m_interior_of[edge];
    const double unstressed =
        m_net.unstressed_lengths()(edge) + (i >= 0 ? iterate.deviations(i) : 0.0);
    const Eigen::Vector3d vector = iterate.form.col(s) - iterate.form.col(t);
    const double length = vector.norm();
    const Eigen::Vector3d u = vector / length;
    const Stretch e = stretch(length - unstressed, m_corner_width);
    double axial = m_net.axial_stiffness()(edge) / unstressed;
    double across = axial * e.value / length;  // T / l
    if (const TensionLaw* law = m_net.tension_law(edge); law != nullptr) {
        const double strain_std = m_blur.strain_stds.size() > 0 ? m_blur.strain_stds(edge) : 0.0;
        const auto [tension, slope] = law->blurred(e.value / unstressed, strain_std);
        axial = slope / unstressed;
        across = tension / length;
    }
    return {.force = across * vector,
            .stiffness = (axial * e.rate - across) * u * u.transpose() +
                         across * Eigen::Matrix3d::Identity(),
            .length_rate = -axial * (e.value / unstressed + e.rate) * u};
}

/// Of an edge's length by the covariance of its ends, taken as independent: one is a support where
/// the edge is at the frame.
double LinearisedStatics::length_variance(int edge, const Iterate& iterate) const {
    const auto [s, t] = m_net.edges()[edge];
    const Eigen::Vector3d u = (iterate.form.col(s) - iterate.form.col(t)).normalized();
    double variance = 0.0;
    for (const int node : {s, t}) {
        if (m_net.free_index(node) >= 0) {
            variance += u.dot(form_covariance(node) * u);
        }
    }
    return variance;
}

LawBlur LinearisedStatics::blur_found(const Iterate& iterate) const {
    constexpr double slowest = 0.5;        // smaller by no more at a time
    constexpr double most_variance = 1e2;  // of the prior, where the law is flat
    const double squared_unit = m_length_unit * m_length_unit;
    const Eigen::VectorXd lengths = edge_lengths(m_net, iterate.form);
    LawBlur found = m_blur;
    for (int e = 0; e < m_net.edge_count(); ++e) {
        const TensionLaw* law = m_net.tension_law(e);
        if (law == nullptr || m_slack[e]) {
            continue;
        }
        const int i = m_interior_of[e];
        const double unstressed =
            m_net.unstressed_lengths()(e) + (i >= 0 ? iterate.deviations(i) : 0.0);
        const double variance =
            i >= 0 ? squared_unit * m_covariance.extensions(e) : length_variance(e, iterate);
        const double std = std::max(std::sqrt(std::max(0.0, variance)) / unstressed,
                                    slowest * m_blur.strain_stds(e));
        found.strain_stds(e) = std;
        if (i >= 0) {
            const double strain = lengths(e) / unstressed - 1.0;
            const double slope = std::max(law->blurred(strain, std).slope, 1e-6 * law->steepest());
            found.missed(i) =
                std::min(law->missed_by_blurred(strain, std) * std::pow(unstressed / slope, 2),
                         most_variance * squared_unit);
        }
    }
    return found;
}

void LinearisedStatics::set_weights(const Observations& observations) {
    // By the mean precision: a wide prior, which tells next to nothing, sets no scale.
    m_length_unit = 1.0 / std::sqrt(observations.variance.cwiseInverse().mean());
    m_multiplier_unit =
        1.0 /
        (m_length_unit * m_net.axial_stiffness().cwiseQuotient(m_net.unstressed_lengths()).mean());
    const double squared_unit = m_length_unit * m_length_unit;
    m_matrix.place_weights = squared_unit * observations.weights(Eigen::all, m_free_nodes);
    m_matrix.length_weights(m_net.interior_edges()) =
        squared_unit * prior_variances(observations).cwiseInverse();
}

void LinearisedStatics::add_edge(int edge, const Iterate& iterate) {
    const auto [s, t] = m_local.edges[edge];
    const EdgeRates e = rates(edge, iterate);
    const double unit = m_length_unit * m_multiplier_unit;
    m_matrix.edge_stiffness[edge] = unit * e.stiffness;
    m_matrix.length_rates.col(edge) = unit * e.length_rate;
    for (const int node : {s, t}) {
        if (node < m_local.free_count) {
            m_matrix.node_stiffness[node] +=
                unit * (e.stiffness + smallest_relative_stiffness * e.stiffness.trace() *
                                          Eigen::Matrix3d::Identity());
        }
    }
}

bool LinearisedStatics::linearise(const Iterate& iterate, const Observations& observations) {
    set_weights(observations);
    std::ranges::fill(m_matrix.edge_stiffness, Eigen::Matrix3d::Zero());
    std::ranges::fill(m_matrix.node_stiffness, Eigen::Matrix3d::Zero());
    m_matrix.length_rates.setZero();
    for (int e = 0; e < m_net.edge_count(); ++e) {
        if (!m_slack[e]) {
            add_edge(e, iterate);
        }
    }
    m_place_reactions.setZero(3, m_local.free_count);
    m_length_reactions.setZero(m_net.edge_count());
    if (!m_matrix.factorize()) {
        return false;
    }
    set_reactions(m_matrix.solve(right_side(iterate, observations)).multipliers);
    return true;
}

void LinearisedStatics::set_reactions(const Eigen::Matrix3Xd& multipliers) {
    for (int node = 0; node < m_local.free_count; ++node) {
        m_place_reactions.col(node) = m_matrix.node_stiffness[node] * multipliers.col(node);
    }
    for (int e = 0; e < m_net.edge_count(); ++e) {
        const auto [s, t] = m_local.edges[e];
        const Eigen::Matrix3d& stiffness = m_matrix.edge_stiffness[e];
        const bool both_are_free = std::max(s, t) < m_local.free_count;
        if (both_are_free) {
            m_place_reactions.col(s) -= stiffness * multipliers.col(t);
            m_place_reactions.col(t) -= stiffness * multipliers.col(s);
        }
        m_length_reactions(e) = 0.0;
        if (s < m_local.free_count) {
            m_length_reactions(e) += m_matrix.length_rates.col(e).dot(multipliers.col(s));
        }
        if (t < m_local.free_count) {
            m_length_reactions(e) -= m_matrix.length_rates.col(e).dot(multipliers.col(t));
        }
    }
}

SaddlePointFactor::Vector LinearisedStatics::right_side(const Iterate& iterate,
                                                        const Observations& observations) const {
    Points forces = -m_net.loads();
    for (int e = 0; e < m_net.edge_count(); ++e) {
        if (!m_slack[e]) {
            const auto [s, t] = m_net.edges()[e];
            const Eigen::Vector3d force = rates(e, iterate).force;
            forces.col(s) += force;
            forces.col(t) -= force;
        }
    }
    const Points misfit = observations.weights.cwiseProduct(observations.form - iterate.form);
    SaddlePointFactor::Vector result{
        .places = m_length_unit * misfit(Eigen::all, m_free_nodes) - m_place_reactions,
        .lengths = -m_length_reactions,
        .multipliers = -m_multiplier_unit * forces(Eigen::all, m_free_nodes)};
    result.lengths(m_net.interior_edges()) +=
        m_length_unit *
        (observations.mean - iterate.deviations).cwiseQuotient(prior_variances(observations));
    return result;
}

Iterate LinearisedStatics::step(const Iterate& iterate, const Observations& observations) const {
    const SaddlePointFactor::Vector solution = m_matrix.solve(right_side(iterate, observations));
    Iterate change{.form = Points::Zero(3, m_net.node_count()),
                   .deviations = m_length_unit * solution.lengths(m_net.interior_edges())};
    change.form(Eigen::all, m_free_nodes) = m_length_unit * solution.places;
    return change;
}

Eigen::VectorXd LinearisedStatics::length_variances() const {
    return m_length_unit * m_length_unit * m_covariance.lengths(m_net.interior_edges());
}

Eigen::VectorXd LinearisedStatics::extension_variances() const {
    return m_length_unit * m_length_unit * m_covariance.extensions(m_net.interior_edges());
}

Eigen::Matrix3d LinearisedStatics::form_covariance(int node) const {
    return m_length_unit * m_length_unit * m_covariance.places[m_local_of[node]];
}

}  // namespace taut
