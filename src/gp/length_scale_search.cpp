// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "gp/length_scale_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace taut::gp {
namespace {

/// Valleys over log lambda narrower than this, a factor of 3.3 in the length scale, have not been
/// seen, and two points closer than it hide none.
constexpr double narrowest_valley = 1.2;

/// However wide the range, looking for valleys takes no more intervals than this.
constexpr int most_first_intervals = 8;

/// Points closer than this in log lambda tell nothing new.
constexpr double closest = 1e-4;

struct Point {
    double at;
    double value;
    double slope;
};

struct Minimum {
    double at = 0.0;
    double value = std::numeric_limits<double>::infinity();
};

/// The cubic with the values and slopes of two points: value + t (c1 + t (c2 + t c3)), t = 0 to 1.
class Cubic {
public:
    Cubic(const Point& a, const Point& b) : m_origin(a), m_width(b.at - a.at) {
        m_c1 = m_width * a.slope;
        m_c2 = 3.0 * (b.value - a.value) - m_width * (2.0 * a.slope + b.slope);
        m_c3 = 2.0 * (a.value - b.value) + m_width * (a.slope + b.slope);
    }

    /// Where it is smallest between lower and upper, ends left out; an infinite value if at an end.
    [[nodiscard]] Minimum minimum(double lower, double upper) const {
        const double discriminant = m_c2 * m_c2 - 3.0 * m_c1 * m_c3;
        if (discriminant < 0.0) {
            return {};
        }
        // The root of the derivative where it rises, written without cancellation.
        const double root = std::sqrt(discriminant);
        const double t = m_c2 >= 0.0 ? -m_c1 / (m_c2 + root) : (root - m_c2) / (3.0 * m_c3);
        const double at = m_origin.at + t * m_width;
        if (!(at > lower && at < upper)) {
            return {};
        }
        return {.at = at, .value = m_origin.value + t * (m_c1 + t * (m_c2 + t * m_c3))};
    }

private:
    Point m_origin;
    double m_width;
    double m_c1;
    double m_c2;
    double m_c3;
};

using Points = std::vector<Point>;  // of one output, in ascending order

double best_value(const Points& points) {
    return std::ranges::min_element(points, {}, &Point::value)->value;
}

/// Whether the interval from point i on may hide a valley: the tangent at one of its ends reaches
/// below the best value within it.
bool may_hide_valley(const Points& points, size_t i, double best) {
    const Point& a = points[i];
    const Point& b = points[i + 1];
    const double width = b.at - a.at;
    return a.value + a.slope * width < best || b.value - b.slope * width < best;
}

/// Where the points let the smallest value be expected.
Minimum expected_minimum(const Points& points) {
    Minimum result;
    const auto offer = [&](const Minimum& found) {
        if (found.value < result.value) {
            result = found;
        }
    };
    for (size_t i = 0; i + 1 < points.size(); ++i) {
        offer(Cubic(points[i], points[i + 1]).minimum(points[i].at, points[i + 1].at));
    }
    // Where the interval downhill of the best point is much the longer one, the cubic across it is
    // the poorer guide, and would creep: the cubic of the shorter one is followed beyond its end,
    // half the way at most.
    const auto best = std::ranges::min_element(points, {}, &Point::value);
    if (best == points.begin() || std::next(best) == points.end()) {
        return result;
    }
    const Point& before = best->slope < 0.0 ? *std::prev(best) : *std::next(best);
    const Point& ahead = best->slope < 0.0 ? *std::next(best) : *std::prev(best);
    if (std::abs(ahead.at - best->at) > 2.0 * std::abs(best->at - before.at)) {
        const double half_way = 0.5 * (best->at + ahead.at);
        const Minimum beyond =
            Cubic(before, *best)
                .minimum(std::min(best->at, half_way), std::max(best->at, half_way));
        if (std::isfinite(beyond.value)) {
            return beyond;
        }
    }
    return result;
}

/// Where an output would like to look next.
struct Wish {
    double at;
    double gain;   ///< expected there
    double reach;  ///< distance from its best point so far
};

/// What all outputs together expect to gain at a point: each a parabola that is zero at its best
/// point so far and highest at its wish.
double expected_gain(const std::vector<Wish>& wishes, double at) {
    double sum = 0.0;
    for (const Wish& wish : wishes) {
        const double t = (at - wish.at) / wish.reach;
        sum += wish.gain * std::max(0.0, 1.0 - t * t);
    }
    return sum;
}

}  // namespace

LengthScaleSearch::LengthScaleSearch(double lower_log_lambda, double upper_log_lambda,
                                     double relative_tolerance)
    : m_lower(lower_log_lambda), m_upper(upper_log_lambda), m_tolerance(relative_tolerance) {}

void LengthScaleSearch::add(double log_lambda, LikelihoodProfile profile) {
    m_profiles.emplace(log_lambda, std::move(profile));
}

std::vector<double> LengthScaleSearch::best() const {
    const Eigen::Index m = m_profiles.begin()->second.value.size();
    std::vector<double> result(m);
    for (Eigen::Index j = 0; j < m; ++j) {
        result[j] = std::ranges::min_element(m_profiles, {}, [j](const auto& p) {
                        return p.second.value(j);
                    })->first;
    }
    return result;
}

std::optional<double> LengthScaleSearch::next() const {
    const double range = m_upper - m_lower;
    const double first_step = std::max(narrowest_valley, range / most_first_intervals);
    const auto intervals = static_cast<int>(std::ceil(0.5 * range / first_step));
    const auto count = static_cast<int>(m_profiles.size());
    if (count <= intervals) {
        return count == 0 ? m_lower : m_lower + range * count / intervals;
    }

    std::vector<Points> outputs(m_profiles.begin()->second.value.size());
    for (const auto& [at, profile] : m_profiles) {
        for (size_t j = 0; j < outputs.size(); ++j) {
            const auto column = static_cast<Eigen::Index>(j);
            outputs[j].push_back(
                {.at = at, .value = profile.value(column), .slope = profile.slope(column)});
        }
    }
    const Points& any = outputs.front();
    for (size_t i = 0; i + 1 < any.size(); ++i) {
        if (any[i + 1].at - any[i].at > first_step &&
            std::ranges::any_of(outputs, [i](const Points& points) {
                return may_hide_valley(points, i, best_value(points));
            })) {
            return 0.5 * (any[i].at + any[i + 1].at);
        }
    }

    std::vector<Wish> wishes;
    for (const Points& points : outputs) {
        const Point best = *std::ranges::min_element(points, {}, &Point::value);
        const Minimum found = expected_minimum(points);
        const bool is_new = std::ranges::all_of(
            points, [&](const Point& p) { return std::abs(p.at - found.at) > closest; });
        const double gain = best.value - found.value;
        if (is_new && gain > m_tolerance * std::max(1.0, std::abs(best.value))) {
            wishes.push_back({.at = found.at, .gain = gain, .reach = std::abs(found.at - best.at)});
        }
    }
    if (wishes.empty()) {
        return std::nullopt;
    }
    return std::ranges::max_element(
               wishes, {}, [&](const Wish& wish) { return expected_gain(wishes, wish.at); })
        ->at;
}

}  // namespace taut::gp
