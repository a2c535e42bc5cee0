// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/checked_result.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "identification/parameter_estimates.hpp"
#include "identification/parameter_spread.hpp"

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

/// The same of one number that would otherwise be 0.
double gain_of(double value, double std_dev) {
    return 0.5 * std::pow(value / std_dev, 2);
}

double gain_of_loads(const Identification& result) {
    const LoadCheck& loads = result.load_check;
    return loads.is_missing() ? gain_of(loads.force, loads.std_dev) : 0.0;
}

/// (other-causes): the one that explains most.
OtherCause other_cause_of(const CheckedResult& of) {
    const Identification& result = of.result;
    const FrameCheck& frame = result.frame_check;
    OtherCause cause;
    const auto take = [&](double gain, std::string name) {
        if (gain > cause.gain) {
            cause = {.gain = gain, .name = std::move(name)};
        }
    };
    if (of.has_scale()) {
        take(gain_of(frame.scale, frame.scale_std), "the scale of the survey");
    }
    if (frame.is_moved()) {
        take(0.5 * frame.motion_statistic, "the frame of the survey");
    }
    if (of.has_mean()) {
        take(gain_of(result.prior_check.mean, result.prior_check.mean_std),
             "what all lengths have in common");
    }
    const bool is_load_likeliest = gain_of_loads(result) > cause.gain;
    take(gain_of_loads(result), "loads and weights of the net");
    if (of.has_narrow_prior()) {
        double gain = 0.0;
        for (const LengthOutlier& outlier : result.length_outliers) {
            gain += 0.5 * outlier.statistic;
        }
        take(gain, "the prior of the lengths");
    }
    for (const ParameterSpread& spread : spreads_of(result.uncertain)) {
        if (spread.is_contradicted()) {
            take(gain_of_scale(spread.ratio, spread.shown), to_string(spread.parameter));
        }
    }
    cause.is_load_likeliest = is_load_likeliest;
    return cause;
}

/// Whether one ratio is significantly above another.
bool is_above(const FoundScale& one, const FoundScale& other) {
    constexpr double significant = 2.5;  // standard deviations
    return one.ratio > (1.0 + significant * std::hypot(one.std_dev, other.std_dev)) * other.ratio;
}

/// Along which axes a survey scatters more widely than given and than along the rest.
std::vector<int> axes_of_noise(const std::vector<FoundScale>& axes) {
    const auto worst = std::ranges::max_element(axes, {}, &FoundScale::ratio);
    if (worst == axes.end() || !(worst->ratio > 1.0) || !worst->is_contradicted()) {
        return {};
    }
    std::vector<int> found;
    bool has_rest = false;
    for (int k = 0; k < std::ssize(axes); ++k) {
        const bool is_shown = axes[k].std_dev > 0.0;
        if (is_shown && axes[k].is_contradicted() && !is_above(*worst, axes[k])) {
            found.push_back(k);
        } else {
            has_rest = has_rest || (is_shown && is_above(*worst, axes[k]));
        }
    }
    return has_rest ? found : std::vector<int>();
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
      noise_axes(axes_of_noise(result.scales.noise_by_axis)) {}

const FoundScale& CheckedResult::noise() const {
    const VarianceComponents& scales = result.scales;
    return noise_axes.empty() ? scales.noise
                              : scales.noise_by_axis[std::ranges::max(noise_axes, {}, [&](int k) {
                                    return scales.noise_by_axis[k].ratio;
                                })];
}

/// The ratio of n numbers has the standard deviation 1 / sqrt(2 n).
bool CheckedResult::is_noise_likelier() const {
    const auto& [ratio, std_dev] = noise();
    return !noise().is_contradicted() ||
           gain_of_scale(ratio, 0.5 / (std_dev * std_dev)) > other_cause.gain;
}

bool CheckedResult::has_uneven_noise() const {
    const std::vector<FoundScale>& axes = result.scales.noise_by_axis;
    return std::ranges::any_of(axes, [&](const FoundScale& one) {
        return std::ranges::any_of(axes, [&](const FoundScale& other) {
            return one.std_dev > 0.0 && other.std_dev > 0.0 && is_above(one, other);
        });
    });
}

bool CheckedResult::has_scale() const {
    const FrameCheck& check = result.frame_check;
    const Points arms = net.nodes().colwise() - net.nodes().rowwise().mean();
    const double furthest = std::abs(check.scale) * arms.colwise().norm().maxCoeff();
    return check.is_scaled() && furthest > negligible_scale * survey.rms_noise_std();
}

bool CheckedResult::has_mean() const {
    const PriorCheck& check = result.prior_check;
    return check.has_mean() &&
           std::abs(check.mean) > negligible_mean * result.length_prior.std_dev();
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

std::string longer_text(double deviation, double std_dev, std::string_view bound) {
    return fmt::format("{}{:.1f} +- {:.1f} mm {}", bound, 1e3 * std::abs(deviation), 1e3 * std_dev,
                       deviation < 0.0 ? "shorter" : "longer");
}

}  // namespace taut
