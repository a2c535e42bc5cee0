// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/mode_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include "survey/string_fit.hpp"

namespace taut {
namespace {

constexpr int most_modes = 30;
/// More has no cable that a string describes: mode 2 would be 9 % above twice the fundamental.
constexpr double most_inharmonicity = 0.05;
/// Standard deviation of a mode from the stiff string, as a part of its frequency: sag, clamped
/// ends, and the sensor's mass move modes by some tenths of a per cent.
constexpr double model_std = 0.005;
constexpr double farthest = 3.0;  // standard deviations from its mode

std::vector<int> assigned_modes(const std::vector<FrequencyPeak>& peaks,
                                const StiffString& string) {
    std::vector<int> modes(peaks.size(), 0);
    std::vector<size_t> peak_of(most_modes + 1, peaks.size());
    const auto distance = [&](size_t i, int n) {
        return std::abs(peaks[i].frequency - string.frequency(n)) / total_std(peaks[i], model_std);
    };
    for (size_t i = 0; i < peaks.size(); ++i) {
        const int n = string.nearest_mode(peaks[i].frequency);
        if (n > most_modes || distance(i, n) > farthest) {
            continue;
        }
        size_t& holder = peak_of[static_cast<size_t>(n)];
        if (holder == peaks.size() || distance(i, n) < distance(holder, n)) {
            if (holder != peaks.size()) {
                modes[holder] = 0;
            }
            holder = i;
            modes[i] = n;
        }
    }
    return modes;
}

/// ln of a density: each peak is of none with a probability of a half, and then anywhere up to the
/// highest.
double log_foreign(const std::vector<FrequencyPeak>& peaks) {
    return -std::log(2.0 * peaks.back().frequency);
}

/// A string, and how well it explains the peaks.
struct Explanation {
    StringFit fit = {};
    double log_evidence = -HUGE_VAL;
};

/// (mode numbers) of docs/theory.md.
double log_evidence(const std::vector<FrequencyPeak>& peaks, const StringFit& fit,
                    const FrequencyRange& range) {
    const double twice_pi = 2.0 * std::numbers::pi;
    double sum = 0.0;
    for (size_t i = 0; i < peaks.size(); ++i) {
        const double std_dev = total_std(peaks[i], model_std);
        const double off =
            (peaks[i].frequency - fit.string.frequency(std::max(fit.modes[i], 1))) / std_dev;
        sum += fit.modes[i] > 0 ? -0.5 * off * off - std::log(std_dev * std::sqrt(twice_pi))
                                : log_foreign(peaks);
    }
    const auto k = static_cast<double>(explained_peaks(fit.modes));
    const double highest = *std::ranges::max_element(fit.modes);
    // Which modes up to the highest, M, are seen, each with a probability p of density 2 p; 1 / M
    // of M itself.
    sum += std::log(2.0) + std::lgamma(k + 1.0) + std::lgamma(highest - k + 1.0) -
           std::lgamma(highest + 2.0) - std::log(highest);
    // Laplace's method over ln f_0 and, where it was fitted, ln B, each uniform.
    constexpr double least_inharmonicity = 1e-4;
    const auto share = [&](double relative_std, double ratio) {
        return std::log(std::min(1.0, std::sqrt(twice_pi) * relative_std / std::log(ratio)));
    };
    const Eigen::Matrix2d& c = fit.covariance;
    const double y = fit.string.squared_f0;
    if (!fit.is_stiff) {
        return sum + share(std::sqrt(c(0, 0)) / (2.0 * y), range.highest / range.lowest);
    }
    return sum +
           share(std::sqrt(c(0, 0) - c(0, 1) * c(0, 1) / c(1, 1)) / (2.0 * y),
                 range.highest / range.lowest) +
           share(std::sqrt(c(1, 1)) / y / std::max(fit.string.inharmonicity, least_inharmonicity),
                 most_inharmonicity / least_inharmonicity);
}

/// Assigns and fits in turn from a string near the peaks. Nothing where that leaves the range.
std::optional<Explanation> explanation_near(const std::vector<FrequencyPeak>& peaks,
                                            StiffString string, bool is_stiff,
                                            const FrequencyRange& range) {
    constexpr int rounds = 4;
    StringFit fit;
    for (int round = 0; round < rounds; ++round) {
        const std::vector<int> modes = assigned_modes(peaks, string);
        if (modes == fit.modes) {
            break;
        }
        if (explained_peaks(modes) < (is_stiff ? 3 : 1)) {
            return std::nullopt;
        }
        fit = fit_string(peaks, modes, is_stiff, model_std);
        string = fit.string;
        const double f0 = std::sqrt(string.squared_f0);
        if (!(f0 >= range.lowest && f0 <= range.highest && string.inharmonicity >= 0.0 &&
              string.inharmonicity <= most_inharmonicity)) {
            return std::nullopt;
        }
    }
    const double evidence = log_evidence(peaks, fit, range);
    return Explanation{.fit = std::move(fit), .log_evidence = evidence};
}

/// Of strings through one peak, B = 0, and through two.
std::vector<Explanation> explanations(const std::vector<FrequencyPeak>& peaks,
                                      const FrequencyRange& range) {
    std::vector<Explanation> found;
    const auto try_string = [&](const StiffString& string, bool is_stiff) {
        const double f0 = std::sqrt(string.squared_f0);
        if (f0 > 0.9 * range.lowest && f0 < 1.1 * range.highest) {
            if (auto one = explanation_near(peaks, string, is_stiff, range)) {
                found.push_back(*std::move(one));
            }
        }
    };
    for (size_t i = 0; i < peaks.size(); ++i) {
        for (int n = 1; n <= most_modes; ++n) {
            const double y = std::pow(peaks[i].frequency / n, 2);
            try_string({.squared_f0 = y}, false);
            for (size_t j = i + 1; j < peaks.size(); ++j) {
                for (int m = n + 1; m <= most_modes; ++m) {
                    const double slope = (std::pow(peaks[j].frequency / m, 2) - y) /
                                         (static_cast<double>(m) * m - static_cast<double>(n) * n);
                    const StiffString string{.squared_f0 = y - slope * n * n,
                                             .inharmonicity = slope / (y - slope * n * n)};
                    if (string.inharmonicity > 0.0 && string.inharmonicity <= most_inharmonicity) {
                        try_string(string, true);
                    }
                }
            }
        }
    }
    return found;
}

/// Whether modes are those of one fundamental: no peak has two numbers, and most are shared.
bool are_variants(const std::vector<int>& a, const std::vector<int>& b) {
    Eigen::Index shared = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        if (a[i] > 0 && b[i] > 0) {
            if (a[i] != b[i]) {
                return false;
            }
            ++shared;
        }
    }
    return 2 * shared > std::min(explained_peaks(a), explained_peaks(b));
}

/// Modes without those of peaks that lie there by chance, which all others contradict: one at a
/// time, of at least five.
std::vector<int> without_outliers(const std::vector<FrequencyPeak>& peaks, std::vector<int> modes) {
    constexpr double contradicted = 5.0;  // standard deviations
    for (Eigen::Index k = explained_peaks(modes); k > 4; --k) {
        size_t worst = 0;
        double largest = 0.0;
        for (size_t i = 0; i < peaks.size(); ++i) {
            if (modes[i] > 0) {
                const int n = std::exchange(modes[i], 0);
                const StringFit others = scattered_fit(peaks, modes);
                modes[i] = n;
                const double off = std::abs(peaks[i].frequency - others.string.frequency(n)) /
                                   std::hypot(total_std(peaks[i], others.part), others.std_dev(n));
                worst = off > largest ? i : worst;
                largest = std::max(off, largest);
            }
        }
        if (largest < contradicted) {
            break;
        }
        modes[worst] = 0;
    }
    return modes;
}

Fundamental fundamental_of(const std::vector<FrequencyPeak>& peaks, const std::vector<int>& found) {
    const std::vector<int> modes = without_outliers(peaks, found);
    const StringFit fit = scattered_fit(peaks, modes);
    double squares = 0.0;
    for (size_t i = 0; i < peaks.size(); ++i) {
        squares += modes[i] > 0
                       ? std::pow(peaks[i].frequency / fit.string.frequency(modes[i]) - 1.0, 2)
                       : 0.0;
    }
    return {.frequency = fit.string.frequency(1),
            .std_dev = fit.std_dev(1),
            .inharmonicity = fit.string.inharmonicity,
            .misfit = std::sqrt(squares / static_cast<double>(explained_peaks(modes))),
            .modes = modes};
}

}  // namespace

