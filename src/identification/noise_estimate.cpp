// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/noise_estimate.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "identification/maximum_a_posteriori.hpp"

namespace taut {

double noise_scale_of(const CableNet& net, const Survey& survey, const LengthPrior& prior,
                      const IdentifyOptions& options, const Progress& progress) {
    if (!survey.is_noisy()) {
        throw std::invalid_argument("estimate_noise is for a survey that is not exact");
    }
    constexpr int most_rounds = 8;
    constexpr double converged = 0.01;
    constexpr double least_known = 0.25;  // largest relative std of a usable estimate
    const Given given(prior, options.uncertain, options.forces);
    Survey scaled = survey;
    double scale = 1.0;
    for (int round = 0; round < most_rounds; ++round) {
        const Identification fit =
            identify_by_maximum_a_posteriori(net, scaled, given, {}, {}, progress);
        if (fit.status != IdentificationStatus::converged) {
            return scale;  // the result reports it
        }
        const double ratio = fit.scales.noise.ratio;
        if (!(fit.scales.noise.std_dev < least_known * ratio)) {
            break;
        }
        scaled = with_noise_times(std::move(scaled), ratio);
        scale *= ratio;
        if (std::abs(ratio - 1.0) < converged) {
            return scale;
        }
    }
    throw SurveyError(0,
                      "does not show its noise: it has too little redundancy. Give its standard "
                      "deviation");
}

}  // namespace taut
