// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/abi.hpp"
#include "taut/survey/forces.hpp"

namespace taut {

/// A target that contradicts all others: rejected by data snooping (docs/theory.md, (snooping)).
struct Outlier {
    int node = 0;            ///< the target's: a free node, or a surveyed support
    double distance = 0.0;   ///< of the surveyed place from where all others put it [m]
    double statistic = 0.0;  ///< its square in standard deviations, to be compared with threshold
    /// Node of another outlier if each of both lies where the other should: their names are
    /// swapped; else -1.
    int swapped_with = -1;
};

/// Probability of the priors from which on all of them are meant.
inline constexpr double all_but_sure = 0.95;

/// A force measurement that contradicts all else: left out, or kept though the difference is larger
/// than chance makes the largest of all once in twenty surveys (doubtful_rate).
struct ForceOutlier {
    int edge = 0;                                 ///< whose force was measured
    double measured = 0.0;                        ///< [N]
    double expected = 0.0;                        ///< by all else [N]
    double statistic = 0.0;                       ///< squared difference in its variances
    ForceSource source = ForceSource::load_cell;  ///< as ForceMeasurement::source
    int mode = 0;                                 ///< as ForceMeasurement::mode
    double probability = 1.0;  ///< of the priors by which it was left out; 0: it was kept

    /// Whether all but unlikely priors left it out.
    [[nodiscard]] bool is_left_out() const { return probability > all_but_sure; }
};

/// An edge whose length by the survey is an outlier of the prior: mis-cut, most likely.
struct LengthOutlier {
    int edge = 0;            ///< an interior one
    double deviation = 0.0;  ///< of its length by the survey alone [m]
    double std_dev = 0.0;    ///< of that [m]
    double statistic = 0.0;  ///< squared distance from the prior in its variances
    /// Edge that is as much shorter as this one is longer, or vice versa: a clamp slipped along the
    /// cable, or both were swapped; -1: none.
    int other = -1;
    int node = -1;  ///< where the clamp is, or both meet; -1: nowhere
    /// Whether the target at that node explains it as well and is left out, too: deviation and std
    /// are those if the target is right.
    bool is_beside_target = false;
    bool is_swapped = false;  ///< whether each of both has the length of the other
};

/// An adjustable edge or a support that the survey shows to differ from the design.
struct BoundaryOutlier {
    /// What it is.
    enum class Kind { adjustable_edge, support };
    Kind kind = Kind::adjustable_edge;  ///< what `index` is of
    int index = 0;                      ///< of the edge or node
    /// Of the edge's length (the first alone), or of the support's place [m].
    Eigen::Vector3d deviation = Eigen::Vector3d::Zero();
    Eigen::Vector3d std_dev = Eigen::Vector3d::Zero();  ///< of that [m]
    double statistic = 0.0;                             ///< its square in standard deviations
    /// Support of the edge, or adjustable edge at the support, that would explain it nearly as
    /// well; -1: none.
    int confounded_with = -1;
};

/// Common relative error of all force measurements: a wrong unit or calibration. Left out or kept
/// as a ForceOutlier.
struct ForceBias {
    double part = 0.0;     ///< they are too high by
    double std_dev = 0.0;  ///< of that
    double probability =
        1.0;  ///< of the priors by which all were left out for it; 0: all were kept

    /// As ForceOutlier::is_left_out().
    [[nodiscard]] bool is_left_out() const { return probability > all_but_sure; }
};

/// Probability that measurements without gross errors are doubted, though kept.
inline constexpr double doubtful_rate = 0.05;

/// Probability that a survey without gross errors loses a target by the test. Small, since a lost
/// target can cost the edges around it their determination, while real gross errors stand far above
/// any threshold.
inline constexpr double default_false_alarm_rate = 0.001;

}  // namespace taut
