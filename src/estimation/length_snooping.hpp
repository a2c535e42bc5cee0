// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "estimation/linearised_statics.hpp"
#include "estimation/observations.hpp"
#include "taut/estimation/length_posterior.hpp"
#include "taut/estimation/outlier.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_prior.hpp"

namespace taut {

/// What may be wrong with lengths: one edge is of another length than its prior lets expect, or two
/// that meet at a node, one as much longer as the other is shorter.
struct LengthSuspect {
    Eigen::Index edge = 0;        ///< among the interior edges (m_I)
    Eigen::Index other = -1;      ///< of two the second; -1: there is none
    int node = -1;                ///< where two meet
    bool is_of_one_run = false;   ///< two that one cable may slip between; else only swapped
    double statistic = 0.0;       ///< of a normal prior as wide
    double core_statistic = 0.0;  ///< beyond what the prior holds for possible
    /// By the survey alone, of two [m]; of one it is in the likelihoods.
    Eigen::Vector2d deviation = Eigen::Vector2d::Zero();
    Eigen::Vector2d std = Eigen::Vector2d::Zero();  ///< of that [m]
    bool is_released = false;
    bool is_readmitted = false;  ///< for good
    /// Whether the target at the node explains it as well, and is left out with it.
    bool is_beside_target = false;

    [[nodiscard]] bool is_pair() const { return other >= 0; }
};

/// Data snooping of the lengths: the prior of an edge's length is tested as targets are, against
/// what survey and statics tell of the length without it, docs/theory.md (length-snooping); and so
/// are those of two edges at a node, (slip). What is beyond its prior is released: one too wide to
/// tell anything takes the place of its own.
class LengthSnooping {
public:
    /// Keeps a reference to the net.
    /// @param priors of the interior edges (m_I)
    /// @param false_alarm_rate of all tests of one edge together, and of all of two; 0: no test
    LengthSnooping(const CableNet& net, std::vector<LengthPrior> priors, double false_alarm_rate);

    /// The statistics at a fit.
    /// @param told of each interior edge without its prior (m_I)
    /// @param fitted where the statics are linearised and inverted
    void evaluate(const std::vector<LengthLikelihood>& told, const LinearisedStatics& statics,
                  const Observations& observations, const Iterate& fitted);

    /// The largest score, (score), of the edges in use at each node (n), to be held
    /// against those of other tests.
    [[nodiscard]] Eigen::VectorXd scores() const;

    /// Releases what is beyond its prior and stands out more than all else within two edges.
    /// @param other_scores scores of other tests by node (n)
    /// @return whether there was any
    [[nodiscard]] bool release(const Eigen::VectorXd& other_scores);
    /// Pairs of one run at a node, but for those of which an edge is released in another pair: what
    /// (slip) tries.
    /// @return places among suspects()
    [[nodiscard]] std::vector<size_t> pairs_at(int node) const;
    /// Releases a pair, or gives it its prior back; neither edge is released by itself.
    /// @param place among suspects()
    void set_pair(size_t place, bool is_released);
    /// Whether one edge of a pair is as much longer as the other is shorter, by what a fit tells of
    /// them.
    [[nodiscard]] bool is_slip(const LengthSuspect& pair) const;
    /// Gives those back their prior, for good, that agree with it after all.
    [[nodiscard]] bool readmit();
    void readmit_all();
    /// All have their prior from now on: where more are beyond it than can be mis-cut it is the
    /// prior that is wrong.
    void give_up() {
        m_given_up = released_count();
        readmit_all();
    }
    [[nodiscard]] bool is_active() const { return m_given_up == 0 && std::isfinite(m_threshold); }
    /// Edges beyond their prior, where they are more than can be mis-cut; else 0.
    [[nodiscard]] int given_up() const { return m_given_up; }
    /// Lets edges that were readmitted be released again.
    void reopen();

    [[nodiscard]] std::vector<bool> released() const;  ///< m_I
    [[nodiscard]] const std::vector<LengthSuspect>& suspects() const { return m_suspects; }
    void set_suspects(std::vector<LengthSuspect> suspects) { m_suspects = std::move(suspects); }
    /// Whether more are beyond their prior than can be mis-cut: the prior is wrong then.
    [[nodiscard]] bool releases_too_many() const;
    /// The priors to fit with: those of released edges are normal and wide (m_I).
    [[nodiscard]] std::vector<LengthPrior> priors() const;
    /// Sum of the thresholds of all that is released.
    [[nodiscard]] double released_cost() const;
    /// DetectableErrors::length, of the edges in use at the fit.
    [[nodiscard]] double detectable(const std::vector<int>& edges) const;
    [[nodiscard]] std::vector<LengthOutlier> outliers() const;  ///< the largest statistic first

private:
    [[nodiscard]] double threshold_of(const LengthSuspect& suspect) const {
        return suspect.is_pair() ? m_pair_threshold : m_threshold;
    }
    [[nodiscard]] double score_of(const LengthSuspect& suspect) const;
    [[nodiscard]] bool is_outlier(const LengthSuspect& suspect) const {
        return std::max(suspect.statistic, suspect.core_statistic) > threshold_of(suspect);
    }
    [[nodiscard]] bool may_release(const LengthSuspect& suspect,
                                   const std::vector<bool>& released) const;
    [[nodiscard]] bool is_testable(const LengthSuspect& pair,
                                   const std::vector<bool>& released) const;
    [[nodiscard]] std::vector<int> nodes_of(const LengthSuspect& suspect) const;
    [[nodiscard]] int released_count() const;
    void add_pairs();
    void evaluate_one(LengthSuspect& suspect) const;
    void evaluate_pairs(const LinearisedStatics& statics, const Observations& observations,
                        const Iterate& fitted);
    void take_pair(LengthSuspect& pair, const Eigen::Matrix2d& covariance,
                   const Eigen::Vector2d& unseen, const Observations& observations,
                   const Iterate& fitted) const;
    [[nodiscard]] bool is_swap(const LengthSuspect& pair, const Eigen::Matrix2d& scatter) const;
    [[nodiscard]] double swapped_difference(const LengthSuspect& pair) const;
    void mark_swapped(std::vector<LengthOutlier>& outliers) const;

    const CableNet& m_net;
    std::vector<LengthPrior> m_priors;
    double m_threshold;
    double m_pair_threshold;
    double m_released_std;  ///< of the prior of a released edge [m]
    int m_given_up = 0;
    std::vector<LengthSuspect> m_suspects;  ///< one an edge (m_I), then pairs
    std::vector<LengthLikelihood> m_told;
};

}  // namespace taut
