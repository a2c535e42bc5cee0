// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/result_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string_view>

#include "files/json_parse.hpp"
#include "files/message.hpp"
#include "results/control_reader.hpp"
#include "results/plan_reader.hpp"
#include "results/result_values.hpp"
#include "results/schema_check.hpp"
#include "taut/files/file.hpp"

namespace taut {
namespace {

constexpr int known_version = 1;

Eigen::MatrixXd read_errors(const JsonValue& errors, Eigen::Index edges, int samples) {
    const auto all = errors.find("all");
    if (!all) {
        return Eigen::MatrixXd(edges, 0);
    }
    all->require_array(edges, fmt::format("a list for each interior edge: {}", edges));
    Eigen::MatrixXd result(edges, samples);
    for (Eigen::Index i = 0; i < edges; ++i) {
        const JsonValue row = all->at(i);
        row.require_array(samples, fmt::format("an error for each validation sample: {}", samples));
        for (Eigen::Index k = 0; k < samples; ++k) {
            result(i, k) = row.at(k).number();
        }
    }
    return result;
}

StudyResult read_study(const JsonValue& root) {
    StudyResult study{.net = require_net(root)};
    const Eigen::Index m = study.net.interior_edge_count();
    const Eigen::Index n = study.net.free_node_count();
    constexpr const char* each_edge = "a number for each interior edge";
    constexpr const char* each_node = "a number for each free node";

    const JsonValue samples = member(root, "samples");
    study.validation = member(samples, "validation").integer();
    if (study.validation == 0 || m == 0) {
        samples.fail_below("/validation", fmt::format("is {} for {} interior edges, expected at "
                                                      "least one of both",
                                                      study.validation, m));
    }

    require_at_most(samples, "training", "total");
    require_at_most(samples, "validation", "total");
    require_at_most(samples, "with_slack", "total");
    for (const char* form : {"nominal", "identified"}) {
        require_at_most(member(member(root, "form_error"), form), "min", "max");
    }
    require_at_most(samples, "not_converged", "total");

    study.nominal_form = require_form(root, "nominal_form", study.net);
    const JsonValue sample = member(root, "sample");
    study.true_deviation = require_list(sample, "true", m, each_edge);
    study.identified_deviation = require_list(sample, "identified", m, each_edge);
    static_cast<void>(require_list(sample, "std", m, each_edge));
    static_cast<void>(require_form(sample, "true_form", study.net));
    static_cast<void>(require_form(sample, "identified_form", study.net));
    for (const char* key : {"true_tension", "identified_tension"}) {
        static_cast<void>(
            require_list(sample, key, study.net.edge_count(), "a number for each edge"));
    }
    const JsonValue form_error = member(sample, "form_error");
    study.nominal_form_error = require_list(form_error, "nominal", n, each_node);
    study.identified_form_error = require_list(form_error, "identified", n, each_node);

    const JsonValue errors = member(root, "errors");
    study.error_mean = require_list(errors, "mean", m, each_edge);
    study.error_std = require_list(errors, "std", m, each_edge);
    study.errors = read_errors(errors, m, study.validation);
    return study;
}

EdgeStatus read_status(const std::string& name) {
    for (const EdgeStatus status : {EdgeStatus::slack, EdgeStatus::unobserved}) {
        if (name == to_string(status)) {
            return status;
        }
    }
    return EdgeStatus::identified;
}

IdentifiedEdge read_edge(const JsonValue& value, const CableNet& net) {
    const auto number = [&value](const char* key) { return member(value, key).number(); };
    const IdentifiedEdge edge{.edge = member(value, "edge").integer(),
                              .nominal = number("nominal"),
                              .length_deviation = number("length_deviation"),
                              .std = number("std"),
                              .lower = number("lower"),
                              .upper = number("upper"),
                              .status = read_status(member(value, "status").text())};
    if (!std::ranges::binary_search(net.interior_edges(), edge.edge)) {
        member(value, "edge")
            .fail(fmt::format("is {}, expected an interior edge of the net", edge.edge));
    }
    const Edge& nodes = net.edges()[edge.edge];
    if (const auto told = value.find("nodes");
        told && (told->at(0).integer() != nodes[0] || told->at(1).integer() != nodes[1])) {
        told->fail(
            fmt::format("expected [{}, {}], the ends of edge {}", nodes[0], nodes[1], edge.edge));
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
    return edge;
}

/// One of each interior edge, in the order of the file.
std::vector<IdentifiedEdge> read_edges(const JsonValue& list, const CableNet& net) {
    const int count = net.interior_edge_count();
    list.require_array(count, fmt::format("one for each interior edge: {}", count));
    std::vector<IdentifiedEdge> edges;
    std::vector<bool> seen(net.edge_count(), false);
    for (int i = 0; i < count; ++i) {
        edges.push_back(read_edge(list.at(i), net));
        const int edge = edges.back().edge;
        if (seen[edge]) {
            list.at(i).fail(fmt::format("is the edge {} again, expected each once", edge));
        }
        seen[edge] = true;
    }
    return edges;
}

Eigen::Vector3d read_vector(const JsonValue& value) {
    return {value.at(0).number(), value.at(1).number(), value.at(2).number()};
}

std::vector<IdentificationResult::Residual> read_residuals(const JsonValue& survey,
                                                           const CableNet& net) {
    std::set<int> left_out;
    for (const JsonValue& outlier : entries(survey, "outliers")) {
        left_out.insert(read_node(member(outlier, "node"), net));
    }
    std::vector<IdentificationResult::Residual> residuals;
    std::set<int> seen;
    for (const JsonValue& entry : entries(survey, "residuals")) {
        const auto number = [&entry](const char* key) { return member(entry, key).number(); };
        const int node = read_node(member(entry, "node"), net);
        if (!seen.insert(node).second) {
            entry.fail(fmt::format("is of the node {} again, expected each once", node));
        }
        residuals.push_back({.node = node,
                             .surveyed_less_predicted = {number("dx"), number("dy"), number("dz")},
                             .is_in_use = !left_out.contains(node)});
        if (const auto standardised = find_unless_null(entry, "standardised")) {
            residuals.back().standardised = read_vector(*standardised);
        }
    }
    return residuals;
}

UnknownEstimate read_unknown(const JsonValue& value, const CableNet& net) {
    UnknownEstimate estimate{.mean = member(value, "mean").number(),
                             .std = member(value, "std").number()};
    const JsonValue told = member(value, "told");
    try {
        estimate.unknown = parse_unknown(told.text());
        check_unknowns(net, {estimate.unknown});
    } catch (const std::invalid_argument& error) {
        told.fail(error.what());
    }
    const Unknown::Kind kind = estimate.unknown.kind;
    if (kind == Unknown::Kind::stiffness_each || kind == Unknown::Kind::adjustable) {
        estimate.edge = read_edge_index(value.require("edge", "the edge whose it is"), net);
    }
    if (kind == Unknown::Kind::supports || kind == Unknown::Kind::loads_each) {
        estimate.node = read_node(value.require("node", "the node whose it is"), net);
        const std::string axis = value.require("axis", R"("x", "y" or "z")").text();
        estimate.axis = static_cast<int>(std::string_view("xyz").find(axis));
    }
    return estimate;
}

/// What was turned between surveys.
std::vector<EdgeTurned> read_turned(const JsonValue& root, const CableNet& net) {
    std::vector<EdgeTurned> result;
    if (!root.find("turned")) {
        return result;
    }
    for (const JsonValue& entry : entries(root, "turned")) {
        result.push_back({.edge = static_cast<int>(member(entry, "edge").integer()),
                          .stroke = member(entry, "stroke").number(),
                          .std = member(entry, "std").number()});
    }
    try {
        check_turned(net, result);
    } catch (const std::invalid_argument& error) {
        member(root, "turned").fail(error.what());
    }
    return result;
}

/// Adjustable edges of another length than told, and supports at another place.
std::vector<BoundaryOutlier> read_boundary_outliers(const JsonValue& root, const CableNet& net) {
    std::vector<BoundaryOutlier> result;
    const auto doubt = root.find("doubt");
    if (!doubt) {
        return result;
    }
    for (const JsonValue& entry : entries(*doubt, "boundary")) {
        const auto edge = entry.find("edge");
        if (!edge) {
            const Eigen::VectorXd moved =
                require_list(entry, "deviation", 3, "a number for each axis");
            result.push_back({.kind = BoundaryOutlier::Kind::support,
                              .index = read_node(member(entry, "node"), net),
                              .deviation = moved});
            continue;
        }
        BoundaryOutlier outlier{.index = read_edge_index(*edge, net)};
        outlier.deviation.x() = member(entry, "deviation").number();
        result.push_back(outlier);
    }
    return result;
}

Trust read_trust(const JsonValue& root) {
    Trust trust;
    const auto told = root.find("trust");
    if (!told) {
        return trust;
    }
    for (const JsonValue& finding : entries(*told, "findings")) {
        const JsonValue verdict = member(finding, "verdict");
        using enum Trust::Verdict;
        const std::array all{passed, doubtful, failed};
        const auto found =
            std::ranges::find(all, verdict.text(), [](Trust::Verdict v) { return to_string(v); });
        if (found == all.end()) {
            verdict.fail(
                fmt::format("is {}, expected passed, doubtful or failed", quote(verdict.text())));
        }
        trust.findings.push_back({.verdict = *found,
                                  .reason = member(finding, "reason").text(),
                                  .next = member(finding, "next").text()});
    }
    return trust;
}

IdentificationResult read_identification(const JsonValue& root) {
    IdentificationResult result{.net = require_net(root)};
    result.edges = read_edges(member(root, "edges"), result.net);
    result.form = require_form(root, "form", result.net);
    if (root.find("tension")) {
        static_cast<void>(
            require_list(root, "tension", result.net.edge_count(), "a number for each edge"));
    }
    if (const auto mean_tension = find_unless_null(root, "mean_tension")) {
        require_at_most(*mean_tension, "lower", "upper");
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
    }
    for (const JsonValue& unknown : entries(root, "unknowns")) {
        result.unknowns.push_back(read_unknown(unknown, result.net));
    }
    result.boundary_outliers = read_boundary_outliers(root, result.net);
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
    result.residuals = read_residuals(survey, result.net);
    return result;
}

ComparisonResult read_comparison(const JsonValue& root) {
    ComparisonResult result;
    for (const JsonValue& row : entries(root, "rows")) {
        require_at_most(row, "failed", "surveys");
        result.rows.push_back(
            {.method = member(row, "method").text(),
             .noise = member(row, "noise").number(),
             .training_samples = optional_number(row, "training_samples"),
             .mse = optional_number(row, "mse"),
             .best_possible_mse = optional_number(row, "best_possible_mse"),
             .hidden_fraction = optional_number(row, "hidden_fraction").value_or(0.0)});
    }
    return result;
}

}  // namespace

ResultFile parse_result(std::string_view text, const std::string& file_name) {
    const nlohmann::json json = parse_json(text, file_name);
    const JsonValue root(json, file_name);
    constexpr const char* formats =
        R"("taut-study", "taut-identification", "taut-comparison", "taut-plan" or "taut-control")";
    root.require_object(fmt::format(R"(an object with "format": {})", formats));
    const JsonValue format = root.require("format", formats);
    const std::string& name = format.text();
    if (name != "taut-study" && name != "taut-identification" && name != "taut-comparison" &&
        name != "taut-plan" && name != "taut-control") {
        format.fail(fmt::format("is {}, expected {}", quote(name), formats));
    }
    const JsonValue version = root.require("version", std::to_string(known_version));
    if (const int found = version.integer(); found != known_version) {
        version.fail(fmt::format("is {}, expected {}, the only one that this taut knows", found,
                                 known_version));
    }
    const auto content = [&]() -> decltype(ResultFile::content) {
        if (name == "taut-study") {
            check_against_schema(root, "study");
            return read_study(root);
        }
        if (name == "taut-identification") {
            check_against_schema(root, "identification");
            return read_identification(root);
        }
        if (name == "taut-plan") {
            check_against_schema(root, "plan");
            return read_plan(root);
        }
        if (name == "taut-control") {
            check_against_schema(root, "control");
            return read_control(root);
        }
        check_against_schema(root, "comparison");
        return read_comparison(root);
    }();
    return {.content = content, .json = json.dump()};
}

ResultFile read_result(const std::filesystem::path& path) {
    return parse_result(read_file(path), path.string());
}

}  // namespace taut
