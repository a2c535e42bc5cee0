// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "estimation/detectable_error.hpp"
#include "taut/estimation/outlier.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/forces.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// The value that the largest of `tests` independent chi-squared statistics exceeds with the
/// probability `false_alarm_rate` (Sidak); infinite for 0. docs/theory.md, (threshold).
[[nodiscard]] double snooping_threshold(double false_alarm_rate, size_t tests,
                                        int degrees_of_freedom = 3);

/// Data snooping (W. Baarda, A testing procedure for use in geodetic networks, 1968) for targets,
/// three coordinates at a time; the one test for gross errors of all methods. docs/theory.md,
/// (snooping): with the residual e of a target from the fit, its noise Sigma and the posterior
/// covariance C of its node's place,
///
///   T = e' Q^-1 e,   Q = Sigma - C in use,   Sigma + C rejected,
///
/// has a chi-squared distribution of three degrees of freedom where there is no gross error. Force
/// measurements are tested in the same way, with one degree of freedom.
class DataSnooping {
public:
    /// Keeps references to net, survey, noise (3 x n, positive where surveyed [m]) and forces.
    /// @param false_alarm_rate 0: no test
    DataSnooping(const CableNet& net, const Survey& survey, const Points& noise,
                 const std::vector<ForceMeasurement>& forces, double false_alarm_rate);

    [[nodiscard]] double threshold() const { return m_threshold; }
    /// Whether there is a test at all: an exact survey has no noise to measure residuals by.
    [[nodiscard]] bool is_active() const;
    [[nodiscard]] const std::vector<bool>& rejected() const { return m_rejected; }  ///< by node (n)
    [[nodiscard]] int rejected_count() const;
    /// By force measurement, in their order.
    [[nodiscard]] const std::vector<bool>& rejected_forces() const { return m_rejected_forces; }

    /// Whether more targets are rejected than can have gross errors: then net, frame, prior or
    /// noise are wrong.
    [[nodiscard]] bool rejects_too_many() const { return is_too_many(rejected_count()); }
    /// The same, counting also the targets in use whose statistic is above the threshold.
    [[nodiscard]] bool contradicts_too_many() const {
        return is_too_many(rejected_count() + suspicious_count());
    }

    /// Posterior covariance C of a node's place [m2].
    using FormCovariance = std::function<Eigen::Matrix3d(int node)>;

    /// Computes the statistic of each target at a fit. Where their median is significantly too
    /// large, the noise given is too small, and all are divided by the median's scale:
    /// docs/theory.md (robust-scale).
    /// @param inflation factor on the noise that the fit was made with; where above 1, the scale of
    ///   the residuals always follows from the median of the statistics, but is no smaller than
    ///   that of the true noise. docs/theory.md, (continuation)
    void evaluate(const Points& fitted_form, const FormCovariance& covariance,
                  double inflation = 1.0);
    /// Posterior variance of a weighted sum of tensions, weights by edge (m) [N2 of the weights].
    using SumVariance = std::function<double(const Eigen::VectorXd& weights)>;

    /// The same for the force measurements, and for all of them together: whether they fit only if
    /// each is off by the same part, (common-bias).
    /// @param tensions of the fit (m) [N]
    /// @param variances of these, posterior (m) [N2]
    void evaluate_forces(const Eigen::VectorXd& tensions, const Eigen::VectorXd& variances,
                         const SumVariance& sum_variance, double inflation = 1.0);

    /// Part by which all force measurements are too high, where they were rejected together for
    /// that.
    [[nodiscard]] const std::optional<ForceBias>& force_bias() const { return m_force_bias; }

    /// Rejects the targets above the threshold; of those two edges or less apart only the largest,
    /// since a gross error shows in the residuals around it, too. Where there are none, readmits
    /// for good those that agree with all others. To first order the statistic of a target is the
    /// same in use and rejected. Where it is not, that of the rejected one is more accurate: it
    /// does not depend on a small difference of Sigma and C. A force measurement that stands out
    /// more than every target is rejected before them, the largest alone, since it affects the
    /// whole net; all of them where they stand out together more than each by itself.
    /// @return whether anything changed
    [[nodiscard]] bool revise() { return reject(Eigen::VectorXd()) || readmit(); }
    /// The first half of revise().
    /// @param other_scores of other tests by node (n), which a target has to exceed; empty: none
    [[nodiscard]] bool reject(const Eigen::VectorXd& other_scores);
    /// The second half of revise().
    [[nodiscard]] bool readmit();
    /// Rejects one target, or takes it back.
    void set_rejected(int node, bool is_rejected) { m_rejected[node] = is_rejected; }
    /// Of each target, from the last fit (n).
    [[nodiscard]] const Eigen::VectorXd& statistics() const { return m_statistics; }
    /// The (score) of the target in use at each node (n), comparable with those of other tests.
    [[nodiscard]] Eigen::VectorXd scores() const;

