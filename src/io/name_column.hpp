// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/core.h>

#include <map>
#include <string>
#include <utility>

#include "files/csv_table.hpp"
#include "files/message.hpp"
#include "survey/node_names.hpp"

namespace taut {

/// The edges or nodes that the first column of a table names.
class NameColumn {
public:
    static NameColumn of_edges(const CsvTable& table, const CableNet& net) {
        std::map<std::string, int> edge_of;
        for (int e = 0; e < net.edge_count(); ++e) {
            edge_of.emplace(net.edge_id(e), e);
        }
        return {table, net, "edge", std::move(edge_of)};
    }
    static NameColumn of_nodes(const CsvTable& table, const CableNet& net) {
        return {table, net, "node", nodes_by_name(net)};
    }

    /// The index of what a row names.
    /// @throws InputError for another name
    [[nodiscard]] int index(const CsvRecord& row) const {
        const std::string& name = m_table.text(row, 0);
        const auto found = m_index_of.find(name);
        if (found == m_index_of.end()) {
            m_table.fail(row,
                         fmt::format("{} is no {} of the net '{}'", quote(name), m_kind, m_net));
        }
        return found->second;
    }

    /// index(), of each name once.
    /// @throws InputError as index(), and for a name that a row before has
    int unique_index(const CsvRecord& row) {
        const int found = index(row);
        const auto [first, is_new] = m_line_of.try_emplace(found, row.line);
        if (!is_new) {
            m_table.fail(row, fmt::format("names {} {} a second time, first in line {}", m_kind,
                                          quote(m_table.text(row, 0)), first->second));
        }
        return found;
    }

private:
    NameColumn(const CsvTable& table, const CableNet& net, const char* kind,
               std::map<std::string, int> index_of)
        : m_table(table), m_net(net.name()), m_kind(kind), m_index_of(std::move(index_of)) {}

    const CsvTable& m_table;
    std::string m_net;
    const char* m_kind;
    std::map<std::string, int> m_index_of;
    std::map<int, int> m_line_of;
};

}  // namespace taut
