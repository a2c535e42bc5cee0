// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/form_conditioning.hpp"

#include <cmath>
#include <utility>

#include "estimation/observations.hpp"
#include "estimation/target_tests.hpp"
#include "numerics/memory_budget.hpp"
#include "survey/covariance.hpp"

namespace taut {

ConditionedForm::ConditionedForm(const CableNet& net, const FormPrior& before, const Survey& survey,
                                 Eigen::VectorXd nominal_form, double false_alarm_rate)
    : m_net(net),
      m_before(before),
      m_survey(survey),
      m_nominal_form(std::move(nominal_form)),
      m_noise(with_noise_floor(net, survey)),
      m_common(common_noise_variance()),
      m_hypotheses(net, measurement_hypotheses(survey, {}, false_alarm_rate)) {
    condition();
    if (!m_hypotheses.is_active(Hypotheses::Family::targets)) {
        return;
    }
    evaluate();
    while (!m_hypotheses.has_too_many(Hypotheses::Family::targets) && m_hypotheses.revise()) {
        condition();
        evaluate();
    }
}

std::optional<double> ConditionedForm::common_noise_variance() const {
    if (m_survey.surveyed.empty()) {
        return std::nullopt;
    }
    const double std_dev = m_noise(0, m_survey.surveyed.front());
    for (const int node : m_survey.surveyed) {
        if ((m_noise.col(node).array() != std_dev).any() ||
            !m_survey.correlations_of(node).isZero(0.0)) {
            return std::nullopt;
        }
    }
    return std_dev * std_dev;
}

/// On the targets that are not rejected.
void ConditionedForm::condition() {
    m_observed.clear();
    std::vector<bool> is_observed(m_net.free_node_count(), false);
    for (const Hypothesis& target : m_hypotheses.of(Suspect::target)) {
        if (!target.is_released()) {
            m_observed.push_back(target.index);
            is_observed[m_net.free_index(target.index)] = true;
        }
    }
    Eigen::VectorXd residual =
        free_coordinates(m_net, m_survey.form) - m_nominal_form - m_before.mean;
    std::vector<int> unobserved;  // coordinates
    for (int i = 0; i < m_net.free_node_count(); ++i) {
        for (int k = 3 * i; !is_observed[i] && k < 3 * i + 3; ++k) {
            residual(k) = 0.0;
            unobserved.push_back(k);
        }
    }
    if (m_common) {
        fill_in(*m_common, residual, unobserved);
    } else {
        condition_by_factor(residual);
    }
}

/// (filled-in) With the same noise variance v of all coordinates, K = C + v I of all of them,
/// observed or not, has the precisions p = 1 / (c + v) along the directions. The unobserved ones
/// are filled in by their conditional mean, -P_uu^-1 P_uo r_o with P = K^-1 = D' diag(p) D, whose
/// error has the covariance P_uu^-1.
/// @param unobserved coordinates u, at which the residual is 0
void ConditionedForm::fill_in(double noise_variance, const Eigen::VectorXd& residual,
                              const std::vector<int>& unobserved) {
    const Eigen::MatrixXd& D = m_before.directions;
    const Eigen::VectorXd p = (m_before.variances.array() + noise_variance).inverse();
    const Eigen::VectorXd gain = m_before.variances.cwiseProduct(p);
    Eigen::VectorXd along = D * residual;
    m_diagonal = noise_variance * gain;
    m_root.resize(0, D.rows());
    if (!unobserved.empty()) {
        const auto hidden = static_cast<double>(std::ssize(unobserved));
        const MemoryCharge charge =
            charge_numbers(hidden * (2.0 * hidden + 3.0 * static_cast<double>(D.rows())));
        const Eigen::MatrixXd D_u = D(Eigen::all, unobserved);
        const Cholesky factor(gram(p.cwiseSqrt().asDiagonal() * D_u));  // of P_uu
        along -= D_u * factor.solve(D_u.transpose() * p.cwiseProduct(along)).col(0);
        m_root = factor.solve_lower(D_u.transpose() * gain.asDiagonal());
    }
    m_mean = m_before.mean + D.transpose() * gain.cwiseProduct(along);
}

/// (by-factor) With c^1/2 taken out, so that it may be zero, the precision of t is
/// c^-1/2 (I + W'W) c^-1/2, W = Sigma^-1/2 D_o' c^1/2.
void ConditionedForm::condition_by_factor(const Eigen::VectorXd& residual) {
    const Eigen::VectorXd c_root = m_before.variances.cwiseSqrt();
    const MemoryCharge charge = charge_numbers(static_cast<double>(c_root.size()) *
                                               (3.0 * static_cast<double>(std::ssize(m_observed)) +
                                                3.0 * static_cast<double>(c_root.size())));
    Eigen::MatrixXd W(3 * std::ssize(m_observed), c_root.size());
    Eigen::VectorXd whitened(W.rows());
    for (Eigen::Index i = 0; i < std::ssize(m_observed); ++i) {
        const int node = m_observed[i];
        const Eigen::Index at = Eigen::Index{3} * m_net.free_index(node);
        const Eigen::Matrix3d whiten = whitening_of(
            {.std_dev = m_noise.col(node), .correlations = m_survey.correlations_of(node)});
        whitened.segment<3>(3 * i) = whiten * residual.segment<3>(at);
        W.middleRows<3>(3 * i) =
            whiten * m_before.directions.middleCols<3>(at).transpose() * c_root.asDiagonal();
    }
    Eigen::MatrixXd precision = gram(W);
    precision.diagonal().array() += 1.0;
    const Cholesky factor(std::move(precision));
    m_mean = m_before.mean + m_before.directions.transpose() *
                                 c_root.cwiseProduct(factor.solve(W.transpose() * whitened).col(0));
    m_diagonal = Eigen::VectorXd::Zero(c_root.size());
    m_root = factor.solve_lower(c_root.asDiagonal());
}

void ConditionedForm::evaluate() {
    const Eigen::MatrixXd reduced = product(m_root, m_before.directions);
    m_hypotheses.begin_tests();
    test_targets(m_hypotheses, m_survey, m_noise,
                 with_free_coordinates(m_net, m_nominal_form + m_mean),
                 [&](int node) -> Eigen::Matrix3d {
                     const Eigen::Index at = Eigen::Index{3} * m_net.free_index(node);
                     const auto D = m_before.directions.middleCols<3>(at);
                     const auto TD = reduced.middleCols<3>(at);
                     return D.transpose() * m_diagonal.asDiagonal() * D + TD.transpose() * TD;
                 });
}

std::vector<Outlier> ConditionedForm::outliers() const {
    return target_outliers(m_hypotheses, m_survey, m_noise);
}

Eigen::VectorXd ConditionedForm::variances_along(const Eigen::MatrixXd& gradients) const {
    return gradients.cwiseAbs2().transpose() * m_diagonal +
           product(m_root, gradients).colwise().squaredNorm().transpose();
}

}  // namespace taut
