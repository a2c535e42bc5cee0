// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "identification/draw_posterior.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// A result under one prior, with the posterior probability of that prior.
struct WeightedIdentification {
    double weight = 1.0;
    Identification result;
};

/// The mixture of results under several priors, docs/theory.md (prior-mixture): means, standard
/// deviations and intervals of lengths, uncertain parameters and frame, the draws of all, and the
/// predicted form. All else is of the first.
/// @param parts at least one, the most probable first, weights that sum to 1; each with as many
///   draws as by shared_out(), or more
/// @param draws how many all together
[[nodiscard]] Identification mixture_of(const CableNet& net, const Survey& survey,
                                        std::vector<WeightedIdentification> parts, int draws);

/// The mixture of the results under the priors of a posterior.
/// @param wanted of all of them together
/// @param identify_by gives the result under the k-th of them, or nothing
/// @return empty where the results converge under too few of them
[[nodiscard]] std::optional<Identification> mixture_over(
    const CableNet& net, const Survey& survey, const std::vector<PriorNode>& nodes,
    const PosteriorSettings& wanted,
    const std::function<std::optional<Identification>(size_t k, const PosteriorSettings&)>&
        identify_by);

/// Shares out draws by weights that sum to 1.
[[nodiscard]] std::vector<int> shared_out(int draws, const std::vector<double>& weights);

/// The quantile p of a mixture of distributions, each with a mean and the 95 % interval of a normal
/// distribution on either side of it.
struct MixturePart {
    double weight = 1.0;
    double mean = 0.0;
    double lower = 0.0;
    double upper = 0.0;
};
[[nodiscard]] double quantile_of(const std::vector<MixturePart>& parts, double p);

}  // namespace taut
