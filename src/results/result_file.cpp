// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/result_file.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "files/json_parse.hpp"
#include "files/message.hpp"
#include "results/result_values.hpp"
#include "taut/files/file.hpp"

namespace taut {
namespace {

constexpr int known_version = 1;

std::optional<JsonValue> find_unless_null(const JsonValue& object, const char* key) {
    auto value = object.find(key);
    return value && !value->json().is_null() ? value : std::nullopt;
}

/// What a result need not tell must still be text where it does.
void check_texts(const JsonValue& root, std::initializer_list<const char*> keys) {
    for (const char* key : keys) {
        if (const auto value = find_unless_null(root, key)) {
            static_cast<void>(value->text());
        }
    }
}

std::optional<double> optional_number(const JsonValue& object, const char* key) {
    const auto value = find_unless_null(object, key);
    return value ? std::optional(value->number()) : std::nullopt;
}

void check_form_errors(const JsonValue& errors) {
    for (const char* form : {"nominal", "identified"}) {
        require_numbers(require_object(errors, form), {"max", "min", "mean", "rmse"});
    }
}

/// A method that failed throughout has no numbers.
void check_method(const JsonValue& method) {
    for (const char* key : {"mse", "mrse", "error_mean_max_abs", "error_std_mean"}) {
        static_cast<void>(method.require(key, "a number, or null"));
        static_cast<void>(optional_number(method, key));
    }
    static_cast<void>(optional_number(method, "coverage_95"));
    if (const auto errors = find_unless_null(method, "form_error")) {
        require_numbers(*errors, {"max", "min", "mean", "rmse"});
    }
}

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

    const JsonValue samples = require_object(root, "samples");
    for (const char* key : {"total", "training", "with_slack", "not_converged"}) {
        static_cast<void>(require_count(samples, key));
    }
    study.validation = require_count(samples, "validation");
    if (study.validation == 0 || m == 0) {
        samples.fail_below("/validation", fmt::format("is {} for {} interior edges, expected at "
                                                      "least one of both",
                                                      study.validation, m));
    }
    const JsonValue methods = require_object(root, "methods");
    if (methods.json().empty()) {
        methods.fail("is empty, expected at least one method");
    }
    for (const auto& [name, method] : methods.json().items()) {
        check_method(require_object(methods, name));
    }
    check_form_errors(require_object(root, "form_error"));
    require_numbers(require_object(root, "seconds"),
                    {"sampling", "training", "identification", "total"});
    check_texts(root, {"program", "date", "command", "law"});

    study.nominal_form = require_form(root, "nominal_form", study.net);
    const JsonValue sample = require_object(root, "sample");
    study.true_deviation = require_list(sample, "true", m, each_edge);
    study.identified_deviation = require_list(sample, "identified", m, each_edge);
    static_cast<void>(require_list(sample, "std", m, each_edge));
    static_cast<void>(require_form(sample, "true_form", study.net));
    static_cast<void>(require_form(sample, "identified_form", study.net));
    for (const char* key : {"true_tension", "identified_tension"}) {
        static_cast<void>(
            require_list(sample, key, study.net.edge_count(), "a number for each edge"));
    }
    const JsonValue form_error = require_object(sample, "form_error");
    study.nominal_form_error = require_list(form_error, "nominal", n, each_node);
    study.identified_form_error = require_list(form_error, "identified", n, each_node);

