// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string_view>

#include "taut/abi.hpp"

namespace taut {

/// Thrown where a stop was requested before the work was done.
class Interrupted : public std::runtime_error {
public:
    Interrupted() : std::runtime_error("interrupted") {}
};

/// How long work tells of itself, and asks whether to go on. Both may be empty.
struct Progress {
    /// The stage ("sampling", "training", "identification"), steps done and steps in all. Called
    /// from one thread at a time. Fewer steps than announced may be needed. May throw to give up.
    std::function<void(std::string_view stage, int done, int total)> tell;
    /// Whether to give up. Called from any thread.
    std::function<bool()> stop_requested;

    [[nodiscard]] bool stopped() const { return stop_requested && stop_requested(); }

    /// @throws Interrupted where a stop was requested
    void operator()(std::string_view stage, int done, int total) const {
        if (stopped()) {
            throw Interrupted();
        }
        if (tell) {
            tell(stage, done, total);
        }
    }

    /// That of one part of a stage of `count` parts with as many steps each, the `index`th from 0:
    /// tells of all parts together.
    [[nodiscard]] Progress part(int index, int count) const {
        Progress result = *this;
        if (tell) {
            result.tell = [whole = tell, index, count](std::string_view stage, int done,
                                                       int total) {
                whole(stage, index * total + done, count * total);
            };
        }
        return result;
    }
};

}  // namespace taut
