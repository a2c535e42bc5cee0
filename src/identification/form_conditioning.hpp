// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "estimation/hypotheses.hpp"
#include "numerics/dense.hpp"
#include "taut/estimation/outlier.hpp"
#include "taut/export/core.hpp"
#include "taut/identification/model.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// The form after a survey, docs/theory.md (conditioning): a normal distribution conditioned on the
/// surveyed coordinates with their noise, gross errors rejected by data snooping.
///
/// Computed in the prior's principal directions, x = mean + D' t with the variances c of t. The
/// covariance of t after the survey is diag(s) + T'T. Where the noise of all coordinates is the
/// same, T has one row for each coordinate without a target in use, (filled-in); else s is zero,
/// (by-factor).
class TAUT_CORE_EXPORT ConditionedForm {
public:
    /// Keeps references to all but the nominal form. Not copied: its parts refer to each other.
    /// @param nominal_form that deviations refer to (3 n_I) [m]
    ConditionedForm(const CableNet& net, const FormPrior& before, const Survey& survey,
                    Eigen::VectorXd nominal_form, double false_alarm_rate);
    ConditionedForm(const ConditionedForm&) = delete;
    ConditionedForm& operator=(const ConditionedForm&) = delete;

    [[nodiscard]] const Eigen::VectorXd& mean() const { return m_mean; }  ///< 3 n_I [m]

    /// Variance of g't of each column g of `gradients` (3 n_I x k), derivatives along the prior's
    /// directions: D times those with respect to the coordinates.
    [[nodiscard]] Eigen::VectorXd variances_along(const Eigen::MatrixXd& gradients) const;

    [[nodiscard]] const Hypotheses& hypotheses() const { return m_hypotheses; }  ///< of targets
    [[nodiscard]] std::vector<Outlier> outliers() const;  ///< the largest statistic first

private:
    void condition();
    void fill_in(double noise_variance, const Eigen::VectorXd& residual,
                 const std::vector<int>& unobserved);
    void condition_by_factor(const Eigen::VectorXd& residual);
    void evaluate();
    /// That of all coordinates that are surveyed, where it is the same (m2).
    [[nodiscard]] std::optional<double> common_noise_variance() const;

    const CableNet& m_net;
    const FormPrior& m_before;
    const Survey& m_survey;
    Eigen::VectorXd m_nominal_form;
    Points m_noise;                  ///< 3 x n [m]
    std::optional<double> m_common;  ///< common_noise_variance()
    std::vector<int> m_observed;     ///< nodes with a target in use
    Eigen::VectorXd m_mean;          ///< 3 n_I [m]
    Eigen::VectorXd m_diagonal;      ///< s (3 n_I) [m2]
    Eigen::MatrixXd m_root;          ///< T (any x 3 n_I) [m]
    Hypotheses m_hypotheses;
};

}  // namespace taut
