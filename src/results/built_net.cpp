// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/built_net.hpp"

#include <fmt/core.h>

#include "taut/files/input_error.hpp"
#include "taut/results/draws_h5.hpp"
#include "taut/results/result_file.hpp"
#include "taut/sampling/circumstances.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {
namespace {

CableNet built_net_of(const CableNet& net, const IdentificationResult& result) {
    Eigen::VectorXd lengths = net.unstressed_lengths();
    for (const IdentifiedEdge& edge : result.edges) {
        lengths(edge.edge) += edge.length_deviation;
    }
    Circumstances circumstances = circumstances_of(net, result.unknowns);
    for (const BoundaryOutlier& outlier : result.boundary_outliers) {
        if (outlier.kind == BoundaryOutlier::Kind::support) {
            circumstances.supports.col(outlier.index) += outlier.deviation;
        } else {
            lengths(outlier.index) += outlier.deviation.x();
        }
    }
    const CableNet identified = net_under(net, circumstances, lengths);
    const Equilibrium equilibrium = solve_equilibrium(identified);
    if (!equilibrium.balanced()) {
        throw std::invalid_argument("its lengths find no equilibrium");
    }
    CableNetData data = identified.data();
    data.nodes = equilibrium.form;
    data.loads = identified.loads();
    data.mass.resize(0);  // its weight is among the loads
    return CableNet(std::move(data));
}

/// The draws beside a result, as absolute lengths; or why there are none.
void add_draws(BuiltNet& built, const CableNet& net, const IdentificationResult& result,
               const std::filesystem::path& path) {
    if (!result.unknowns.empty()) {
        built.no_draws_since =
            "the draws of an identification hold lengths alone, and more than lengths was unknown";
        return;
    }
    if (!std::filesystem::exists(path)) {
        built.no_draws_since = fmt::format("there is no file {} beside the result", path.string());
        return;
    }
    const PosteriorDraws draws = read_draws(net, path);
    if (!draws.doubt.empty()) {
        built.no_draws_since = fmt::format("the draws are in doubt: {}", draws.doubt);
        return;
    }
    const Eigen::VectorXd nominal = net.unstressed_lengths()(net.interior_edges());
    built.length_draws = draws.length_deviations.colwise() + nominal;
}

}  // namespace

IdentifiedNet read_identified_net(const CableNet& net, const std::filesystem::path& path) {
    const ResultFile file = read_result(path);
    const auto* result = std::get_if<IdentificationResult>(&file.content);
    if (result == nullptr) {
        throw InputError(path.string(), "/format",
                         "is of another kind, expected the \"taut-identification\" of a survey");
    }
    if (result->net.fingerprint() != net.fingerprint()) {
        throw InputError(path.string(), "/net/fingerprint",
                         fmt::format("is {}, expected {}: it is of another net",
                                     result->net.fingerprint(), net.fingerprint()));
    }
    try {
        IdentifiedNet identified{
            .built = {.net = built_net_of(net, *result), .length_draws = {}, .no_draws_since = {}},
            .trust = result->trust};
        add_draws(identified.built, net, *result, draws_path(path));
        return identified;
    } catch (const InputError&) {
        throw;
    } catch (const std::invalid_argument& error) {
        throw InputError(path.string(), "", fmt::format("is of no net: {}", error.what()));
    }
}

}  // namespace taut
