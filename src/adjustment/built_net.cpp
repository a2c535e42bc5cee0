// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/adjustment/built_net.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "adjustment/built_net_parts.hpp"
#include "identification/parameter_spread.hpp"
#include "net/sliding_nodes.hpp"
#include "statics/sliding.hpp"
#include "taut/sampling/model_perturbation.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
BuiltNet net_as_identified(const CableNet& net, std::span<const IdentifiedEdge> edges,
                           std::span<const ParameterEstimate> uncertain,
                           std::span<const BoundaryOutlier> boundary_outliers) {
    Eigen::VectorXd lengths = net.unstressed_lengths();
    for (const IdentifiedEdge& edge : edges) {
        lengths(edge.edge) += edge.length_deviation;
    }
    ModelPerturbation perturbation = perturbation_of(net, {uncertain.begin(), uncertain.end()});
    for (const BoundaryOutlier& outlier : boundary_outliers) {
        if (outlier.kind == BoundaryOutlier::Kind::support) {
            perturbation.supports.col(outlier.index) += outlier.deviation;
        } else {
            lengths(outlier.index) += outlier.deviation.x();
        }
    }
    const CableNet identified = net_under(net, perturbation, lengths);
    const Equilibrium equilibrium = solve_equilibrium(clamped(identified));
    if (!equilibrium.balanced()) {
        throw std::invalid_argument("with the estimated lengths the net finds no equilibrium");
    }
    CableNetData data = identified.data();
    data.unstressed_lengths = equilibrium.unstressed_lengths;
    data.nodes = equilibrium.form;
    data.runs =
        runs_from_here(identified, equilibrium.form,
                       tensions_of(identified, equilibrium.unstressed_lengths, equilibrium.form));
    BuiltNet built{.net = CableNet(std::move(data))};
    built.shown_lengths = built.net.unstressed_lengths();
    built.shown_lengths(net.adjustable_edges()) = lengths(net.adjustable_edges());
    return built;
}

namespace {

/// Whether the samples hold all uncertain parameters: those of older versions hold lengths alone.
bool holds_all(const PosteriorDraws& draws, std::span<const ParameterEstimate> uncertain) {
    return std::ranges::all_of(uncertain, [&](const ParameterEstimate& one) {
        const UncertainParameter::Kind kind = one.parameter.kind;
        return kind == UncertainParameter::Kind::slip ||  // part of the lengths
               (kind == UncertainParameter::Kind::adjustable
                    ? draws.adjustable_deviations.size() > 0
                    : !draws.perturbations.empty());
    });
}

/// How sample d differs from the net as identified. Perturbations of samples are relative to the
/// net as it was turned.
ModelPerturbation perturbation_of(const CableNet& identified, const CableNet& turned,
                                  const ModelPerturbations& draws, Eigen::Index d) {
    ModelPerturbation result = unperturbed(identified);
    const auto& nodes = turned.supports();
    result.stiffness =
        (turned.data().axial_stiffness.array() / identified.data().axial_stiffness.array())
            .log()
            .matrix();
    result.supports(Eigen::all, nodes) = (turned.nodes() - identified.nodes())(Eigen::all, nodes);
    result.own_loads = turned.loads() - identified.loads();
    if (const double identified_sag = identified.data().sag_weight.sum(); identified_sag > 0.0) {
        result.sag =
            turned.data().sag_weight.sum() / identified_sag - 1.0;  // one factor, of the mass
    }
    for (size_t k = 0; k < turned.elastic_supports().size(); ++k) {
        const ElasticSupport& as_turned = turned.elastic_supports()[k];
        const ElasticSupport& as_identified = identified.elastic_supports()[k];
        result.supports.col(as_turned.node) = as_turned.place - as_identified.place;
        result.support_stiffness =  // the same factor for all
            std::log(as_turned.stiffness.trace() / as_identified.stiffness.trace());
    }
    if (draws.stiffness.size() > 0) {
        result.stiffness += draws.stiffness.col(d);
    }
    if (draws.supports.size() > 0) {
        result.supports(Eigen::all, nodes) += draws.supports.col(d).reshaped(3, std::ssize(nodes));
    }
    if (draws.loads.size() > 0) {
        result.own_loads(Eigen::all, turned.free_nodes()) +=
            draws.loads.col(d).reshaped(3, turned.free_node_count());
    }
    return result;
}

}  // namespace

void add_draws(BuiltNet& built, const CableNet& turned, const PosteriorDraws& draws,
               std::span<const ParameterEstimate> uncertain) {
    if (!draws.reason.empty()) {
        built.no_draws_because =
            fmt::format("the posterior samples are not reliable: {}", draws.reason);
        return;
    }
    if (!holds_all(draws, uncertain)) {
        built.no_draws_because =
            "the posterior samples, of an older version, hold lengths alone, though more was "
            "uncertain: identify again";
        return;
    }
    const ModelPerturbations& perturbations = draws.perturbations;
    // Thermal perturbations are relative to the lengths as turned. Without them, lengths that were
    // not drawn are those of the estimate.
    const bool is_thermal = perturbations.thermal.size() > 0;
    built.length_draws =
        (is_thermal ? turned : built.net).unstressed_lengths().replicate(1, draws.count());
    const auto draw_deviations = [&](const std::vector<int>& edges,
                                     const Eigen::MatrixXd& deviations) {
        built.length_draws(edges, Eigen::all) =
            deviations.colwise() + turned.unstressed_lengths()(edges);
    };
    draw_deviations(turned.interior_edges(), draws.length_deviations);
    if (draws.adjustable_deviations.size() > 0) {
        draw_deviations(turned.adjustable_edges(), draws.adjustable_deviations);
    }
    if (is_thermal) {
        built.length_draws.array() *= 1.0 + perturbations.thermal.array();
    }
    if (draws.count() > 0 && !(built.length_draws.minCoeff() > 0.0)) {
        throw std::invalid_argument("in a posterior sample an edge has no positive length");
    }
    const bool differs = !perturbations.empty() || !turned.sliding_nodes().empty();
    for (Eigen::Index d = 0; differs && d < draws.count(); ++d) {
        built.perturbations.push_back(perturbation_of(built.net, turned, perturbations, d));
        double whole = 0.0;
        const double part =  // evenly spread, in an order that the samples do not follow
            std::modf((static_cast<double>(d) + 0.5) / std::numbers::phi, &whole);
        built.perturbations.back().runs = runs_from_here(
            turned, with_free_coordinates(turned, draws.forms.col(d)), draws.tensions.col(d),
            CableRun::uncertain_friction * (2.0 * part - 1.0));
    }
}

std::string failure_of(const Trust& trust) {
    if (trust.verdict() != Trust::Verdict::failed) {
        return {};
    }
    const Trust::Finding& worst = trust.findings.front();
    return worst.advice.empty() ? worst.reason + " Correct that, and identify again."
                                : worst.text();
}

BuiltNet built_net_of(const CableNet& net, const Identification& identification) {
    const CableNet turned = turned_net(net, identification.turned);
    BuiltNet built = net_as_identified(turned, identification.edges, identification.uncertain,
                                       identification.boundary_outliers);
    built.no_draws_because = "the identification was made without posterior samples";
    built.failed_because = failure_of(identification.trust);
    if (identification.draws) {
        built.no_draws_because.clear();
        add_draws(built, turned, *identification.draws, identification.uncertain);
    }
    return built;
}

}  // namespace taut
