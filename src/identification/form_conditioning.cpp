// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/form_conditioning.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "estimation/data_snooping.hpp"
#include "taut/statics/form_sensitivity.hpp"

namespace taut {
namespace {

/// The covariance of centred samples (d x n) with its entries off the diagonal times 1 - a, where
/// a = sum Var(s_ij) / sum s_ij^2 over these entries is their part that is chance.
Eigen::MatrixXd shrunk_covariance(const Eigen::MatrixXd& centred) {
    const auto n = static_cast<double>(centred.cols());
    const Eigen::MatrixXd mean_product = product(centred, centred.transpose()) / n;
    const Eigen::MatrixXd squares = centred.cwiseAbs2();
    // Of the products w = e_i e_j: sum (w - mean w)^2 = sum w^2 - n (mean w)^2.
    const Eigen::MatrixXd spread =
        product(squares, squares.transpose()) - n * mean_product.cwiseAbs2();
    const double unbiased = n / std::max(1.0, n - 1.0);
    const double chance =
        std::pow(unbiased, 3) / (n * n) * (spread.sum() - spread.diagonal().sum());
    const double all =
        unbiased * unbiased * (mean_product.squaredNorm() - mean_product.diagonal().squaredNorm());
    const double part = all > 0.0 ? std::clamp(chance / all, 0.0, 1.0) : 1.0;
    Eigen::MatrixXd result = (1.0 - part) * unbiased * mean_product;
    result.diagonal() = unbiased * mean_product.diagonal();
    return result;
}

}  // namespace

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
                                 const Survey& survey, const Eigen::VectorXd& nominal_form,
                                 const Points& noise, double threshold)
    : m_before(before), m_noise(free_coordinates(net, noise)) {
    const Eigen::VectorXd surveyed = free_coordinates(net, survey.form) - nominal_form;
    const Neighbours neighbours = neighbours_of(net);
    std::vector<bool> left_out(net.node_count(), false);
    std::vector<int> taken_back;  // for good
    while (true) {
        use_targets(net, survey.surveyed, left_out);
        condition(surveyed);
        if (!std::isfinite(threshold)) {
            return;
        }
        Eigen::VectorXd suspicious = statistics(net.node_count());
        suspicious(taken_back).setZero();
        const std::vector<int> worst =
            worst_targets(m_nodes, neighbours, suspicious, left_out, threshold);
        const auto still_used = static_cast<double>(m_nodes.size() - worst.size());
        if (still_used < (1.0 - most_outliers) * static_cast<double>(survey.surveyed.size())) {
            m_fits = false;
            tell_outliers(net, survey.surveyed, left_out, surveyed);
            return;
        }
        for (const int node : worst) {
            left_out[node] = true;
        }
        if (!worst.empty()) {
            continue;
        }
        tell_outliers(net, survey.surveyed, left_out, surveyed);
        const size_t taken_before = taken_back.size();
        for (const Outlier& outlier : m_outliers) {
            if (outlier.statistic <= threshold) {
                left_out[outlier.node] = false;
                taken_back.push_back(outlier.node);
            }
        }
        if (taken_back.size() == taken_before) {
            return;
        }
    }
}

/// Takes the targets that are not left out as observed.
void ConditionedForm::use_targets(const CableNet& net, const std::vector<int>& surveyed,
                                  const std::vector<bool>& left_out) {
    m_nodes.clear();
    m_observed.clear();
    for (const int node : surveyed) {
        if (!left_out[node]) {
            m_nodes.push_back(node);
            for (int k = 0; k < 3; ++k) {
                m_observed.push_back(3 * net.free_index(node) + k);
            }
        }
    }
}

void ConditionedForm::condition(const Eigen::VectorXd& surveyed_deviations) {
    Eigen::MatrixXd K = m_before.covariance(m_observed, m_observed);
    K.diagonal() += m_noise(m_observed).cwiseAbs2();
    m_factor.emplace(std::move(K));
    m_weights = m_factor->solve((surveyed_deviations - m_before.mean)(m_observed)).col(0);
    m_mean = m_before.mean + m_before.covariance(Eigen::all, m_observed) * m_weights;
}

Eigen::VectorXd ConditionedForm::statistics(int node_count) {
    const Eigen::MatrixXd P = m_factor->inverse_lower();
    Eigen::VectorXd result = Eigen::VectorXd::Zero(node_count);
    double squares = 0.0;
    double redundancy = 0.0;
    for (size_t i = 0; i < m_nodes.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(3 * i);
        const Eigen::Vector3d a = m_weights.segment<3>(at);
        const Eigen::Matrix3d block = P.block<3, 3>(at, at).selfadjointView<Eigen::Lower>();
        result(m_nodes[i]) = a.dot(block.llt().solve(a));
        // The residual is Sigma a, of covariance Sigma P Sigma.
        const Eigen::Vector3d noise = m_noise.segment<3>(m_observed[3 * i]);
        squares += noise.cwiseProduct(a).squaredNorm();
        redundancy += noise.cwiseAbs2().dot(block.diagonal());
    }
    m_noise_ratio = redundancy > 0.0 ? std::sqrt(squares / redundancy) : 0.0;
    return result;
}

void ConditionedForm::tell_outliers(const CableNet& net, const std::vector<int>& surveyed,
                                    const std::vector<bool>& left_out,
                                    const Eigen::VectorXd& surveyed_deviations) {
    m_outliers.clear();
    for (const int node : surveyed) {
        if (!left_out[node]) {
            continue;
        }
        const int at = 3 * net.free_index(node);
        const Eigen::Vector3d error = (surveyed_deviations - m_mean).segment<3>(at);
        Eigen::MatrixXd coordinates = Eigen::MatrixXd::Zero(m_mean.size(), 3);
        coordinates.middleRows<3>(at).setIdentity();
        const Eigen::MatrixXd root = reduced(coordinates);
        Eigen::Matrix3d Q = m_before.covariance.block<3, 3>(at, at) - root.transpose() * root;
        Q.diagonal() += m_noise.segment<3>(at).cwiseAbs2();
        m_outliers.push_back(
            {.node = node, .distance = error.norm(), .statistic = error.dot(Q.llt().solve(error))});
    }
    std::ranges::sort(m_outliers, std::greater{}, &Outlier::statistic);
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
