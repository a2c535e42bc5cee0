// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/epoch_evidence.hpp"

#include <Eigen/Cholesky>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "numerics/small_dense.hpp"

namespace taut {
namespace {

/// A change with a standard deviation above so many prior ones counts as not shown: its estimate
/// comes from rounding errors and terms of second order.
constexpr double least_shown = 1.0 / 30.0;

Eigen::MatrixXd symmetric(const Eigen::MatrixXd& matrix) {
    return 0.5 * (matrix + matrix.transpose());
}

/// With pivots, since rounding errors can make it indefinite.
Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& positive) {
    return symmetric(
        symmetric_solution(positive, Eigen::MatrixXd::Identity(positive.rows(), positive.cols())));
}

/// A distribution of x in the standard deviations that it has before any survey.
struct Standardised {
    Eigen::VectorXd mean;
    Eigen::MatrixXd covariance;
};

Standardised standardised(const LengthEvidence& evidence, const Eigen::VectorXd& prior_stds) {
    const auto by_std = prior_stds.asDiagonal();
    const Eigen::MatrixXd precision =
        Eigen::MatrixXd::Identity(prior_stds.size(), prior_stds.size()) +
        by_std * evidence.information * by_std;
    Standardised result{.mean = {}, .covariance = inverse_of(precision)};
    result.mean = result.covariance * (by_std * evidence.pull);
    return result;
}

/// Builds evidence with its root, without the negative parts that rounding errors left.
/// @param information and pull in standard deviations
LengthEvidence with_root(const Eigen::MatrixXd& information, const Eigen::VectorXd& pull,
                         const Eigen::VectorXd& prior_stds) {
    const Eigen::LDLT<Eigen::MatrixXd> factor(symmetric(information));
    const Eigen::VectorXd pivots = factor.vectorD().cwiseMax(0.0).cwiseSqrt();
    Eigen::MatrixXd root = factor.matrixL();
    root *= pivots.asDiagonal();
    root = factor.transpositionsP().transpose() * root;
    const Eigen::VectorXd by_std = prior_stds.cwiseInverse();
    LengthEvidence result;
    result.root = by_std.asDiagonal() * root;
    result.information = result.root * result.root.transpose();
    result.pull = by_std.cwiseProduct(pull);
    return result;
}

/// L^-1 P g has independent entries of variance D, where L D L' = P W P'.
Agreement agreement_of(const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient) {
    const Eigen::LDLT<Eigen::MatrixXd> factor(information);
    Eigen::VectorXd independent = factor.transpositionsP() * gradient;
    factor.matrixL().solveInPlace(independent);
    Agreement result;
    for (Eigen::Index i = 0; i < independent.size(); ++i) {
        if (const double variance = factor.vectorD()(i); variance > least_shown * least_shown) {
            result.squares += independent(i) * independent(i) / variance;
            ++result.rank;
        }
    }
    return result;
}

}  // namespace

EpochStep EpochStep::reversed() const {
    const Eigen::VectorXd back = factor.cwiseProduct(prior_from).cwiseQuotient(prior_to);
    return {.factor = back,
            .added = (prior_from - back.cwiseAbs2().cwiseProduct(prior_to)).cwiseMax(0.0),
            .prior_from = prior_to,
            .prior_to = prior_from};
}

LengthEvidence own_evidence(const LinearisedFit& fitted, const Observations& observations,
                            int common_count) {
    const Eigen::Index lengths = fitted.iterate.deviations.size();
    Eigen::VectorXd prior_variances = Eigen::VectorXd::Ones(lengths + common_count);
    prior_variances.head(lengths) =
        observations.variance + fitted.model().blur.length_variances(lengths);
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(lengths + common_count);
    mean.head(lengths) = observations.mean;
    // Common parameters have the prior mean 0: by how much theirs was moved, (marginal-mode), is
    // evidence of the survey.
    const Eigen::VectorXd stds = prior_variances.cwiseSqrt();
    const auto by_std = stds.cwiseInverse().asDiagonal();
    const Eigen::MatrixXd precision =
        inverse_of(by_std * fitted.linearisation.evidence_covariance(common_count) * by_std);
    const Eigen::VectorXd x = by_std * fitted.iterate.lengths_and_common(stds.size());
    LengthEvidence result{.information = by_std * precision * by_std,
                          .root = {},
                          .pull = by_std * (precision * x - by_std * mean)};
    result.information.diagonal() -= prior_variances.cwiseInverse();
    if (observations.evidence) {
        result.information -= observations.evidence->information;
        result.pull -= observations.evidence_pull;
    }
    return result;
}

LengthEvidence no_evidence(Eigen::Index size) {
    return {.information = Eigen::MatrixXd::Zero(size, size),
            .root = Eigen::MatrixXd::Zero(size, 0),
            .pull = Eigen::VectorXd::Zero(size)};
}

LengthEvidence sum_of(const LengthEvidence& a, const LengthEvidence& b) {
    return {.information = a.information + b.information, .root = {}, .pull = a.pull + b.pull};
}

