// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string_view>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// Thrown where a stop was requested before the work was done.
class TAUT_CORE_EXPORT Interrupted : public std::runtime_error {
public:
    /// A message of its own: "interrupted".
    Interrupted() : std::runtime_error("interrupted") {}
};

/// How long work tells of itself, and asks whether to go on. Both may be empty. What they refer to
/// must live as long as the call that they are given to; no call keeps them.
struct Progress {
    /// The stage ("sampling", "training", "identification"), steps done and steps in all. Called
    /// from one thread at a time, not always the one that called taut, and with a lock held: it
    /// must neither call taut nor wait for oneTBB. Fewer steps than announced may be needed; 0 in
    /// all where their number is not known. What it throws ends the call, and comes out of it.
    std::function<void(std::string_view stage, int done, int total)> tell;
    /// Whether to give up. Called from any thread, from several at once, and often: it should only
    /// look. What it throws ends the call, too.
    std::function<bool()> stop_requested;

    /// Whether a stop was requested.
    [[nodiscard]] bool stopped() const { return stop_requested && stop_requested(); }

    /// @throws Interrupted where a stop was requested
    void throw_if_stopped() const {
        if (stopped()) {
            throw Interrupted();
        }
    }

    /// Tells of a step, unless a stop was requested.
    /// @throws Interrupted where it was; and what the two functions throw
    void operator()(std::string_view stage, int done, int total) const {
        throw_if_stopped();
        if (tell) {
            tell(stage, done, total);
        }
    }

    /// That of one part of a stage of `count` parts with as many steps each, the `index`th from 0:
    /// tells of all parts together. Holds copies of the functions, and no reference to this.
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
