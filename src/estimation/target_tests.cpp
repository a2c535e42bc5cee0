// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/target_tests.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

#include "estimation/detectable_error.hpp"
#include "numerics/small_dense.hpp"
#include "survey/covariance.hpp"

namespace taut {
namespace {

/// A direction of which less than this part of the variance is redundant cannot be tested.
constexpr double smallest_redundancy = 1e-3;

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

PlaceNoise noise_of(const Survey& survey, const Points& noise, int node, double inflation = 1.0) {
    return {.std_dev = inflation * noise.col(node), .correlations = survey.correlations_of(node)};
}

/// Of the targets in use.
double median_statistic(std::span<const Hypothesis> targets) {
    std::vector<double> in_use;
    for (const Hypothesis& target : targets) {
        if (!target.is_released()) {
            in_use.push_back(target.statistic);
        }
    }
    if (in_use.empty()) {
        return 0.0;
    }
    const auto middle = in_use.begin() + static_cast<std::ptrdiff_t>(in_use.size() / 2);
    std::nth_element(in_use.begin(), middle, in_use.end());
    return *middle;
}

/// (robust-scale), (continuation)
double residual_scale_of(std::span<const Hypothesis> targets, double inflation) {
    const double scale = median_statistic(targets) / median_of_chi_squared;
    if (inflation > 1.0) {
        return std::max(scale, 1.0 / (inflation * inflation));
    }
    const bool is_given_too_small =
        scale > largest_scale_by_chance(targets.size()) && scale < largest_scale_of_noise;
    return is_given_too_small ? scale : 1.0;
}

/// T of a rejected target at another node's expected place, as if that were its own.
double statistic_at(const Hypothesis& target, const Hypothesis& other, const Survey& survey,
                    const Points& noise, double residual_scale) {
    const Eigen::Vector3d place = survey.form.col(other.index) - other.deviation;
    const Eigen::Matrix3d Q = covariance_of(noise_of(survey, noise, target.index)) +
                              other.covariance -
                              covariance_of(noise_of(survey, noise, other.index));
    const Eigen::Vector3d residual = survey.form.col(target.index) - place;
    return (residual.transpose() * symmetric_solution(Q, residual)).value() / residual_scale;
}

/// Statistic from which on force measurements in use, or their common error, are doubted: chance
/// has one above it once in 1 / doubtful_rate surveys.
double doubt_threshold(const Hypotheses& hypotheses) {
    const std::span<const Hypothesis> forces = hypotheses.of(Suspect::force);
    const bool is_tested = !forces.empty() && std::isfinite(forces[0].threshold);
    return snooping_threshold(is_tested ? doubtful_rate : 0.0,
                              forces.size() + hypotheses.of(Suspect::force_scale).size(), 1);
}

/// Those of a kind in use, as the last fit tested them.
std::vector<Hypothesis> in_use(const Hypotheses& hypotheses, Suspect kind) {
    std::vector<Hypothesis> result;
    std::ranges::copy_if(hypotheses.of(kind), std::back_inserter(result),
                         [](const Hypothesis& one) {
                             return one.test == Hypothesis::Test::in_use && !one.is_released();
                         });
    return result;
}

/// Variance of the difference of a force measurement in use from what all others say [N2]. That of
/// its residual is the noise less what the fit knows, so their ratio is noise / residual.
double variance_by_others(const Hypothesis& force, double std_dev) {
    constexpr double least = 1e-12;  // of the noise, where nothing else tells that tension
    const double noise = std_dev * std_dev;
    return noise * noise / std::max(force.covariance(0, 0), least * noise);
}

/// Those of them that are doubted, the worst first.
std::vector<Hypothesis> doubted(const Hypotheses& hypotheses, Suspect kind) {
    std::vector<Hypothesis> result = in_use(hypotheses, kind);
    std::erase_if(result, [threshold = doubt_threshold(hypotheses)](const Hypothesis& one) {
        return !(one.statistic > threshold);
    });
    std::ranges::stable_sort(result, std::greater{}, &Hypothesis::statistic);
    return result;
}

}  // namespace

std::vector<Hypothesis> measurement_hypotheses(const Survey& survey,
                                               const std::vector<ForceMeasurement>& forces,
                                               double false_alarm_rate) {
    const double rate = survey.is_noisy() ? false_alarm_rate : 0.0;
    const size_t tests = survey.surveyed.size() + forces.size();
    const double target_threshold = snooping_threshold(rate, tests, 3);
    const double force_threshold = snooping_threshold(rate, tests, 1);
    std::vector<Hypothesis> result;
    result.reserve(tests + 1);
    for (const int node : survey.surveyed) {
        result.push_back({.kind = Suspect::target,
                          .index = node,
                          .nodes = {node, -1, -1},
                          .degrees_of_freedom = 3,
                          .threshold = target_threshold});
    }
    for (int k = 0; k < static_cast<int>(forces.size()); ++k) {
        result.push_back({.kind = Suspect::force, .index = k, .threshold = force_threshold});
    }
    if (forces.size() > 1) {
        // A test of its own: one calibration or unit for all is the likeliest fault.
        result.push_back(
            {.kind = Suspect::force_scale, .threshold = snooping_threshold(rate, 1, 1)});
    }
    return result;
}

void test_targets(Hypotheses& hypotheses, const Survey& survey, const Points& noise,
                  const Points& fitted_form, const FormCovariance& covariance, double inflation) {
    const std::span<Hypothesis> targets = hypotheses.of(Suspect::target);
    std::vector<double> kept(targets.size(), 0.0);
    double squares = 0.0;
    double redundancy = 0.0;
    for (size_t i = 0; i < targets.size(); ++i) {
        Hypothesis& target = targets[i];
        const int node = target.index;
        const bool is_rejected = target.is_released();
        kept[i] = target.statistic;
        target.test = is_rejected ? Hypothesis::Test::released : Hypothesis::Test::in_use;
        target.deviation = survey.form.col(node) - fitted_form.col(node);
        // In units of the noise, Sigma = L L': L^-1 Q L'^-1 = I -+ L^-1 C L'^-1.
        const PlaceNoise measured = noise_of(survey, noise, node, inflation);
        const Eigen::Matrix3d whiten = whitening_of(measured);
        const Eigen::Matrix3d C = covariance(node);
        const Eigen::Vector3d e = whiten * target.deviation;
        const Eigen::Matrix3d Q = Eigen::Matrix3d::Identity() +
                                  (is_rejected ? 1.0 : -1.0) * (whiten * C * whiten.transpose());
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(Q);
        Eigen::Matrix3d testable = Eigen::Matrix3d::Zero();  // Q without directions not tested
        target.statistic = 0.0;
        for (int k = 0; k < 3; ++k) {
            const double variance = eigen.eigenvalues()(k);
            if (variance > smallest_redundancy) {
                const Eigen::Vector3d direction = eigen.eigenvectors().col(k);
                const double along = direction.dot(e);
                target.statistic += along * along / variance;  // (snooping)
                testable += variance * direction * direction.transpose();
            }
        }
        if (is_rejected) {
            target.covariance = covariance_of(noise_of(survey, noise, node)) + C;
        } else {
            target.noncentrality = whiten.transpose() * testable * whiten;
            squares += e.squaredNorm();
            redundancy += Q.trace();  // (redundancy)
        }
    }
    const double scale = residual_scale_of(targets, inflation);
    for (size_t i = 0; i < targets.size(); ++i) {
        const bool is_kept = targets[i].state == Hypothesis::State::released_for_good;
        targets[i].statistic = is_kept ? kept[i] : targets[i].statistic / scale;
        targets[i].noncentrality /= scale;
    }
    hypotheses.residual_scale = scale;
    hypotheses.noise_ratio = redundancy > 0.0 ? std::sqrt(squares / redundancy) : 0.0;
}

void test_forces(Hypotheses& hypotheses, const std::vector<ForceMeasurement>& forces,
                 const Eigen::VectorXd& tensions, const Eigen::VectorXd& variances,
                 const SumVariance& sum_variance, double inflation) {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(tensions.size());
    double along = 0.0;  // c' W e, c the measured tensions
    double known = 0.0;  // c' W c
    int in_use = 0;
    for (Hypothesis& hypothesis : hypotheses.of(Suspect::force)) {
        const ForceMeasurement& force = forces[hypothesis.index];
        const bool is_rejected = hypothesis.is_released();
        const double noise = std::pow(inflation * force.std_dev, 2);
        const double variance = noise + (is_rejected ? 1.0 : -1.0) * variances(force.edge);
        const double residual = force.tension - tensions(force.edge);
        hypothesis.test = is_rejected ? Hypothesis::Test::released : Hypothesis::Test::in_use;
        hypothesis.deviation(0) = residual;
        hypothesis.covariance(0, 0) = variance;
        hypothesis.statistic = variance > smallest_redundancy * noise
                                   ? residual * residual / variance / hypotheses.residual_scale
                                   : 0.0;  // (snooping)
        if (!is_rejected) {
            weights(force.edge) = force.tension / noise;
            along += force.tension * residual / noise;
            known += force.tension * force.tension / noise;
            ++in_use;
        }
    }
    for (Hypothesis& scale : hypotheses.of(Suspect::force_scale)) {
        if (scale.is_released()) {
            continue;  // as it was when it was released
        }
        constexpr double rounding = 1e-7;
        const double redundant = in_use > 1 ? known - sum_variance(weights) : 0.0;
        scale.test = Hypothesis::Test::in_use;
        scale.statistic = 0.0;
        if (redundant > rounding * known) {  // (common-bias)
            scale.deviation(0) = along / redundant;
            scale.covariance(0, 0) = 1.0 / redundant;
            scale.statistic = along * along / redundant / hypotheses.residual_scale;
        }
    }
}

std::vector<Outlier> target_outliers(const Hypotheses& hypotheses, const Survey& survey,
                                     const Points& noise) {
    const std::vector<Hypothesis> found = hypotheses.found(Suspect::target);
    std::vector<Outlier> result;
    for (const Hypothesis& one : found) {
        Outlier outlier{
            .node = one.index, .distance = one.deviation.norm(), .statistic = one.statistic};
        double least = one.threshold;
        for (const Hypothesis& other : found) {
            if (&one == &other || one.test != Hypothesis::Test::released ||
                other.test != Hypothesis::Test::released) {
                continue;
            }
            const double statistic = std::max(
                statistic_at(one, other, survey, noise, hypotheses.residual_scale),
                statistic_at(other, one, survey, noise, hypotheses.residual_scale));  // (swapped)
            if (statistic < least) {
                least = statistic;
                outlier.swapped_with = other.index;
            }
        }
        result.push_back(outlier);
    }
    return result;
}

std::vector<ForceOutlier> force_outliers(const Hypotheses& hypotheses,
                                         const std::vector<ForceMeasurement>& forces,
                                         const Hypotheses* without) {
    std::vector<ForceOutlier> result;
    const auto add = [&](const Hypothesis& one, double residual, double probability) {
        const ForceMeasurement& force = forces[static_cast<size_t>(one.index)];
        result.push_back({.edge = force.edge,
                          .measured = force.tension,
                          .expected = force.tension - residual,
                          .statistic = one.statistic,
                          .source = force.source,
                          .mode = force.mode,
                          .probability = probability});
    };
    for (const Hypothesis& one : hypotheses.found(Suspect::force)) {
        add(one, one.deviation(0), 1.0);
    }
    for (const Hypothesis& one : doubted(hypotheses, Suspect::force)) {
        const double std_dev = forces[static_cast<size_t>(one.index)].std_dev;
        add(one, one.deviation(0) * variance_by_others(one, std_dev) / (std_dev * std_dev), 0.0);
    }
    if (without != nullptr) {
        const double threshold = doubt_threshold(hypotheses);
        for (const Hypothesis& one : without->found(Suspect::force)) {
            const int edge = forces[static_cast<size_t>(one.index)].edge;
            const bool is_named =
                std::ranges::find(result, edge, &ForceOutlier::edge) != result.end();
            if (!is_named && one.statistic > threshold) {
                add(one, one.deviation(0), 0.0);
            }
        }
    }
    return result;
}

std::optional<ForceBias> force_bias(const Hypotheses& hypotheses) {
    const auto bias_of = [](const std::vector<Hypothesis>& scales, double probability) {
        return scales.empty() ? std::nullopt
                              : std::optional<ForceBias>({.part = scales[0].deviation(0),
                                                          .std_dev = scales[0].std_dev()(0),
                                                          .probability = probability});
    };
    const std::optional<ForceBias> found = bias_of(hypotheses.found(Suspect::force_scale), 1.0);
    return found ? found : bias_of(doubted(hypotheses, Suspect::force_scale), 0.0);
}

double detectable_force(const Hypotheses& hypotheses, const std::vector<ForceMeasurement>& forces) {
    const double bound = std::sqrt(doubt_threshold(hypotheses));
    std::vector<BoundedEstimate> errors;
    for (const Hypothesis& one : in_use(hypotheses, Suspect::force)) {
        const ForceMeasurement& force = forces[static_cast<size_t>(one.index)];
        const double size = std::abs(force.tension);  // a compressed strut's is negative
        if (size > 0.0) {
            const double std_dev =
                std::sqrt(hypotheses.residual_scale * variance_by_others(one, force.std_dev)) /
                size;
            errors.push_back({.bound = bound * std_dev, .std_dev = std_dev});
        }
    }
    return errors.empty() ? std::numeric_limits<double>::infinity() : detectable_error(errors);
}

double detectable_force_scale(const Hypotheses& hypotheses) {
    double result = std::numeric_limits<double>::infinity();
    for (const Hypothesis& one : in_use(hypotheses, Suspect::force_scale)) {
        const double std_dev = std::sqrt(hypotheses.residual_scale) * one.std_dev()(0);
        result = detectable_error(std::vector<BoundedEstimate>{
            {.bound = std::sqrt(doubt_threshold(hypotheses)) * std_dev, .std_dev = std_dev}});
    }
    return result;
}

}  // namespace taut
