// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/checked_result.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "identification/parameter_estimates.hpp"

namespace taut {
namespace {

/// Of the lengths: so many outliers are named one by one only where the prior is too narrow.
constexpr double many_lengths = 5;
constexpr double many_of_lengths = 0.03;

/// How much likelier so many normal numbers are with a standard deviation this many times as large,
/// logarithm.
double gain_of_scale(double ratio, double count) {
    return count * (0.5 * (ratio * ratio - 1.0) - std::log(ratio));
}

/// (other-causes): the one that explains most.
OtherCause other_cause_of(const CheckedResult& of) {
    const Identification& result = of.result;
    const FrameCheck& frame = result.frame_check;
    OtherCause cause;
    const auto take = [&](double gain, std::string name) {
        if (gain > cause.gain) {
            cause = {gain, std::move(name)};
        }
    };
    if (of.has_scale()) {
        take(0.5 * std::pow(frame.scale / frame.scale_std, 2), "the scale of the survey");
    }
    if (frame.is_moved()) {
        take(0.5 * frame.motion_statistic, "the frame of the survey");
    }
    if (const LoadCheck& loads = result.load_check; loads.is_missing()) {
        take(0.5 * std::pow(loads.force / loads.std, 2), "loads and weights of the net");
    }
    if (of.has_narrow_prior()) {
        double gain = 0.0;
        for (const LengthOutlier& outlier : result.length_outliers) {
            gain += 0.5 * outlier.statistic;
        }
        take(gain, "the prior of the lengths");
    }
    for (const ParameterSpread& spread : spreads_of(result.uncertain)) {
        if (spread.is_contradicted()) {
            take(gain_of_scale(spread.ratio, spread.shown), spread.parameter.to_string());
        }
    }
    return cause;
}

/// Along which axis a survey scatters more widely than given and than along both others; -1: none.
int axis_of_noise(const std::array<FoundScale, 3>& axes) {
    constexpr double significant = 3.0;  // standard deviations
    const auto worst = std::ranges::max_element(axes, {}, &FoundScale::ratio);
    const auto k = static_cast<int>(worst - axes.begin());
    double squares = 0.0;
    double redundancy = 0.0;
    for (const FoundScale& other : {axes[(k + 1) % 3], axes[(k + 2) % 3]}) {
        if (other.std > 0.0) {
            const double count = 0.5 / (other.std * other.std);
            redundancy += count;
            squares += other.ratio * other.ratio * count;
        }
    }
    if (!(worst->ratio > 1.0) || !worst->is_contradicted() || !(redundancy > 0.0)) {
        return -1;
    }
    const double std_of_both = std::hypot(worst->std, std::sqrt(0.5 / redundancy));
    return worst->ratio > (1.0 + significant * std_of_both) * std::sqrt(squares / redundancy) ? k
                                                                                              : -1;
}

}  // namespace

std::string OtherCause::advice() const {
    return fmt::format("Look at {} first: it explains more.", name);
}

CheckedResult::CheckedResult(const CableNet& of_net, const Survey& of_survey,
                             const Identification& found)
    : net(of_net),
      survey(of_survey),
      result(found),
      other_cause(other_cause_of(*this)),
      noise_axis(axis_of_noise(result.scales.noise_by_axis)) {}

const FoundScale& CheckedResult::noise() const {
    return noise_axis < 0 ? result.scales.noise : result.scales.noise_by_axis[noise_axis];
}

/// The ratio of n numbers has the standard deviation 1 / sqrt(2 n).
bool CheckedResult::is_noise_likelier() const {
    const auto& [ratio, std] = noise();
    return !noise().is_contradicted() || gain_of_scale(ratio, 0.5 / (std * std)) > other_cause.gain;
}

bool CheckedResult::has_scale() const {
    const FrameCheck& check = result.frame_check;
    const Points arms = net.nodes().colwise() - net.nodes().rowwise().mean();
    const double furthest = std::abs(check.scale) * arms.colwise().norm().maxCoeff();
    return check.is_scaled() && furthest > negligible_scale * survey.rms_noise_std();
}

bool CheckedResult::has_narrow_prior() const {
    const auto outliers = static_cast<double>(result.length_outliers.size());
    return outliers >= many_lengths &&
           outliers > many_of_lengths * static_cast<double>(result.edges.size());
}

std::string and_more(std::vector<std::string> names) {
    constexpr size_t shown = 6;
    const size_t count = names.size();
    names.resize(std::min(shown, count));
    return fmt::format("{}{}", fmt::join(names, ", "),
                       count > shown ? fmt::format(" and {} more", count - shown) : "");
}

std::string longer_text(double deviation, double std, std::string_view bound) {
    return fmt::format("{}{:.1f} +- {:.1f} mm {}", bound, 1e3 * std::abs(deviation), 1e3 * std,
                       deviation < 0.0 ? "shorter" : "longer");
}

}  // namespace taut
