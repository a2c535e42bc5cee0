// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/form_conditioning.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimation/observations.hpp"
#include "numerics/shrunk_covariance.hpp"
#include "taut/statics/form_sensitivity.hpp"
#include "taut/survey/covariance.hpp"

namespace taut {

FormDistribution form_before_survey(const CableNet& net, const LengthModel& model) {
    const Eigen::MatrixXd J = FormSensitivity(net, net.unstressed_lengths(),
                                              with_free_coordinates(net, model.nominal_form))
                                  .columns(net.interior_edges());
    Eigen::MatrixXd remainder = model.form_deviations() - product(J, model.length_deviations);
    FormDistribution result{.mean = remainder.rowwise().mean(), .covariance = {}};
    remainder.colwise() -= result.mean;
    result.covariance = shrunk_covariance(remainder);
    result.covariance += model.law.std() * model.law.std() * product(J, J.transpose());
    return result;
}

ConditionedForm::ConditionedForm(const CableNet& net, const FormDistribution& before,
                                 const Survey& survey, Eigen::VectorXd nominal_form,
                                 double false_alarm_rate)
    : m_net(net),
      m_before(before),
      m_survey(survey),
      m_nominal_form(std::move(nominal_form)),
      m_noise(with_noise_floor(net, survey)),
      m_snooping(net, survey, m_noise, m_no_readings, false_alarm_rate) {
    condition();
    if (!m_snooping.is_active()) {
        return;
    }
    evaluate();
    while (!m_snooping.rejects_too_many() && m_snooping.revise()) {
        condition();
        evaluate();
    }
}

/// On the targets that are not rejected.
void ConditionedForm::condition() {
    m_place_in_use.assign(m_net.node_count(), -1);
    m_observed.clear();
    for (const int node : m_survey.surveyed) {
        if (!m_snooping.rejected()[node]) {
            m_place_in_use[node] = static_cast<int>(m_observed.size()) / 3;
            for (int k = 0; k < 3; ++k) {
                m_observed.push_back(3 * m_net.free_index(node) + k);
            }
        }
    }
    const Eigen::VectorXd surveyed = free_coordinates(m_net, m_survey.form) - m_nominal_form;
    Eigen::MatrixXd K = m_before.covariance(m_observed, m_observed);
    for (const int node : m_survey.surveyed) {
        if (const int place = m_place_in_use[node]; place >= 0) {
            K.block<3, 3>(3 * place, 3 * place) += noise_covariance(node);
        }
    }
    m_factor.emplace(std::move(K));
    const Eigen::VectorXd weights = m_factor->solve((surveyed - m_before.mean)(m_observed)).col(0);
    m_mean = m_before.mean + m_before.covariance(Eigen::all, m_observed) * weights;
}

void ConditionedForm::evaluate() {
    m_precision = m_factor->inverse_lower();
    m_snooping.evaluate(with_free_coordinates(m_net, m_nominal_form + m_mean),
                        [this](int node) { return covariance_of(node); });
}

Eigen::Matrix3d ConditionedForm::noise_covariance(int node) const {
    return taut::covariance_of(
        {.std = m_noise.col(node), .correlations = m_survey.correlations_of(node)});
}

/// Of a node's place after the survey: Sigma - Sigma P Sigma of a target in use, which keeps the
/// digits of the redundancy Sigma P Sigma; else C - C_o' K^-1 C_o.
Eigen::Matrix3d ConditionedForm::covariance_of(int node) const {
    const int at = 3 * m_net.free_index(node);
    if (const Eigen::Index place = m_place_in_use[node]; place >= 0) {
        const Eigen::Matrix3d P =
            m_precision.block<3, 3>(3 * place, 3 * place).selfadjointView<Eigen::Lower>();
        const Eigen::Matrix3d noise = noise_covariance(node);
        return noise - noise * P * noise;
    }
    Eigen::MatrixXd coordinates = Eigen::MatrixXd::Zero(m_mean.size(), 3);
    coordinates.middleRows<3>(at).setIdentity();
    const Eigen::MatrixXd root = reduced(coordinates);
    return m_before.covariance.block<3, 3>(at, at) - root.transpose() * root;
}

Eigen::MatrixXd ConditionedForm::reduced(const Eigen::MatrixXd& gradients) const {
    return m_factor->solve_lower(product(m_before.covariance(m_observed, Eigen::all), gradients));
}

Eigen::VectorXd ConditionedForm::variances(const Eigen::MatrixXd& gradients) const {
    const Eigen::VectorXd before =
        gradients.cwiseProduct(product(m_before.covariance, gradients)).colwise().sum();
    const Eigen::VectorXd told = reduced(gradients).colwise().squaredNorm();
    return (before - told).cwiseMax(0.0);
}

}  // namespace taut
