// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string_view>

namespace taut {

/// Told of the work as it goes on, from one thread at a time: the stage ("sampling", "training",
/// "identification"), steps done and steps in all. In training the steps are decompositions, of
/// which fewer than announced may be needed.
using StudyProgress = std::function<void(std::string_view stage, int done, int total)>;

/// Thrown where a stop was requested before the work was done.
class Interrupted : public std::runtime_error {
public:
    Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace taut
