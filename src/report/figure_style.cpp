// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/figure_style.hpp"

#include <fmt/core.h>

#include <array>
#include <iterator>
#include <string_view>

namespace taut::report {
namespace {

struct Rule {
    std::string_view selector;
    std::string_view colour;  ///< which property
    std::string_view light;
    std::string_view dark;
    std::string_view rest;  ///< the same on both grounds
};

// Hues after Okabe and Ito, who chose them to be told apart with every kind of colour vision. A dot
// is a line of no length with round ends.
constexpr std::array rules{
    Rule{"text", "fill", "#222", "#ddd",
         R"(font:12px system-ui,-apple-system,"Segoe UI","DejaVu Sans",sans-serif)"},
    Rule{"path", "stroke", "#222", "#ddd", "fill:none;stroke-linecap:round;stroke-linejoin:round"},
    Rule{".frame", "stroke", "#777", "#888", "fill:none;stroke-width:1"},
    Rule{".grid", "stroke", "#e4e4e4", "#333", "stroke-width:1"},
    Rule{".interior", "stroke", "#8a949e", "#78828c", "stroke-width:1"},
    Rule{".adjustable", "stroke", "#d55e00", "#f58231", "stroke-width:1.8"},
    Rule{".free", "stroke", "#0072b2", "#56b4e9", "stroke-width:3.2"},
    Rule{".support", "fill", "#111", "#fff", "stroke:none"},
    Rule{".true", "stroke", "#f0b93a", "#a87400", "stroke-width:5.4"},
    Rule{".link", "stroke", "#9a9a9a", "#888", "stroke-width:.8"},
    Rule{".predicted", "stroke", "#00527f", "#8fd3ff", "stroke-width:2.4"},
    Rule{".error", "stroke", "#b5177a", "#ff7cc8", "stroke-width:2.6"},
    Rule{".all-errors", "stroke", "#333", "#ccc", "stroke-width:1.5;stroke-opacity:.6"},
    Rule{".mean", "stroke", "#0095d9", "#56b4e9", "stroke-width:1.6"},
    Rule{".std", "stroke", "#d55e00", "#f58231", "stroke-width:1.2"},
    Rule{".faint", "stroke", "#b9c0c7", "#4a525a", "stroke-width:.8"},
    Rule{".slack", "stroke", "#d55e00", "#f58231", "stroke-width:2.4"},
    Rule{".marked", "stroke", "#d55e00", "#f58231", "stroke-width:2.4"},
    Rule{".unobserved", "stroke", "#999", "#8a8a8a", "stroke-width:2.4"},
    Rule{".bar", "fill", "#7fb0d0", "#3f7ba3", "stroke:none"},
    Rule{".series0", "stroke", "#0072b2", "#56b4e9", "stroke-width:1.8"},
    Rule{".series1", "stroke", "#d55e00", "#f58231", "stroke-width:1.8"},
    Rule{".series2", "stroke", "#009e73", "#2fd0a2", "stroke-width:1.8"},
    Rule{".series3", "stroke", "#b5177a", "#ff7cc8", "stroke-width:1.8"},
    Rule{".series4", "stroke", "#a87400", "#f0b93a", "stroke-width:1.8"},
    Rule{".series5", "stroke", "#5a6067", "#a3abb3", "stroke-width:1.8"},
    Rule{".best", "stroke", "#111", "#fff", "stroke-width:1.2;stroke-dasharray:5 4"},
    Rule{".outline", "stroke", "#777", "#ddd", ""},
    Rule{".arm", "stroke", "#222", "#ddd", "stroke-width:1.2"},
};

}  // namespace

std::string figure_style() {
    std::string css;
    for (const Rule& rule : rules) {
        fmt::format_to(std::back_inserter(css), "svg {}{{{}:{};{}}}\n", rule.selector, rule.colour,
                       rule.light, rule.rest);
    }
    return css;
}

std::string dark_figure_style() {
    std::string css;
    for (const Rule& rule : rules) {
        fmt::format_to(std::back_inserter(css), "svg {}{{{}:{}}}\n", rule.selector, rule.colour,
                       rule.dark);
    }
    return css;
}

}  // namespace taut::report
