// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "gp/length_scale_search.hpp"
#include "gp/likelihood_profile.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>

namespace taut::gp {
namespace {

/// No valley over log lambda narrower than this, a factor of 3.3 in the length scale, was ever
/// seen. So two points closer than this hide none.
constexpr double narrowest_valley = 1.2;

/// However wide the range, the search for valleys takes no more intervals than this.
constexpr int most_first_intervals = 8;

/// Points closer than this in log lambda give nothing new.
constexpr double closest = 1e-4;

using Point = ProfilePoint;
using Points = std::vector<Point>;  // of one output, in ascending order

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

const Point& best_of(const Points& points) {
    return *std::ranges::min_element(points, {}, &Point::value);
}

/// Whether the interval from point i on may hide a valley: the tangent at one of its ends reaches
/// below the best value within the half that is nearer to that end.
bool may_hide_valley(const Points& points, size_t i) {
    const Point& a = points[i];
    const Point& b = points[i + 1];
    const double half = 0.5 * (b.at - a.at);
    const double best = best_of(points).value;
    return a.value + a.slope * half < best || b.value - b.slope * half < best;
}

/// The minimum expected from the points.
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
    // Where the interval downhill of the best point is much the longer one, its cubic is a poor
    // guide and the search would creep. Then the cubic of the shorter interval is extrapolated, at
    // most half of the way.
    const auto best = std::ranges::min_element(points, {}, &Point::value);
    if (best == points.begin() || std::next(best) == points.end()) {
        return result;
    }
    const Point& before = best->slope < 0.0 ? *std::prev(best) : *std::next(best);
    const Point& ahead = best->slope < 0.0 ? *std::next(best) : *std::prev(best);
    if (std::abs(ahead.at - best->at) > 2.0 * std::abs(best->at - before.at)) {
        const double half_way = 0.5 * (best->at + ahead.at);
        const Minimum extrapolated =
            Cubic(before, *best)
                .minimum(std::min(best->at, half_way), std::max(best->at, half_way));
        if (std::isfinite(extrapolated.value)) {
            return extrapolated;
        }
    }
    return result;
}

/// Where an output would like to look next.
struct Wish {
    Eigen::Index output;
    double at;
    double gain;          ///< expected there
    double reach;         ///< distance from its best point so far
    double least;         ///< gain below which the output is content
    double served = 0.0;  ///< gain expected at the points that have been chosen
};

/// The gain that an output expects at a point: a parabola that is zero at its best point so far and
/// highest at its wish.
double expected_gain(const Wish& wish, double at) {
    const double t = (at - wish.at) / wish.reach;
    return wish.gain * std::max(0.0, 1.0 - t * t);
}

/// The gain that all outputs together expect on top of that of the chosen points.
double expected_gain(const std::vector<Wish>& wishes, double at) {
    double sum = 0.0;
    for (const Wish& wish : wishes) {
        sum += std::max(0.0, expected_gain(wish, at) - wish.served);
    }
    return sum;
}

/// Takes a point as chosen, and removes the wishes that it fulfils.
void serve(std::vector<Wish>& wishes, double at) {
    for (Wish& wish : wishes) {
        wish.served = std::max(wish.served, expected_gain(wish, at));
    }
    std::erase_if(wishes, [](const Wish& wish) { return wish.gain - wish.served <= wish.least; });
}

/// The wishes of all outputs that are not content.
std::vector<Wish> wishes_of(const std::vector<Points>& outputs, double tolerance) {
    std::vector<Wish> wishes;
    for (size_t j = 0; j < outputs.size(); ++j) {
        const Points& points = outputs[j];
        const Point& best = best_of(points);
        const Minimum found = expected_minimum(points);
        const bool is_new = std::ranges::all_of(
            points, [&](const Point& p) { return std::abs(p.at - found.at) > closest; });
        const double gain = best.value - found.value;
        const double least = tolerance * std::max(1.0, std::abs(best.value));
        if (is_new && gain > least) {
            wishes.push_back({.output = static_cast<Eigen::Index>(j),
                              .at = found.at,
                              .gain = gain,
                              .reach = std::abs(found.at - best.at),
                              .least = least});
        }
    }
    return wishes;
}

/// The outputs whose best point is beside this one, or that expect a gain there.
std::vector<Eigen::Index> outputs_that_may_gain(const std::vector<Points>& outputs,
                                                const std::vector<Wish>& wishes, double at) {
    std::vector<bool> may_gain(outputs.size());
    for (size_t j = 0; j < outputs.size(); ++j) {
        const Points& points = outputs[j];
        const auto next = std::ranges::upper_bound(points, at, {}, &Point::at);
        const double best = best_of(points).at;
        may_gain[j] = (next != points.end() && next->at == best) ||
                      (next != points.begin() && std::prev(next)->at == best);
    }
    for (const Wish& wish : wishes) {
        may_gain[wish.output] = may_gain[wish.output] || expected_gain(wish, at) > 0.0;
    }
    std::vector<Eigen::Index> result;
    for (size_t j = 0; j < outputs.size(); ++j) {
        if (may_gain[j]) {
            result.push_back(static_cast<Eigen::Index>(j));
        }
    }
    return result;
}

/// The middles of intervals that may hide a valley of some output, in ascending order.
std::vector<double> unseen_valleys(const std::vector<Points>& outputs, double first_step) {
    std::set<double> middles;
    for (const Points& points : outputs) {
        for (size_t i = 0; i + 1 < points.size(); ++i) {
            if (points[i + 1].at - points[i].at > first_step && may_hide_valley(points, i)) {
                middles.insert(0.5 * (points[i].at + points[i + 1].at));
            }
        }
    }
    return {middles.begin(), middles.end()};
}

}  // namespace

