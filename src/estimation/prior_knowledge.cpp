// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/prior_knowledge.hpp"

#include <algorithm>
#include <cmath>

#include "net/sliding_nodes.hpp"
#include "net/support_stiffness.hpp"
#include "sampling/uncertain_widths.hpp"
#include "statics/sliding.hpp"
#include "taut/numerical_error.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using StretchTension = PriorKnowledge::StretchTension;

/// (slips): tensions of the edges of a stretch differ from that of the stretch by friction alone.
void observe_stretches(const PriorKnowledge& knowledge, int first, Observations& result) {
    int place = first;
    for (const StretchTension& stretch : knowledge.stretches) {
        for (size_t i = 0; i < stretch.edges.size(); ++i) {
            const int edge = stretch.edges[i];
            result.tension(edge) = stretch.shares[i] * stretch.mean;
            result.tension_weights(edge) = std::pow(stretch.scatter * result.tension(edge), -2);
            result.tension_bias(edge, place) = -stretch.shares[i] * stretch.unit();
        }
        ++place;
    }
}

}  // namespace

void observe_force(const ForceMeasurement& force, const std::vector<UncertainParameter>& uncertain,
                   Observations& result) {
    using Kind = UncertainParameter::Kind;
    result.tension(force.edge) = force.tension;
    result.tension_weights(force.edge) = 1.0 / (force.std_dev * force.std_dev);
    const Kind kind = force.is_by_mass() ? Kind::mass : Kind::forces;
    int k = 0;
    for (const UncertainParameter& parameter : uncertain) {
        if (parameter.kind == kind) {
            // A cable that is heavier than given carries more than its frequency shows.
            result.tension_bias(force.edge, k) =
                std::copysign(std::hypot(parameter.std_dev * force.tension, force.shared_std),
                              kind == Kind::mass ? -force.tension : force.tension);
            return;
        }
        k += is_common(parameter) ? 1 : 0;
    }
    result.tension_weights(force.edge) =
        1.0 / (force.std_dev * force.std_dev + force.shared_std * force.shared_std);
}

PriorKnowledge::PriorKnowledge(const CableNet& net, const LengthPrior& prior)
    : priors(net.interior_edge_count(), prior) {
    if (net.sliding_nodes().empty()) {
        return;
    }
    constexpr double least = 0.1;     // of the mean tension of the net
    constexpr double rubbing = 1e-3;  // of the tension, without friction
    const Equilibrium nominal = solve_equilibrium(net);
    if (!nominal.balanced()) {
        throw NumericalError("the net as designed has no equilibrium in which its runs can slide");
    }
    const Eigen::VectorXd tension = tensions_of(net, nominal.unstressed_lengths, nominal.form);
    for (const std::vector<int>& edges : sliding_stretches(net)) {
        StretchTension stretch{.edges = edges, .shares = {1.0}};
        double sum = 0.0;
        double squares = 0.0;
        double mean = tension(edges[0]) / static_cast<double>(edges.size());
        for (const SlidingNode& at : net.sliding_nodes()) {
            if (at.before != edges[stretch.shares.size() - 1]) {
                continue;
            }
            const double holds = at.most_friction * contact_angle(net.edges(), nominal.form, at);
            sum += holds;
            squares += holds * holds;
            stretch.friction = at.most_friction;
            stretch.shares.push_back(stretch.shares.back() * at.ratio);
            mean += tension(at.after) / stretch.shares.back() / static_cast<double>(edges.size());
        }
        stretch.mean = std::max(mean, least * nominal.mean_tension);
        const double by_friction = std::sqrt(std::max(squares / 3.0, sum * sum / 12.0));
        stretch.scatter = std::hypot(rubbing, by_friction);
        stretches.push_back(std::move(stretch));
    }
}

bool PriorKnowledge::take_up_tensions(const CommonParameters& parameters,
                                      const Eigen::VectorXd& common) {
    constexpr double alike = 0.2;
    constexpr double smallest = 0.1;
    bool differs = false;
    int place = parameters.first_of_stretches();
    if (!(parameters.slip_std() > 0.0)) {
        return false;
    }
    for (StretchTension& stretch : stretches) {
        const double found =
            std::max(smallest * stretch.mean, stretch.mean + stretch.unit() * common(place++));
        differs = differs || std::abs(found - stretch.mean) > alike * stretch.mean;
        stretch.mean = found;
    }
    return differs;
}