    const JsonValue errors = require_object(root, "errors");
    study.error_mean = require_list(errors, "mean", m, each_edge);
    study.error_std = require_list(errors, "std", m, each_edge);
    study.errors = read_errors(errors, m, study.validation);
    return study;
}

EdgeStatus read_status(const JsonValue& value) {
    for (const EdgeStatus status :
         {EdgeStatus::identified, EdgeStatus::slack, EdgeStatus::unobserved}) {
        if (value.text() == to_string(status)) {
            return status;
        }
    }
    value.fail(fmt::format(R"(is {}, expected "identified", "slack" or "unobserved")",
                           quote(value.text())));
}

IdentifiedEdge read_edge(const JsonValue& value, const CableNet& net) {
    value.require_object("an edge");
    const JsonValue index = value.require("edge", "an edge of the net");
    IdentifiedEdge edge{.edge = index.integer()};
    if (!std::ranges::binary_search(net.interior_edges(), edge.edge)) {
        index.fail(fmt::format("is {}, expected an interior edge of the net", edge.edge));
    }
    const auto number = [&value](const char* key) {
        return value.require(key, "a number").number();
    };
    edge.nominal = number("nominal");
    edge.length_deviation = number("length_deviation");
    edge.std = number("std");
    edge.lower = number("lower");
    edge.upper = number("upper");
    edge.status = read_status(value.require("status", "a status"));
    if (edge.std < 0.0 || edge.lower > edge.upper) {
        value.fail(
            fmt::format("has the standard deviation {} and the interval from {} to {}, "
                        "expected none below 0 and lower before upper",
                        edge.std, edge.lower, edge.upper));
    }
    return edge;
}

Eigen::Vector3d read_vector(const JsonValue& value) {
    value.require_array(3, "three numbers");
    return {value.at(0).number(), value.at(1).number(), value.at(2).number()};
}

std::vector<IdentificationResult::Residual> read_residuals(const JsonValue& survey,
                                                           const CableNet& net) {
    std::vector<IdentificationResult::Residual> residuals;
    const auto list = survey.find("residuals");
    const size_t count = list ? list->array_size("a list of residuals") : 0;
    for (size_t i = 0; i < count; ++i) {
        const JsonValue entry = list->at(i);
        entry.require_object("a residual");
        const auto number = [&entry](const char* key) {
            return entry.require(key, "a number").number();
        };
        IdentificationResult::Residual residual{
            .node = read_node(entry.require("node", "a node"), net),
            .surveyed_less_predicted = {number("dx"), number("dy"), number("dz")}};
        if (const auto standardised = find_unless_null(entry, "standardised")) {
            residual.standardised = read_vector(*standardised);
        }
        residuals.push_back(residual);
    }
    return residuals;
}

/// What the page lists but no figure draws.
void check_survey_lists(const JsonValue& survey, const CableNet& net) {
    static_cast<void>(require_count(survey, "used"));
    static_cast<void>(require_count(survey, "missing"));
    require_numbers(survey, {"rms_residual", "max_residual"});
    if (const auto missing = survey.find("missing_nodes")) {
        for (size_t i = 0; i < missing->array_size("a list of nodes"); ++i) {
            static_cast<void>(read_node(missing->at(i), net));
        }
    }
    const JsonValue outliers = survey.require("outliers", "a list");
    for (size_t i = 0; i < outliers.array_size("a list of outliers"); ++i) {
        const JsonValue outlier = outliers.at(i);
        outlier.require_object("an outlier");
        static_cast<void>(read_node(outlier.require("node", "a node"), net));
        static_cast<void>(optional_number(outlier, "statistic"));
    }
    if (const auto unmatched = survey.find("unmatched")) {
        static_cast<void>(unmatched->array_size("a list of targets"));
    }
}

IdentificationResult read_identification(const JsonValue& root) {
    IdentificationResult result{.net = require_net(root)};
    check_texts(root, {"program", "date", "command", "method", "method_reason"});
    const JsonValue edges = root.require("edges", "a list of edges");
    std::vector<char> seen(result.net.edge_count(), 0);
    for (size_t i = 0; i < edges.array_size("a list of edges"); ++i) {
        result.edges.push_back(read_edge(edges.at(i), result.net));
        char& mark = seen[result.edges.back().edge];
        if (mark != 0) {
            edges.at(i).fail(
                fmt::format("is the edge {} again, expected each once", result.edges.back().edge));
        }
        mark = 1;
    }
    if (result.edges.empty()) {
        edges.fail("is empty, expected at least one edge");
    }
    result.form = require_form(root, "form", result.net);
    if (root.find("tension")) {
        static_cast<void>(
            require_list(root, "tension", result.net.edge_count(), "a number for each edge"));
    }
    const JsonValue survey = require_object(root, "survey");
    check_survey_lists(survey, result.net);
    result.residuals = read_residuals(survey, result.net);
    return result;
}

ComparisonResult read_comparison(const JsonValue& root) {
    ComparisonResult result;
    static_cast<void>(require_object(root, "net"));
    check_texts(root, {"program", "date", "command", "law"});
    const JsonValue rows = root.require("rows", "a list of rows");
    for (size_t i = 0; i < rows.array_size("a list of rows"); ++i) {
        const JsonValue row = rows.at(i);
        row.require_object("a row");
        for (const char* key : {"mrse", "form_error", "coverage", "seconds", "training_seconds",
                                "surveys", "failed"}) {
            static_cast<void>(optional_number(row, key));
        }
        check_texts(row, {"first_failure"});
        result.rows.push_back(
            {.method = row.require("method", "a method").text(),
             .noise = row.require("noise", "a number [m]").number(),
             .training_samples = optional_number(row, "training_samples"),
             .mse = optional_number(row, "mse"),
             .best_possible_mse = optional_number(row, "best_possible_mse"),
             .hidden_fraction = optional_number(row, "hidden_fraction").value_or(0.0)});
    }
    if (result.rows.empty()) {
        rows.fail("is empty, expected at least one row");
    }
    return result;
}

}  // namespace

ResultFile parse_result(std::string_view text, const std::string& file_name) {
    const nlohmann::json json = parse_json(text, file_name);
    const JsonValue root(json, file_name);
    constexpr const char* formats = R"("taut-study", "taut-identification" or "taut-comparison")";
    root.require_object(fmt::format(R"(an object with "format": {})", formats));
    const JsonValue format = root.require("format", formats);
    const std::string& name = format.text();
    if (name != "taut-study" && name != "taut-identification" && name != "taut-comparison") {
        format.fail(fmt::format("is {}, expected {}", quote(name), formats));
    }
    const JsonValue version = root.require("version", std::to_string(known_version));
    if (const int found = version.integer(); found != known_version) {
        version.fail(fmt::format("is {}, expected {}, the only one that this taut knows", found,
                                 known_version));
    }
    const auto content = [&]() -> decltype(ResultFile::content) {
        if (name == "taut-study") {
            return read_study(root);
        }
        if (name == "taut-identification") {
            return read_identification(root);
        }
        return read_comparison(root);
    }();
    return {.content = content, .json = json.dump()};
}

ResultFile read_result(const std::filesystem::path& path) {
    return parse_result(read_file(path), path.string());
}

}  // namespace taut