LengthEvidence forgotten(LengthEvidence evidence, std::span<const Eigen::Index> entries) {
    for (const Eigen::Index i : entries) {
        const double own = evidence.information(i, i);
        if (own > 0.0) {
            const Eigen::VectorXd column = evidence.information.col(i);
            evidence.pull -= column * (evidence.pull(i) / own);
            evidence.information -= column * (column / own).transpose();
        }
        evidence.information.col(i).setZero();
        evidence.information.row(i).setZero();
        evidence.pull(i) = 0.0;
    }
    return evidence;
}

LengthEvidence carried(const LengthEvidence& evidence, const EpochStep& step) {
    const Eigen::VectorXd from = step.prior_from.cwiseSqrt();
    const Eigen::VectorXd to = step.prior_to.cwiseSqrt();
    const Standardised before = standardised(evidence, from);
    const Eigen::VectorXd factor = step.factor.cwiseProduct(from).cwiseQuotient(to);
    Eigen::MatrixXd covariance = factor.asDiagonal() * before.covariance * factor.asDiagonal();
    covariance.diagonal() += step.added.cwiseQuotient(step.prior_to);
    const Eigen::VectorXd mean = factor.cwiseProduct(before.mean);
    Eigen::MatrixXd precision = inverse_of(covariance);
    const Eigen::VectorXd pull = precision * mean;
    precision.diagonal().array() -= 1.0;  // the prior
    return with_root(precision, pull, to);
}

EvidenceTest::EvidenceTest(const Eigen::VectorXd& prior_variances, const LengthEvidence& others,
                           const LengthEvidence& own)
    : m_stds(prior_variances.cwiseSqrt()) {
    const auto by_std = m_stds.asDiagonal();
    Standardised before = standardised(others, m_stds);
    m_covariance = std::move(before.covariance);
    m_mean = std::move(before.mean);
    m_own = by_std * own.information * by_std;
    m_pull = by_std * own.pull;
    update();
}

void EvidenceTest::let_go(Eigen::Index entry) {
    constexpr double anything = 0.1;  // [m]
    m_covariance(entry, entry) += std::pow(anything / m_stds(entry), 2);
    update();
}

/// With A the covariance by the others, m their mean and J, p the survey's own evidence:
/// g = W (y - m) for p = J y, W = (J^-1 + A)^-1, without J^-1:
///
///   g = (1 + J A)^-1 (p - J m),   W = (1 + J A)^-1 J
void EvidenceTest::update() {
    const Eigen::Index size = m_own.cols();
    Eigen::MatrixXd right(m_own.rows(), size + 1);
    right << m_own, m_pull - m_own * m_mean;
    const Eigen::MatrixXd solution =
        lu_solution(Eigen::MatrixXd::Identity(size, size) + m_own * m_covariance, right);
    m_gradient = solution.col(size);
    m_information = symmetric(solution.leftCols(size));
}

EvidenceTest::Changes EvidenceTest::changes() const {
    const Eigen::Index size = m_stds.size();
    Changes result{
        .change = Eigen::VectorXd::Zero(size),
        .std_dev = Eigen::VectorXd::Constant(size, std::numeric_limits<double>::infinity()),
        .statistic = Eigen::VectorXd::Zero(size)};
    for (Eigen::Index i = 0; i < size; ++i) {
        const double shown = m_information(i, i);
        if (shown > least_shown * least_shown) {
            result.change(i) = m_stds(i) * m_gradient(i) / shown;
            result.std_dev(i) = m_stds(i) / std::sqrt(shown);
            result.statistic(i) = std::abs(m_gradient(i)) / std::sqrt(shown);
        }
    }
    return result;
}

std::pair<double, double> EvidenceTest::change_along(const Eigen::VectorXd& direction) const {
    const Eigen::VectorXd d = direction.cwiseQuotient(m_stds);
    const double shown = d.dot(m_information * d);
    if (!(shown > 0.0)) {
        return {0.0, std::numeric_limits<double>::infinity()};
    }
    return {d.dot(m_gradient) / shown, 1.0 / std::sqrt(shown)};
}

double Agreement::ratio() const {
    return rank > 0 ? std::sqrt(squares / rank) : 0.0;
}

double Agreement::limit() const {
    constexpr double false_alarm_rate = 1e-3;
    if (rank == 0) {
        return 0.0;
    }
    const boost::math::chi_squared_distribution<> by_chance(rank);
    return std::sqrt(boost::math::quantile(boost::math::complement(by_chance, false_alarm_rate)) /
                     rank);
}

Agreement EvidenceTest::agreement() const {
    return agreement_of(m_information, m_gradient);
}

Agreement EvidenceTest::agreement(std::span<const Eigen::Index> entries) const {
    return agreement_of(m_information(entries, entries), m_gradient(entries));
}

/// Changes e of variances s^2 / std^2 add W E W to the covariance W of g.
double EvidenceTest::spread(std::span<const Eigen::Index> entries) const {
    const Eigen::MatrixXd information = m_information(entries, entries);
    const Eigen::VectorXd gradient = m_gradient(entries);
    const Eigen::VectorXd by_variance = m_stds(entries).cwiseAbs2().cwiseInverse();
    const double more = gradient.squaredNorm() - information.trace();
    const double by_one = (information.cwiseAbs2() * by_variance).sum();
    return more > 0.0 && by_one > 0.0 ? std::sqrt(more / by_one) : 0.0;
}

}  // namespace taut
