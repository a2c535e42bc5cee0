// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "taut/adjustment/plan.hpp"

namespace taut::app {

/// --turn 5mm --step 1/4; nothing where no turn is given.
/// @throws std::invalid_argument
std::optional<TurnSize> parse_turn(const std::string& turn, const std::string& step);

/// Limits of tension, as given.
struct TensionRange {
    /// A force [N], or a part of the breaking load.
    struct End {
        double value = 0.0;
        bool is_part = false;
        bool is_given = false;
        /// @param breaking_load of the edge, used for a part only [N]
        [[nodiscard]] double at(double breaking_load) const {
            return is_part ? value * breaking_load : value;
        }
    };
    End least;
    End most;  ///< infinite where it is not given
    [[nodiscard]] bool has_part() const { return least.is_part || most.is_part; }
};

/// "1.5kN..10kN", "20%..60%", "1kN..60%", of which either end may be left out.
/// @throws std::invalid_argument for anything else, a least below 0 or not below the most, and
///   parts above 100 %
TensionRange parse_tension_range(const std::string& text);

}  // namespace taut::app
