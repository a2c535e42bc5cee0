// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "support/uncertain.hpp"
#include "taut/identification/result.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"
#include "taut/survey/survey.hpp"

namespace taut::test {

/// Lengths drawn from a prior, their form, and a survey of it with normal noise.
struct SimulatedSurvey {
    Eigen::VectorXd deviations;  ///< m_I, the truth [m]
    Equilibrium truth;
    Survey survey;
};

/// Adds independent errors to the places of some nodes.
inline void add_noise(Points& form, const std::vector<int>& nodes, double std_dev,
                      std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    for (const int node : nodes) {
        for (double& coordinate : form.col(node)) {
            coordinate += std_dev * normal(random);
        }
    }
}

/// @param alter what is otherwise than the prior has it, of the length deviations (m_I)
inline SimulatedSurvey simulate(
    const CableNet& net, const LengthPrior& prior, double noise_std, std::uint64_t seed,
    const std::function<void(Eigen::VectorXd&)>& alter = [](Eigen::VectorXd&) {}) {
    SimulatedSurvey s;
    s.deviations = draw_length_deviations(prior, 11, seed, net.interior_edge_count());
    alter(s.deviations);
    s.truth = EquilibriumSolver(net).solve(with_length_deviations(net, s.deviations), net.nodes());
    s.survey = {.form = s.truth.form,
                .noise_std = Points::Constant(3, net.node_count(), noise_std),
                .surveyed = net.free_nodes(),
                .missing = {}};
    add_noise(s.survey.form, net.free_nodes(), noise_std, seed);
    return s;
}

/// Another survey of the same net as built.
/// @param seed another one than that of the first
inline Survey surveyed_again(const CableNet& net, const SimulatedSurvey& first, double noise_std,
                             std::uint64_t seed) {
    Survey again = first.survey;
    again.form = first.truth.form;
    add_noise(again.form, net.free_nodes(), noise_std, seed);
    return again;
}

/// T of all edges of the net as built [N].
inline Eigen::VectorXd true_tensions(const CableNet& net, const SimulatedSurvey& s) {
    return tensions_of(net, with_length_deviations(net, s.deviations), s.truth.form);
}

/// A third of the supports give way by a millimetre or two under the net.
inline CableNet on_springs(const CableNet& net) {
    CableNetData data = net.data();
    data.supports.clear();
    for (size_t i = 0; i < net.supports().size(); ++i) {
        const int node = net.supports()[i];
        if (i % 3 != 0) {
            data.supports.push_back(node);
            continue;
        }
        const Eigen::Vector3d along = Eigen::Vector3d(1.0, 0.5, 0.2).normalized();
        data.elastic_supports.push_back(
            {.node = node,
             .stiffness = 1e6 * (Eigen::Matrix3d::Identity() + 2.0 * along * along.transpose()),
             .place = data.nodes.col(node)});
    }
    return with_supports_in_balance(CableNet(std::move(data)));
}

/// A net with as much tension at so many times the axial stiffness.
inline CableNet stiffened(const CableNet& soft, double factor) {
    CableNetData data = soft.data();
    const Eigen::ArrayXd lengths = edge_lengths(soft, soft.nodes()).array();
    const Eigen::ArrayXd strains = lengths / data.unstressed_lengths.array() - 1.0;
    data.unstressed_lengths = lengths / (1.0 + strains / factor);
    data.axial_stiffness *= factor;
    return CableNet(data);
}

/// Whether a value is in an interval, of a length or of something drawn.
inline bool holds(const auto& interval, double value) {
    return interval.lower <= value && value <= interval.upper;
}

/// Part of the lengths whose intervals hold the truth (m_I).
inline double coverage(const Identification& result, const Eigen::VectorXd& truth) {
    double inside = 0.0;
    for (size_t i = 0; i < result.edges.size(); ++i) {
        inside += holds(result.edges[i], truth(static_cast<Eigen::Index>(i))) ? 1.0 : 0.0;
    }
    return inside / static_cast<double>(result.edges.size());
}

/// Number of the drawn tensions whose intervals hold the truth (m).
inline int tensions_held(const Identification& result, const Eigen::VectorXd& truth) {
    return static_cast<int>(std::ranges::count_if(
        result.drawn.tensions,
        [&](const DrawnTension& one) { return holds(one.tension, truth(one.edge)); }));
}

/// The first finding of a kind; one without words where there is none.
inline Trust::Finding finding_of(const Trust& trust, Trust::Finding::Kind kind) {
    const auto found = std::ranges::find(trust.findings, kind, &Trust::Finding::kind);
    return found == trust.findings.end() ? Trust::Finding{} : *found;
}

/// @param ids that it names; empty: any
inline bool finds(const Identification& result, Trust::Finding::Kind kind,
                  const std::vector<std::string>& ids = {}) {
    return std::ranges::any_of(result.trust.findings, [&](const Trust::Finding& finding) {
        return finding.kind == kind && (ids.empty() || finding.ids == ids);
    });
}

/// A number of each of a result's edges.
template <class Edge>
Eigen::VectorXd of_edges(const std::vector<Edge>& edges, double Edge::* number) {
    Eigen::VectorXd values(std::ssize(edges));
    std::ranges::transform(edges, values.begin(), [&](const Edge& edge) { return edge.*number; });
    return values;
}

/// The estimated deviations of the interior lengths (m_I) [m].
inline Eigen::VectorXd estimates(const Identification& result) {
    return of_edges(result.edges, &IdentifiedEdge::length_deviation);
}

/// Mean squared error of the lengths against the truth (m_I) [m2].
inline double squared_error(const Identification& result, const Eigen::VectorXd& truth) {
    return (estimates(result) - truth).cwiseAbs2().mean();
}

/// Takes a target out of a survey.
inline void hide(const CableNet& net, Survey& survey, int node) {
    std::erase(survey.surveyed, node);
    survey.missing.insert(std::ranges::upper_bound(survey.missing, node), node);
    survey.form.col(node) = net.nodes().col(node);
}

/// A survey that is yet to be made, of all free nodes but some.
inline Survey planned_survey(const CableNet& net, double noise_std,
                             const std::set<int>& hidden = {}) {
    Survey survey{.form = net.nodes(),
                  .noise_std = Points::Constant(3, net.node_count(), noise_std)};
    for (const int node : net.free_nodes()) {
        (hidden.contains(node) ? survey.missing : survey.surveyed).push_back(node);
    }
    return survey;
}

}  // namespace taut::test
