// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string_view>

#include "taut/abi.hpp"
#include "taut/error.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// Thrown if a stop was requested before the work was done.
class TAUT_CORE_EXPORT Interrupted : public std::runtime_error, public Error {
public:
    [[nodiscard]] ErrorCode code() const noexcept override {
        return ErrorCode::interrupted;
    }  ///< Error
    /// With the message "interrupted".
    Interrupted() : std::runtime_error("interrupted") {}
};

/// How long calls report progress, and ask whether to continue. Both functions may be empty. What
/// they refer to must outlive the call that they are passed to; no call keeps them.
struct Progress {
    /// Receives the stage ("sampling", "training", "identification"), the steps done and their
    /// total number; 0 if this is not known. Fewer steps than announced may suffice. Called from
    /// one thread at a time, not always the one that called taut, and with a lock held: it must
    /// neither call taut nor wait for oneTBB. If it throws, the call ends with its exception.
    std::function<void(std::string_view stage, int done, int total)> report;
    /// Whether to stop. Called often, from any thread and from several at once: it should only read
    /// a flag. If it throws, the call ends with its exception.
    std::function<bool()> stop_requested;

    /// Whether a stop was requested.
    [[nodiscard]] bool stopped() const { return stop_requested && stop_requested(); }

    /// @throws Interrupted if a stop was requested
    void throw_if_stopped() const {
        if (stopped()) {
            throw Interrupted();
        }
    }

    /// Reports a step, unless a stop was requested.
    /// @throws Interrupted if a stop was requested; and what the two functions throw
    void operator()(std::string_view stage, int done, int total) const {
        throw_if_stopped();
        if (report) {
            report(stage, done, total);
        }
    }

    /// Progress for part `index` (from 0) of a stage with `count` parts of equally many steps. It
    /// reports the steps of all parts together. It holds copies of the functions, and no reference
    /// to this object.
    [[nodiscard]] Progress part(int index, int count) const {
        Progress result = *this;
        if (report) {
            result.report = [whole = report, index, count](std::string_view stage, int done,
                                                           int total) {
                whole(stage, index * total + done, count * total);
            };
        }
        return result;
    }
};

}  // namespace taut
