// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "estimation/epoch_evidence.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// (epoch-slip): a target that is left out, as a clamp that slipped at its node since the survey
/// before explains it as well.
struct SlipOrTarget {
    int node = 0;
    std::vector<LengthChange> lengths;  ///< of both edges, if the target is right

    /// By how much either may have changed: of two found one after the other, the first one's
    /// estimate is too small [m].
    [[nodiscard]] double width() const {
        return std::max(std::abs(lengths[0].change), std::abs(lengths[1].change));
    }
};

/// (epoch-slip) of a target that a survey by itself rejects: whether it lies along a cable from
/// where the others put it.
/// @param form where they put all nodes (3 x n) [m]
[[nodiscard]] std::optional<SlipOrTarget> slip_to_target(const CableNet& net, const Survey& survey,
                                                         const Points& form, const Outlier& target);

/// (epoch-slip) of changes: two that are opposite, of edges that meet, are one slip or its target.
/// @param changes lose them
/// @param found gains them
void take_out_slips(const CableNet& net, std::vector<LengthChange>& changes,
                    std::vector<SlipOrTarget>& found);

/// How lengths changed before a survey, besides the turns given.
struct EpochChanges {
    /// Since the survey before; of the first survey: of adjustable edges from the net. The largest
    /// first.
    std::vector<LengthChange> lengths;
    Agreement agreement;               ///< of all others
    double excess_actuator_std = 0.0;  ///< EpochResult::excess_actuator_std [m]
    double stroke_factor = 1.0;        ///< EpochResult::stroke_factor
    double stroke_factor_std = 0.0;    ///< EpochResult::stroke_factor_std
    /// Whether that factor explains all: then no length is let go.
    bool is_of_all_turns = false;
    /// A strain in common of all interior edges, or those of a group, that chance does not explain.
    struct CommonStrain {
        std::string group;  ///< empty: of all
        double strain = 0.0;
        double std_dev = 0.0;
    };
    std::optional<CommonStrain> common_strain;
    std::vector<SlipOrTarget> slips_or_targets;  ///< in which no other change is

    /// Whether the factor on all strokes is not 1.
    [[nodiscard]] bool are_strokes_off() const;
};

/// The entries of x, LengthEvidence: edges with uncertain length, then common parameters.
struct EpochEntries {
    std::vector<int> edges;  ///< ascending
    int common = 0;          ///< number of common parameters

    [[nodiscard]] Eigen::Index size() const {
        return static_cast<Eigen::Index>(edges.size()) + common;
    }
    [[nodiscard]] Eigen::Index place_of(int edge) const;
};

/// Whether more lengths changed than can have: then the turns are wrong.
[[nodiscard]] bool are_too_many_changes(const CableNet& net, size_t changes);

/// Lets lengths that changed go, one after another, until none is left, (epoch-change).
/// @param edges that may have changed
/// @return the largest change first
[[nodiscard]] std::vector<LengthChange> let_go_changed(EvidenceTest& test, const CableNet& net,
                                                       const EpochEntries& entries,
                                                       const std::vector<int>& edges);

/// What a comparison found, and the lengths that it let go, which these changes may explain
/// otherwise.
struct ComparedEpoch {
    EpochChanges changes;
    std::vector<LengthChange> let_go;
};

/// Compares a survey with those before it and the turns given: single lengths, a factor on all
/// strokes, a strain in common, and the scatter of the turns.
/// @param turned before the survey, as given
/// @param scattering edges whose turns may scatter more than given
[[nodiscard]] ComparedEpoch compared_epoch(EvidenceTest test, const CableNet& net,
                                           const EpochEntries& entries,
                                           const std::vector<EdgeTurned>& turned,
                                           const std::vector<int>& scattering);

}  // namespace taut
