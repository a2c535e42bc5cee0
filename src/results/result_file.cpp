// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/result_file.hpp"

#include <fmt/core.h>

#include <string_view>

#include "files/json_parse.hpp"
#include "files/message.hpp"
#include "results/older_results.hpp"
#include "results/result_checks.hpp"
#include "results/result_readers.hpp"
#include "results/result_values.hpp"
#include "results/schema_check.hpp"
#include "taut/files/file.hpp"

namespace taut {
namespace {

constexpr int known_version = 2;

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

    const auto form_of = [&net = study.net](const JsonValue& parent, const char* key) {
        const Points form = require_form(parent, key, net);
        check_supports(member(parent, key), form, net, net.nodes(), "/cable_net");
        return form;
    };
    study.nominal_form = form_of(root, "nominal_form");
    const JsonValue sample = member(root, "sample");
    study.true_deviation = require_list(sample, "true", m, each_edge);
    study.identified_deviation = require_list(sample, "identified", m, each_edge);
    static_cast<void>(require_list(sample, "std", m, each_edge));
    static_cast<void>(form_of(sample, "true_form"));
    static_cast<void>(form_of(sample, "identified_form"));
    for (const char* key : {"true_tension", "identified_tension"}) {
        require_tension_list(sample, key, study.net);
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

ComparisonResult read_comparison(const JsonValue& root) {
    ComparisonResult result;
    for (const JsonValue& row : entries(root, "rows")) {
        require_at_most(row, "failed", "surveys");
        result.rows.push_back(
            {.method = member(row, "method").text(),
             .noise = member(row, "noise").number(),
             .training_samples = optional_number(row, "training_samples"),
             .mse = optional_number(row, "mse"),
             .cramer_rao_mse = optional_number(row, "cramer_rao_mse"),
             .hidden_fraction = optional_number(row, "hidden_fraction").value_or(0.0)});
    }
    return result;
}

ResultFile read_root(const JsonValue& root) {
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
    if (version.integer() == 1) {
        const nlohmann::json newer = with_new_keys(root.json());
        return read_root(JsonValue(newer, root.file_name()));
    }
    if (version.integer() != known_version) {
        version.fail(fmt::format("is {}, expected 1 to {}, which this taut knows",
                                 version.integer(), known_version));
    }
    const std::string kind = name.substr(std::string("taut-").size());
    check_against_schema(root, kind);
    const auto content = [&]() -> decltype(ResultFile::content) {
        if (kind == "study") {
            return read_study(root);
        }
        if (kind == "identification") {
            return read_identification(root);
        }
        if (kind == "plan") {
            return read_plan(root);
        }
        if (kind == "control") {
            return read_control(root);
        }
        return read_comparison(root);
    }();
    return {.content = content, .json = root.json().dump()};
}

}  // namespace

ResultFile parse_result(std::string_view text, const std::string& file_name) {
    return read_json(text, file_name, read_root);
}

ResultFile read_result(const std::filesystem::path& path) {
    return parse_result(read_file(path), path.string());
}

}  // namespace taut
