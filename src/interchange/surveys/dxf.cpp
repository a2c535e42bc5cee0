// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "files/message.hpp"
#include "files/parse_number.hpp"
#include "interchange/surveys/survey_reader.hpp"
#include "taut/files/input_error.hpp"
#include "taut/files/printable.hpp"

namespace taut {
namespace {

/// A code and its value, on two lines.
struct DxfPair {
    int code = 0;
    std::string_view value;
    int line = 0;  ///< of the value
};

/// Takes pairs off a DXF file.
class DxfPairs {
public:
    DxfPairs(const std::vector<TextLine>& lines, const std::string& file_name)
        : m_lines(lines), m_file_name(file_name) {}

    [[nodiscard]] DxfPair next() {
        if (m_at + 2 > m_lines.size()) {
            throw InputError(m_file_name, std::to_string(m_lines.size()),
                             "ends before the pair 0, EOF that ends a DXF file: is it whole?");
        }
        const std::string_view code = trimmed(m_lines[m_at].text);
        DxfPair pair{.value = trimmed(m_lines[m_at + 1].text), .line = m_lines[m_at + 1].number};
        const auto [rest, error] =
            std::from_chars(code.data(), code.data() + code.size(), pair.code);
        if (error != std::errc() || rest != code.data() + code.size()) {
            throw InputError(m_file_name, std::to_string(m_lines[m_at].number),
                             fmt::format("is {}, expected the number of a DXF code", quote(code)));
        }
        m_at += 2;
        return pair;
    }

