// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

struct Identification;

/// Whether a result may be acted on, from all tests of it together.
struct TAUT_CORE_EXPORT Trust {
    /// Ascending: the worst is the largest.
    enum class Verdict {
        passed,    ///< nothing speaks against it
        doubtful,  ///< something was found that should be looked at first
        failed,    ///< something that was told is not true: its intervals are not to be relied on
    };
    /// What one test found.
    struct Finding {
        Verdict verdict = Verdict::passed;  ///< what this test alone leads to
        std::string reason;                 ///< in words
        std::string next;                   ///< what to do about it; may be empty
    };
    std::vector<Finding> findings;  ///< the worst first

    /// The worst of all findings.
    [[nodiscard]] Verdict verdict() const;
};

/// "passed", "doubtful", "failed".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(Trust::Verdict verdict);

/// What the tests of a result found, docs/theory.md, "Doubt". identify() has called it already.
/// @param survey the one that was identified from; that net, survey and result go together is not
///   checked
[[nodiscard]] TAUT_CORE_EXPORT Trust trust_of(const CableNet& net, const Survey& survey,
                                              const Identification& result);

}  // namespace taut
