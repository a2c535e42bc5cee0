// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/report/report_html.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "report/markup.hpp"
#include "report/viewer_page.hpp"

namespace taut {
namespace report {
namespace {

/// The page's title: the name of the net.
std::string title(const ResultFile& result) {
    return std::visit(
        [](const auto& content) -> std::string {
            if constexpr (requires { content.net; }) {
                return content.net.name().empty() ? "A net" : content.net.name();
            } else if constexpr (requires { content.strategies; }) {
                return "Simulated jobs";
            } else {
                return "Comparison of methods";
            }
        },
        result.content);
}

/// JSON for a script element, which ends at the first "</script" and changes its mode at "<!--". So
/// each "<", which occurs in strings only, is escaped.
std::string in_script(std::string_view json) {
    std::string text;
    text.reserve(json.size());
    for (const char c : json) {
        c == '<' ? void(text += "\\u003c") : text.push_back(c);
    }
    return text;
}

}  // namespace
}  // namespace report

bool has_report_viewer() {
    return !report::viewer_page().empty();
}

std::string report_html(const ResultFile& result) {
    using namespace report;
    std::string_view rest = viewer_page();
    if (rest.empty()) {
        throw std::runtime_error("this taut was built without Node.js and has no report viewer");
    }
    const std::pair<std::string_view, std::string> parts[] = {
        {"<!--taut:title-->", escape(title(result))},
        {"<!--taut:result-->", in_script(result.json)},
    };
    std::string page;
    for (const auto& [place, text] : parts) {
        const size_t found = rest.find(place);
        if (found == std::string_view::npos) {
            throw std::logic_error(fmt::format("the viewer's page has no place {}", place));
        }
        page += rest.substr(0, found);
        page += text;
        rest.remove_prefix(found + place.size());
    }
    return page.append(rest);
}

}  // namespace taut
