// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/spectrum_peaks.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "survey/median.hpp"

namespace taut {
namespace {

using Bins = Eigen::Ref<const Eigen::VectorXd>;

constexpr size_t most_peaks = 24;
constexpr double least_ratio = 3.0;  // where floors of long records are known better than they are

/// The quantile of a mean of squares over its expectation, of a normal deviate z (Wilson and
/// Hilferty 1931). Segments that overlap by half under a Hann window count as 0.95 of their number
/// (Welch 1967, eq. 12); several columns as one, since they may be the same.
double chance_ratio(int segments, double z) {
    const double spread = 2.0 / (9.0 * 2.0 * 0.95 * segments);
    return std::pow(std::max(1.0 - spread + z * std::sqrt(spread), 0.1), 3);
}

/// The noise floor at each bin: the median around it, over what a median is of the mean.
Eigen::VectorXd noise_floor(const WelchSpectrum& spectrum) {
    constexpr double cells = 20.0;          // to either side, of which peaks fill a few
    constexpr double broad_part = 0.25;     // of the frequency: damping widens peaks in proportion
    constexpr double dynamic_range = 1e-7;  // less is distortion
    const Bins density = spectrum.density;
    const double median_ratio = chance_ratio(spectrum.segments, 0.0);
    const double least = dynamic_range * density.maxCoeff();
    const auto cell =
        std::max<Eigen::Index>(1, static_cast<Eigen::Index>(spectrum.resolution / spectrum.step));
    Eigen::VectorXd floor(density.size());
    for (Eigen::Index first = 0; first < density.size();) {
        const double reach =
            std::max(cells * static_cast<double>(cell), broad_part * static_cast<double>(first));
        const auto half = static_cast<Eigen::Index>(reach);
        const Eigen::Index count = std::min(std::max(cell, half / 4), density.size() - first);
        const Eigen::Index from = std::max<Eigen::Index>(first + count / 2 - half, 1);
        const Eigen::Index to = std::min(first + count / 2 + half + 1, density.size());
        const double level = median_of(density.segment(from, to - from)) / median_ratio;
        floor.segment(first, count).setConstant(std::max(level, least));
        first += count;
    }
    return floor;
}

/// How far the density falls off from a peak to either side before it rises above the peak.
double prominence(const Bins& density, Eigen::Index peak) {
    const auto lowest = [&](Eigen::Index direction) {
        double least = density(peak);
        for (Eigen::Index i = peak + direction;
             i >= 0 && i < density.size() && density(i) <= density(peak); i += direction) {
            least = std::min(least, density(i));
        }
        return least;
    };
    const double foot = std::max(lowest(-1), lowest(1));
    return foot > 0.0 ? density(peak) / foot : HUGE_VAL;
}

/// Envelope of the side lobes of a Hann window's power, so many cells off; 1 in the main lobe.
double hann_leakage(double cells) {
    return cells < 1.2 ? 1.0 : std::pow(std::numbers::pi * cells * (cells * cells - 1.0), -2.0);
}

/// The vertex of the parabola through the logarithms at the highest bin near one [bins].
double vertex(const Bins& density, Eigen::Index bin) {
    while (bin > 1 && density(bin - 1) > density(bin)) {
        --bin;
    }
    while (bin + 2 < density.size() && density(bin + 1) > density(bin)) {
        ++bin;
    }
    const double left = std::log(density(bin - 1));
    const double middle = std::log(density(bin));
    const double right = std::log(density(bin + 1));
    const double curvature = left - 2.0 * middle + right;
    return static_cast<double>(bin) + (curvature < 0.0 ? 0.5 * (left - right) / curvature : 0.0);
}

/// Scatter of a peak's frequency over the record, by leaving out a group of segments at a time (the
/// jackknife); never less than that of a steady sine of its height in noise, by the Cramér-Rao
/// bound of D. C. Rife, R. R. Boorstyn, IEEE Trans. Inf. Theory 20 (1974):
///     var f = 3 S / (pi^2 A^2 T^3),  A^2 = 3 P / T_s
/// with the densities S of the noise and P at the peak, and the lengths T of the record and T_s of
/// a segment.
double peak_std(const WelchSpectrum& spectrum, Eigen::Index bin, double level, double duration) {
    constexpr Eigen::Index reach = 8;  // bins, two cells of the least padding
    const Eigen::Index first = std::max<Eigen::Index>(bin - reach, 0);
    const Eigen::Index count = std::min(bin + reach + 1, spectrum.density.size()) - first;
    const Eigen::Index groups = spectrum.groups.cols();
    Eigen::VectorXd without(groups);
    for (Eigen::Index g = 0; g < groups; ++g) {
        without(g) = vertex(
            (spectrum.density.segment(first, count) - spectrum.groups.col(g).segment(first, count))
                .cwiseMax(1e-300),
            bin - first);
    }
    const double scatter =
        spectrum.step * std::sqrt(static_cast<double>(groups - 1) / static_cast<double>(groups)) *
        (without.array() - without.mean()).matrix().norm();
    const double bound =
        std::sqrt(1.0 / (level * spectrum.resolution * duration)) / (std::numbers::pi * duration);
    return std::max(scatter, bound);
}

}  // namespace

std::vector<FrequencyPeak> spectrum_peaks(const WelchSpectrum& spectrum, double duration,
                                          const FrequencyRange& range) {
    constexpr double chance_above = 5.0;  // one in 3 million, of some thousand bins
    constexpr double chance_dip = 3.0;
    constexpr double above_leakage = 4.0;
    const Bins density = spectrum.density;
    const Eigen::VectorXd floor = noise_floor(spectrum);
    const double above = std::max(least_ratio, chance_ratio(spectrum.segments, chance_above));
    const double fall = std::max(least_ratio, chance_ratio(spectrum.segments, chance_dip) /
                                                  chance_ratio(spectrum.segments, -chance_dip));
    std::vector<Eigen::Index> maxima;
    for (Eigen::Index i = 0; i + 1 < density.size(); ++i) {
        if ((i == 0 || density(i) > density(i - 1)) && density(i) >= density(i + 1) &&
            density(i) > above * floor(i)) {
            maxima.push_back(i);
        }
    }
    std::ranges::sort(maxima, std::greater{}, [&](Eigen::Index i) { return density(i); });
    // Also what lies out of the range, or is no peak, has side lobes.
    std::vector<Eigen::Index> sources;
    std::vector<Eigen::Index> kept;
    for (const Eigen::Index i : maxima) {
        const auto leaks = [&](Eigen::Index higher) {
            const double cells =
                static_cast<double>(std::abs(i - higher)) * spectrum.step / spectrum.resolution;
            return density(i) < above_leakage * density(higher) * hann_leakage(cells);
        };
        if (std::ranges::any_of(sources, leaks)) {
            continue;
        }
        sources.push_back(i);
        const double frequency = spectrum.step * static_cast<double>(i);
        if (i > 0 && frequency >= range.lowest && frequency <= range.highest &&
            prominence(density, i) > fall) {
            kept.push_back(i);
        }
    }
    std::ranges::sort(kept, std::greater{}, [&](Eigen::Index i) { return density(i) / floor(i); });
    kept.resize(std::min(kept.size(), most_peaks));
    std::ranges::sort(kept);
    std::vector<FrequencyPeak> peaks;
    for (const Eigen::Index i : kept) {
        const double level = density(i) / floor(i);
        peaks.push_back({.frequency = spectrum.step * vertex(density, i),
                         .std_dev = peak_std(spectrum, i, level, duration),
                         .level = level});
    }
    return peaks;
}

}  // namespace taut
