// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/hyperprior.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "numerics/dense.hpp"

namespace taut {
namespace {

/// Standard deviations of the logarithm of the scale: logarithms of the factors.
const double log_std_given = std::log(1.5);
const double log_std_broad = std::log(2.5);
constexpr double own_shape = 0.75;

/// The grid over the logarithm of the scale.
constexpr double grid_reach = 3.0;   // standard deviations of the hyperprior
constexpr double reach_found = 4.5;  // standard deviations of the scale that was found
constexpr Eigen::Index places = 17;

/// A scale known this precisely rests on many lengths: its evidence is normal in the logarithm.
constexpr double surely_normal = 0.06;

/// Posterior standard deviations of the logarithm of the scale up to which one or two nodes
/// suffice.
constexpr double one_node_does = 0.04;
constexpr double two_nodes_do = 0.10;
/// Shapes less probable are left out.
constexpr double improbable = 0.02;

/// d log Z / d log sigma of a normal prior N(0, sigma^2): (prior-evidence).
double score_of_scale(const LinearisedFit& fitted, const Observations& observations,
                      const std::vector<bool>& left_out) {
    const Eigen::VectorXd& variances = fitted.covariance.lengths;
    double score = 0.0;
    for (int i = 0; i < variances.size(); ++i) {
        if (left_out[i] || !(variances(i) > 0.0)) {
            continue;
        }
        const double square = fitted.iterate.deviations(i) * fitted.iterate.deviations(i);
        score += (square + variances(i)) / observations.variance(i) - 1.0;
    }
    return score;
}

/// The observations where normal priors have the standard deviation exp(log_std).
Observations scaled_to(double log_std, Observations observations,
                       const std::vector<bool>& left_out) {
    for (Eigen::Index i = 0; i < observations.variance.size(); ++i) {
        if (!left_out[static_cast<size_t>(i)]) {
            observations.mean(i) = 0.0;
            observations.variance(i) = std::exp(2.0 * log_std);
        }
    }
    return observations;
}

/// Log evidence of normal priors at each place of the grid, up to a constant: the integral of the
/// score. Empty where there is no fit with one of them.
Eigen::VectorXd evidence_by_scores(const Eigen::VectorXd& grid, LinearisedFit start,
                                   const Observations& observations,
                                   const std::vector<bool>& left_out) {
    Eigen::VectorXd evidence = Eigen::VectorXd::Zero(grid.size());
    double before = 0.0;
    std::optional<LinearisedFit> fitted = std::move(start);
    for (Eigen::Index k = 0; k < grid.size(); ++k) {
        const Observations scaled = scaled_to(grid(k), observations, left_out);
        fitted = (*std::move(fitted)).stepped(scaled);
        const double score = fitted ? score_of_scale(*fitted, scaled, left_out) : std::nan("");
        if (!std::isfinite(score)) {
            return {};
        }
        if (k > 0) {
            evidence(k) = evidence(k - 1) + 0.5 * (grid(k) - grid(k - 1)) * (before + score);
        }
        before = score;
    }
    return evidence;
}

LengthPrior of_std(LengthPrior::Kind kind, double std_dev) {
    return {kind, std_dev / LengthPrior{kind, 1.0}.std_dev()};
}

struct Moments {
    double mean = 0.0;
    double std_dev = 0.0;
};
Moments moments_of(const Eigen::VectorXd& values, const Eigen::VectorXd& weights) {
    const double mean = weights.dot(values) / weights.sum();
    const double variance = weights.dot((values.array() - mean).square().matrix()) / weights.sum();
    return {.mean = mean, .std_dev = std::sqrt(variance)};
}

}  // namespace

Hyperprior hyperprior_around(const LengthPrior& given) {
    const bool is_uniform = given.kind == LengthPrior::Kind::uniform;
    const bool is_bimodal = given.kind == LengthPrior::Kind::bimodal;
    return {.centre = given,
            .log_std = log_std_given,
            .uniform_probability = is_uniform ? own_shape : (is_bimodal ? 0.0 : 1.0 - own_shape)};
}

Hyperprior broad_hyperprior() {
    return {.centre = LengthPrior(), .log_std = log_std_broad, .uniform_probability = 0.5};
}

LengthPrior central_prior(const PriorEstimate& estimate) {
    return estimate.exact ? estimate.given
                          : rounded(of_std(estimate.nodes.front().prior.kind, estimate.std_dev));
}

std::vector<std::pair<double, double>> gauss_nodes(const Eigen::VectorXd& places,
                                                   const Eigen::VectorXd& weights, int count) {
    // Lanczos iteration with the places as a diagonal matrix: its coefficients are those of the
    // recurrence of the polynomials orthogonal under the weights.
    const Eigen::VectorXd start = (weights / weights.sum()).cwiseSqrt();
    Eigen::VectorXd last = Eigen::VectorXd::Zero(places.size());
    Eigen::VectorXd current = start;
    std::vector<double> diagonal;
    std::vector<double> beside;
    const double spread = places.maxCoeff() - places.minCoeff();
    for (int k = 0; k < count; ++k) {
        Eigen::VectorXd next = places.cwiseProduct(current);
        diagonal.push_back(current.dot(next));
        next -= diagonal.back() * current + (k > 0 ? beside.back() : 0.0) * last;
        constexpr double rounding = 1e-9;
        const double norm = next.norm();
        if (!(norm > rounding * spread) || k + 1 == count) {
            break;
        }
        beside.push_back(norm);
        last = current;
        current = next / norm;
    }
    const auto size = static_cast<Eigen::Index>(diagonal.size());
    Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(size, size);
    for (Eigen::Index k = 0; k < size; ++k) {
        jacobi(k, k) = diagonal[static_cast<size_t>(k)];
        if (k + 1 < size) {
            jacobi(k, k + 1) = jacobi(k + 1, k) = beside[static_cast<size_t>(k)];
        }
    }
    const SymmetricEigen eigen = symmetric_eigen(jacobi);
    std::vector<std::pair<double, double>> nodes;
    for (Eigen::Index k = 0; k < size; ++k) {
        const double first = eigen.vectors(0, k);
        nodes.emplace_back(eigen.values(k), first * first);
    }
    return nodes;
}

namespace {

/// Log evidence of the scale of a normal prior, with its hyperprior, on a grid of logarithms.
struct ScaleEvidence {
    Eigen::VectorXd grid;
    Eigen::VectorXd log;
};

/// (hyperprior)
ScaleEvidence scale_evidence(const Hyperprior& hyperprior, LinearisedFit fitted,
                             const Observations& observations, const std::vector<bool>& left_out,
                             const LengthPrior& fit_prior, const FoundScale& scale) {
    const double centre = std::log(hyperprior.centre.std_dev());
    double middle = centre;
    double half_width = grid_reach * hyperprior.log_std;
    const bool is_found = scale.ratio > 0.0 && scale.std_dev > 0.0;
    const double found = is_found ? std::log(scale.ratio * fit_prior.std_dev()) : centre;
    if (is_found && scale.std_dev < 1.0 / reach_found) {
        // The product of both, as normal distributions.
        const double of_prior = 1.0 / (hyperprior.log_std * hyperprior.log_std);
        const double of_survey = 1.0 / (scale.std_dev * scale.std_dev);
        middle = (of_prior * centre + of_survey * found) / (of_prior + of_survey);
        half_width = reach_found * scale.std_dev;
    }
    ScaleEvidence result{
        .grid = Eigen::VectorXd::LinSpaced(places, middle - half_width, middle + half_width),
        .log = {}};
    if (is_found && scale.std_dev < surely_normal) {
        result.log = -0.5 * ((result.grid.array() - found) / scale.std_dev).square();
    } else {
        result.log = evidence_by_scores(result.grid, std::move(fitted), observations, left_out);
    }
    if (result.log.size() == 0) {
        result.log = Eigen::VectorXd::Zero(places);
    }
    result.log.array() -= 0.5 * ((result.grid.array() - centre) / hyperprior.log_std).square();
    return result;
}

/// Posterior of scale (rows) and of the two shapes (columns), up to a factor.
Eigen::MatrixXd posterior_of(const Hyperprior& hyperprior, const ScaleEvidence& evidence,
                             const std::array<LengthPrior::Kind, 2>& kinds, const FoundScale& scale,
                             const PriorLikelihood& shapes) {
    // A composite likelihood of correlated lengths, raised to the square of their relative
    // redundancy; the power is by trial.
    const double redundancy = scale.std_dev > 0.0 ? 0.5 / (scale.std_dev * scale.std_dev) : 0.0;
    const double power = std::pow(std::min(1.0, redundancy / std::max(1, shapes.count())), 2);
    Eigen::MatrixXd log_posterior(places, 2);
    for (Eigen::Index k = 0; k < places; ++k) {
        const double std_dev = std::exp(evidence.grid(k));
        const double of_normal = shapes(of_std(LengthPrior::Kind::normal, std_dev));
        for (Eigen::Index j = 0; j < 2; ++j) {
            const double probability =
                j == 0 ? hyperprior.uniform_probability : 1.0 - hyperprior.uniform_probability;
            log_posterior(k, j) =
                std::log(probability) + evidence.log(k) +
                power * (shapes(of_std(kinds[static_cast<size_t>(j)], std_dev)) - of_normal);
        }
    }
    return (log_posterior.array() - log_posterior.maxCoeff()).exp().matrix();
}

}  // namespace

PriorEstimate estimate_prior(const Hyperprior& hyperprior, LinearisedFit fitted,
                             const Observations& observations, const std::vector<bool>& left_out,
                             const LengthPrior& fit_prior, const FoundScale& scale,
                             const PriorLikelihood& shapes) {
    const ScaleEvidence evidence =
        scale_evidence(hyperprior, std::move(fitted), observations, left_out, fit_prior, scale);
    const LengthPrior::Kind other = hyperprior.centre.kind == LengthPrior::Kind::bimodal
                                        ? LengthPrior::Kind::bimodal
                                        : LengthPrior::Kind::normal;
    const std::array<LengthPrior::Kind, 2> kinds{LengthPrior::Kind::uniform, other};
    const Eigen::MatrixXd posterior = posterior_of(hyperprior, evidence, kinds, scale, shapes);
    const double sum = posterior.sum();

    PriorEstimate result{.given = hyperprior.centre, .exact = false};
    const Eigen::VectorXd stds = evidence.grid.array().exp();
    const auto [mean, std_of_std] = moments_of(stds, posterior.rowwise().sum());
    result.std_dev = mean;
    result.std_std = std_of_std;
    // Rounding may make a part exceed the whole.
    result.uniform_probability = std::min(1.0, posterior.col(0).sum() / sum);
    for (Eigen::Index j = 0; j < 2; ++j) {
        const double probability = posterior.col(j).sum() / sum;
        if (probability < improbable) {
            continue;
        }
        const double spread = moments_of(evidence.grid, posterior.col(j)).std_dev;
        const int count = spread < one_node_does ? 1 : (spread < two_nodes_do ? 2 : 3);
        for (const auto& [place, weight] : gauss_nodes(evidence.grid, posterior.col(j), count)) {
            result.nodes.push_back(
                {.prior = rounded(of_std(kinds[static_cast<size_t>(j)], std::exp(place))),
                 .weight = weight * probability});
        }
    }
    double kept = 0.0;
    for (const PriorNode& node : result.nodes) {
        kept += node.weight;
    }
    for (PriorNode& node : result.nodes) {
        node.weight /= kept;
    }
    std::ranges::sort(result.nodes, std::greater{}, &PriorNode::weight);
    return result;
}

}  // namespace taut
