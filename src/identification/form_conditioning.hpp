// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "estimation/data_snooping.hpp"
#include "numerics/dense.hpp"
#include "taut/export/core.hpp"
#include "taut/identification/model.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Normal distribution of the free coordinates' deviations from the nominal form.
struct FormDistribution {
    Eigen::VectorXd mean;        ///< 3 n_I [m]
    Eigen::MatrixXd covariance;  ///< 3 n_I x 3 n_I [m2]
};

/// What is known of the form before any survey, docs/theory.md (form-prior): the length deviations'
/// law, taken as normal, through the linearised statics J, and the remainder e = x - J d of the
/// model's training samples,
///
///   mean(e),   law.std()^2 J J' + cov(e),
///
/// with cov(e) shrunk towards its diagonal.
[[nodiscard]] TAUT_CORE_EXPORT FormDistribution form_before_survey(const CableNet& net,
                                                                   const LengthModel& model);

/// The form after a survey, docs/theory.md (conditioning): a normal distribution conditioned on the
/// surveyed coordinates with their noise, gross errors rejected by data snooping.
class TAUT_CORE_EXPORT ConditionedForm {
public:
    /// Keeps references to all but the nominal form. Not copied: its parts refer to each other.
    /// @param nominal_form that deviations refer to (3 n_I) [m]
    ConditionedForm(const CableNet& net, const FormDistribution& before, const Survey& survey,
                    Eigen::VectorXd nominal_form, double false_alarm_rate);
    ConditionedForm(const ConditionedForm&) = delete;
    ConditionedForm& operator=(const ConditionedForm&) = delete;

    [[nodiscard]] const Eigen::VectorXd& mean() const { return m_mean; }  ///< 3 n_I [m]

    /// g' C g of each column g of `gradients` (3 n_I x k), C the covariance after the survey.
    [[nodiscard]] Eigen::VectorXd variances(const Eigen::MatrixXd& gradients) const;

    [[nodiscard]] const DataSnooping& snooping() const { return m_snooping; }

private:
    void condition();
    void evaluate();
    [[nodiscard]] Eigen::Matrix3d covariance_of(int node) const;
    [[nodiscard]] Eigen::Matrix3d noise_covariance(int node) const;  ///< Sigma of a target [m2]
    /// L^-1 C_o g: what the survey takes from the variance is its square.
    [[nodiscard]] Eigen::MatrixXd reduced(const Eigen::MatrixXd& gradients) const;

    const CableNet& m_net;
    const FormDistribution& m_before;
    const Survey& m_survey;
    Eigen::VectorXd m_nominal_form;
    Points m_noise;                    ///< 3 x n [m]
    std::vector<int> m_place_in_use;   ///< of each node (n) among the targets in use, or -1
    std::vector<int> m_observed;       ///< coordinates of these, among the free ones
    std::optional<Cholesky> m_factor;  ///< of K = C_oo + Sigma
    Eigen::MatrixXd m_precision;       ///< P = K^-1, its lower triangle; made by evaluate()
    Eigen::VectorXd m_mean;
    std::vector<ForceReading> m_no_readings;
    DataSnooping m_snooping;
};

}  // namespace taut
