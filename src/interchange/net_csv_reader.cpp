// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "files/csv_reader.hpp"
#include "files/message.hpp"
#include "files/parse_number.hpp"
#include "files/plain_text.hpp"
#include "interchange/edge_collection.hpp"
#include "taut/files/input_error.hpp"
#include "taut/interchange/net_csv.hpp"

namespace taut {
namespace {

/// The records of a file behind its header, with fields by the names in the header.
class Table {
public:
    /// @param leading names of the first columns, whatever the header calls them
    Table(std::string_view text, const std::string& file_name, std::vector<std::string> leading)
        : m_file_name(file_name),
          m_reader(table_text(text, file_name), file_name),
          m_names(std::move(leading)) {
        const size_t least = m_names.size();
        next(least);
        if (m_record.line == 0) {
            throw InputError(file_name, "", "is empty, expected a header and a line an item");
        }
        if (std::ranges::all_of(m_record.fields,
                                [](const std::string& f) { return parse_number(f).has_value(); })) {
            fail("holds numbers only, expected a header");
        }
        m_names.insert(m_names.end(), m_record.fields.begin() + static_cast<long>(least),
                       m_record.fields.end());
    }

    /// Goes to the next record, if there is one.
    bool next() { return next(m_names.size()); }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(m_file_name, std::to_string(m_record.line), what);
    }
    [[nodiscard]] std::string place() const { return std::to_string(m_record.line); }
    [[nodiscard]] const std::vector<std::string>& names() const { return m_names; }
    [[nodiscard]] const std::string& field(size_t column) const { return m_record.fields[column]; }

    [[nodiscard]] std::optional<size_t> column(const std::string& name) const {
        const auto found = std::ranges::find(m_names, name);
        return found == m_names.end() ? std::nullopt
                                      : std::optional<size_t>(found - m_names.begin());
    }
    [[nodiscard]] double number(size_t column) const {
        const auto value = parse_number(field(column));
        if (!value) {
            fail(fmt::format("{} is {}, expected a finite number", m_names[column],
                             quote(field(column))));
        }
        return *value;
    }
    [[nodiscard]] double number(const std::string& name, double otherwise) const {
        const auto found = column(name);
        return found ? number(*found) : otherwise;
    }

private:
    bool next(size_t expected) {
        auto record = m_reader.next();
        if (!record) {
            return false;
        }
        const bool is_header = m_record.line == 0;
        m_record = std::move(*record);
        const size_t found = m_record.fields.size();
        if (is_header ? found < expected : found != expected) {
            fail(fmt::format("has {} fields, expected {}{}", found, is_header ? "at least " : "",
                             expected));
        }
        return true;
    }

