// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "taut/identification/epochs.hpp"
#include "taut/identification/identify.hpp"

namespace taut {

/// Runs an action, and names the survey in its errors.
template <class Action>
auto with_epoch(size_t k, const Action& action) {
    try {
        return action();
    } catch (const SurveyError& error) {
        throw EpochError(static_cast<int>(k), error.what());
    }
}

/// What identify_epochs() requires of its arguments.
/// @throws std::invalid_argument, EpochError as identify_epochs()
void check_epochs(const CableNet& net, std::span<const Epoch> epochs,
                  const IdentifyOptions& options);

}  // namespace taut
