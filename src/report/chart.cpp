// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/chart.hpp"

#include <fmt/core.h>

namespace taut::report {
namespace {

std::string scales(const Axes& axes) {
    const auto text = [](const Scale& s) {
        return fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}", s.low, s.high, s.from, s.to);
    };
    return fmt::format(R"( data-x="{}" data-y="{}")", text(axes.x), text(axes.y));
}

}  // namespace

std::string edge_chart(const Axes& axes) {
    return R"( data-chart="edges")" + scales(axes);
}

std::string node_chart(const Axes& axes, const Plan& plan) {
    return fmt::format(R"( data-chart="nodes" data-right="{}" data-up="{}"{})", plan.right, plan.up,
                       scales(axes));
}

}  // namespace taut::report
