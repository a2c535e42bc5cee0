// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/svg.hpp"

#include <fmt/core.h>

#include <iterator>

#include "report/figure_style.hpp"
#include "report/markup.hpp"

namespace taut::report {
namespace {

std::string_view to_string(SvgBody::Anchor anchor) {
    switch (anchor) {
        case SvgBody::Anchor::start:
            return "start";
        case SvgBody::Anchor::middle:
            return "middle";
        case SvgBody::Anchor::end:
            break;
    }
    return "end";
}

std::string svg_start(const Drawing& drawing, std::string_view attributes) {
    return fmt::format(
        R"(<svg{} viewBox="0 0 {:g} {:g}" width="{:g}" height="{:g}" role="img" aria-label="{}">)",
        attributes, drawing.width, drawing.height, drawing.width, drawing.height,
        escape(drawing.title));
}

}  // namespace

void SvgBody::path(std::string_view style, const PathData& data, std::string_view attributes) {
    if (!data.empty()) {
        fmt::format_to(std::back_inserter(m_body), "<path class=\"{}\"{}{} d=\"{}\"/>\n", style,
                       attributes.empty() ? "" : " ", attributes, data.text());
    }
}

void SvgBody::line(std::string_view style, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    fmt::format_to(std::back_inserter(m_body),
                   "<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n",
                   style, from.x(), from.y(), to.x(), to.y());
}

void SvgBody::rectangle(std::string_view style, const Eigen::Vector2d& corner,
                        const Eigen::Vector2d& size, std::string_view attributes) {
    fmt::format_to(
        std::back_inserter(m_body),
        "<rect class=\"{}\"{}{} x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
        style, attributes.empty() ? "" : " ", attributes, corner.x(), corner.y(), size.x(),
        size.y());
}

void SvgBody::text(const Eigen::Vector2d& place, std::string_view text, Anchor anchor) {
    fmt::format_to(std::back_inserter(m_body),
                   "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", place.x(),
                   place.y(), to_string(anchor), escape(text));
}

void SvgBody::upward_text(const Eigen::Vector2d& place, std::string_view text) {
    fmt::format_to(
        std::back_inserter(m_body),
        "<text transform=\"translate({:.1f} {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}"
        "</text>\n",
        place.x(), place.y(), escape(text));
}

std::string inline_svg(const Drawing& drawing) {
    return svg_start(drawing, drawing.attributes) + '\n' + drawing.body + "</svg>";
}

std::string standalone_svg(const Drawing& drawing) {
    return fmt::format(
        "{}\n<style>{}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{}</svg>\n",
        svg_start(drawing, R"( xmlns="http://www.w3.org/2000/svg")"), figure_style(), drawing.body);
}

}  // namespace taut::report
