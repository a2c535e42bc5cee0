// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/ply_reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <optional>
#include <sstream>

#include "files/message.hpp"
#include "files/parse_number.hpp"
#include "files/plain_text.hpp"
#include "interchange/polygon_triangles.hpp"
#include "taut/files/input_error.hpp"
#include "taut/files/printable.hpp"

namespace taut {
namespace {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyTypeName {
    std::string_view name;
    PlyType type;
};
constexpr std::array<PlyTypeName, 16> ply_types{{{"char", PlyType::int8},
                                                 {"uchar", PlyType::uint8},
                                                 {"short", PlyType::int16},
                                                 {"ushort", PlyType::uint16},
                                                 {"int", PlyType::int32},
                                                 {"uint", PlyType::uint32},
                                                 {"float", PlyType::float32},
                                                 {"double", PlyType::float64},
                                                 {"int8", PlyType::int8},
                                                 {"uint8", PlyType::uint8},
                                                 {"int16", PlyType::int16},
                                                 {"uint16", PlyType::uint16},
                                                 {"int32", PlyType::int32},
                                                 {"uint32", PlyType::uint32},
                                                 {"float32", PlyType::float32},
                                                 {"float64", PlyType::float64}}};

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    std::optional<PlyType> count_type;  ///< of a list
};

struct PlyElement {
    std::string name;
    std::int64_t count = 0;
    std::vector<PlyProperty> properties;
};

class PlyReader {
public:
    PlyReader(std::string_view content, std::string file_name)
        : m_rest(content), m_file_name(std::move(file_name)) {}

    PlyContent read() {
        const std::string_view whole = m_rest;
        read_header();
        if (m_is_text) {
            require_last_line_break(whole, m_file_name);
        }
        for (const PlyElement& element : m_elements) {
            read_element(element);
        }
        if (m_is_text) {
            skip_blanks();
        }
        if (!m_rest.empty()) {
            fail("goes on behind the last element of its header");
        }
        return std::move(m_content);
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(m_file_name, m_where.empty() ? std::to_string(m_line) : m_where, what);
    }

    std::vector<std::string> header_words() {
        const size_t end = m_rest.find('\n');
        if (end == std::string_view::npos) {
            fail("ends within the header of PLY, expected end_header");
        }
        std::istringstream line{std::string(m_rest.substr(0, end))};
        m_rest.remove_prefix(end + 1);
        ++m_line;
        std::vector<std::string> words;
        for (std::string word; line >> word;) {
            words.push_back(word);
        }
        return words;
    }

    [[nodiscard]] PlyType type_of(const std::string& name) const {
        const auto* const found = std::ranges::find(ply_types, name, &PlyTypeName::name);
        if (found == ply_types.end()) {
            fail(
                fmt::format("names the type {}, expected char, uchar, short, ushort, int, uint, "
                            "float or double",
                            quote(name)));
        }
        return found->type;
    }

    void read_header() {
        header_words();  // "ply"
        bool has_format = false;
        while (true) {
            const std::vector<std::string> words = header_words();
            if (words.empty() || words[0] == "comment" || words[0] == "obj_info") {
                continue;
            }
            if (words[0] == "end_header") {
                ++m_line;
                break;
            }
            if (words[0] == "format" && words.size() == 3) {
                read_format(words[1]);
                has_format = true;
            } else if (words[0] == "element" && words.size() == 3) {
                add_element(words[1], words[2]);
            } else if (words[0] == "property" && words.size() == 3) {
                add_property({.name = words[2], .type = type_of(words[1]), .count_type = {}});
            } else if (words[0] == "property" && words.size() == 5 && words[1] == "list") {
                add_property(
                    {.name = words[4], .type = type_of(words[3]), .count_type = type_of(words[2])});
            } else {
                fail(
                    fmt::format("starts with {}, expected a line of the header of PLY: format, "
                                "element, property, comment or end_header",
                                quote(words[0])));
            }
        }
        if (!has_format) {
            fail("the header ends without a format");
        }
    }

    void read_format(const std::string& name) {
        m_is_text = name == "ascii";
        m_is_swapped =
            name == (std::endian::native == std::endian::little ? "binary_big_endian"
                                                                : "binary_little_endian");
        if (!m_is_text && name != "binary_big_endian" && name != "binary_little_endian") {
            fail(
                fmt::format("the format is {}, expected ascii, binary_little_endian or "
                            "binary_big_endian",
                            quote(name)));
        }
    }

    void add_element(const std::string& name, const std::string& count) {
        const auto number = parse_number(count);
        if (!number || *number < 0.0 || *number > 1e9 || *number != std::floor(*number)) {
            fail(fmt::format("there are {} elements, expected a whole number", quote(count)));
        }
        m_elements.push_back(
            {.name = name, .count = static_cast<std::int64_t>(*number), .properties = {}});
    }

    void add_property(PlyProperty property) {
        if (m_elements.empty()) {
            fail("a property comes before the first element");
        }
        m_elements.back().properties.push_back(std::move(property));
    }

