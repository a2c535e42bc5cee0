// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "report/axes.hpp"
#include "report/figures.hpp"
#include "report/number_text.hpp"

namespace taut::report {
namespace {

using Strategy = ControlResult::Strategy;
using Round = ControlResult::Round;

struct StrategyStyle {
    std::string_view name;
    std::string_view style;
    std::string_view words;
};
// Grey and dashed are told from the two hues by lightness and shape.
constexpr std::array strategy_styles{
    StrategyStyle{"true lengths", "best", "true lengths: the best that turning can do"},
    StrategyStyle{"identified", "series0", "identified: lengths from each round's survey"},
    StrategyStyle{"design", "series1", "design: each survey, nothing identified"},
    StrategyStyle{"design, once", "series5", "design, once: turned in round 1 alone"}};

const StrategyStyle& style_of(const Strategy& strategy) {
    const auto found = std::ranges::find(strategy_styles, strategy.name, &StrategyStyle::name);
    return found == strategy_styles.end() ? strategy_styles.back() : *found;
}

/// Between sorted values, linearly. @param part 0: the least, 1: the most
double quantile_of(const std::vector<double>& sorted, double part) {
    const double place = part * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<size_t>(place);
    const size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

/// Trials below which a middle half says nothing that the range does not.
constexpr int least_for_quartiles = 4;

struct RoundChart {
    std::string name;
    std::string title;
    std::string y_label;
    double width = half_width;
    int first = 0;     ///< round
    double top = 0.0;  ///< largest value
    double least_top = 1.0;
    double bottom = 0.0;  ///< least value on a logarithmic axis; 0: a linear one, from 0
};

/// @param from, to places in the drawing
void set_heights(Axes& axes, const RoundChart& chart, double from, double to) {
    if (!(chart.bottom > 0.0)) {
        axes.y = {.high = std::max(1.06 * chart.top, chart.least_top), .from = from, .to = to};
        axes.y_ticks = nice_ticks(axes.y.low, axes.y.high, 6);
        return;
    }
    constexpr double margin = 0.08;
    axes.y = {.low = std::log10(chart.bottom) - margin,
              .high = std::log10(chart.top) + margin,
              .from = from,
              .to = to};
    axes.y_ticks = decade_ticks(axes.y.low, axes.y.high);
}

/// One line a strategy over the rounds, which stand side by side at each round.
class RoundDrawing {
public:
    RoundDrawing(RoundChart chart, const ControlResult& control)
        : m_chart(std::move(chart)), m_strategies(control.strategies) {
        constexpr double row_height = 18.0;
        constexpr double plot_height = 250.0;
        const int last = static_cast<int>(m_strategies.front().rounds.size()) - 1;
        const double top = 12.0 + row_height * static_cast<double>(m_strategies.size());
        m_height = top + plot_height;
        set_heights(m_axes, m_chart, m_height - bottom_margin, top);
        m_axes.x = {.low = m_chart.first - 0.5,
                    .high = last + 0.5,
                    .from = left_margin(m_axes.y_ticks),
                    .to = m_chart.width - 12.0};
        m_axes.x_ticks = nice_ticks(m_axes.x.low, m_axes.x.high, 10, 1.0);
        if (m_chart.first == 0) {
            m_axes.x_ticks.labels.front() = "as built";
        }
        m_axes.x_label = "after round";
        m_axes.y_label = m_chart.y_label;
        draw_axes(m_svg, m_axes, true);
        double legend_y = 16.0;
        for (const Strategy& strategy : m_strategies) {
            const auto& [name, style, words] = style_of(strategy);
            draw_legend(m_svg, {m_axes.x.from, legend_y},
                        {{.style = std::string(style),
                          .words = std::string(words),
                          .mark = Mark::dash,
                          .attributes = {}}});
            legend_y += row_height;
        }
    }

    /// Lines and dots. @param value of a round
    template <class Value>
    void draw_values(const Value& value) {
        for (size_t i = 0; i < m_strategies.size(); ++i) {
            PathData line;
            PathData dots;
            const auto& rounds = m_strategies[i].rounds;
            for (size_t round = m_chart.first; round < rounds.size(); ++round) {
                const Eigen::Vector2d place = place_of(i, round, value(rounds[round]));
                line.empty() ? line.move_to(place) : line.line_to(place);
                dots.dot(place);
            }
            const std::string_view style = style_of(m_strategies[i]).style;
            m_svg.path(style, line);
            // A dash pattern would leave a dot away.
            m_svg.path(style, dots, R"(style="stroke-width:6.5;stroke-dasharray:none")");
        }
    }

    /// From the least to the most of all trials, thicker over the middle half.
    void draw_spread() {
        for (size_t i = 0; i < m_strategies.size(); ++i) {
            PathData range;
            PathData middle;
            const auto& rounds = m_strategies[i].rounds;
            for (size_t round = m_chart.first; round < rounds.size(); ++round) {
                std::vector<double> all = rounds[round].normal_rmse_of_trials;
                std::ranges::sort(all);
                const auto add = [&](PathData& path, double part) {
                    path.move_to(place_of(i, round, 1e3 * quantile_of(all, part)));
                    path.line_to(place_of(i, round, 1e3 * quantile_of(all, 1.0 - part)));
                };
                add(range, 0.0);
                if (all.size() >= least_for_quartiles) {
                    add(middle, 0.25);
                }
            }
            const std::string_view style = style_of(m_strategies[i]).style;
            m_svg.path(style, range, R"(style="stroke-width:1;stroke-dasharray:none")");
            m_svg.path(style, middle,
                       R"(style="stroke-width:5;stroke-opacity:.35;stroke-dasharray:none")");
        }
    }

    [[nodiscard]] Drawing take() {
        return {.name = m_chart.name,
                .title = m_chart.title,
                .width = m_chart.width,
                .height = m_height,
                .body = m_svg.take(),
                .attributes = {}};
    }

private:
    [[nodiscard]] Eigen::Vector2d place_of(size_t strategy, size_t round, double value) const {
        constexpr double apart = 0.1;  // rounds
        const double middle = 0.5 * static_cast<double>(m_strategies.size() - 1);
        const double x =
            static_cast<double>(round) + apart * (static_cast<double>(strategy) - middle);
        const double bottom = m_chart.bottom;
        return m_axes(x, bottom > 0.0 ? std::log10(std::max(value, bottom)) : value);
    }

    RoundChart m_chart;
    const std::vector<Strategy>& m_strategies;
    Axes m_axes;
    double m_height = 0.0;
    SvgBody m_svg;
};

/// The largest of all strategies and rounds. @param value of a round
template <class Value>
double largest_after(const ControlResult& control, const Value& value) {
    double most = 0.0;
    for (const Strategy& strategy : control.strategies) {
        for (const Round& round : strategy.rounds) {
            most = std::max(most, value(round));
        }
    }
    return most;
}

/// Least and largest distance of any trial [mm]. A distance of 0 has no logarithm, and one far
/// below the others would press these together.
std::pair<double, double> distance_range(const ControlResult& control) {
    std::vector<double> all;
    for (const Strategy& strategy : control.strategies) {
        for (const Round& round : strategy.rounds) {
            std::ranges::copy(round.normal_rmse_of_trials, std::back_inserter(all));
            all.push_back(round.normal_rmse);
        }
    }
    const double most = std::ranges::max(all);
    if (!(most > 0.0)) {
        return {0.0, 0.0};
    }
    constexpr double decades = 1e-4;
    return {1e3 * std::max(std::ranges::min(all), decades * most), 1e3 * most};
}

/// Where nothing could be planned.
std::string failure_words(const ControlResult& control) {
    int failed = 0;
    for (const Strategy& strategy : control.strategies) {
        for (const Round& round : strategy.rounds) {
            failed += round.failed;
        }
    }
    if (failed == 0) {
        return "";
    }
    return fmt::format(
        " Where nothing could be planned, {} over all jobs, nothing was turned; these are among "
        "the others.",
        failed == 1 ? "1 time" : fmt::format("{} times", failed));
}

}  // namespace

Figure control_form_figure(const ControlResult& control) {
    const auto [bottom, top] = distance_range(control);
    RoundDrawing drawing({.name = "control_form",
                          .title = "Distance from the target along its normal, after each round",
                          .y_label = "along the normal, RMS [mm]",
                          .width = full_width,
                          .top = top,
                          .bottom = bottom},
                         control);
    std::string caption = fmt::format(
        "Distance of the true form from the target along its normal{}: dots are the root mean "
        "square over all nodes and {}",
        bottom > 0.0 ? ", on a logarithmic scale" : "", counted(control.trials, "job"));
    if (control.trials == 1) {
        caption += ", so that nothing is told of how much jobs differ.";
    } else {
        drawing.draw_spread();
        caption += "; thin lines go from the least to the most of a job";
        caption += control.trials >= least_for_quartiles ? ", thick ones over the middle half of "
                                                           "the jobs."
                                                         : ".";
    }
    drawing.draw_values([](const Round& round) { return 1e3 * round.normal_rmse; });
    return {.drawings = {drawing.take()},
            .heading = "Distance from the target",
            .caption = caption + failure_words(control)};
}

Figure control_work_figure(const ControlResult& control) {
    const double trials = control.trials;
    const auto share = [trials](const Round& round) {
        return 100.0 * round.broken_trials / trials;
    };
    const auto turned = [](const Round& round) { return 1e3 * round.turned; };
    RoundDrawing limits({.name = "control_limits",
                         .title = "Share of jobs in which a limit is broken, after each round",
                         .y_label = "jobs with a broken limit [%]",
                         .top = largest_after(control, share),
                         .least_top = 10.0},
                        control);
    limits.draw_values(share);
    RoundDrawing strokes({.name = "control_strokes",
                          .title = "Strokes turned in each round",
                          .y_label = "strokes of a round, in all [mm]",
                          .first = 1,
                          .top = largest_after(control, turned)},
                         control);
    strokes.draw_values(turned);
    return {
        .drawings = {limits.take(), strokes.take()},
        .heading = "Broken limits, and the work",
        .caption = fmt::format(
            "The share of {} in which the true tension of an edge is beyond a limit; and the sizes "
            "of the strokes of a round, added up over all turnbuckles, mean of the jobs.{}",
            counted(control.trials, "job"), failure_words(control))};
}

}  // namespace taut::report
