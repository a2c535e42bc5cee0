// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/frame_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "files/csv_table.hpp"
#include "files/message.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

/// A row or column of the stiffness: a support, by its position in those of the frame, and an axis.
class Directions {
public:
    explicit Directions(const CableNet& net) : m_net(net) {}

    /// @param name such as "N4.x"
    Eigen::Index row_of(const CsvTable& table, const CsvRecord& line, const std::string& name) {
        const size_t dot = name.rfind('.');
        const size_t axis = dot == std::string::npos || dot + 2 != name.size()
                                ? std::string_view::npos
                                : std::string_view("xyz").find(name[dot + 1]);
        const int node = axis == std::string_view::npos ? -1 : m_net.find_node(name.substr(0, dot));
        if (node < 0 || !m_net.is_support(node)) {
            table.fail(line, fmt::format("{} is no support and axis of the net '{}', expected a "
                                         "name such as '{}.x'",
                                         quote(name), m_net.name(),
                                         m_net.node_id(m_net.all_supports().front())));
        }
        const auto [found, is_new] =
            m_position.try_emplace(node, static_cast<Eigen::Index>(m_supports.size()));
        if (is_new) {
            m_supports.push_back(node);
        }
        return 3 * found->second + static_cast<Eigen::Index>(axis);
    }

    [[nodiscard]] const std::vector<int>& supports() const { return m_supports; }

private:
    const CableNet& m_net;
    std::map<int, Eigen::Index> m_position;
    std::vector<int> m_supports;
};

/// Entries as the file gives them, by row and column.
using Entries = std::map<std::pair<Eigen::Index, Eigen::Index>, double>;

void add_entry(const CsvTable& table, const CsvRecord& line,
               std::pair<Eigen::Index, Eigen::Index> place, double value, Entries& entries) {
    if (const auto [found, is_new] = entries.try_emplace(place, value);
        !is_new && found->second != value) {
        table.fail(line, fmt::format("gives an entry a second time: {}, but {} before", value,
                                     found->second));
    }
}

Entries read_entries(const CsvTable& table, Directions& directions) {
    Entries entries;
    for (const CsvRecord& line : table.rows()) {
        const Eigen::Index row = directions.row_of(table, line, table.text(line, 0));
        const Eigen::Index column = directions.row_of(table, line, table.text(line, 1));
        add_entry(table, line, {row, column}, table.number(line, 2), entries);
    }
    // Of one triangle: the other is the same.
    Entries both = entries;
    for (const auto& [place, value] : entries) {
        both.try_emplace({place.second, place.first}, value);
    }
    return both;
}

Entries read_rows(const CsvTable& table, const std::vector<std::string>& header,
                  Directions& directions) {
    Entries entries;
    std::vector<Eigen::Index> columns;
    for (const CsvRecord& line : table.rows()) {
        const Eigen::Index row = directions.row_of(table, line, table.text(line, 0));
        for (size_t k = 1; k < header.size(); ++k) {
            if (columns.size() < k) {
                columns.push_back(directions.row_of(table, line, header[k]));
            }
            add_entry(table, line, {row, columns[k - 1]}, table.number(line, k), entries);
        }
    }
    return entries;
}

}  // namespace

FrameStiffness parse_frame(const CableNet& net, std::string_view text,
                           const std::string& file_name) {
    const std::vector<std::string> header = first_fields(text, file_name);
    const bool is_list = header == std::vector<std::string>{"row", "column", "stiffness"};
    if (!is_list && (header.empty() || header[0] != "dof")) {
        throw InputError(file_name, "1",
                         "expected the header dof,NODE.x,NODE.y,... of a matrix, or "
                         "row,column,stiffness of its entries");
    }
    const CsvTable table(text, file_name, {.names = header, .header = CsvColumns::Header::required},
                         "holds no stiffness");
    constexpr size_t most_supports = 1000;  // of a dense matrix of 72 MB
    Directions directions(net);
    const Entries entries =
        is_list ? read_entries(table, directions) : read_rows(table, header, directions);
    FrameStiffness frame{.supports = directions.supports(), .stiffness = {}};
    if (frame.supports.size() > most_supports) {
        throw InputError(file_name, "",
                         fmt::format("is of {} supports, expected no more than {}",
                                     frame.supports.size(), most_supports));
    }
    const auto size = static_cast<Eigen::Index>(3 * frame.supports.size());
    frame.stiffness.setZero(size, size);
    for (const auto& [place, value] : entries) {
        frame.stiffness(place.first, place.second) = value;
    }
    for (Eigen::Index i = 0; i < size; ++i) {
        if (!entries.contains({i, i})) {
            throw InputError(
                file_name, "",
                fmt::format("has no stiffness of the support {} along {} itself",
                            net.node_id(frame.supports[static_cast<size_t>(i / 3)]), "xyz"[i % 3]));
        }
    }
    try {
        static_cast<void>(on_frame(net, frame));
    } catch (const std::invalid_argument& error) {  // a NetError, too
        throw InputError(file_name, "", error.what());
    }
    return frame;
}

}  // namespace taut
