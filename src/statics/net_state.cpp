// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/net_state.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace taut {

NetState::NetState(const LocalNet& net)
    : m_unstressed_lengths(net.axial_stiffness.size()),
      m_form(net.nodes),
      m_edges(net.edges.size()),
      m_forces(net.loads.size()),
      m_rounding(net.free_count) {}

void NetState::set_unstressed_lengths(const LocalNet& net,
                                      const Eigen::Ref<const Eigen::VectorXd>& lengths) {
    m_unstressed_lengths = lengths;
    // The last digit of a coordinate of one metre, times EA/l_0 of all edges at the node. The
    // factor 4 allows for the rounding of the neighbours: the solver reaches 0.2 to 0.6 of this
    // bound.
    const double last_place = 4.0 * std::numeric_limits<double>::epsilon();
    m_rounding.setZero();
    for (size_t e = 0; e < m_edges.size(); ++e) {
        const auto edge = static_cast<Eigen::Index>(e);
        for (const int node : net.edges[e]) {
            if (node < net.free_count) {
                m_rounding(node) += last_place * net.axial_stiffness(edge) / lengths(edge);
            }
        }
    }
    for (const Spring& spring : net.springs) {
        m_rounding(spring.node) += last_place * spring.stiffness.trace();
    }
}

void NetState::update(const LocalNet& net) {
    m_forces = -net.loads;
    net.add_spring_forces(m_form, m_forces);
    m_taut_cables = {};
    m_all_forces = {};
    for (size_t e = 0; e < m_edges.size(); ++e) {
        const auto [s, t] = net.edges[e];
        const auto edge = static_cast<Eigen::Index>(e);
        m_edges[e] = edge_state(m_form.col(s), m_form.col(t), net.axial_stiffness(edge),
                                m_unstressed_lengths(edge), net.law(e), net.is_strut(e));
        if (!m_edges[e].carries()) {
            continue;
        }
        const double tension = m_edges[e].tension;
        m_all_forces.add(std::abs(tension));
        if (!m_edges[e].is_strut) {
            m_taut_cables.add(tension);
        }
        const Eigen::Vector3d force = tension * m_edges[e].direction;
        if (s < net.free_count) {
            m_forces.segment<3>(Eigen::Index{3} * s) += force;
        }
        if (t < net.free_count) {
            m_forces.segment<3>(Eigen::Index{3} * t) -= force;
        }
    }
}

double NetState::largest_force() const {
    return m_forces.reshaped(3, m_forces.size() / 3).colwise().norm().maxCoeff();
}

std::vector<int> NetState::slack_edges() const {
    std::vector<int> slack;
    for (size_t e = 0; e < m_edges.size(); ++e) {
        if (!m_edges[e].carries()) {
            slack.push_back(static_cast<int>(e));
        }
    }
    return slack;
}

double NetState::mean_tension() const {
    return m_taut_cables.count > 0 ? m_taut_cables.mean() : mean_force();
}

double NetState::mean_force() const {
    return m_all_forces.mean();
}

double NetState::stretch_energy() const {
    return std::transform_reduce(
        m_edges.begin(), m_edges.end(), 0.0, std::plus<>(),
        [](const EdgeState& e) { return 0.5 * std::abs(e.tension * e.extension); });
}

double NetState::imbalance(const LocalNet& net, double relative_tolerance) const {
    const double force = mean_force();
    const double scale =
        force > 0.0 ? force : net.loads.reshaped(3, net.free_count).colwise().norm().mean();
    // The smaller of both: nominal coordinates far off must not loosen the bound, nor must a form
    // that diverges.
    const double coordinate =
        std::min(m_form.cwiseAbs().maxCoeff(), net.nodes.cwiseAbs().maxCoeff());
    double largest = 0.0;
    for (int i = 0; i < net.free_count; ++i) {
        const double at_node = m_forces.segment<3>(Eigen::Index{3} * i).norm() /
                               (relative_tolerance * scale + coordinate * m_rounding(i));
        if (!(at_node <= largest)) {  // also for NaN, which is never balanced
            largest = at_node;
        }
        if (!std::isfinite(largest)) {
            return std::numeric_limits<double>::infinity();
        }
    }
    return largest;
}

double NetState::energy_above(const NetState& other, const LocalNet& net) const {
    double difference = 0.0;
    for (size_t e = 0; e < m_edges.size(); ++e) {
        difference +=
            energy_between(other.m_edges[e], m_edges[e],
                           m_unstressed_lengths(static_cast<Eigen::Index>(e)), net.law(e));
    }
    const Eigen::Index n = net.loads.size();
    difference -= net.loads.dot(m_form.reshaped().head(n) - other.m_form.reshaped().head(n));
    for (const auto& [node, stiffness, place] : net.springs) {
        const Eigen::Vector3d step = m_form.col(node) - other.m_form.col(node);
        const Eigen::Vector3d middle = 0.5 * (m_form.col(node) + other.m_form.col(node)) - place;
        difference += step.dot(stiffness * middle);
    }
    if (!net.spring_pairs.empty()) {
        const Eigen::Matrix3Xd before = net.spring_shifts(other.m_form);
        const Eigen::Matrix3Xd step = net.spring_shifts(m_form) - before;
        const Eigen::Matrix3Xd middle = before + 0.5 * step;
        for (const SpringPair& pair : net.spring_pairs) {
            difference += step.col(pair.first).dot(pair.stiffness * middle.col(pair.second)) +
                          middle.col(pair.first).dot(pair.stiffness * step.col(pair.second));
        }
    }
    return difference;
}

}  // namespace taut