LengthScaleSearch::LengthScaleSearch(Eigen::Index outputs, double lower_log_lambda,
                                     double upper_log_lambda, double relative_tolerance)
    : m_lower(lower_log_lambda),
      m_upper(upper_log_lambda),
      m_tolerance(relative_tolerance),
      m_outputs(outputs) {}

void LengthScaleSearch::add(const Look& look, const LikelihoodProfile& profile) {
    ++m_looks;
    for (size_t k = 0; k < look.outputs.size(); ++k) {
        const auto column = static_cast<Eigen::Index>(k);
        Points& points = m_outputs[look.outputs[k]];
        points.insert(std::ranges::upper_bound(points, look.log_lambda, {}, &Point::at),
                      {.at = look.log_lambda,
                       .value = profile.value(column),
                       .slope = profile.slope(column)});
    }
}

std::vector<double> LengthScaleSearch::best() const {
    std::vector<double> result;
    std::ranges::transform(m_outputs, std::back_inserter(result),
                           [](const Points& points) { return best_of(points).at; });
    return result;
}

std::vector<LengthScaleSearch::Look> LengthScaleSearch::next(int most) const {
    const double range = m_upper - m_lower;
    const double first_step = std::max(narrowest_valley, range / most_first_intervals);
    const auto intervals = static_cast<int>(std::ceil(0.5 * range / first_step));
    std::vector<Eigen::Index> all(m_outputs.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<Look> looks;
    const auto enough = [&] { return std::ssize(looks) >= most; };
    for (int k = m_looks; k <= intervals && !enough(); ++k) {
        looks.push_back({k == 0 ? m_lower : m_lower + range * k / intervals, all});
    }
    if (!looks.empty()) {
        return looks;
    }

    const std::vector<Wish> wishes = wishes_of(m_outputs, m_tolerance);
    std::vector<Wish> open = wishes;
    for (const double middle : unseen_valleys(m_outputs, first_step)) {
        if (!enough()) {
            looks.push_back({middle, all});
            serve(open, middle);
        }
    }
    while (!open.empty() && !enough()) {
        const double at = std::ranges::max_element(open, {}, [&](const Wish& wish) {
                              return expected_gain(open, wish.at);
                          })->at;
        looks.push_back({at, outputs_that_may_gain(m_outputs, wishes, at)});
        serve(open, at);
    }
    return looks;
}

}  // namespace taut::gp
