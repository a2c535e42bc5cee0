// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/cramer_rao_bound.hpp"

#include <utility>

#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {

Eigen::VectorXd cramer_rao_variances(const CableNet& net,
                                     const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                     const Eigen::Ref<const Points>& form, const Survey& survey,
                                     const LengthPrior& prior) {
    prior.check();
    check_survey(net, survey);
    StaticsModel model(net);
    for (const int edge : slack_edges(net, unstressed_lengths, form)) {
        model.slack[edge] = true;
    }
    const std::vector<bool> none_rejected(net.node_count(), false);
    Iterate truth = nominal_iterate(net);
    truth.form = form;
    truth.deviations = (unstressed_lengths - net.unstressed_lengths())(net.interior_edges());
    const LinearisedFit fit = linearised_fit(
        model, std::move(truth),
        observe(net, survey, with_noise_floor(net, survey), none_rejected, prior.std_dev()));
    // At loose nodes they can be lost in rounding errors: then the prior is all that is known.
    const double of_prior = prior.std_dev() * prior.std_dev();
    return fit.covariance.lengths.unaryExpr(
        [of_prior](double variance) { return variance > 0.0 ? variance : of_prior; });
}

}  // namespace taut
