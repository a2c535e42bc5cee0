// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/survey/survey.hpp"

namespace taut::test {

/// The error with which an action is refused; of line -1 where it is taken.
template <class Action>
SurveyError survey_error_of(const Action& action) {
    try {
        static_cast<void>(action());
    } catch (const SurveyError& error) {
        return error;
    }
    return {-1, "not refused"};
}

}  // namespace taut::test
