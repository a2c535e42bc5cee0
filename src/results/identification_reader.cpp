// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "files/message.hpp"
#include "identification/parameter_spread.hpp"
#include "results/identification_parts.hpp"
#include "results/result_checks.hpp"
#include "results/result_readers.hpp"
#include "results/result_values.hpp"

namespace taut {
namespace {

IdentifiedEdge read_edge(const JsonValue& value, const CableNet& net) {
    const auto edge = read<IdentifiedEdge>(value);
    if (!std::ranges::binary_search(net.interior_edges(), edge.edge)) {
        member(value, "edge")
            .fail(fmt::format("is {}, expected an interior edge of the net", edge.edge));
    }
    if (const double l0 = net.unstressed_lengths()(edge.edge);
        std::abs(edge.nominal - l0) > 1e-9 * l0) {
        member(value, "nominal")
            .fail(fmt::format("is {}, expected {}, the unstressed length in /cable_net",
                              edge.nominal, l0));
    }
    if (edge.lower > edge.upper) {
        value.fail(fmt::format("has the interval from {} to {}, expected lower before upper",
                               edge.lower, edge.upper));
    }
    if (edge.length_deviation < edge.lower || edge.length_deviation > edge.upper) {
        value.fail(
            fmt::format("has the length deviation {}, expected one in its interval, {} to {}",
                        edge.length_deviation, edge.lower, edge.upper));
    }
    require_at_most(value, "tension_lower", "tension_upper");
    require_tensions(value, {"tension", "tension_lower", "tension_upper"}, net, edge.edge);
    if (edge.status == EdgeStatus::slack && !net.can_be_slack(edge.edge)) {
        member(value, "status")
            .fail(net.is_strut(edge.edge) ? "is slack, but the edge is a strut"
                                          : "is slack, but the cable sags");
    }
    return edge;
}

double reach_of(const JsonValue& prior) {
    try {
        return parse_length_prior(prior.text()).reach();
    } catch (const std::invalid_argument& error) {
        prior.fail(error.what());
    }
}

/// Largest distance of two lengths by the priors of a result; infinite where it has none.
double farthest_of(const JsonValue& root) {
    const auto prior = root.find("length_prior");
    if (!prior) {
        return std::numeric_limits<double>::infinity();
    }
    double reach = reach_of(*prior);
    if (const auto prior = root.find("prior")) {
        constexpr double rounding = 1e-6;
        double sum = 0.0;
        for (const JsonValue& node : entries(*prior, "nodes")) {
            reach = std::max(reach, reach_of(member(node, "prior")));
            sum += member(node, "weight").number();
        }
        if (!entries(*prior, "nodes").empty() && std::abs(sum - 1.0) > rounding) {
            member(*prior, "nodes").fail(fmt::format("has weights of sum {}, expected 1", sum));
        }
    }
    return 2.0 * reach;
}

/// Edges to which the prior does not apply: length outliers, and lengths that changed between
/// surveys.
std::set<int> length_outliers(const JsonValue& root) {
    std::set<int> edges;
    if (root.find("epochs")) {
        for (const JsonValue& epoch : entries(root, "epochs")) {
            for (const JsonValue& change : entries(epoch, "changes")) {
                edges.insert(member(change, "edge").integer());
            }
        }
    }
    if (const auto diagnostics = root.find("diagnostics")) {
        for (const JsonValue& outlier : entries(*diagnostics, "length_outliers")) {
            edges.insert(member(outlier, "edge").integer());
        }
    }
    return edges;
}

/// One entry per interior edge, in the order of the file.
std::vector<IdentifiedEdge> read_edges(const JsonValue& root, const CableNet& net) {
    const JsonValue list = member(root, "edges");
    const double farthest = farthest_of(root);
    const std::set<int> outliers = length_outliers(root);
    const int count = net.interior_edge_count();
    list.require_array(count, fmt::format("one for each interior edge: {}", count));
    std::vector<IdentifiedEdge> edges;
    std::vector<bool> seen(net.edge_count(), false);
    for (int i = 0; i < count; ++i) {
        edges.push_back(read_edge(list.at(i), net));
        const int edge = edges.back().edge;
        if (edges.back().status != EdgeStatus::slack && !outliers.contains(edge)) {
            check_std(list.at(i), edges.back(), farthest);
        }
        if (seen[edge]) {
            list.at(i).fail(fmt::format("is the edge {} again, expected each once", edge));
        }
        seen[edge] = true;
    }
    return edges;
}

using Residual = IdentificationResult::Residual;

std::vector<Residual> read_residuals(const JsonValue& survey) {
    std::set<int> left_out;
    for (const JsonValue& outlier : entries(survey, "outliers")) {
        left_out.insert(member(outlier, "node").integer());
    }
    std::vector<Residual> residuals;
    std::set<int> seen;
    for (const JsonValue& entry : entries(survey, "residuals")) {
        residuals.push_back(read<Residual>(entry));
        const int node = residuals.back().node;
        residuals.back().is_in_use = !left_out.contains(node);
        if (!seen.insert(node).second) {
            entry.fail(fmt::format("is of the node {} again, expected each once", node));
        }
    }
    return residuals;
}

ParameterEstimate read_uncertain_parameter(const JsonValue& value, const CableNet& net) {
    auto estimate = read<ParameterEstimate>(value);
    try {
        check_uncertain_parameters(net, {estimate.parameter});
    } catch (const std::invalid_argument& error) {
        member(value, "given").fail(error.what());
    }
    if (!value.find("prior_std")) {
        estimate.prior_std = estimate.parameter.std_dev;
    }
    const UncertainParameter::Kind kind = estimate.parameter.kind;
    if (kind == UncertainParameter::Kind::stiffness_each ||
        kind == UncertainParameter::Kind::adjustable || kind == UncertainParameter::Kind::slip) {
        estimate.edge = read_edge_index(value.require("edge", "the edge of this parameter"), net);
        const auto& sliding = net.sliding_nodes();
        if (kind == UncertainParameter::Kind::slip &&
            std::ranges::find(sliding, estimate.edge, &SlidingNode::after) == sliding.end()) {
            member(value, "edge")
                .fail(
                    fmt::format("is {}, expected an edge to which a run slides from the one before",
                                estimate.edge));
        }
    }
    if (kind == UncertainParameter::Kind::supports ||
        kind == UncertainParameter::Kind::loads_each) {
        estimate.node = read_node(value.require("node", "the node of this parameter"), net);
        const std::string axis = value.require("axis", R"("x", "y" or "z")").text();
        estimate.axis = static_cast<int>(std::string_view("xyz").find(axis));
    }
    return estimate;
}

std::vector<EdgeTurned> read_turned(const JsonValue& root, const CableNet& net) {
    const auto result = read_or_default<std::vector<EdgeTurned>>(root, "turned");
    try {
        check_turned(net, result);
    } catch (const std::invalid_argument& error) {
        member(root, "turned").fail(error.what());
    }
    return result;
}

/// Adjustable edges and supports that are not as designed.
std::vector<BoundaryOutlier> read_boundary(const JsonValue& parent, const CableNet& net) {
    std::vector<BoundaryOutlier> result;
    for (const JsonValue& entry : entries(parent, "boundary")) {
        const auto edge = entry.find("edge");
        BoundaryOutlier outlier;
        if (edge) {
            outlier.index = edge->integer();
            outlier.deviation.x() = member(entry, "deviation").number();
            outlier.std_dev.x() = member(entry, "std").number();
        } else {
            const JsonValue node = entry.require("node", "it, or \"edge\"");
            outlier.kind = BoundaryOutlier::Kind::support;
            outlier.index = node.integer();
            outlier.deviation = require_list(entry, "deviation", 3, "a number for each axis");
            outlier.std_dev = require_list(entry, "std", 3, "a number for each axis");
        }
        if (edge ? !std::ranges::binary_search(net.adjustable_edges(), outlier.index)
                 : net.free_index(outlier.index) >= 0) {
            member(entry, edge ? "edge" : "node")
                .fail(fmt::format("is {}, expected {}", outlier.index,
                                  edge ? "an adjustable edge" : "a support"));
        }
        result.push_back(outlier);
    }
    return result;
}

Trust read_trust(const JsonValue& root) {
    Trust trust;
    const auto given = root.find("trust");
    const auto findings = root.find("findings");
    if (findings) {
        trust.findings = read<std::vector<Trust::Finding>>(*findings);
    }
    if (!given) {
        if (trust.findings.empty()) {
            trust.findings.push_back({.kind = Trust::Finding::Kind::other,
                                      .severity = Trust::Verdict::doubtful,
                                      .reason = "This result does not say what its checks found.",
                                      .advice = "Identify again."});
        }
        return trust;
    }
    if (!findings && given->find("reasons")) {  // of a version before 0.3
        for (const auto& reason : read_or_default<std::vector<std::string>>(*given, "reasons")) {
            trust.findings.push_back({.kind = Trust::Finding::Kind::other,
                                      .severity = read<Trust::Verdict>(member(*given, "verdict")),
                                      .reason = reason.ends_with('.') ? reason : reason + ".",
                                      .advice = {}});
        }
    }
    const JsonValue verdict = member(*given, "verdict");
    if (verdict.text() != to_string(trust.verdict())) {
        verdict.fail(fmt::format("is {}, expected {}, the worst of all findings",
                                 quote(verdict.text()), quote(to_string(trust.verdict()))));
    }
    return trust;
}

/// Places of the supports by all parts of a result.
Points support_places(const IdentificationResult& result) {
    const CableNet& net = result.net;
    Points places = net.nodes() + perturbation_of(net, result.uncertain).supports;
    for (const BoundaryOutlier& outlier : result.boundary_outliers) {
        if (outlier.kind == BoundaryOutlier::Kind::support) {
            places.col(outlier.index) += outlier.deviation;
        }
    }
    if (result.frame_offset) {
        places += result.frame_offset->motion_of(net.nodes());
    }
    return places;
}

void check_length_covariance(const JsonValue& value, const CableNet& net) {
    const std::vector<JsonValue> edges = entries(value, "edges");
    for (const JsonValue& edge : edges) {
        static_cast<void>(read_edge_index(edge, net));
    }
    member(value, "ids")
        .require_array(edges.size(), fmt::format("one for each edge: {}", edges.size()));
    const JsonValue rows = member(value, "covariance");
    rows.require_array(edges.size(), fmt::format("a row for each edge: {}", edges.size()));
    for (size_t i = 0; i < edges.size(); ++i) {
        rows.at(i).require_array(edges.size(),
                                 fmt::format("a number for each edge: {}", edges.size()));
    }
}

}  // namespace

IdentificationResult read_identification(const JsonValue& root) {
    IdentificationResult result{.net = require_net(root)};
    check_names(root, result.net);
    result.edges = read_edges(root, result.net);
    result.form = require_form(root, "form", result.net);
    if (const auto covariance = find_unless_null(root, "length_covariance")) {
        check_length_covariance(*covariance, result.net);
    }
    check_covariances(root, "form_covariance", result.net);
    if (root.find("tension")) {
        require_tension_list(root, "tension", result.net);
    }
    if (const auto mean_tension = find_unless_null(root, "mean_tension")) {
        require_at_most(*mean_tension, "lower", "upper");
        require_tensions(*mean_tension, {"mean", "lower", "upper"}, result.net);
    }
    std::set<int> adjustable;
    for (const JsonValue& drawn : entries(root, "adjustable_edges")) {
        const JsonValue edge = member(drawn, "edge");
        if (!std::ranges::binary_search(result.net.adjustable_edges(), edge.integer()) ||
            !adjustable.insert(edge.integer()).second) {
            edge.fail(fmt::format("is {}, expected each adjustable edge of the net once",
                                  edge.integer()));
        }
        require_at_most(drawn, "tension_lower", "tension_upper");
        require_tensions(drawn, {"tension", "tension_lower", "tension_upper"}, result.net,
                         edge.integer());
    }
    for (const JsonValue& parameter : entries(root, "uncertain")) {
        result.uncertain.push_back(read_uncertain_parameter(parameter, result.net));
    }
    if (const auto diagnostics = root.find("diagnostics")) {
        result.boundary_outliers = read_boundary(*diagnostics, result.net);
    }
    for (const JsonValue& epoch : entries(root, "epochs")) {
        static_cast<void>(read_boundary(epoch, result.net));
        static_cast<void>(read_turned(epoch, result.net));
        static_cast<void>(read_trust(epoch));
    }
    result.frame_offset = read_or_default<std::optional<FrameOffset>>(root, "frame_offset");
    check_supports(member(root, "form"), result.form, result.net, support_places(result),
                   "/cable_net, moved as the result says");
    result.turned = read_turned(root, result.net);
    result.trust = read_trust(root);
    if (const auto draws = root.find("draws"); draws && !draws->json().is_null()) {
        result.draws = member(*draws, "count").integer();
        if (const auto fingerprint = draws->find("fingerprint")) {
            result.draws_fingerprint = fingerprint->text();
        }
    }
    const JsonValue survey = member(root, "survey");
    require_equal(survey, "missing",
                  result.net.free_node_count() - member(survey, "used").integer(),
                  "the free nodes that were not used");
    for (const JsonValue& node : entries(survey, "missing_nodes")) {
        static_cast<void>(read_node(node, result.net));
    }
    result.residuals = read_residuals(survey);
    return result;
}

}  // namespace taut
