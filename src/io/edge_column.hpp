// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/core.h>

#include <map>
#include <string>
#include <vector>

#include "files/csv_reader.hpp"
#include "files/message.hpp"
#include "taut/files/input_error.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The edges of a file, each named once.
class EdgeColumn {
public:
    EdgeColumn(const CableNet& net, const std::string& file_name)
        : m_net(net), m_file_name(file_name), m_line_of(net.edge_count(), 0) {
        for (int e = 0; e < net.edge_count(); ++e) {
            m_edge_of.emplace(net.edge_id(e), e);
        }
    }

    [[noreturn]] void fail(const CsvRecord& record, const std::string& what) const {
        throw InputError(m_file_name, std::to_string(record.line), what);
    }

    /// The edge of a name, any number of times.
    [[nodiscard]] int find(const CsvRecord& record, const std::string& id) const {
        const auto found = m_edge_of.find(id);
        if (found == m_edge_of.end()) {
            fail(record, fmt::format("{} is no edge of the net '{}'", quote(id), m_net.name()));
        }
        return found->second;
    }

    /// The edge that the first field of a record names.
    int edge(const CsvRecord& record) {
        const std::string& id = record.fields[0];
        const int found = find(record, id);
        int& line = m_line_of[found];
        if (line != 0) {
            fail(record,
                 fmt::format("names edge {} a second time, first in line {}", quote(id), line));
        }
        line = record.line;
        return found;
    }

private:
    const CableNet& m_net;
    const std::string& m_file_name;
    std::map<std::string, int> m_edge_of;
    std::vector<int> m_line_of;
};

}  // namespace taut
