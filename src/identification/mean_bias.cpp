// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/mean_bias.hpp"

#include <cmath>
#include <optional>

#include "identification/maximum_a_posteriori.hpp"
#include "numerics/random_numbers.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/sampling/model_perturbation.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {
namespace {

constexpr std::uint64_t seed = 20;

/// Empty where the drawn net finds no equilibrium.
std::optional<Survey> simulated(const CableNet& net, const Survey& survey, const LengthPrior& prior,
                                const std::vector<UncertainParameter>& uncertain) {
    const Eigen::VectorXd deviations =
        draw_length_deviations(prior, seed, 0, net.interior_edge_count());
    RandomNumbers random(seed, 0);
    Survey result = survey;
    try {
        const CableNet drawn = net_under(net, draw_perturbation(net, uncertain, seed, 0),
                                         with_length_deviations(net, deviations));
        const Equilibrium form = solve_equilibrium(drawn);
        if (!form.balanced()) {
            return std::nullopt;
        }
        const auto seen = [&](int node, const Eigen::Vector3d& std_dev) {
            Eigen::Vector3d place = form.form.col(node);
            for (int axis = 0; axis < 3; ++axis) {
                place(axis) += std_dev(axis) * random.normal();
            }
            return place;
        };
        for (const int node : survey.surveyed) {
            result.form.col(node) = seen(node, survey.noise_std.col(node));
        }
        for (SurveyedSupport& support : result.supports) {
            support.position = seen(support.node, support.noise_std);
        }
    } catch (const NetError&) {
        return std::nullopt;  // a length that is no longer positive
    }
    return result;
}

}  // namespace

void take_out_mean_bias(Identification& result, const CableNet& net, const Survey& survey,
                        const std::vector<UncertainParameter>& uncertain,
                        const Progress& progress) {
    constexpr double largest_bias = 0.6;  // standard deviations of the prior
    PriorCheck& check = result.prior_check;
    if (result.status != IdentificationStatus::converged || !check.has_mean() ||
        std::abs(check.mean) > largest_bias * result.length_prior.std_dev()) {
        return;
    }
    const std::optional<Survey> again = simulated(net, survey, result.length_prior, uncertain);
    if (!again) {
        return;
    }
    const Identification fit = identify_by_maximum_a_posteriori(
        net, *again, Given(result.length_prior, uncertain), {}, {}, progress);
    if (fit.status == IdentificationStatus::converged && fit.prior_check.mean_std > 0.0) {
        check.mean -= fit.prior_check.mean;
        check.mean_std = std::hypot(check.mean_std, fit.prior_check.mean_std);
    }
}

}  // namespace taut
