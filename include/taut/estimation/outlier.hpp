// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/abi.hpp"

namespace taut {

/// A target that contradicts all others: rejected by data snooping (docs/theory.md, (snooping)).
struct Outlier {
    int node = 0;            ///< the target's: a free node, or a surveyed support
    double distance = 0.0;   ///< of the surveyed place from the one that all others tell [m]
    double statistic = 0.0;  ///< its square in standard deviations, to be compared with threshold
    /// Node of another outlier, where each of both lies where the other should: their names are
    /// swapped; else -1.
    int swapped_with = -1;
};

/// A reading of a force that contradicts all else.
struct ForceOutlier {
    int edge = 0;            ///< whose force was read
    double measured = 0.0;   ///< [N]
    double expected = 0.0;   ///< what all else tells [N]
    double statistic = 0.0;  ///< squared difference in its variances
};

/// An edge whose length the survey shows to be beyond the prior of the others: mis-cut, most
/// likely.
struct LengthOutlier {
    int edge = 0;            ///< an interior one
    double deviation = 0.0;  ///< of its length by the survey alone [m]
    double std = 0.0;        ///< of that [m]
    double statistic = 0.0;  ///< squared distance from the prior in its variances
    /// Edge that is as much shorter as this one is longer, or the other way round: a clamp slipped
    /// along the cable, or both were swapped; -1: none.
    int other = -1;
    int node = -1;  ///< where the clamp is, or both meet; -1: nowhere
    /// Whether the target at that node explains it as well, and is left out, too: deviation and std
    /// are those if the target is right.
    bool is_beside_target = false;
    bool is_swapped = false;  ///< whether each of both has the length of the other
};

/// An adjustable edge or a support that the survey shows not to be as told.
struct BoundaryOutlier {
    /// What it is.
    enum class Kind { adjustable_edge, support };
    Kind kind = Kind::adjustable_edge;  ///< what `index` is of
    int index = 0;                      ///< of the edge or node
    /// Of the edge's length (the first alone), or of the support's place [m].
    Eigen::Vector3d deviation = Eigen::Vector3d::Zero();
    Eigen::Vector3d std = Eigen::Vector3d::Zero();  ///< of that [m]
    double statistic = 0.0;                         ///< its square in standard deviations
    /// The support of the edge, or an adjustable edge at the support, that would explain it nearly
    /// as well; -1: none.
    int confounded_with = -1;
};

/// What all readings of forces have in common against all else: a wrong unit, a calibration.
struct ForceBias {
    double part = 0.0;  ///< by which they are too high
    double std = 0.0;   ///< of that
};

/// Probability that a survey without gross errors loses a target by the test for them. Small: a
/// target less can cost the edges around it all that is known of them, while gross errors worth the
/// name stand far above any threshold.
inline constexpr double default_false_alarm_rate = 0.001;

}  // namespace taut
