// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/adjustment/built_net.hpp"

#include <fmt/core.h>

#include <stdexcept>
#include <vector>

#include "taut/sampling/circumstances.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {

CableNet net_as_identified(const CableNet& net, std::span<const IdentifiedEdge> edges,
                           std::span<const UnknownEstimate> unknowns,
                           std::span<const BoundaryOutlier> boundary_outliers) {
    Eigen::VectorXd lengths = net.unstressed_lengths();
    for (const IdentifiedEdge& edge : edges) {
        lengths(edge.edge) += edge.length_deviation;
    }
    Circumstances circumstances = circumstances_of(net, {unknowns.begin(), unknowns.end()});
    for (const BoundaryOutlier& outlier : boundary_outliers) {
        if (outlier.kind == BoundaryOutlier::Kind::support) {
            circumstances.supports.col(outlier.index) += outlier.deviation;
        } else {
            lengths(outlier.index) += outlier.deviation.x();
        }
    }
    const CableNet identified = net_under(net, circumstances, lengths);
    const Equilibrium equilibrium = solve_equilibrium(identified);
    if (!equilibrium.balanced()) {
        throw std::invalid_argument("the identified lengths find no equilibrium");
    }
    CableNetData data = identified.data();
    data.nodes = equilibrium.form;
    return CableNet(std::move(data));
}

void add_draws(BuiltNet& built, const CableNet& turned, const PosteriorDraws& draws,
               std::span<const UnknownEstimate> unknowns) {
    const bool has_all_lengths = draws.adjustable_deviations.cols() == draws.count();
    if (!unknowns.empty() && !has_all_lengths) {
        built.no_draws_since =
            "the draws of an identification hold lengths alone, and more than lengths was unknown";
    } else if (!draws.doubt.empty()) {
        built.no_draws_since = fmt::format("the draws are in doubt: {}", draws.doubt);
    } else {
        const auto draw_deviations = [&](const std::vector<int>& edges,
                                         const Eigen::MatrixXd& deviations) {
            built.length_draws(edges, Eigen::all) =
                deviations.colwise() + turned.unstressed_lengths()(edges);
        };
        built.length_draws = built.net.unstressed_lengths().replicate(1, draws.count());
        draw_deviations(turned.interior_edges(), draws.length_deviations);
        if (!unknowns.empty()) {
            draw_deviations(turned.adjustable_edges(), draws.adjustable_deviations);
        }
        if (draws.count() > 0 && !(built.length_draws.minCoeff() > 0.0)) {
            throw std::invalid_argument("draws leave an edge no length");
        }
    }
}

std::string failure_of(const Trust& trust) {
    if (trust.verdict() != Trust::Verdict::failed) {
        return {};
    }
    const Trust::Finding& worst = trust.findings.front();
    return fmt::format("{}; {}", worst.reason,
                       worst.next.empty() ? "correct that and identify again" : worst.next);
}

BuiltNet built_net_of(const CableNet& net, const Identification& identification) {
    const CableNet turned = turned_net(net, identification.turned);
    BuiltNet built{.net = net_as_identified(turned, identification.edges, identification.unknowns,
                                            identification.boundary_outliers),
                   .length_draws = {},
                   .no_draws_since = "the identification was made without draws",
                   .failed_since = failure_of(identification.trust)};
    if (identification.draws) {
        built.no_draws_since.clear();
        add_draws(built, turned, *identification.draws, identification.unknowns);
    }
    return built;
}

}  // namespace taut