    void read_element(const PlyElement& element) {
        const bool is_vertex = element.name == "vertex";
        const bool is_face = element.name == "face";
        std::array<const PlyProperty*, 3> axes{};
        const PlyProperty* corners = nullptr;
        for (const PlyProperty& property : element.properties) {
            for (size_t k = 0; k < 3; ++k) {
                if (is_vertex && !property.count_type &&
                    property.name == std::string(1, "xyz"[k])) {
                    axes[k] = &property;
                }
            }
            if (is_face && property.count_type &&
                (property.name == "vertex_indices" || property.name == "vertex_index")) {
                corners = &property;
            }
        }
        if (is_vertex && std::ranges::count(axes, nullptr) > 0) {
            fail("the vertices have no x, y and z");
        }
        if (is_face && corners == nullptr) {
            fail("the faces have no list vertex_indices");
        }
        if (element.properties.empty()) {
            return;  // Holds nothing, however often.
        }
        for (std::int64_t i = 0; i < element.count; ++i) {
            if (!m_is_text) {
                m_where = fmt::format("{} {}", printable(element.name), i);
            }
            Eigen::Vector3d position = Eigen::Vector3d::Zero();
            for (const PlyProperty& property : element.properties) {
                if (property.count_type) {
                    std::vector<int> list = read_list(property, &property == corners);
                    if (&property == corners) {
                        m_content.faces.push_back(std::move(list));
                    }
                    continue;
                }
                const double value = number(property.type);
                for (size_t k = 0; k < 3; ++k) {
                    if (&property == axes[k]) {
                        if (!std::isfinite(value)) {
                            fail(
                                fmt::format("{} is {}, expected a finite number", "xyz"[k], value));
                        }
                        position(static_cast<Eigen::Index>(k)) = value;
                    }
                }
            }
            if (is_vertex) {
                m_content.vertices.push_back(position);
            }
        }
        m_where.clear();
    }

    std::vector<int> read_list(const PlyProperty& property, bool is_kept) {
        const double count = number(*property.count_type);
        if (!(count >= 0.0) || count != std::floor(count) ||
            count > static_cast<double>(m_rest.size())) {
            fail(fmt::format("a list has {} entries, more than there are", count));
        }
        if (is_kept && (count < 3.0 || count > static_cast<double>(most_corners))) {
            fail(fmt::format("a face has {} corners, expected 3 to {}", count, most_corners));
        }
        std::vector<int> list;
        for (int k = 0; k < static_cast<int>(count); ++k) {
            const double value = number(property.type);
            if (is_kept) {
                if (!(value >= 0.0) || value != std::floor(value) || value > 1e9) {
                    fail(fmt::format("a face names the vertex {}, expected one from 0", value));
                }
                list.push_back(static_cast<int>(value));
            }
        }
        return list;
    }

    void skip_blanks() {
        size_t blanks = 0;
        for (; blanks < m_rest.size(); ++blanks) {
            const char c = m_rest[blanks];
            if (c == '\n') {
                ++m_line;
            } else if (c != ' ' && c != '\t' && c != '\r') {
                break;
            }
        }
        m_rest.remove_prefix(blanks);
    }

    double number(PlyType type) {
        if (m_is_text) {
            skip_blanks();
            const size_t end = std::min(m_rest.find_first_of(" \t\r\n"), m_rest.size());
            const std::string_view word = m_rest.substr(0, end);
            if (word.empty()) {
                fail("ends before the elements of its header");
            }
            m_rest.remove_prefix(end);
            const auto value = parse_number(word);
            if (!value) {
                fail(fmt::format("holds {}, expected a finite number", quote(word)));
            }
            return *value;
        }
        switch (type) {
            case PlyType::int8:
                return static_cast<double>(bytes<std::int8_t>());
            case PlyType::uint8:
                return static_cast<double>(bytes<std::uint8_t>());
            case PlyType::int16:
                return static_cast<double>(bytes<std::int16_t>());
            case PlyType::uint16:
                return static_cast<double>(bytes<std::uint16_t>());
            case PlyType::int32:
                return static_cast<double>(bytes<std::int32_t>());
            case PlyType::uint32:
                return static_cast<double>(bytes<std::uint32_t>());
            case PlyType::float32:
                return static_cast<double>(bytes<float>());
            case PlyType::float64:
                break;
        }
        return bytes<double>();
    }

    template <typename T>
    T bytes() {
        std::array<char, sizeof(T)> raw{};
        if (m_rest.size() < raw.size()) {
            fail("ends before the elements of its header");
        }
        std::memcpy(raw.data(), m_rest.data(), raw.size());
        m_rest.remove_prefix(raw.size());
        if (m_is_swapped) {
            std::ranges::reverse(raw);
        }
        return std::bit_cast<T>(raw);
    }

    std::string_view m_rest;
    std::string m_file_name;
    std::string m_where;  ///< in a binary file
    int m_line = 0;
    bool m_is_text = true;
    bool m_is_swapped = false;
    std::vector<PlyElement> m_elements;
    PlyContent m_content;
};

}  // namespace

PlyContent read_ply(std::string_view content, const std::string& file_name) {
    return PlyReader(content, file_name).read();
}

}  // namespace taut
