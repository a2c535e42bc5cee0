// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/noise_check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "net/rounded_length.hpp"
#include "survey/mean_edge_length.hpp"
#include "taut/net/units.hpp"
#include "taut/survey/survey.hpp"

namespace taut {
namespace {

constexpr double plausible_part = 0.02;   ///< of the mean edge length
constexpr double plausible_noise = 0.05;  ///< [m]

/// Asks for the noise in millimetres where that is at least 0.01 mm: no instrument is better.
std::string question(double noise_std) {
    constexpr double smallest_meant = 1e-5;
    const double meant = 1e-3 * noise_std;
    return meant >= smallest_meant ? fmt::format("is {} meant? A number without unit is in metres",
                                                 rounded_length(meant))
                                   : "is that meant?";
}

}  // namespace

std::vector<std::string> noise_warnings(const CableNet& net, double noise_std) {
    const double length = mean_edge_length(net);
    if (noise_std <= std::min(plausible_noise, plausible_part * length)) {
        return {};
    }
    return {fmt::format("noise of {} on edges of {:.4g} mm in the mean: {}",
                        rounded_length(noise_std), 1e3 * length, question(noise_std))};
}

void refuse_absurd_noise(const CableNet& net, double noise_std) {
    const double length = mean_edge_length(net);
    if (noise_std > length) {
        throw SurveyError(
            0, fmt::format("noise of {}, expected less than the mean edge length, {:.4g} mm: {}",
                           rounded_length(noise_std), 1e3 * length, question(noise_std)));
    }
}

}  // namespace taut
