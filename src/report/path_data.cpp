// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/path_data.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>

namespace taut::report {
namespace {

/// A number of tenths as SVG may write it: no zero before the point, none after it.
std::string tenths_text(long tenths) {
    const long whole = std::abs(tenths) / 10;
    const long rest = std::abs(tenths) % 10;
    std::string text = tenths < 0 ? "-" : "";
    if (whole != 0 || rest == 0) {
        text += fmt::format("{}", whole);
    }
    if (rest != 0) {
        text += fmt::format(".{}", rest);
    }
    return text;
}

}  // namespace

void PathData::step(char command, const Eigen::Vector2d& place) {
    const long x = std::lround(10.0 * place.x());
    const long y = std::lround(10.0 * place.y());
    const std::string dy = tenths_text(y - m_y);
    m_text += command;
    m_text += tenths_text(x - m_x);
    m_text += dy.starts_with('-') ? dy : " " + dy;
    m_x = x;
    m_y = y;
}

void PathData::move_to(const Eigen::Vector2d& place) {
    step('m', place);
}

void PathData::line_to(const Eigen::Vector2d& place) {
    step('l', place);
}

void PathData::dot(const Eigen::Vector2d& place) {
    step('m', place);
    m_text += "h0";
}

void PathData::square(const Eigen::Vector2d& middle, double width) {
    step('m', middle - Eigen::Vector2d::Constant(0.5 * width));
    const std::string side = tenths_text(std::lround(10.0 * width));
    m_text += fmt::format("h{}v{}h-{}z", side, side, side);
}

}  // namespace taut::report
