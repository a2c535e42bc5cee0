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

/// A possible length outlier: one edge, or a pair of edges at a node of which one is as much longer
/// as the other is shorter.
struct LengthSuspect {
    Eigen::Index edge = 0;        ///< among the interior edges (m_I)
    Eigen::Index other = -1;      ///< the second edge of a pair; -1: a single edge
    int node = -1;                ///< where a pair meets
    bool is_of_one_run = false;   ///< a pair that one cable may slip between; else only swapped
    double statistic = 0.0;       ///< against a normal prior of the same standard deviation
    double core_statistic = 0.0;  ///< W_b of (length-snooping): outside the core of the prior
    /// Of a pair, by the survey alone [m]; that of a single edge is in the likelihoods.
    Eigen::Vector2d deviation = Eigen::Vector2d::Zero();
    Eigen::Vector2d std = Eigen::Vector2d::Zero();  ///< of the deviations [m]
    bool is_released = false;
    bool is_readmitted = false;  ///< for good
    /// Whether the target at the node explains it as well, and is left out, too.
    bool is_beside_target = false;

    [[nodiscard]] bool is_pair() const { return other >= 0; }
};

/// Data snooping of the lengths: the prior of an edge's length is tested like a target, against the
/// length that survey and statics give without it, docs/theory.md (length-snooping). Pairs of edges
/// at a node are tested likewise, (slip). An outlier is released: it gets a prior too wide to
/// matter.
class LengthSnooping {
public:
    /// Keeps a reference to the net.
    /// @param priors of the interior edges (m_I)
    /// @param false_alarm_rate of all tests of one edge together, and of all of two; 0: no test
    LengthSnooping(const CableNet& net, std::vector<LengthPrior> priors, double false_alarm_rate);

    /// Computes the statistics at a fit.
    /// @param likelihoods of each interior edge's length, without its prior (m_I)
    /// @param fitted where the statics are linearised and inverted
    void evaluate(const std::vector<LengthLikelihood>& likelihoods,
                  const LinearisedStatics& statics, const Observations& observations,
                  const Iterate& fitted);

    /// The largest (score) of the edges in use at each node (n), comparable with those of other
    /// tests.
    [[nodiscard]] Eigen::VectorXd scores() const;

    /// Releases the outliers whose score is the largest within two edges.
    /// @param other_scores of other tests by node (n)
    /// @return whether there was any
    [[nodiscard]] bool release(const Eigen::VectorXd& other_scores);
    /// Pairs of one run at a node that (slip) tries: those with no edge released in another pair.
    /// @return places among suspects()
    [[nodiscard]] std::vector<size_t> pairs_at(int node) const;
    /// Releases a pair, or restores its priors; neither edge is released by itself then.
    /// @param place among suspects()
    void set_pair(size_t place, bool is_released);
    /// Whether one edge of a pair is as much longer as the other is shorter, within what a fit
    /// shows.
    [[nodiscard]] bool is_slip(const LengthSuspect& pair) const;
    /// Restores, for good, the priors of those that agree with them after all.
    /// @return whether there was any
    [[nodiscard]] bool readmit();
    void readmit_all();
    /// Ends the test, with all priors restored: more outliers than can be mis-cut mean that the
    /// prior is wrong.
    void give_up() {
        m_given_up = released_count();
        readmit_all();
    }
    [[nodiscard]] bool is_active() const { return m_given_up == 0 && std::isfinite(m_threshold); }
    /// How many outliers there were when the test ended by give_up(); else 0.
    [[nodiscard]] int given_up() const { return m_given_up; }
    /// Allows readmitted ones to be released again.
    void reopen();

    [[nodiscard]] std::vector<bool> released() const;  ///< m_I
    [[nodiscard]] const std::vector<LengthSuspect>& suspects() const { return m_suspects; }
    void set_suspects(std::vector<LengthSuspect> suspects) { m_suspects = std::move(suspects); }
    /// Whether more are released than can be mis-cut: then the prior is wrong.
    [[nodiscard]] bool releases_too_many() const;
    /// The priors to fit with: those of released edges are normal and wide (m_I).
    [[nodiscard]] std::vector<LengthPrior> priors() const;
    /// Sum of the thresholds of all released.
    [[nodiscard]] double released_cost() const;
    /// DetectableErrors::length, for the edges in use at the fit.
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
    std::vector<LengthSuspect> m_suspects;        ///< one an edge (m_I), then pairs
    std::vector<LengthLikelihood> m_likelihoods;  ///< m_I, at the last fit
};

}  // namespace taut
