// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/result_parts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

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

Description<CableNet> describe(const CableNet* /*type*/) {
    return Description<CableNet>("counts")
        .newer("name", &CableNet::name)
        .newer("free_nodes", &CableNet::free_node_count)
        .newer("supports", TAUT_VALUE(it.supports().size()), Rule::count())
        .newer("interior_edges", &CableNet::interior_edge_count)
        .newer("adjustable_edges", TAUT_VALUE(it.adjustable_edges().size()), Rule::count())
        .newer("fingerprint", &CableNet::fingerprint);
}

ResultJson net_json(const CableNet& net) {
    return ResultJson::parse(net_to_json(net));
}

Rule net_rule() {
    const Rule points = Rule::list_of(Rule::point());
    const Rule indices = Rule::list_of(Rule::count());
    const Rule numbers = Rule::list_of(Rule::number());
    const Rule texts = Rule::list_of(Rule::text());
    ObjectRule net("net_file", "A net in taut's own format; its reader checks it further.");
    net.add("format", Rule::only("taut-net"), true);
    net.add("version", Rule::only(1), true);
    net.add("name", Rule::text(), false);
    net.add("nodes", points, true);
    net.add("supports", indices, true);
    net.add("edges", Rule::list_of(Rule::list_of(Rule::count(), 2)), true);
    net.add("axial_stiffness", Rule::any_of(Rule::number(), numbers), true);
    net.add("unstressed_lengths", numbers, true);
    net.add("adjustable", indices, true);
    net.add("loads", points, false);
    net.add("node_ids", texts, false);
    net.add("edge_ids", texts, false);
    return net.rule();
}

std::vector<std::string> reasons_of(const Trust& trust) {
    std::vector<std::string> reasons;
    std::ranges::transform(trust.findings, std::back_inserter(reasons), &Trust::Finding::reason);
    return reasons;
}

std::optional<std::string> unless_empty(const std::string& text) {
    return text.empty() ? std::nullopt : std::optional(text);
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

ResultJson covariances_json(const std::vector<Eigen::Matrix3d>& covariances) {
    ResultJson list;
    for (const Eigen::Matrix3d& C : covariances) {
        const Eigen::Vector<double, 6> numbers{C(0, 0), C(0, 1), C(0, 2),
                                               C(1, 1), C(1, 2), C(2, 2)};
        list.push_back(numbers_json(numbers, 6));
    }
    return list;
}

Rule covariances_rule() {
    return Rule::list_of(Rule::list_of(Rule::number(), 6)).or_null();
}

std::string to_text(const ResultJson& document) {
    std::string text;
    write(text, document, "\n");
    return text + "\n";
}

}  // namespace taut