    [[nodiscard]] double number(const DxfPair& pair) const {
        const auto value = parse_number(pair.value);
        if (!value) {
            throw InputError(m_file_name, std::to_string(pair.line),
                             fmt::format("code {} is {}, expected a finite number", pair.code,
                                         quote(pair.value)));
        }
        return *value;
    }

private:
    const std::vector<TextLine>& m_lines;
    const std::string& m_file_name;
    size_t m_at = 0;
};

/// A POINT or TEXT.
struct DxfEntity {
    int line = 0;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    std::string text;
};

struct DxfContent {
    std::vector<DxfEntity> points;
    std::vector<DxfEntity> texts;
    std::map<std::string, int> others;  ///< kinds of entities that are left out, counted
    std::optional<int> unit;            ///< $INSUNITS
};

/// Puts an entity that has ended where it belongs.
void file_entity(const std::string& kind, DxfEntity entity, DxfContent& content) {
    if (kind == "POINT") {
        content.points.push_back(std::move(entity));
    } else if ((kind == "TEXT" || kind == "MTEXT") && !entity.text.empty()) {
        content.texts.push_back(std::move(entity));
    } else if (!kind.empty()) {
        ++content.others[kind];
    }
}

DxfContent read_dxf_content(const std::vector<TextLine>& lines, const std::string& file_name) {
    DxfContent content;
    DxfPairs pairs(lines, file_name);
    std::string section;
    std::string variable;
    std::string kind;  // of the entity at work; empty: none
    DxfEntity entity;
    bool names_section = false;
    for (DxfPair pair = pairs.next(); !(pair.code == 0 && pair.value == "EOF");
         pair = pairs.next()) {
        if (pair.code == 0) {
            if (section == "ENTITIES") {
                file_entity(kind, std::move(entity), content);
            }
            names_section = pair.value == "SECTION";
            const bool is_entity =
                section == "ENTITIES" && !names_section && pair.value != "ENDSEC";
            section = pair.value == "ENDSEC" ? "" : section;
            kind = is_entity ? std::string(pair.value) : "";
            entity = {.line = pair.line};
        } else if (names_section && pair.code == 2) {
            section = pair.value;
            names_section = false;
        } else if (section == "HEADER" && pair.code == 9) {
            variable = pair.value;
        } else if (section == "HEADER" && variable == "$INSUNITS" && pair.code == 70) {
            content.unit = static_cast<int>(pairs.number(pair));
        } else if (kind == "POINT" || kind == "TEXT" || kind == "MTEXT") {
            if (pair.code == 10 || pair.code == 20 || pair.code == 30) {
                entity.place(pair.code / 10 - 1) = pairs.number(pair);
            } else if (pair.code == 1) {
                entity.text = pair.value;
            }
        }
    }
    return content;
}

std::optional<double> dxf_unit(std::optional<int> code) {
    static const std::map<int, const char*> names{{1, "in"}, {2, "ft"}, {4, "mm"},
                                                  {5, "cm"}, {6, "m"},  {21, "us-ft"}};
    const auto found = code ? names.find(*code) : names.end();
    return found == names.end() ? std::nullopt : length_of_unit(found->second);
}

namespace dxf_geometry = boost::geometry;
using DxfPlace = dxf_geometry::model::point<double, 3, dxf_geometry::cs::cartesian>;
using DxfTree =
    dxf_geometry::index::rtree<std::pair<DxfPlace, size_t>, dxf_geometry::index::quadratic<16>>;

DxfTree tree_of(const std::vector<DxfEntity>& entities) {
    std::vector<std::pair<DxfPlace, size_t>> places;
    places.reserve(entities.size());
    for (size_t i = 0; i < entities.size(); ++i) {
        const Eigen::Vector3d& p = entities[i].place;
        places.emplace_back(DxfPlace(p.x(), p.y(), p.z()), i);
    }
    return DxfTree(places);
}

size_t nearest_in(const DxfTree& tree, const Eigen::Vector3d& p) {
    std::vector<std::pair<DxfPlace, size_t>> found;
    tree.query(dxf_geometry::index::nearest(DxfPlace(p.x(), p.y(), p.z()), 1U),
               std::back_inserter(found));
    return found.front().second;
}

/// Texts that say a point's height, as plans show it beside the name.
bool is_height_text(const DxfEntity& text, const std::vector<DxfEntity>& points,
                    const DxfTree& tree) {
    std::string digits = text.text;
    std::ranges::replace(digits, ',', '.');
    const auto value = parse_number(digits);
    if (!value || digits.find('.') == std::string::npos) {
        return false;
    }
    const auto decimals = static_cast<double>(digits.size() - digits.find('.') - 1);
    return std::abs(*value - points[nearest_in(tree, text.place)].place.z()) <=
           std::pow(10.0, -decimals);
}

}  // namespace

ForeignSurvey read_dxf(const std::string& text, const std::string& file_name) {
    DxfContent content = read_dxf_content(lines_of(text, file_name), file_name);
    ForeignSurvey survey{.format = "DXF", .unit = dxf_unit(content.unit)};
    for (const auto& [kind, count] : content.others) {
        survey.left_out.push_back(
            {.line = 0, .reason = fmt::format("{} entities {}", count, printable(kind))});
    }
    if (content.points.empty()) {
        throw InputError(file_name, "", "holds no POINT among its ENTITIES, expected one a target");
    }
    const DxfTree points = tree_of(content.points);
    std::erase_if(content.texts, [&](const DxfEntity& one) {
        return is_height_text(one, content.points, points);
    });
    size_t named = 0;
    const DxfTree texts = tree_of(content.texts);
    for (size_t i = 0; i < content.points.size(); ++i) {
        const DxfEntity& entity = content.points[i];
        SurveyPoint point{.position = entity.place, .line = entity.line};
        if (!content.texts.empty()) {
            // The text that is nearest to the point, if the point is the nearest to that text, too.
            const DxfEntity& name = content.texts[nearest_in(texts, entity.place)];
            if (nearest_in(points, name.place) == i) {
                point.id = name.text;
                ++named;
            }
        }
        survey.points.push_back(std::move(point));
    }
    survey.notes.push_back(fmt::format(
        "columns: POINT by codes 10, 20, 30 as x, y, z; the TEXT beside it as id, of {} "
        "of {}",
        named, survey.points.size()));
    return survey;
}

}  // namespace taut
