// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "numerics/dense.hpp"
#include "taut/identification/form_distribution.hpp"
#include "taut/identification/identification.hpp"
#include "taut/identification/model.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// The form after a survey: a normal distribution conditioned on the surveyed coordinates with
/// their noise, gross errors left out.
///
/// A target is tested against what all others let expect of it: with K = C_oo + Sigma of the
/// surveyed coordinates, a = K^-1 (y - mean) and P = K^-1, the statistic a_i' P_ii^-1 a_i has a
/// chi-squared distribution of three degrees of freedom. Targets that fit once others were left out
/// are taken back for good.
class ConditionedForm {
public:
    /// @param nominal_form that deviations refer to (3 n_I) [m]
    /// @param noise standard deviation of each coordinate (3 x n), positive where surveyed [m]
    /// @param threshold of the test; infinite: none
    ConditionedForm(const CableNet& net, const FormDistribution& before, const Survey& survey,
                    const Eigen::VectorXd& nominal_form, const Points& noise, double threshold);

    [[nodiscard]] const Eigen::VectorXd& mean() const { return m_mean; }  ///< 3 n_I [m]

    /// g' C g of each column g of `gradients` (3 n_I x k), C the covariance after the survey.
    [[nodiscard]] Eigen::VectorXd variances(const Eigen::MatrixXd& gradients) const;

    /// False where so many targets contradict the others that it is not they who are wrong; those
    /// found last are then still in use.
    [[nodiscard]] bool fits() const { return m_fits; }
    [[nodiscard]] const std::vector<Outlier>& outliers() const { return m_outliers; }

    /// Root mean square of the standardised residuals in use, over their expectation.
    [[nodiscard]] double noise_ratio() const { return m_noise_ratio; }

private:
    void use_targets(const CableNet& net, const std::vector<int>& surveyed,
                     const std::vector<bool>& left_out);
    void condition(const Eigen::VectorXd& surveyed_deviations);
    /// The test statistic of each node in use (n), 0 elsewhere; finds the noise ratio.
    [[nodiscard]] Eigen::VectorXd statistics(int node_count);
    void tell_outliers(const CableNet& net, const std::vector<int>& surveyed,
                       const std::vector<bool>& left_out,
                       const Eigen::VectorXd& surveyed_deviations);
    /// L^-1 C_o g: what the survey takes from the variance is its square.
    [[nodiscard]] Eigen::MatrixXd reduced(const Eigen::MatrixXd& gradients) const;

    const FormDistribution& m_before;
    Eigen::VectorXd m_noise;           ///< of the free coordinates (3 n_I)
    std::vector<int> m_nodes;          ///< targets in use
    std::vector<int> m_observed;       ///< their coordinates, among the free ones
    std::optional<Cholesky> m_factor;  ///< of K
    Eigen::VectorXd m_weights;         ///< a
    Eigen::VectorXd m_mean;
    std::vector<Outlier> m_outliers;
    double m_noise_ratio = 0.0;
    bool m_fits = true;
};

}  // namespace taut
