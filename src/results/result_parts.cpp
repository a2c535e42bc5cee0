// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/result_parts.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "net/rounded_length.hpp"
#include "taut/io/net_json.hpp"

namespace taut {
namespace {

/// On one line. Bytes that are not UTF-8, in a file's name say, are replaced.
std::string line_of(const ResultJson& value) {
    return value.dump(-1, ' ', false, ResultJson::error_handler_t::replace);
}

bool is_flat(const ResultJson& list) {
    return std::ranges::all_of(list, [](const ResultJson& entry) { return entry.is_primitive(); });
}

void write(std::string& text, const ResultJson& value, const std::string& indent) {
    const bool is_list = value.is_array();
    if (value.is_primitive() || value.empty() || (is_list && is_flat(value))) {
        text += line_of(value);
        return;
    }
    const char* separator = "";
    text += is_list ? '[' : '{';
    for (const auto& [key, entry] : value.items()) {
        text += separator + indent + "  ";
        if (is_list) {
            text += line_of(entry);
        } else {
            text += line_of(key) + ": ";
            write(text, entry, indent + "  ");
        }
        separator = ",";
    }
    text += indent + (is_list ? ']' : '}');
}

}  // namespace

ResultJson counts_json(const CableNet& net) {
    return {{"name", net.name()},
            {"free_nodes", net.free_node_count()},
            {"supports", net.supports().size()},
            {"interior_edges", net.interior_edge_count()},
            {"adjustable_edges", net.adjustable_edges().size()},
            {"fingerprint", net.fingerprint()}};
}

void add_run(ResultJson& document, const RunRecord& run) {
    for (const auto& [key, text] : {std::pair{"date", run.date}, {"command", run.command}}) {
        if (!text.empty()) {
            document[key] = text;
        }
    }
}

ResultJson net_json(const CableNet& net) {
    return ResultJson::parse(net_to_json(net));
}

ResultJson trust_json(const Trust& trust) {
    ResultJson reasons = ResultJson::array();
    for (const Trust::Finding& finding : trust.findings) {
        reasons.push_back(finding.reason);
    }
    return {{"verdict", to_string(trust.verdict())}, {"reasons", reasons}};
}

ResultJson numbers_json(const Eigen::Ref<const Eigen::VectorXd>& numbers, int digits) {
    ResultJson list = ResultJson::array();
    for (const double number : numbers) {
        list.push_back(to_digits(number, digits));
    }
    return list;
}

ResultJson points_json(const Points& points) {
    ResultJson list = ResultJson::array();
    for (const auto& point : points.colwise()) {
        list.push_back(numbers_json(point, 9));
    }
    return list;
}

std::string to_text(const ResultJson& document) {
    std::string text;
    write(text, document, "\n");
    return text + "\n";
}

}  // namespace taut
