// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "taut/net/cable_net.hpp"

namespace taut {

/// The value that the largest of `tests` independent chi-squared statistics exceeds with the
/// probability `false_alarm_rate` (Sidak); infinite for 0. docs/theory.md, (threshold).
[[nodiscard]] double snooping_threshold(double false_alarm_rate, size_t tests,
                                        int degrees_of_freedom = 3);

/// What may be wrong, in the order of the table.
enum class Suspect {
    target,
    force,        ///< one force measurement
    force_scale,  ///< all force measurements are off by the same part
    length,       ///< of an interior edge
    pair,         ///< of interior edges at a node: a clamp slipped, or both were swapped
    adjustable_edge,
    support
};

/// One possible error, with its test at the last fit.
struct Hypothesis {
    enum class State {
        in_use,
        readmitted,        ///< in use for good
        released,          ///< left out, or nothing is assumed of it
        released_for_good  ///< with another one that it is confounded with
    };
    /// How the last fit tested it.
    enum class Test { none, in_use, released };

    Suspect kind = Suspect::target;
    /// Node, edge, place among the force measurements or among the interior edges (m_I).
    int index = 0;
    int other = -1;              ///< second edge of a pair, among the interior edges (m_I)
    bool is_of_one_run = false;  ///< a pair that one cable may slip between; else only swapped
    std::array<int, 3> nodes{-1, -1, -1};  ///< where it counts; the first of a pair is in common
    int degrees_of_freedom = 1;            ///< of the statistic: 1 or 3
    double threshold = std::numeric_limits<double>::infinity();  ///< (threshold)

    State state = State::in_use;
    Test test = Test::none;
    double statistic = 0.0;       ///< chi-squared, where there is no such error
    double core_statistic = 0.0;  ///< W_b of (length-snooping): outside the core of the prior
    /// The error: of a target from where all others put it, of a force measurement [N], its part
    /// of all, of a length, of both of a pair, of a support's place [m].
    Eigen::Vector3d deviation = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the deviation [its unit squared]
    /// Of the statistic, per squared error, while in use [1/m2].
    Eigen::Matrix3d noncentrality = Eigen::Matrix3d::Zero();
    bool is_lower_bound = false;  ///< a length of an edge that may be slack: no shorter than that
    int confounded_with = -1;     ///< support of the edge, or edge at the support, when released

    [[nodiscard]] Eigen::Vector3d std_dev() const {  ///< of the deviation [its unit]
        return covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    }
    [[nodiscard]] bool is_released() const { return state >= State::released; }
    [[nodiscard]] bool is_pair() const { return kind == Suspect::pair; }
    [[nodiscard]] double largest_statistic() const { return std::max(statistic, core_statistic); }
    [[nodiscard]] bool is_outlier() const { return largest_statistic() > threshold; }
    /// Makes tests of any degrees of freedom comparable:
    ///
    ///   score = max(0, 1 + (statistic - threshold) / 20),
    ///
    /// above 1 where the statistic is above its threshold, and larger where more of the misfit is
    /// explained. docs/theory.md, (score).
    [[nodiscard]] double score() const;
};

/// All hypotheses of a fit: data snooping (W. Baarda, A testing procedure for use in geodetic
/// networks, 1968) by one set of rules, docs/theory.md (snooping). A value: a copy keeps what was
/// found, and restores it. The tests themselves are the functions of target_tests.hpp,
/// length_tests.hpp and boundary_tests.hpp.
class Hypotheses {
public:
    /// Those of which too many cannot be true together.
    enum class Family { targets, forces, lengths, boundary };

    /// Whether the boundary takes part: not, like all else, or after all else and only with the
    /// largest scores of all.
    enum class BoundaryTest { none, at_once, one_by_one };

    /// Keeps a pointer to the net.
    /// @param all by kind, in the order of Suspect, and within one by index
    Hypotheses(const CableNet& net, std::vector<Hypothesis> all);