    const std::string& m_file_name;
    CsvReader m_reader;
    std::vector<std::string> m_names;
    CsvRecord m_record;
};

using NodeOf = std::map<std::string, int>;

/// What stands between semicolons: names of runs, or true or 1 for all.
void read_slides(const std::string& text, ImportedNode& node) {
    node.all_slide = text == "true" || text == "1";
    for (size_t at = 0; !node.all_slide && at < text.size();) {
        const size_t end = std::min(text.find(';', at), text.size());
        const size_t first = std::min(text.find_first_not_of(' ', at), end);
        const size_t last = text.find_last_not_of(' ', end - 1);
        if (first < end) {
            node.slides.push_back(text.substr(first, last + 1 - first));
        }
        at = end + 1;
    }
}

/// Numbers of columns of which a line has all or none.
std::optional<Eigen::Vector3d> read_three(const Table& table,
                                          const std::array<const char*, 3>& names) {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    int given = 0;
    for (size_t k = 0; k < names.size(); ++k) {
        if (const auto column = table.column(names[k]); column && !table.field(*column).empty()) {
            result(static_cast<Eigen::Index>(k)) = table.number(*column);
            ++given;
        }
    }
    if (given != 0 && given != 3) {
        table.fail(fmt::format("has {} of {}, {} and {}, expected all or none", given, names[0],
                               names[1], names[2]));
    }
    return given == 3 ? std::optional(result) : std::nullopt;
}

/// Stiffness and place of a support that gives way; empty fields where it is rigid.
void read_support(const Table& table, ImportedNode& node) {
    const auto along = read_three(table, {"kxx", "kyy", "kzz"});
    const auto across = read_three(table, {"kxy", "kxz", "kyz"});
    node.support_place = read_three(table, {"x0", "y0", "z0"});
    if (along) {
        const Eigen::Vector3d k = across.value_or(Eigen::Vector3d::Zero());
        node.support_stiffness = Eigen::Matrix3d{
            {along->x(), k(0), k(1)}, {k(0), along->y(), k(2)}, {k(1), k(2), along->z()}};
    } else if (across || node.support_place) {
        table.fail("has a support that gives way without kxx, kyy and kzz");
    }
}

NodeOf read_nodes(std::string_view text, ImportedStructure& structure) {
    Table table(text, structure.file, {"id", "x", "y", "z"});
    const bool has_displacements = table.column("u") && table.column("v") && table.column("w");
    bool any_displaced = false;
    NodeOf node_of;
    while (table.next()) {
        ImportedNode node{.id = table.field(0), .place = table.place()};
        if (node.id.empty()) {
            table.fail("has an empty id");
        }
        if (!node_of.emplace(node.id, static_cast<int>(structure.nodes.size())).second) {
            table.fail(fmt::format("gives the node {} a second time", quote(node.id)));
        }
        node.position = {table.number(1), table.number(2), table.number(3)};
        if (has_displacements) {
            const Eigen::Vector3d displacement(table.number("u", 0.0), table.number("v", 0.0),
                                               table.number("w", 0.0));
            any_displaced |= !displacement.isZero(0.0);
            node.position += displacement;
        }
        node.load = {table.number("px", 0.0), table.number("py", 0.0), table.number("pz", 0.0)};
        node.is_support = table.number("is_free", 1.0) == 0.0;
        read_support(table, node);
        if (const auto slides = table.column("slides"); slides) {
            read_slides(table.field(*slides), node);
        }
        structure.nodes.push_back(std::move(node));
    }
    if (any_displaced) {
        structure.notes.emplace_back(
            "positions before the displacements u, v, w: the form is x + u");
    }
    return node_of;
}

/// The numbers of the current record, and its name if it has one.
void read_attributes(const Table& table, size_t first, ImportedEdge& edge) {
    for (size_t column = first; column < table.names().size(); ++column) {
        const std::string& name = table.names()[column];
        if (name == "id") {
            edge.id = table.field(column);
        } else if (name == "run") {
            edge.run = table.field(column);
        } else if (!table.field(column).empty()) {
            edge.numbers[name] = table.number(column);
        }
    }
    for (const char* name : {"qopt", "q0"}) {
        if (const auto found = edge.numbers.find(name); found != edge.numbers.end()) {
            edge.numbers.try_emplace("q", found->second);
        }
    }
}

void read_edges(std::string_view text, const std::string& file_name, const NodeOf& node_of,
                ImportedStructure& structure) {
    Table table(text, file_name, {"u", "v"});
    EdgeCollection edges;
    std::map<std::pair<int, int>, ImportedEdge> records;
    while (table.next()) {
        std::array<int, 2> ends{};
        for (size_t k = 0; k < 2; ++k) {
            const auto found = node_of.find(table.field(k));
            if (found == node_of.end()) {
                table.fail(fmt::format("names the node {}, which is not in {}",
                                       quote(table.field(k)), structure.file));
            }
            ends[k] = found->second;
        }
        if (ends[0] == ends[1]) {
            table.fail(fmt::format("joins the node {} to itself", quote(table.field(0))));
        }
        if (edges.contains(ends[0], ends[1])) {
            table.fail(fmt::format("joins the nodes {} and {} a second time", quote(table.field(0)),
                                   quote(table.field(1))));
        }
        edges.add(ends[0], ends[1], file_name + ":" + table.place());
        ImportedEdge& record = records[std::minmax(ends[0], ends[1])];
        read_attributes(table, 2, record);
    }
    edges.write_to(structure);
    for (ImportedEdge& edge : structure.edges) {
        ImportedEdge& record = records.at({edge.s, edge.t});
        edge.numbers = std::move(record.numbers);
        edge.run = std::move(record.run);
        edge.id = record.id.empty() ? edge.id : record.id;
    }
}

}  // namespace

ImportedStructure parse_net_csv(const NetCsv& text, const std::string& nodes_name,
                                const std::string& edges_name) {
    ImportedStructure structure;
    structure.file = nodes_name;
    structure.format = "CSV nodes and edges as of JAX FDM";
    const NodeOf node_of = read_nodes(text.nodes, structure);
    read_edges(text.edges, edges_name, node_of, structure);
    return structure;
}

}  // namespace taut
