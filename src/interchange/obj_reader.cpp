// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "files/plain_text.hpp"
#include "interchange/edge_collection.hpp"
#include "interchange/obj_statements.hpp"
#include "taut/files/input_error.hpp"
#include "taut/interchange/obj.hpp"

namespace taut {
namespace {

class ObjReader {
public:
    explicit ObjReader(const std::string& file_name) {
        m_structure.file = file_name;
        m_structure.format = "OBJ";
    }

    ImportedStructure read(std::string_view text) {
        for_each_obj_statement(text, m_structure.file,
                               [this](const ObjStatement& statement) { take(statement); });
        if (m_structure.nodes.empty()) {
            throw InputError(m_structure.file, "", "holds no vertex, expected lines v x y z");
        }
        m_edges.write_to(m_structure);
        return std::move(m_structure);
    }

private:
    void take(const ObjStatement& statement) {
        if (statement.keyword == "v") {
            m_structure.nodes.push_back({.id = std::to_string(m_structure.nodes.size() + 1),
                                         .place = std::to_string(statement.line),
                                         .position = statement.position()});
        } else if (statement.keyword == "l") {
            read_path(statement, 2, false);
        } else if (statement.keyword == "f") {
            read_path(statement, 3, true);
        } else if (statement.keyword == "g") {
            m_in_supports =
                std::ranges::find(statement.arguments, "supports") != statement.arguments.end();
        } else {
            read_points(statement);
        }
    }

    [[nodiscard]] int node_at(const ObjStatement& statement, const std::string& argument) const {
        return statement.vertex(argument, static_cast<int>(m_structure.nodes.size()));
    }

    void read_path(const ObjStatement& statement, size_t least, bool is_face) {
        const std::vector<std::string>& arguments = statement.arguments;
        if (arguments.size() < least) {
            statement.fail(
                fmt::format("has {} vertices, expected at least {}", arguments.size(), least));
        }
        const size_t sides = arguments.size() - (is_face ? 0 : 1);
        for (size_t i = 0; i < sides; ++i) {
            const int s = node_at(statement, arguments[i]);
            const int t = node_at(statement, arguments[(i + 1) % arguments.size()]);
            if (s == t) {
                statement.fail(fmt::format("names the vertex {} twice in a row", s + 1));
            }
            if (is_face) {
                m_edges.add_side(s, t, std::to_string(statement.line));
            } else {
                m_edges.add(s, t, std::to_string(statement.line));
            }
        }
    }

    void read_points(const ObjStatement& statement) {
        for (const std::string& argument : statement.arguments) {
            const int node = node_at(statement, argument);
            m_structure.nodes[node].is_support |= m_in_supports;
        }
    }

    ImportedStructure m_structure;
    EdgeCollection m_edges;
    bool m_in_supports = false;
};

}  // namespace

ImportedStructure parse_obj(std::string_view text, const std::string& file_name) {
    return ObjReader(file_name).read(table_text(text, file_name));
}

}  // namespace taut
