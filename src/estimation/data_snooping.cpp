// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/data_snooping.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>

namespace taut {
namespace {

/// A direction in which the fit follows a target to this part of its variance cannot be tested.
constexpr double smallest_redundancy = 1e-3;

/// Of three degrees of freedom.
constexpr double median_of_chi_squared = 2.366;

}  // namespace

double outlier_threshold(double false_alarm_rate, size_t targets) {
    if (!(false_alarm_rate > 0.0)) {
        return std::numeric_limits<double>::infinity();
    }
    const double of_one = -std::expm1(std::log1p(-false_alarm_rate) / static_cast<double>(targets));
    return boost::math::quantile(
        boost::math::complement(boost::math::chi_squared_distribution<>(3.0), of_one));
}

Neighbours neighbours_of(const CableNet& net) {
    Neighbours neighbours(net.node_count());
    for (const auto& [s, t] : net.edges()) {
        neighbours[s].push_back(t);
        neighbours[t].push_back(s);
    }
    return neighbours;
}

std::vector<int> worst_targets(const std::vector<int>& surveyed, const Neighbours& neighbours,
                               const Eigen::VectorXd& statistics, const std::vector<bool>& left_out,
                               double threshold) {
    const auto is_worst_around = [&](int node) {
        const auto beats = [&](int other) {
            return left_out[other] || statistics(node) >= statistics(other);
        };
        return std::ranges::all_of(neighbours[node], [&](int near) {
            return beats(near) && std::ranges::all_of(neighbours[near], beats);
        });
    };
    std::vector<int> worst;
    for (const int node : surveyed) {
        if (!left_out[node] && statistics(node) > threshold && is_worst_around(node)) {
            worst.push_back(node);
        }
    }
    return worst;
}

GrossErrorTest::GrossErrorTest(const CableNet& net, const Survey& survey, const Points& noise,
                               double false_alarm_rate)
    : m_survey(survey),
      m_noise(noise),
      m_threshold(outlier_threshold(false_alarm_rate, survey.surveyed.size())),
      m_neighbours(neighbours_of(net)),
      m_left_out(net.node_count(), false),
      m_acquitted(net.node_count(), false),
      m_statistics(Eigen::VectorXd::Zero(net.node_count())),
      m_distances(Eigen::VectorXd::Zero(net.node_count())) {}

int GrossErrorTest::left_out_count() const {
    return static_cast<int>(std::ranges::count(m_left_out, true));
}

int GrossErrorTest::suspicious_count() const {
    return static_cast<int>(std::ranges::count_if(m_survey.surveyed, [this](int node) {
        return !is_left_out(node) && m_statistics(node) > m_threshold;
    }));
}

void GrossErrorTest::evaluate(const ConditionedStatics& statics, const Points& fitted_form,
                              double inflation) {
    m_statistics.setZero();
    m_distances.setZero();
    m_squares = 0.0;
    m_redundancy = 0.0;
    for (const int node : m_survey.surveyed) {
        const Eigen::Vector3d residual = m_survey.form.col(node) - fitted_form.col(node);
        m_distances(node) = residual.norm();
        // In units of the noise: I -+ Sigma^-1/2 C Sigma^-1/2.
        const Eigen::DiagonalMatrix<double, 3> whiten(
            (inflation * m_noise.col(node)).cwiseInverse());
        const Eigen::Vector3d e = whiten * residual;
        const double sign = is_left_out(node) ? 1.0 : -1.0;
        const Eigen::Matrix3d Q =
            Eigen::Matrix3d::Identity() + sign * (whiten * statics.form_covariance(node) * whiten);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(Q);
        for (int k = 0; k < 3; ++k) {
            if (eigen.eigenvalues()(k) > smallest_redundancy) {
                const double along = eigen.eigenvectors().col(k).dot(e);
                m_statistics(node) += along * along / eigen.eigenvalues()(k);
            }
        }
        if (!is_left_out(node)) {
            m_squares += e.squaredNorm();
            m_redundancy += Q.trace();
        }
    }
    if (inflation > 1.0) {
        m_statistics /=
            std::max(median_statistic() / median_of_chi_squared, 1.0 / (inflation * inflation));
    }
}

/// Of the targets in use.
double GrossErrorTest::median_statistic() const {
    std::vector<double> in_use;
    for (const int node : m_survey.surveyed) {
        if (!is_left_out(node)) {
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

bool GrossErrorTest::revise() {
    Eigen::VectorXd suspicious = m_statistics;
    for (const int node : m_survey.surveyed) {
        if (m_acquitted[node]) {
            suspicious(node) = 0.0;
        }
    }
    std::vector<int> changing =
        worst_targets(m_survey.surveyed, m_neighbours, suspicious, m_left_out, m_threshold);
    if (changing.empty()) {
        for (const int node : m_survey.surveyed) {
            if (is_left_out(node) && m_statistics(node) <= m_threshold) {
                changing.push_back(node);
                m_acquitted[node] = true;
            }
        }
    }
    for (const int node : changing) {
        m_left_out[node] = !is_left_out(node);
    }
    return !changing.empty();
}

void GrossErrorTest::leave_out_suspicious() {
    for (const int node : m_survey.surveyed) {
        if (m_statistics(node) > m_threshold) {
            m_left_out[node] = true;
        }
    }
}

void GrossErrorTest::take_all_back() {
    m_left_out.assign(m_left_out.size(), false);
}
void GrossErrorTest::reopen() {
    m_acquitted.assign(m_acquitted.size(), false);
}

std::vector<Outlier> GrossErrorTest::outliers() const {
    std::vector<Outlier> result;
    for (const int node : m_survey.surveyed) {
        if (is_left_out(node)) {
            result.push_back(
                {.node = node, .distance = m_distances(node), .statistic = m_statistics(node)});
        }
    }
    std::ranges::sort(result, std::greater{}, &Outlier::statistic);
    return result;
}

double GrossErrorTest::noise_ratio() const {
    return m_redundancy > 0.0 ? std::sqrt(m_squares / m_redundancy) : 0.0;
}

}  // namespace taut
