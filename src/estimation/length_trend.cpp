// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/length_trend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "estimation/marginal_mode.hpp"
#include "numerics/dense.hpp"
#include "taut/net/cable_runs.hpp"

namespace taut {
namespace {

/// Prior standard deviation of the common mean, in that of the prior of a length.
constexpr double mean_width = 0.5;
/// Prior probability that lengths of a run have a scale in common, and standard deviations of it,
/// in those of the prior of a length at an edge of mean length.
constexpr double probability_of_runs = 0.9;
constexpr std::array run_widths{0.25, 0.5, 1.0, 2.0};

/// Errors of the linearised means, in standard deviations of the prior: of all lengths, and of the
/// adjustable edges.
constexpr double nonlinearity = 0.1;
constexpr double nonlinearity_of_adjustable = 0.2;

constexpr Eigen::Index most_runs = 128;

/// Prior standard deviation of what all adjustable edges have in common, in their own: all may have
/// been set or read alike.
constexpr double adjustable_width = 0.6;
/// The same of what all struts have in common, in that of the prior of a length: they come from
/// another shop than the cables.
constexpr double strut_width = 1.0;

/// Whether several struts are uncertain, beside cables.
bool has_common_struts(const CableNet& net) {
    const auto struts =
        std::ranges::count_if(net.interior_edges(), [&](int edge) { return net.is_strut(edge); });
    return struts > 1 && struts < net.interior_edge_count();
}

/// Columns of G: the mean [m], the scale of each run [-], and last, if any, what all struts [m] and
/// all adjustable edges [m] have in common.
Eigen::MatrixXd columns_of(const CableNet& net, const std::vector<bool>& left_out,
                           const Eigen::VectorXd& adjustable_stds) {
    std::vector<std::vector<int>> runs = cable_runs(net);
    if (std::ssize(runs) > most_runs) {
        runs.clear();
    }
    Eigen::MatrixXd of_edges = Eigen::MatrixXd::Zero(net.edge_count(), 1 + std::ssize(runs));
    of_edges.col(0).setOnes();
    for (Eigen::Index k = 0; k < std::ssize(runs); ++k) {
        for (const int edge : runs[static_cast<size_t>(k)]) {
            of_edges(edge, 1 + k) = net.unstressed_lengths()(edge);
        }
    }
    Eigen::MatrixXd columns = of_edges(net.interior_edges(), Eigen::all);
    for (size_t i = 0; i < left_out.size(); ++i) {
        if (left_out[i]) {
            columns.row(static_cast<Eigen::Index>(i)).setZero();
        }
    }
    if (has_common_struts(net)) {
        columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
        for (Eigen::Index i = 0; i < columns.rows(); ++i) {
            const bool is_strut = net.is_strut(net.interior_edges()[static_cast<size_t>(i)]);
            columns.rightCols(1)(i) = is_strut ? columns(i, 0) : 0.0;
        }
    }
    if (adjustable_stds.size() > 0) {
        columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
        columns.rightCols(1) = (adjustable_stds.array() > 0.0).cast<double>().matrix();
    }
    return columns;
}

/// Posterior of b with priors of these standard deviations.
struct Posterior {
    double log_evidence = 0.0;
    Eigen::VectorXd mean;
    Eigen::MatrixXd covariance;
};
Posterior posterior_of_trend(const Eigen::VectorXd& score, const Eigen::MatrixXd& information,
                             const Eigen::VectorXd& stds) {
    const SymmetricEigen eigen =
        symmetric_eigen(stds.asDiagonal() * information * stds.asDiagonal());
    const Eigen::ArrayXd values = eigen.values.array().max(0.0);
    const Eigen::VectorXd turned = eigen.vectors.transpose() * stds.cwiseProduct(score);
    const Eigen::VectorXd shrunk = turned.array() / (1.0 + values);
    const Eigen::MatrixXd spread = stds.asDiagonal() * eigen.vectors;
    return {
        .log_evidence = 0.5 * turned.dot(shrunk) - 0.5 * (1.0 + values).log().sum(),
        .mean = spread * shrunk,
        .covariance = spread * (1.0 + values).inverse().matrix().asDiagonal() * spread.transpose()};
}

/// (considered): the same where the last of b keeps its prior, whatever the survey shows of it.
Posterior posterior_with_last_unseen(const Eigen::VectorXd& score,
                                     const Eigen::MatrixXd& information,
                                     const Eigen::VectorXd& stds) {
    const Eigen::Index seen = stds.size() - 1;
    const Posterior others = posterior_of_trend(
        score.head(seen), information.topLeftCorner(seen, seen), stds.head(seen));
    Eigen::VectorXd moved(stds.size());
    moved << -others.covariance * information.col(seen).head(seen), 1.0;
    moved *= stds(seen);
    Posterior all{.log_evidence = others.log_evidence,
                  .mean = Eigen::VectorXd::Zero(stds.size()),
                  .covariance = moved * moved.transpose()};
    all.mean.head(seen) = others.mean;
    all.covariance.topLeftCorner(seen, seen) += others.covariance;
    return all;
}

/// Where the columns of G are that not every net has; -1: there is none.
struct Places {
    Eigen::Index runs = 0;  ///< how many, after the mean
    Eigen::Index struts = -1;
    Eigen::Index adjustable = -1;
};

/// Log-likelihood of b, score' b - b' information b / 2, d integrated over.
struct Likelihood {
    Eigen::VectorXd score;
    Eigen::MatrixXd information;

