// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimation/detectable_error.hpp"
#include "estimation/linearised_statics.hpp"
#include "taut/estimation/outlier.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Data snooping of the boundary: the length of each adjustable edge and the place of each support
/// is tested like targets and lengths, by the score statistic of it as a free parameter,
/// docs/theory.md (boundary). An outlier is released: from then on the survey alone determines it.
class BoundarySnooping {
public:
    /// Keeps a reference to the net.
    /// @param uncertain supports among these are tested against their standard deviation
    /// @param false_alarm_rate of targets; 0: no test
    BoundarySnooping(const CableNet& net, const std::vector<UncertainParameter>& uncertain,
                     double false_alarm_rate);

    [[nodiscard]] bool is_active() const { return m_is_active; }

    /// Computes the statistics at a fit.
    /// @param scale DataSnooping::residual_scale()
    void evaluate(const LinearisedStatics& statics, const Iterate& fitted,
                  const Observations& observations, double scale);

    /// Whether the boundary may explain what was found: it has scores above 1, or suspects are
    /// near.
    /// @param suspects above 0 at nodes (n) of rejected targets and released edges
    [[nodiscard]] bool is_suspicious(const Eigen::VectorXd& suspects) const;
    /// As of LengthSnooping.
    [[nodiscard]] Eigen::VectorXd scores() const;
    /// As of LengthSnooping.
    /// @param one_by_one only those near the largest score of all
    [[nodiscard]] bool release(const Eigen::VectorXd& other_scores, bool one_by_one);
    /// As of LengthSnooping.
    [[nodiscard]] bool readmit();
    void readmit_all() { set_released({}); }
    /// Allows readmitted ones to be released again.
    void reopen();

    [[nodiscard]] const BoundaryReleases& released() const { return m_released; }
    void set_released(BoundaryReleases released) { m_released = std::move(released); }
    /// Whether so many are released that none can be named alone.
    [[nodiscard]] bool releases_too_many() const;
    /// How many are above their threshold but not released.
    [[nodiscard]] int not_released_count() const;
    /// Sum of the thresholds of all released.
    [[nodiscard]] double released_cost() const;
    /// DetectableErrors::adjustable or support, for those not released.
    [[nodiscard]] double detectable(BoundaryOutlier::Kind kind) const;
    [[nodiscard]] std::vector<BoundaryOutlier> outliers() const;  ///< the largest statistic first

private:
    /// One adjustable edge or support, with its test at the last fit.
    struct Hypothesis {
        BoundaryOutlier::Kind kind = BoundaryOutlier::Kind::adjustable_edge;
        int index = 0;
        std::vector<int> edges;  ///< of a support
        BoundaryOutlier found;
        double score = 0.0;        ///< (score)
        TestedItem tested;         ///< while not released
        int confounded_with = -1;  ///< when it was released
        bool is_readmitted = false;

        [[nodiscard]] bool is_support() const { return kind == BoundaryOutlier::Kind::support; }
    };
    [[nodiscard]] double threshold_of(const Hypothesis& hypothesis) const {
        return hypothesis.is_support() ? m_support_threshold : m_edge_threshold;
    }
    [[nodiscard]] bool is_released(const Hypothesis& hypothesis) const;
    [[nodiscard]] LinearisedStatics::Score score_of_place(int node,
                                                          const LinearisedStatics& statics,
                                                          const Iterate& fitted,
                                                          const Observations& observations) const;
    void take_score(Hypothesis& hypothesis, const LinearisedStatics::Score& score,
                    double scale) const;
    void take_estimate(Hypothesis& hypothesis, const LinearisedStatics& statics,
                       const Iterate& fitted, double scale) const;
    [[nodiscard]] int confounded_with_of(const Hypothesis& hypothesis) const;
    [[nodiscard]] bool is_suspect(const Hypothesis& hypothesis,
                                  const Eigen::VectorXd& nearby) const;
    /// The released ones of its kind.
    [[nodiscard]] const std::vector<int>& released_like(const Hypothesis& hypothesis) const {
        return hypothesis.is_support() ? m_released.moved : m_released.turned;
    }
    void set_member(const Hypothesis& hypothesis, bool is_member);

    const CableNet& m_net;
    bool m_are_supports_uncertain = false;
    bool m_is_active;
    double m_edge_threshold;     ///< of one degree of freedom
    double m_support_threshold;  ///< of three
    std::vector<Hypothesis> m_hypotheses;
    BoundaryReleases m_released;
};

}  // namespace taut
