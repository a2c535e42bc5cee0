// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/prior_likelihood.hpp"

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>

#include "estimation/length_likelihoods.hpp"

namespace taut {
namespace {

/// A length with a larger standard deviation shows nothing of the prior.
constexpr double widest_used = 2.0;  // standard deviations of the prior

/// Part of each prior that is spread widely, so that one mis-cut edge does not favour another
/// prior.
constexpr double outlier_part = 0.005;
constexpr double outlier_width = 6.0;  // standard deviations of the prior checked

double normal_density(double x, double std_dev) {
    return std::exp(-0.5 * x * x / (std_dev * std_dev)) /
           (std_dev * std::sqrt(2.0 * std::numbers::pi));
}

double normal_distribution(double x) {
    return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

/// The density of an estimate with this standard deviation: the prior's, spread by its error.
double density_of(const LengthPrior& prior, double mean, double std_dev) {
    switch (prior.kind) {
        case LengthPrior::Kind::uniform: {
            // By the small tails, to avoid cancellation.
            const double near = (prior.scale - std::abs(mean)) / std_dev;
            const double far = (-prior.scale - std::abs(mean)) / std_dev;
            return (normal_distribution(near) - normal_distribution(far)) / (2.0 * prior.scale);
        }
        case LengthPrior::Kind::normal:
            return normal_density(mean, std::hypot(std_dev, prior.scale));
        case LengthPrior::Kind::bimodal: {
            const double fall =
                std::sqrt(prior.std_dev() * prior.std_dev() - prior.scale * prior.scale);
            const double spread = std::hypot(std_dev, fall);
            return 0.5 * (normal_density(mean - prior.scale, spread) +
                          normal_density(mean + prior.scale, spread));
        }
    }
    return 0.0;
}

}  // namespace

PriorLikelihood::PriorLikelihood(const LengthPrior& prior,
                                 const std::vector<LengthLikelihood>& likelihoods,
                                 const std::vector<bool>& left_out)
    : m_prior_std(prior.std_dev()) {
    for (size_t i = 0; i < likelihoods.size(); ++i) {
        const LengthLikelihood& one = likelihoods[i];
        if (!left_out[i] && one.std_dev < widest_used * m_prior_std &&
            one.extension > surely_taut_extension) {
            m_lengths.emplace_back(one.mean, one.std_dev);
        }
    }
}

double PriorLikelihood::operator()(const LengthPrior& prior) const {
    double sum = 0.0;
    for (const auto& [mean, std_dev] : m_lengths) {
        const double outlier_std = std::hypot(std_dev, outlier_width * m_prior_std);
        sum += std::log((1.0 - outlier_part) * density_of(prior, mean, std_dev) +
                        outlier_part * normal_density(mean, outlier_std));
    }
    return sum;
}

LengthPrior PriorLikelihood::likeliest(LengthPrior::Kind kind) const {
    constexpr double widest = 10.0;
    constexpr int bits = 20;
    const double unit = m_prior_std / LengthPrior{kind, 1.0}.std_dev();
    const auto cost = [&](double log_scale) {
        return -(*this)({kind, unit * std::exp(log_scale)});
    };
    // The likelihood may have more than one peak: the best of a few is refined.
    constexpr int starts = 24;
    const double step = 2.0 * std::log(widest) / starts;
    double best = 0.0;
    for (int k = 0; k <= starts; ++k) {
        const double log_scale = -std::log(widest) + step * k;
        best = cost(log_scale) < cost(best) ? log_scale : best;
    }
    const double found =
        boost::math::tools::brent_find_minima(cost, best - step, best + step, bits).first;
    return rounded({kind, unit * std::exp(found)});
}

LengthPrior rounded(const LengthPrior& prior) {
    constexpr double finest = 1e9;
    double steps_a_millimetre = 100.0;
    const auto steps_of = [&] { return std::round(1e3 * prior.scale * steps_a_millimetre); };
    while (steps_of() <= 10.0 && steps_a_millimetre < finest) {
        steps_a_millimetre *= 10.0;
    }
    const double steps = steps_of();
    // As "4.89mm" is read.
    return {prior.kind, steps > 0.0 ? steps / steps_a_millimetre / 1e3 : prior.scale};
}

}  // namespace taut