double PriorKnowledge::length_std() const {
    double sum = 0.0;
    for (const LengthPrior& prior : priors) {
        sum += prior.std_dev() * prior.std_dev();
    }
    return std::sqrt(sum / static_cast<double>(priors.size()));
}

std::vector<bool> PriorKnowledge::as_seen(std::vector<bool> slack,
                                          const std::vector<bool>& rejected_forces) const {
    constexpr double surely_taut = 4.0;  // standard deviations
    for (size_t k = 0; k < forces.measurements.size(); ++k) {
        const ForceMeasurement& force = forces.measurements[k];
        const bool is_rejected = !rejected_forces.empty() && rejected_forces[k];
        if (!is_rejected && force.tension > surely_taut * force.std_dev) {
            slack[force.edge] = false;
        }
    }
    for (const int edge : forces.taut) {
        slack[edge] = false;
    }
    for (const int edge : forces.slack) {
        slack[edge] = true;
    }
    return slack;
}

std::vector<LengthPrior> interior_priors(const CableNet& net, const PriorKnowledge& knowledge) {
    if (knowledge.priors.size() == net.interior_edges().size()) {
        return knowledge.priors;
    }
    std::vector<LengthPrior> priors;
    priors.reserve(net.interior_edges().size());
    for (const int edge : net.interior_edges()) {
        priors.push_back(knowledge.priors[edge]);
    }
    return priors;
}

Survey with_supports(const CableNet& net, const Survey& survey) {
    Survey result = survey;
    if (survey.supports.empty()) {
        return result;
    }
    if (result.noise_std.cols() == 0) {
        result.noise_std = Points::Zero(3, net.node_count());
    }
    for (const SurveyedSupport& support : survey.supports) {
        result.surveyed.push_back(support.node);
        result.form.col(support.node) = support.position;
        result.noise_std.col(support.node) = support.noise_std;
        result.set_correlations(support.node, support.noise_correlations);
    }
    std::ranges::sort(result.surveyed);
    return result;
}

Observations observe(const CableNet& net, const Survey& survey, const Points& noise,
                     const std::vector<bool>& rejected, const PriorKnowledge& knowledge,
                     int common_parameters) {
    Observations result = observe(net, survey, noise, rejected, 1.0, common_parameters);
    for (Eigen::Index i = 0; i < result.variance.size(); ++i) {
        const double std_dev = knowledge.priors[i].std_dev();
        result.variance(i) = std_dev * std_dev;
    }
    if (const double std_dev = std_of(knowledge.uncertain, UncertainParameter::Kind::supports);
        std_dev > 0.0) {
        for (const int node : net.supports()) {
            result.support_weights.col(node).setConstant(1.0 / (std_dev * std_dev));
        }
        const std::vector<int> coupled = coupled_supports(net);
        for (const ElasticSupport& support : net.elastic_supports()) {
            if (std::ranges::find(coupled, support.node) != coupled.end()) {
                continue;  // of CommonParameters
            }
            const Eigen::Matrix3d V = std_dev * std_dev * support.stiffness * support.stiffness;
            result.load_variance.col(support.node) += V.diagonal();
            if (!V.isDiagonal(0.0)) {
                result.cross_load_variance.conservativeResizeLike(
                    Points::Zero(3, net.node_count()));
                result.cross_load_variance.col(support.node) << V(0, 1), V(0, 2), V(1, 2);
            }
        }
    }
    if (const double std_dev = std_of(knowledge.uncertain, UncertainParameter::Kind::loads_each);
        std_dev > 0.0) {
        for (const int node : net.free_nodes()) {
            result.load_variance.col(node).array() += std_dev * std_dev;
        }
    }
    result.set_evidence(knowledge.evidence);
    for (const ForceMeasurement& force : knowledge.forces.measurements) {
        observe_force(force, knowledge.uncertain, result);
    }
    if (std_of(knowledge.uncertain, UncertainParameter::Kind::slip) > 0.0) {
        const auto given = std::ranges::count_if(knowledge.uncertain, is_common);
        observe_stretches(knowledge,
                          static_cast<int>(given) + static_cast<int>(net.sliding_nodes().size()),
                          result);
    }
    return result;
}

}  // namespace taut
