// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

struct Identification;

/// Whether a result can be used, by all its tests together.
struct TAUT_CORE_EXPORT Trust {
    /// Ascending: the worst is the largest.
    enum class Verdict {
        passed,    ///< nothing speaks against it
        doubtful,  ///< something was found that should be checked first
        failed,    ///< an assumption is wrong: its intervals are not reliable
    };
    /// A remedy: a parameter and its value.
    struct Remedy {
        std::string parameter;  ///< "noise", "prior", "uncertain", "frame", "match"
        std::string value;      ///< as read from text, "0.71mm"; empty: to be chosen

        bool operator==(const Remedy&) const = default;  ///< all fields
    };
    /// What one test found.
    struct TAUT_CORE_EXPORT Finding {
        /// What is wrong, or may be; `value` and `ids` of each.
        enum class Kind {
            no_convergence,
            survey_scale,          ///< of the survey over the net's, less 1
            survey_frame,          ///< shift of the survey [m]
            survey_noise,          ///< standard deviation found over the one given
            missing_load,          ///< downwards at each free node [N]
            prior,                 ///< standard deviation of the lengths found [m]
            common_deviation,      ///< that all lengths have in common [m]
            run_scales,            ///< standard deviation of the runs' scales
            length,                ///< deviation of an edge [m]
            slip,                  ///< deviations of two edges at a clamp, the first one's [m]
            swapped_cables,        ///< likewise
            adjustable_edge,       ///< deviation of its length from the one given [m]
            support,               ///< distance from its design position [m]
            boundary,              ///< number of adjustable edges and supports, not which
            target,                ///< distance from where all else puts it [m]
            adjacent_targets,      ///< number of targets next to each other that were left out
            swapped_targets,       ///< two nodes with each other's names
            target_far_from_node,  ///< distance from the node of its name [m]
            misplaced_names,       ///< number of points on other nodes than they name
            predicted_form,        ///< distance of the predicted form from a target [m]
            slack_marks,           ///< edges marked slack or taut that are not
            force_scale,           ///< of all force measurements over what is expected, less 1
            force_measurement,     ///< measured less expected [N]
            given_stiffness,       ///< relative change of EA that forces or known loads show
            uncertain_parameter,   ///< standard deviation found over the one assumed
            tensions,              ///< they are not reported
            length_change,         ///< of an edge between two surveys [m]
            turns,                 ///< all strokes over those given
            actuator_std,          ///< of the turns, besides the one given [m]
            epoch,                 ///< change of the lengths between two surveys over the expected
            repeated_survey,       ///< difference of two surveys' errors over the expected
            net_balance,           ///< force out of balance at a node over the mean tension
            sag,    ///< of cables, taken as none or as a parabola: error as length [m]
            other,  ///< read from a result of an earlier version, without a kind
        };
        Kind kind = Kind::no_convergence;    ///< what this is about
        Verdict severity = Verdict::passed;  ///< what this alone leads to
        std::vector<std::string> ids;        ///< of its edges or nodes
        std::optional<double> value;         ///< SI, as `Kind` has it
        std::optional<double> std_dev;       ///< standard deviation of the value
        /// Edges and nodes that would explain it nearly as well: the survey does not show which.
        std::vector<std::string> confounded_with;
        std::optional<Remedy> remedy;  ///< what to identify again with
        std::string reason;            ///< in sentences
        std::string advice;            ///< what to do about it, in sentences; may be empty

        /// Both, one after the other.
        [[nodiscard]] std::string text() const;
    };
    std::vector<Finding> findings;  ///< the worst first

    /// The worst of all findings.
    [[nodiscard]] Verdict verdict() const;
};

/// "passed", "doubtful", "failed".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(Trust::Verdict verdict);
/// Its name: "survey_scale".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(Trust::Finding::Kind kind);
/// The kind of a name; none of another word.
[[nodiscard]] TAUT_CORE_EXPORT std::optional<Trust::Finding::Kind> finding_kind(
    std::string_view name);

/// The findings of all tests of a result, docs/theory.md, "Diagnostics". identify() has called it.
/// @param survey the one that was identified from; that net, survey and result go together is not
///   checked
[[nodiscard]] TAUT_CORE_EXPORT Trust trust_of(const CableNet& net, const Survey& survey,
                                              const Identification& result);

}  // namespace taut
