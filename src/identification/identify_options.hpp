// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/identification/identify.hpp"

namespace taut {

struct MethodChoice {
    IdentificationMethod method = IdentificationMethod::balance;
    std::string reason;
};

/// Checks net, survey and options against each other.
/// @return the method asked for, or the one that suits the input
/// @throws std::invalid_argument, SurveyError as identify()
[[nodiscard]] MethodChoice checked_method(const CableNet& net, const Survey& survey,
                                          const LengthPrior& prior, const IdentifyOptions& options);

/// Number of posterior samples: as given, or default_draws().
[[nodiscard]] int draws_wanted(const CableNet& net, const IdentifyOptions& options);

/// Numbers that a posterior sample holds while samples are drawn.
[[nodiscard]] double numbers_of_draw(const CableNet& net);

/// @throws std::invalid_argument for one of an edge that slides: the tension of its stretch is a
///   parameter of the fit, which no measurement of one edge tests
void check_forces_on_runs(const CableNet& net, const Forces& forces);

}  // namespace taut
