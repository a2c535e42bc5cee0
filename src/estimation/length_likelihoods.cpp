// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/length_likelihoods.hpp"

#include <cmath>
#include <limits>

#include "taut/statics/tensions.hpp"

namespace taut {

std::vector<LengthLikelihood> length_likelihoods(const PriorKnowledge& knowledge,
                                                 const StaticsModel& model,
                                                 const Covariance& covariance,
                                                 const Observations& observations,
                                                 const Iterate& fitted) {
    const CableNet& net = model.net();
    const Eigen::VectorXd& variances = covariance.lengths;
    const Eigen::VectorXd& extension_variances = covariance.extensions;
    const Eigen::VectorXd prior_variances =
        model.blur.length_variances(net.interior_edge_count());  // (blurred-law), (own-stiffness)
    const Eigen::VectorXd lengths =
        model.common.cold(edge_lengths(net, fitted.form), fitted.common);
    const std::vector<bool> can_be_slack =
        knowledge.as_seen(std::vector<bool>(net.edge_count(), true));
    std::vector<LengthLikelihood> result;
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[i];
        // At loose nodes rounding errors can exceed a variance: then nothing is known.
        const bool is_known = variances(i) > 0.0;
        LengthLikelihood likelihood =
            is_known ? without_prior(observations.mean(i),
                                     std::sqrt(observations.variance(i) + prior_variances(i)),
                                     fitted.deviations(i), std::sqrt(variances(i)))  // (likelihood)
                     : LengthLikelihood();
        likelihood.std_dev =
            std::sqrt(likelihood.std_dev * likelihood.std_dev + prior_variances(i));
        likelihood.slack_from = lengths(edge) - net.unstressed_lengths()(edge);
        if (!can_be_slack[edge] || !net.can_be_slack(edge)) {
            likelihood.extension = std::numeric_limits<double>::infinity();
        } else if (model.slack[edge]) {
            likelihood.extension = -std::numeric_limits<double>::infinity();
            // Its length and the form are independent, so their variances add up.
            if (const double variance = extension_variances(i) - variances(i); variance > 0.0) {
                likelihood.slack_from_std = std::sqrt(variance);
            }
        } else {
            const double extension = likelihood.slack_from - fitted.deviations(i);
            likelihood.extension =
                extension_variances(i) > 0.0
                    ? extension / std::sqrt(extension_variances(i))
                    : std::copysign(std::numeric_limits<double>::infinity(), extension);
        }
        result.push_back(likelihood);
    }
    return result;
}

}  // namespace taut
