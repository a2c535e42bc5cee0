// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/data_snooping.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>

#include "estimation/comparable_scores.hpp"
#include "numerics/small_dense.hpp"
#include "taut/survey/covariance.hpp"

namespace taut {
namespace {

/// A direction of which less than this part of the variance is redundant cannot be tested.
constexpr double smallest_redundancy = 1e-3;

/// Part of the targets that can have gross errors; more, and net, frame, prior or noise are wrong.
constexpr double most_outliers = 0.25;

/// Of three degrees of freedom.
constexpr double median_of_chi_squared = 2.366;

/// The noise given may be five times too small, squared; a survey that is farther off does not fit.
constexpr double largest_scale_of_noise = 25.0;

/// Largest median of the statistics by chance, over its expectation: five standard deviations, plus
/// what a quarter of targets with gross errors adds.
double largest_scale_by_chance(size_t targets) {
    constexpr double std_of_median = 1.12;  // over the median, of one; pdf 0.188 at 2.366
    constexpr double by_gross_errors = 1.5;
    return by_gross_errors + 5.0 * std_of_median / std::sqrt(static_cast<double>(targets));
}

}  // namespace

double snooping_threshold(double false_alarm_rate, size_t tests, int degrees_of_freedom) {
    if (!(false_alarm_rate > 0.0)) {
        return std::numeric_limits<double>::infinity();
    }
    const double of_one = -std::expm1(std::log1p(-false_alarm_rate) / static_cast<double>(tests));
    return boost::math::quantile(boost::math::complement(
        boost::math::chi_squared_distribution<>(degrees_of_freedom), of_one));
}

DataSnooping::DataSnooping(const CableNet& net, const Survey& survey, const Points& noise,
                           const std::vector<ForceMeasurement>& forces, double false_alarm_rate)
    : m_net(net),
      m_survey(survey),
      m_noise(noise),
      m_forces(forces),
      m_threshold(snooping_threshold(survey.is_noisy() ? false_alarm_rate : 0.0,
                                     survey.surveyed.size() + forces.size())),
      m_force_threshold(snooping_threshold(survey.is_noisy() ? false_alarm_rate : 0.0,
                                           survey.surveyed.size() + forces.size(), 1)),
      m_rejected(net.node_count(), false),
      m_readmitted(net.node_count(), false),
      m_rejected_for_good(Eigen::VectorXd::Zero(net.node_count())),
      m_statistics(Eigen::VectorXd::Zero(net.node_count())),
      m_distances(Eigen::VectorXd::Zero(net.node_count())),
      m_rejected_forces(forces.size(), false),
      m_readmitted_forces(forces.size(), false),
      m_force_statistics(Eigen::VectorXd::Zero(std::ssize(forces))),
      m_expected(Eigen::VectorXd::Zero(std::ssize(forces))) {}

bool DataSnooping::is_active() const {
    return std::isfinite(m_threshold);
}

int DataSnooping::rejected_count() const {
    return static_cast<int>(std::ranges::count(m_rejected, true));
}

int DataSnooping::suspicious_count() const {
    return static_cast<int>(std::ranges::count_if(m_survey.surveyed, [this](int node) {
        return !is_rejected(node) && m_statistics(node) > m_threshold;
    }));
}

bool DataSnooping::is_too_many(int targets) const {
    return targets > most_outliers * static_cast<double>(m_survey.surveyed.size());
}

void DataSnooping::evaluate(const Points& fitted_form, const FormCovariance& covariance,
                            double inflation) {
    m_statistics.setZero();
    m_squares = 0.0;
    m_redundancy = 0.0;
    m_expected_places.clear();
    m_in_use.clear();
    for (const int node : m_survey.surveyed) {
        const Eigen::Vector3d residual = m_survey.form.col(node) - fitted_form.col(node);
        m_distances(node) = residual.norm();
        // In units of the noise, Sigma = L L': L^-1 Q L'^-1 = I -+ L^-1 C L'^-1.
        const Eigen::Matrix3d whiten = whitening_of(
            {.std = inflation * m_noise.col(node), .correlations = m_survey.correlations_of(node)});
        const Eigen::Vector3d e = whiten * residual;
        const double sign = is_rejected(node) ? 1.0 : -1.0;
        const Eigen::Matrix3d Q =
            Eigen::Matrix3d::Identity() + sign * (whiten * covariance(node) * whiten.transpose());
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(Q);
        Eigen::Matrix3d testable = Eigen::Matrix3d::Zero();  // Q without directions not tested
        for (int k = 0; k < 3; ++k) {
            const double variance = eigen.eigenvalues()(k);
            if (variance > smallest_redundancy) {
                const Eigen::Vector3d direction = eigen.eigenvectors().col(k);
                const double along = direction.dot(e);
                m_statistics(node) += along * along / variance;  // (snooping)
                testable += variance * direction * direction.transpose();
            }
        }
        if (is_rejected(node)) {
            m_expected_places[node] = {fitted_form.col(node), covariance(node)};
        } else {
            m_squares += e.squaredNorm();
            m_redundancy += Q.trace();  // (redundancy)
            m_in_use.push_back({whiten.transpose() * testable * whiten});
        }
    }
    const double scale = median_statistic() / median_of_chi_squared;
    if (inflation > 1.0) {
        m_residual_scale = std::max(scale, 1.0 / (inflation * inflation));
    } else {  // (robust-scale)
        const bool is_given_too_small = scale > largest_scale_by_chance(m_survey.surveyed.size()) &&
                                        scale < largest_scale_of_noise;
        m_residual_scale = is_given_too_small ? scale : 1.0;
    }
    m_statistics /= m_residual_scale;
    for (const int node : m_survey.surveyed) {
        if (m_rejected_for_good(node) > 0.0) {
            m_statistics(node) = m_rejected_for_good(node);
        }
    }
}

void DataSnooping::evaluate_forces(const Eigen::VectorXd& tensions,
                                   const Eigen::VectorXd& variances,
                                   const SumVariance& sum_variance, double inflation) {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(tensions.size());
    double along = 0.0;  // c' W e, c the measured tensions
    double known = 0.0;  // c' W c
    int in_use = 0;
    for (Eigen::Index k = 0; k < std::ssize(m_forces); ++k) {
        const ForceMeasurement& force = m_forces[k];
        const double noise = std::pow(inflation * force.std, 2);
        const double sign = m_rejected_forces[k] ? 1.0 : -1.0;
        const double variance = noise + sign * variances(force.edge);
        m_expected(k) = tensions(force.edge);
        const double residual = force.tension - m_expected(k);
        m_force_statistics(k) = variance > smallest_redundancy * noise
                                    ? residual * residual / variance / m_residual_scale
                                    : 0.0;  // (snooping)
        if (!m_rejected_forces[k]) {
            weights(force.edge) = force.tension / noise;
            along += force.tension * residual / noise;
            known += force.tension * force.tension / noise;
            ++in_use;
        }
    }
    m_bias_statistic = 0.0;
    if (in_use > 1) {  // (common-bias)
        const double redundant = known - sum_variance(weights);
        constexpr double rounding = 1e-7;
        if (redundant > rounding * known) {
            m_found_bias = {.part = along / redundant, .std = 1.0 / std::sqrt(redundant)};
            m_bias_statistic = along * along / redundant / m_residual_scale;
        }
    }
}

/// Of the targets in use.
double DataSnooping::median_statistic() const {
    std::vector<double> in_use;
    for (const int node : m_survey.surveyed) {
        if (!is_rejected(node)) {
            in_use.push_back(m_statistics(node));
        }
    }
    if (in_use.empty()) {
        return 0.0;
    }
    const auto middle = in_use.begin() + static_cast<std::ptrdiff_t>(in_use.size() / 2);
    std::nth_element(in_use.begin(), middle, in_use.end());
    return *middle;
}

/// Targets in use, and not readmitted before, that are above the threshold and have the largest
/// score within two edges.
/// @param other_scores of other tests by node, which must not be larger; empty: none
std::vector<int> DataSnooping::largest_above_threshold(const Eigen::VectorXd& other_scores) const {
    const Eigen::VectorXd own_scores = scores();
    const Eigen::VectorXd all =
        other_scores.size() > 0 ? own_scores.cwiseMax(other_scores) : own_scores;
    const Eigen::VectorXd nearby = largest_nearby(m_net, largest_nearby(m_net, all));
    std::vector<int> result;
    for (const int node : m_survey.surveyed) {
        if (own_scores(node) > 1.0 && own_scores(node) >= nearby(node)) {
            result.push_back(node);
        }
    }
    return result;
}

Eigen::VectorXd DataSnooping::scores() const {
    Eigen::VectorXd scores = Eigen::VectorXd::Zero(m_statistics.size());
    for (const int node : m_survey.surveyed) {
        if (!m_rejected[node] && !m_readmitted[node]) {
            scores(node) = comparable_score(m_statistics(node), m_threshold);
        }
    }
    return scores;
}

bool DataSnooping::reject(const Eigen::VectorXd& other_scores) {
    const std::vector<int> changing = largest_above_threshold(other_scores);
    double largest = other_scores.size() > 0 ? std::max(1.0, other_scores.maxCoeff()) : 1.0;
    for (const int node : changing) {
        largest = std::max(largest, comparable_score(m_statistics(node), m_threshold));
    }
    if (reject_all_forces(largest) || reject_worst_force(largest)) {
        return true;
    }
    for (const int node : changing) {
        m_rejected[node] = true;
    }
    return !changing.empty();
}

bool DataSnooping::readmit() {
    bool has_changed = readmit_forces();
    for (const int node : m_survey.surveyed) {
        if (is_rejected(node) && m_rejected_for_good(node) == 0.0 &&
            m_statistics(node) <= m_threshold) {
            m_rejected[node] = false;
            m_readmitted[node] = true;
            has_changed = true;
        }
    }
    return has_changed;
}

/// Rejects all force measurements where they stand out together more than each by itself.
/// @param than score to exceed
/// @return whether it did
bool DataSnooping::reject_all_forces(double than) {
    const double score = comparable_score(m_bias_statistic, m_force_threshold);
    double worst = than;
    for (Eigen::Index k = 0; k < std::ssize(m_forces); ++k) {
        if (!m_rejected_forces[k]) {
            worst = std::max(worst, comparable_score(m_force_statistics(k), m_force_threshold));
        }
    }
    if (score <= worst) {
        return false;
    }
    m_force_bias = m_found_bias;
    m_rejected_forces.assign(m_forces.size(), true);
    return true;
}

double DataSnooping::rejected_cost() const {
    if (!is_active()) {
        return 0.0;
    }
    const auto forces = std::ranges::count(m_rejected_forces, true);
    return m_threshold * rejected_count() + m_force_threshold * static_cast<double>(forces);
}

/// @param than score to exceed
/// @return whether there was one
bool DataSnooping::reject_worst_force(double than) {
    Eigen::Index worst = -1;
    for (Eigen::Index k = 0; k < std::ssize(m_forces); ++k) {
        const double score = comparable_score(m_force_statistics(k), m_force_threshold);
        if (!m_rejected_forces[k] && !m_readmitted_forces[k] && score > than) {
            worst = k;
            than = score;
        }
    }
    if (worst >= 0) {
        m_rejected_forces[worst] = true;
    }
    return worst >= 0;
}

bool DataSnooping::readmit_forces() {
    bool has_changed = false;
    for (Eigen::Index k = 0; !m_force_bias && k < std::ssize(m_forces); ++k) {
        if (m_rejected_forces[k] && m_force_statistics(k) <= m_force_threshold) {
            m_rejected_forces[k] = false;
            m_readmitted_forces[k] = true;
            has_changed = true;
        }
    }
    return has_changed;
}

void DataSnooping::reject_suspicious() {
    for (const int node : m_survey.surveyed) {
        if (m_statistics(node) > m_threshold) {
            m_rejected[node] = true;
        }
    }
}

void DataSnooping::readmit_all() {
    m_rejected.assign(m_rejected.size(), false);
    m_rejected_for_good.setZero();
    m_rejected_forces.assign(m_forces.size(), false);
    m_force_bias.reset();
}

void DataSnooping::reopen() {
    m_readmitted.assign(m_readmitted.size(), false);
    m_readmitted_forces.assign(m_forces.size(), false);
}

double DataSnooping::statistic_at(int target, int node) const {
    const ExpectedPlace& expected = m_expected_places.at(node);
    const Eigen::Matrix3d noise = covariance_of(
        {.std = m_noise.col(target), .correlations = m_survey.correlations_of(target)});
    const Eigen::Matrix3d Q = noise + expected.covariance;
    const Eigen::Vector3d residual = m_survey.form.col(target) - expected.place;
    return (residual.transpose() * symmetric_solution(Q, residual)).value() / m_residual_scale;
}

void DataSnooping::mark_swapped(std::vector<Outlier>& outliers) const {
    for (Outlier& one : outliers) {
        double least = m_threshold;
        for (const Outlier& other : outliers) {
            if (other.node == one.node || !m_expected_places.contains(one.node) ||
                !m_expected_places.contains(other.node)) {
                continue;
            }
            const double statistic = std::max(statistic_at(one.node, other.node),
                                              statistic_at(other.node, one.node));  // (swapped)
            if (statistic < least) {
                least = statistic;
                one.swapped_with = other.node;
            }
        }
    }
}

std::vector<Outlier> DataSnooping::outliers() const {
    std::vector<Outlier> result;
    for (const int node : m_survey.surveyed) {
        if (is_rejected(node)) {
            result.push_back(
                {.node = node, .distance = m_distances(node), .statistic = m_statistics(node)});
        }
    }
    std::ranges::sort(result, std::greater{}, &Outlier::statistic);
    mark_swapped(result);
    return result;
}

std::vector<ForceOutlier> DataSnooping::force_outliers() const {
    std::vector<ForceOutlier> result;
    for (Eigen::Index k = 0; k < std::ssize(m_forces); ++k) {
        if (m_rejected_forces[k]) {
            result.push_back({.edge = m_forces[k].edge,
                              .measured = m_forces[k].tension,
                              .expected = m_expected(k),
                              .statistic = m_force_statistics(k)});
        }
    }
    std::ranges::sort(result, std::greater{}, &ForceOutlier::statistic);
    return result;
}

double DataSnooping::detectable() const {
    return detectable_error(m_in_use, m_threshold * m_residual_scale, 3);
}

double DataSnooping::noise_ratio() const {
    return m_redundancy > 0.0 ? std::sqrt(m_squares / m_redundancy) : 0.0;
}

}  // namespace taut
