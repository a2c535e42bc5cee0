// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/law_check.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>
#include <utility>

namespace taut {
namespace {

/// Chance explains no more than so many standard deviations, or so much log likelihood.
constexpr double beyond_chance_std = 4.0;
constexpr double beyond_chance_gain = 8.0;
constexpr double untenable_gain = 20.0;

/// What is told so weakly says nothing of the law.
constexpr double weakest_telling = 2.0;  // standard deviations of the law
constexpr double surely_taut_law = 4.0;  // standard deviations
constexpr int fewest_lengths = 8;

/// Of all laws, so that one mis-cut edge does not speak for another law.
constexpr double outlier_part = 0.005;
constexpr double outlier_width = 6.0;  // standard deviations of the law told

double normal_density(double x, double std) {
    return std::exp(-0.5 * x * x / (std * std)) / (std * std::sqrt(2.0 * std::numbers::pi));
}

double normal_distribution(double x) {
    return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

/// Of a length known with an error: the law's density spread by that.
double density_of(const LengthLaw& law, double mean, double std) {
    switch (law.kind) {
        case LengthLaw::Kind::uniform: {
            // By the tail that is not 1 less something small.
            const double near = (law.scale - std::abs(mean)) / std;
            const double far = (-law.scale - std::abs(mean)) / std;
            return (normal_distribution(near) - normal_distribution(far)) / (2.0 * law.scale);
        }
        case LengthLaw::Kind::normal:
            return normal_density(mean, std::hypot(std, law.scale));
        case LengthLaw::Kind::bimodal: {
            const double fall = std::sqrt(law.std() * law.std() - law.scale * law.scale);
            const double spread = std::hypot(std, fall);
            return 0.5 * (normal_density(mean - law.scale, spread) +
                          normal_density(mean + law.scale, spread));
        }
    }
    return 0.0;
}

class LawLikelihood {
public:
    LawLikelihood(double law_std, std::vector<std::pair<double, double>> lengths)
        : m_outlier_std(outlier_width * law_std), m_lengths(std::move(lengths)) {}

    [[nodiscard]] double operator()(const LengthLaw& law) const {
        double sum = 0.0;
        for (const auto& [mean, std] : m_lengths) {
            sum += std::log((1.0 - outlier_part) * density_of(law, mean, std) +
                            outlier_part * normal_density(mean, std::hypot(std, m_outlier_std)));
        }
        return sum;
    }

    /// Of a kind, the scale within a factor of ten of the other law's that is likeliest.
    [[nodiscard]] LengthLaw likeliest(LengthLaw::Kind kind, double law_std) const {
        constexpr double widest = 10.0;
        constexpr int bits = 20;
        const double unit = law_std / LengthLaw{kind, 1.0}.std();
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
        return {kind, rounded(unit * std::exp(found))};
    }

private:
    /// To a hundredth of a millimetre, or to two digits where that is much of it: nobody reads
    /// more.
    static double rounded(double scale) {
        constexpr double finest = 1e9;
        double steps_a_millimetre = 100.0;
        const auto steps_of = [&] { return std::round(1e3 * scale * steps_a_millimetre); };
        while (steps_of() <= 10.0 && steps_a_millimetre < finest) {
            steps_a_millimetre *= 10.0;
        }
        const double steps = steps_of();
        return steps > 0.0 ? steps / steps_a_millimetre / 1e3 : scale;  // as "4.89mm" is read
    }

    double m_outlier_std;
    std::vector<std::pair<double, double>> m_lengths;  ///< mean, standard deviation [m]
};

}  // namespace

bool FoundScale::is_contradicted() const {
    return ratio > 0.0 && std > 0.0 && std::abs(ratio - 1.0) > beyond_chance_std * std;
}

bool LawCheck::has_mean() const {
    return mean_std > 0.0 && std::abs(mean) > beyond_chance_std * mean_std;
}

bool LawCheck::is_contradicted() const {
    return gain > beyond_chance_gain || has_mean() || beyond > 0;
}

bool LawCheck::is_untenable() const {
    return gain > untenable_gain;
}

bool LawCheck::is_too_wide() const {
    constexpr double narrower = 0.8;
    return likeliest.std() < narrower * checked.std();
}

LawCheck check_law_by_lengths(const LengthLaw& law, const std::vector<LengthLikelihood>& told,
                              const std::vector<bool>& left_out) {
    std::vector<std::pair<double, double>> lengths;
    for (size_t i = 0; i < told.size(); ++i) {
        if (!left_out[i] && told[i].std < weakest_telling * law.std() &&
            told[i].extension > surely_taut_law) {
            lengths.emplace_back(told[i].mean, told[i].std);
        }
    }
    LawCheck result{.checked = law, .lengths = static_cast<int>(lengths.size()), .likeliest = law};
    if (result.lengths < fewest_lengths) {
        return result;
    }
    const LawLikelihood likelihood(law.std(), std::move(lengths));
    const double of_told = likelihood(law);
    for (const LengthLaw::Kind kind :
         {LengthLaw::Kind::uniform, LengthLaw::Kind::normal, LengthLaw::Kind::bimodal}) {
        const LengthLaw found = likelihood.likeliest(kind, law.std());
        if (const double gain = likelihood(found) - of_told; gain > result.gain) {
            result.gain = gain;
            result.likeliest = found;
        }
    }
    return result;
}

}  // namespace taut