    [[nodiscard]] std::span<const Hypothesis> of(Suspect kind) const;
    [[nodiscard]] std::span<Hypothesis> of(Suspect kind);
    /// @return null where there is none of a kind with this index
    [[nodiscard]] Hypothesis* find(Suspect kind, int index);
    /// Releases the length of an edge (m), interior or adjustable, whatever its test.
    /// @return false where it is released already, or has no test
    [[nodiscard]] bool release_edge(int edge);
    /// Whether there is a test at all: an exact survey has no noise to measure residuals by.
    [[nodiscard]] bool is_active(Family family) const;
    [[nodiscard]] double threshold(Suspect kind) const;  ///< infinite where there is no test

    /// Before the tests of a fit: none but the boundary's, which not every fit makes, counts
    /// longer.
    void begin_tests();
    /// Before a fit: hypotheses readmitted may be released again.
    void reopen();
    /// One step of data snooping after the tests of a fit. Releases the outliers that stand out
    /// within two edges; where there are none, readmits for good those that agree with all else.
    /// @return whether anything changed
    [[nodiscard]] bool revise(BoundaryTest boundary = BoundaryTest::none);
    /// Puts all back in use.
    void readmit_all();
    /// Releases what is above its threshold of a kind, whether it stands out or not.
    void release_outliers(Suspect kind);
    /// Leaves out all force measurements in use, for good.
    void release_forces();
    /// Releases a pair of lengths, or restores its priors; neither edge is released by itself then.
    void set_pair(Hypothesis& pair, bool is_released);

    /// The released ones of a kind, the largest statistic first.
    [[nodiscard]] std::vector<Hypothesis> found(Suspect kind) const;
    /// Indices of the released ones of a kind, ascending.
    [[nodiscard]] std::vector<int> released(Suspect kind) const;
    /// The same as flags, one for each index from 0 to count - 1.
    [[nodiscard]] std::vector<bool> is_released(Suspect kind, int count) const;
    /// Interior edges (m_I) that are released, by themselves or in a pair.
    [[nodiscard]] std::vector<bool> released_lengths() const;
    /// How many of a family are released.
    [[nodiscard]] int released_count(Family family) const;
    /// How many of a family are in use, though above their threshold.
    [[nodiscard]] int suspicious_count(Family family) const;
    /// Whether so many are released that they are not the reason: of targets, then net, frame,
    /// prior or noise are wrong; of lengths, their prior; of the boundary none can be named.
    [[nodiscard]] bool has_too_many(Family family) const {
        return is_too_many(family, released_count(family));
    }
    /// The same, counting also suspicious_count().
    [[nodiscard]] bool contradicts_too_many(Family family) const {
        return is_too_many(family, released_count(family) + suspicious_count(family));
    }
    /// How many lengths were released when their test ended, since the prior is wrong; else 0.
    [[nodiscard]] int given_up() const { return m_given_up; }
    /// Whether the boundary may explain what was found: it has scores above 1, or a rejected target
    /// or released edge is within two edges.
    [[nodiscard]] bool may_be_boundary() const;
    /// Sum of the thresholds of all that is released.
    [[nodiscard]] double cost() const;
    /// DetectableErrors of a kind, for those in use at the fit.
    [[nodiscard]] double detectable(Suspect kind) const;

    double residual_scale = 1.0;  ///< divisor of all statistics: (robust-scale), (continuation)
    /// Root mean square of the standardised residuals in use, over its expectation. docs/theory.md,
    /// (redundancy).
    double noise_ratio = 0.0;

private:
    [[nodiscard]] bool is_too_many(Family family, int count) const;
    [[nodiscard]] bool is_open(const Hypothesis& hypothesis,
                               const std::vector<bool>& released_lengths) const;
    using Filter = std::function<bool(const Hypothesis&)>;
    [[nodiscard]] Eigen::VectorXd scores(const Filter& is_candidate) const;
    [[nodiscard]] bool release_force(double than);
    [[nodiscard]] bool release(const Eigen::VectorXd& scores, double least,
                               const Filter& is_candidate);
    [[nodiscard]] bool readmit(const Filter& is_candidate);
    void give_up_lengths();
    [[nodiscard]] int confounded_with(const Hypothesis& hypothesis) const;

    const CableNet* m_net;
    std::vector<Hypothesis> m_all;
    int m_given_up = 0;
};

}  // namespace taut
