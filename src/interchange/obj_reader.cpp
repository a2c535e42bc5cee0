// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>
#include <utility>

#include "files/message.hpp"
#include "files/parse_number.hpp"
#include "files/plain_text.hpp"
#include "interchange/edge_collection.hpp"
#include "taut/files/input_error.hpp"
#include "taut/interchange/obj.hpp"

namespace taut {
namespace {

/// What says nothing of nodes and edges.
constexpr std::array<std::string_view, 7> ignored{"vn", "vt", "vp", "s", "mtllib", "usemtl", "o"};

class ObjReader {
public:
    explicit ObjReader(const std::string& file_name) {
        m_structure.file = file_name;
        m_structure.format = "OBJ";
    }

    ImportedStructure read(std::string_view text) {
        while (!text.empty()) {
            const size_t end = std::min(text.find('\n'), text.size());
            ++m_line;
            read_line(text.substr(0, end));
            text.remove_prefix(std::min(end + 1, text.size()));
        }
        if (m_structure.nodes.empty()) {
            throw InputError(m_structure.file, "", "holds no vertex, expected lines v x y z");
        }
        m_edges.write_to(m_structure);
        return std::move(m_structure);
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(m_structure.file, std::to_string(m_line), what);
    }

    void read_line(std::string_view line) {
        std::istringstream words{std::string(line.substr(0, line.find('#')))};
        std::string keyword;
        if (!(words >> keyword) || std::ranges::find(ignored, keyword) != ignored.end()) {
            return;
        }
        std::vector<std::string> arguments;
        for (std::string word; words >> word;) {
            arguments.push_back(word);
        }
        if (keyword == "v") {
            read_vertex(arguments);
        } else if (keyword == "l") {
            read_path(arguments, 2, false);
        } else if (keyword == "f") {
            read_path(arguments, 3, true);
        } else if (keyword == "g") {
            m_in_supports = std::ranges::find(arguments, "supports") != arguments.end();
        } else if (keyword == "p") {
            read_points(arguments);
        } else {
            fail(fmt::format("starts with {}, expected v, l, f or another keyword of OBJ",
                             quote(keyword)));
        }
    }

    void read_vertex(const std::vector<std::string>& arguments) {
        if (arguments.size() < 3) {
            fail(fmt::format("has {} coordinates, expected 3", arguments.size()));
        }
        ImportedNode node{.id = std::to_string(m_structure.nodes.size() + 1),
                          .place = std::to_string(m_line)};
        for (size_t k = 0; k < 3; ++k) {
            const auto number = parse_number(arguments[k]);
            if (!number) {
                fail(fmt::format("{} is {}, expected a finite number", "xyz"[k],
                                 quote(arguments[k])));
            }
            node.position(static_cast<Eigen::Index>(k)) = *number;
        }
        m_structure.nodes.push_back(std::move(node));
    }

    /// The node of "7", "-1" (the last so far) or "7/1/3".
    [[nodiscard]] int node_at(const std::string& text) const {
        const auto count = static_cast<int>(m_structure.nodes.size());
        int number = 0;
        const std::string vertex = text.substr(0, text.find('/'));
        const auto [end, error] =
            std::from_chars(vertex.data(), vertex.data() + vertex.size(), number);
        if (error != std::errc() || end != vertex.data() + vertex.size() || number == 0 ||
            number > count || number < -count) {
            fail(fmt::format("names the vertex {}, expected 1 to {}, or -1 to -{} from the end",
                             quote(text), count, count));
        }
        return number > 0 ? number - 1 : count + number;
    }

    void read_path(const std::vector<std::string>& arguments, size_t least, bool is_face) {
        if (arguments.size() < least) {
            fail(fmt::format("has {} vertices, expected at least {}", arguments.size(), least));
        }
        const size_t sides = arguments.size() - (is_face ? 0 : 1);
        for (size_t i = 0; i < sides; ++i) {
            const int s = node_at(arguments[i]);
            const int t = node_at(arguments[(i + 1) % arguments.size()]);
            if (s == t) {
                fail(fmt::format("names the vertex {} twice in a row", s + 1));
            }
            if (is_face) {
                m_edges.add_side(s, t, std::to_string(m_line));
            } else {
                m_edges.add(s, t, std::to_string(m_line));
            }
        }
    }

    void read_points(const std::vector<std::string>& arguments) {
        for (const std::string& argument : arguments) {
            const int node = node_at(argument);
            m_structure.nodes[node].is_support |= m_in_supports;
        }
    }

    ImportedStructure m_structure;
    EdgeCollection m_edges;
    int m_line = 0;
    bool m_in_supports = false;
};

}  // namespace

ImportedStructure parse_obj(std::string_view text, const std::string& file_name) {
    return ObjReader(file_name).read(plain_text(text, file_name));
}

}  // namespace taut