std::vector<Fundamental> number_modes(const std::vector<FrequencyPeak>& peaks,
                                      const FrequencyRange& range, bool is_certain) {
    std::vector<Explanation> found = explanations(peaks, range);
    std::ranges::sort(found, std::greater{}, &Explanation::log_evidence);
    constexpr double negligible = 15.0;  // of the logarithm
    std::vector<Explanation> distinct;
    for (Explanation& one : found) {
        if (!distinct.empty() && one.log_evidence < distinct.front().log_evidence - negligible) {
            break;
        }
        if (std::ranges::none_of(distinct, [&](const Explanation& other) {
                return are_variants(one.fit.modes, other.fit.modes);
            })) {
            distinct.push_back(std::move(one));
        }
    }
    const double none = static_cast<double>(peaks.size()) * log_foreign(peaks);
    const double largest = std::max(none, distinct.empty() ? none : distinct.front().log_evidence);
    double sum = is_certain ? 0.0 : std::exp(none - largest);
    for (const Explanation& one : distinct) {
        sum += std::exp(one.log_evidence - largest);
    }
    std::vector<Fundamental> fundamentals;
    for (const Explanation& one : distinct) {
        fundamentals.push_back(fundamental_of(peaks, one.fit.modes));
        fundamentals.back().probability = std::exp(one.log_evidence - largest) / sum;
    }
    return fundamentals;
}

}  // namespace taut
