// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "identification/simulated_survey.hpp"
#include "support/identify_lengths.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"

/// What the tests of diagnostics share.
namespace of_diagnostics {

using namespace taut;
using namespace taut::test;

using Kind = Trust::Finding::Kind;
using Verdict = Trust::Verdict;

inline constexpr LengthPrior prior{LengthPrior::Kind::uniform, 0.005};
inline constexpr double noise = 0.5e-3;

inline const CableNet& net() {
    static const CableNet built_in = hilo_quarter();
    return built_in;
}

inline Identification identified(const Survey& survey, std::optional<LengthPrior> given,
                                 IdentificationMethod method = IdentificationMethod::map) {
    return test::identify_lengths(net(), survey, {.method = method, .prior = given});
}

/// With all that taut assumes on a site, without draws.
inline Identification identified_on_site(const CableNet& of, const Survey& survey,
                                         std::optional<LengthPrior> given, int draws = 0) {
    return test::identify_lengths(of, survey,
                                  {.prior = given, .assume_site = true, .draws = draws});
}

inline SimulatedSurvey survey_of(const CableNet& of, const LengthPrior& truth, std::uint64_t seed) {
    return simulate(of, truth, noise, seed);
}

inline bool says(const Identification& result, const std::string& words) {
    return std::ranges::any_of(result.trust.findings, [&](const Trust::Finding& finding) {
        return finding.reason.find(words) != std::string::npos;
    });
}

}  // namespace of_diagnostics