    void reject_suspicious();
    /// What is rejected: one flag a node, one a force measurement.
    struct Rejected {
        std::vector<bool> targets;
        /// Statistics of targets that are confounded with another error, and are not readmitted;
        /// else 0 (n).
        Eigen::VectorXd for_good;
        std::vector<bool> forces;
        std::optional<ForceBias> bias;
    };
    [[nodiscard]] Rejected all_rejected() const {
        return {m_rejected, m_rejected_for_good, m_rejected_forces, m_force_bias};
    }
    /// Rejects these, and no others.
    void set_rejected(Rejected rejected) {
        m_rejected = std::move(rejected.targets);
        m_rejected_for_good = std::move(rejected.for_good);
        m_rejected_forces = std::move(rejected.forces);
        m_force_bias = rejected.bias;
    }
    /// Sum of the thresholds of all that is rejected.
    [[nodiscard]] double rejected_cost() const;
    /// Puts all targets and force measurements back in use.
    void readmit_all();
    /// Allows readmitted ones to be rejected again.
    void reopen();

    /// DetectableErrors::target, for the targets in use at the fit.
    [[nodiscard]] double detectable() const;

    [[nodiscard]] std::vector<Outlier> outliers() const;  ///< the largest statistic first
    [[nodiscard]] std::vector<ForceOutlier> force_outliers() const;  ///< likewise
    /// Root mean square of the standardised residuals in use, over its expectation. docs/theory.md,
    /// (redundancy).
    [[nodiscard]] double noise_ratio() const;
    /// Divisor of all statistics: (robust-scale), (continuation).
    [[nodiscard]] double residual_scale() const { return m_residual_scale; }

private:
    [[nodiscard]] bool is_rejected(int node) const { return m_rejected[node]; }
    /// T of a target at another node's expected place, as if that were its own.
    [[nodiscard]] double statistic_at(int target, int node) const;
    void mark_swapped(std::vector<Outlier>& outliers) const;
    [[nodiscard]] int suspicious_count() const;
    [[nodiscard]] bool is_too_many(int targets) const;
    [[nodiscard]] std::vector<int> largest_above_threshold(
        const Eigen::VectorXd& other_scores) const;
    [[nodiscard]] double median_statistic() const;
    [[nodiscard]] bool reject_all_forces(double than);
    [[nodiscard]] bool reject_worst_force(double than);
    [[nodiscard]] bool readmit_forces();

    const CableNet& m_net;
    const Survey& m_survey;
    const Points& m_noise;
    const std::vector<ForceMeasurement>& m_forces;
    double m_threshold;
    double m_force_threshold;
    std::vector<bool> m_rejected;
    std::vector<bool> m_readmitted;       ///< for good
    Eigen::VectorXd m_rejected_for_good;  ///< Rejected::for_good
    Eigen::VectorXd m_statistics;         ///< n
    Eigen::VectorXd m_distances;          ///< n [m]
    /// Where all others put the node of a rejected target.
    struct ExpectedPlace {
        Eigen::Vector3d place;       // [m]
        Eigen::Matrix3d covariance;  // [m2]
    };
    std::map<int, ExpectedPlace> m_expected_places;  ///< by node
    std::vector<bool> m_rejected_forces;
    std::vector<bool> m_readmitted_forces;  ///< for good
    Eigen::VectorXd m_force_statistics;
    Eigen::VectorXd m_expected;     ///< fitted tensions of the measured edges [N]
    ForceBias m_found_bias;         ///< of the force measurements in use
    double m_bias_statistic = 0.0;  ///< its square in its variances
    std::optional<ForceBias> m_force_bias;
    std::vector<TestedItem> m_in_use;
    double m_residual_scale = 1.0;  ///< residual_scale()
    double m_squares = 0.0;
    double m_redundancy = 0.0;
};

}  // namespace taut
