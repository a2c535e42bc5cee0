// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/surveys/survey_xml.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "files/message.hpp"
#include "files/parse_number.hpp"
#include "interchange/surveys/survey_reader.hpp"
#include "taut/files/input_error.hpp"

namespace taut {

SurveyXml::SurveyXml(const std::string& text, const std::string& file_name)
    : m_file_name(file_name) {
    m_line_starts.push_back(0);
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n') {
            m_line_starts.push_back(static_cast<std::ptrdiff_t>(i) + 1);
        }
    }
    const pugi::xml_parse_result parsed =
        m_document.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!parsed) {
        throw InputError(file_name, std::to_string(line_at(parsed.offset)),
                         fmt::format("is no XML: {}: is the file whole?", parsed.description()));
    }
}

std::vector<pugi::xml_node> SurveyXml::elements(pugi::xml_node below, std::string_view name) {
    // Step by step and not by recursion: a hostile file may be as deep as it is long.
    std::vector<pugi::xml_node> found;
    pugi::xml_node at = below.first_child();
    while (at) {
        if (local_name(at) == name) {
            found.push_back(at);
        }
        if (at.first_child()) {
            at = at.first_child();
            continue;
        }
        while (at != below && !at.next_sibling()) {
            at = at.parent();
        }
        if (at == below) {
            break;
        }
        at = at.next_sibling();
    }
    return found;
}

std::optional<double> SurveyXml::number(pugi::xml_node parent, const char* child) const {
    const pugi::xml_node node = parent.child(child);
    const std::string_view text = node.text().get();
    if (!node || text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
        return std::nullopt;
    }
    return number(node, text, child);
}

double SurveyXml::number(pugi::xml_node at, std::string_view text, std::string_view name) const {
    const size_t start = text.find_first_not_of(" \t\r\n");
    const size_t end = text.find_last_not_of(" \t\r\n");
    const auto value =
        parse_number(start == std::string_view::npos ? text : text.substr(start, end - start + 1));
    if (!value) {
        fail(at, fmt::format("{} is {}, expected a finite number", name, quote(text)));
    }
    return *value;
}

int SurveyXml::line_of(pugi::xml_node node) const {
    return line_at(node.offset_debug());
}

int SurveyXml::line_at(std::ptrdiff_t offset) const {
    const auto behind = std::ranges::upper_bound(m_line_starts, offset);
    return static_cast<int>(behind - m_line_starts.begin());
}

void SurveyXml::fail(pugi::xml_node node, const std::string& what) const {
    throw InputError(m_file_name, std::to_string(line_of(node)), what);
}

}  // namespace taut
