// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/adjustment_csv.hpp"

#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <utility>

#include "files/parse_number.hpp"
#include "files/plain_text.hpp"
#include "io/edge_column.hpp"

namespace taut {
namespace {

constexpr double largest_load = 1e12;  ///< [N]

/// The numbers behind the first field, each below a limit.
template <size_t N>
std::array<double, N> numbers_in(const CsvRecord& record, const std::string& file_name,
                                 const std::array<std::string_view, N>& names, double below) {
    std::array<double, N> result{};
    for (size_t i = 0; i < N; ++i) {
        const auto value = parse_number(record.fields[i + 1]);
        if (!value || !(std::abs(*value) < below)) {
            throw InputError(file_name, std::to_string(record.line),
                             fmt::format("{} is {}, expected a number of less than {:g}", names[i],
                                         quote(record.fields[i + 1]), below));
        }
        result[i] = *value;
    }
    return result;
}

/// The records of a table behind its header, if it has one.
std::vector<CsvRecord> records_of(std::string_view text, const std::string& file_name,
                                  const std::vector<std::string>& header) {
    const std::string plain(table_text(text, file_name));
    CsvReader reader(plain, file_name);
    std::vector<CsvRecord> records;
    bool is_first = true;
    while (auto record = reader.next()) {
        if (record->fields.size() != header.size()) {
            throw InputError(file_name, std::to_string(record->line),
                             fmt::format("has {} fields, expected {}", record->fields.size(),
                                         fmt::join(header, ",")));
        }
        if (!is_first || record->fields != header) {
            records.push_back(std::move(*record));
        }
        is_first = false;
    }
    if (records.empty()) {
        throw InputError(file_name, "",
                         fmt::format("has no line, expected some of {}", fmt::join(header, ",")));
    }
    return records;
}

/// Nodes by the names in the first field, each once.
class NodeColumn {
public:
    NodeColumn(const CableNet& net, std::string file_name)
        : m_net(&net), m_file_name(std::move(file_name)) {
        for (int node = 0; node < net.node_count(); ++node) {
            m_node_of.emplace(net.node_id(node), node);
        }
    }

    [[noreturn]] void fail(const CsvRecord& record, const std::string& what) const {
        throw InputError(m_file_name, std::to_string(record.line), what);
    }

    int node(const CsvRecord& record) {
        const auto found = m_node_of.find(record.fields[0]);
        if (found == m_node_of.end()) {
            fail(record, fmt::format("{} is no node of the net '{}'", quote(record.fields[0]),
                                     m_net->name()));
        }
        const auto [first, is_new] = m_line_of.try_emplace(found->second, record.line);
        if (!is_new) {
            fail(record, fmt::format("names node {} a second time, first in line {}",
                                     quote(record.fields[0]), first->second));
        }
        return found->second;
    }

private:
    const CableNet* m_net;
    std::string m_file_name;
    std::map<std::string, int> m_node_of;
    std::map<int, int> m_line_of;
};

}  // namespace

std::vector<StrokeRange> parse_stroke_ranges(const CableNet& net, std::string_view text,
                                             const std::string& file_name) {
    EdgeColumn edges(net, file_name);
    std::vector<StrokeRange> ranges;
    for (const CsvRecord& record : records_of(text, file_name, {"edge", "shortest", "longest"})) {
        constexpr double longest_stroke = 1e3;  // [m]
        const int edge = edges.edge(record);
        const auto [shortest, longest] =
            numbers_in<2>(record, file_name, {"shortest", "longest"}, longest_stroke);
        if (shortest > 0.0 || longest < 0.0) {
            edges.fail(record, fmt::format("the strokes go from {:g} to {:g} m, expected a range "
                                           "that holds 0",
                                           shortest, longest));
        }
        ranges.push_back({.edge = edge, .shortest = shortest, .longest = longest});
    }
    return ranges;
}

Points parse_loads(const CableNet& net, std::string_view text, const std::string& file_name) {
    NodeColumn nodes(net, file_name);
    Points loads = Points::Zero(3, net.node_count());
    for (const CsvRecord& record : records_of(text, file_name, {"id", "x", "y", "z"})) {
        const int node = nodes.node(record);
        const auto [x, y, z] = numbers_in<3>(record, file_name, {"x", "y", "z"}, largest_load);
        loads.col(node) << x, y, z;
    }
    return loads;
}

std::vector<NodeWeights> parse_node_weights(const CableNet& net, std::string_view text,
                                            const std::string& file_name) {
    NodeColumn nodes(net, file_name);
    std::vector<NodeWeights> result;
    for (const CsvRecord& record : records_of(text, file_name, {"id", "normal", "tangential"})) {
        const int node = nodes.node(record);
        if (net.free_index(node) < 0) {
            nodes.fail(record, fmt::format("node {} is a support, which does not move; expected a "
                                           "free node",
                                           quote(record.fields[0])));
        }
        constexpr double largest_weight = 1e12;
        const auto [normal, tangential] =
            numbers_in<2>(record, file_name, {"normal", "tangential"}, largest_weight);
        if (normal < 0.0 || tangential < 0.0) {
            nodes.fail(record, fmt::format("the weights are {:g} and {:g}, expected 0 or more",
                                           normal, tangential));
        }
        result.push_back({.node = node, .normal = normal, .tangential = tangential});
    }
    return result;
}

}  // namespace taut