    /// Makes b_k known no better than this.
    void blur(Eigen::Index k, double squared_bias) {
        const Eigen::VectorXd of_mean = information.col(k);
        const double part = squared_bias / (1.0 + squared_bias * of_mean(k));
        score -= part * score(k) * of_mean;
        information -= part * of_mean * of_mean.transpose();
    }
    /// (marginal-mode): each edge has its part of the slope by all. The mean is known no better
    /// than by as much as it moves.
    void move_to_marginal_mode(const LinearisedFit& fitted, const Observations& observations,
                               const Eigen::MatrixXd& columns,
                               const Linearisation::LengthResponse& response, double h) {
        Observations moved = observations;
        moved.mean += h * columns.col(0);
        const double slope = DeterminantSlope(fitted, observations).change(moved) / h;
        if (std::isfinite(slope) && information(0, 0) > 0.0) {
            // The slope holds the response of the common parameters, which the fit was moved by.
            score -= response.common.transpose() * observations.common_mean;
            score -= slope / columns.col(0).sum() * columns.colwise().sum().transpose();
            blur(0, std::pow(slope / information(0, 0), 2));
        }
    }
};

/// The mixture over the scales of the runs, equally probable. Sets what is found of b.
void mix(LengthTrend& trend, const Likelihood& shown, const Places& at, const LengthPrior& prior,
         double mean_length, bool is_adjustable_unseen) {
    const Eigen::Index count = shown.score.size();
    std::vector<Posterior> posteriors;
    std::vector<double> widths;
    std::vector<Eigen::VectorXd> prior_stds;
    Eigen::VectorXd log_weights(at.runs > 0 ? 1 + std::ssize(run_widths) : 1);
    for (Eigen::Index k = 0; k < log_weights.size(); ++k) {
        widths.push_back(
            k == 0 ? 0.0 : run_widths[static_cast<size_t>(k - 1)] * prior.std_dev() / mean_length);
        Eigen::VectorXd stds = Eigen::VectorXd::Constant(count, widths.back());
        stds(0) = mean_width * prior.std_dev();
        if (at.struts >= 0) {
            stds(at.struts) = strut_width * prior.std_dev();
        }
        if (at.adjustable >= 0) {
            stds(at.adjustable) = trend.adjustable_std;
        }
        prior_stds.push_back(stds);
        posteriors.push_back(is_adjustable_unseen
                                 ? posterior_with_last_unseen(shown.score, shown.information, stds)
                                 : posterior_of_trend(shown.score, shown.information, stds));
        log_weights(k) = posteriors.back().log_evidence +
                         std::log(k == 0 ? 1.0 - probability_of_runs
                                         : probability_of_runs / std::ssize(run_widths));
    }
    const Eigen::VectorXd weights_of =
        (log_weights.array() - log_weights.maxCoeff()).exp().matrix();
    const double sum = weights_of.sum();
    trend.mean = Eigen::VectorXd::Zero(count);
    Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd prior_variances = Eigen::VectorXd::Zero(count);
    for (size_t k = 0; k < posteriors.size(); ++k) {
        const double weight = weights_of(static_cast<Eigen::Index>(k)) / sum;
        const Posterior& one = posteriors[k];
        trend.mean += weight * one.mean;
        prior_variances += weight * prior_stds[k].cwiseAbs2();
        squares += weight * (one.covariance + one.mean * one.mean.transpose());
        trend.found.run_std += weight * widths[k];
        trend.found.run_probability += k > 0 ? weight : 0.0;
    }
    trend.found.run_probability = std::min(1.0, trend.found.run_probability);  // but for rounding
    // Not zero where no run has a scale, as a quotient of it.
    trend.prior_stds = prior_variances.cwiseSqrt().cwiseMax(std::numeric_limits<double>::min());
    const SymmetricEigen eigen = symmetric_eigen(squares - trend.mean * trend.mean.transpose());
    // The symmetric root: another would depend on the signs of eigenvectors, which are free.
    trend.root = eigen.vectors * eigen.values.cwiseMax(0.0).cwiseSqrt().asDiagonal() *
                 eigen.vectors.transpose();
}

}  // namespace

LengthTrend trend_of(const LinearisedFit& fitted, const Observations& observations,
                     const std::vector<bool>& left_out, const Eigen::VectorXd& adjustable_stds,
                     const LengthPrior& prior) {
    const CableNet& net = fitted.model().net();
    LengthTrend trend;
    trend.adjustable_std = std::max(0.0, adjustable_width * adjustable_stds.maxCoeff());
    trend.columns =
        columns_of(net, left_out, trend.adjustable_std > 0.0 ? adjustable_stds : Eigen::VectorXd());
    const Eigen::Index count = trend.columns.cols();
    Places at;
    at.adjustable = trend.adjustable_std > 0.0 ? count - 1 : -1;
    const Eigen::Index others = count - (at.adjustable >= 0 ? 1 : 0);
    at.struts = has_common_struts(net) ? others - 1 : -1;
    at.runs = others - (at.struts >= 0 ? 2 : 1);

    const Eigen::VectorXd variances =
        observations.variance + fitted.model().blur.length_variances(observations.variance.size());
    const Eigen::VectorXd weights = variances.cwiseInverse();
    const Eigen::MatrixXd weighted = weights.asDiagonal() * trend.columns;
    const Linearisation::LengthResponse response =
        fitted.linearisation.response_to_lengths(weighted);
    Likelihood shown{
        .score = weighted.transpose() * (fitted.iterate.deviations - observations.mean),
        .information =
            trend.columns.transpose() * weighted - weighted.transpose() * response.lengths};

    // Non-linearity moves a mean by as much, so it is known no better; adjustable edges keep their
    // prior where that is better.
    const double bias = nonlinearity * prior.std_dev();
    const double adjustable_bias = nonlinearity_of_adjustable * prior.std_dev();
    const bool has_many_edges = net.interior_edge_count() >= fewest_for_marginal_mode;
    const bool is_adjustable_unseen =
        at.adjustable >= 0 && (has_many_edges || trend.adjustable_std < adjustable_bias);
    if (has_many_edges) {
        shown.move_to_marginal_mode(fitted, observations, trend.columns, response, bias);
    }
    shown.blur(0, bias * bias);
    if (at.struts >= 0) {
        shown.blur(at.struts, bias * bias);
    }
    if (at.adjustable >= 0 && !is_adjustable_unseen) {
        shown.blur(at.adjustable, adjustable_bias * adjustable_bias);
    }
    mix(trend, shown, at, prior, net.unstressed_lengths()(net.interior_edges()).mean(),
        is_adjustable_unseen);

    // Of the sum with what nobody knows a part is the edge's own.
    const Eigen::VectorXd own = observations.variance.cwiseQuotient(variances);
    trend.length_gains = trend.columns + own.asDiagonal() * (response.lengths - trend.columns);
    trend.common_gains = response.common;
    trend.found.mean = trend.mean(0);
    trend.found.mean_std = trend.root.row(0).norm();
    trend.found.runs = static_cast<int>(at.runs);
    if (at.struts >= 0) {
        trend.found.struts = trend.mean(at.struts);
        trend.found.struts_std = trend.root.row(at.struts).norm();
    }
    if (at.adjustable >= 0) {
        trend.found.adjustable = trend.mean(at.adjustable);
        trend.found.adjustable_std = trend.root.row(at.adjustable).norm();
    }
    return trend;
}

}  // namespace taut
