// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/drawn_posterior.hpp"

#include <cmath>
#include <vector>

#include "taut/statics/energy.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

constexpr double corner_of_draws = 0.3;  ///< as in fit()

Iterate with_all_taut(const CableNet& net, const CommonParameters& common, const Iterate& fitted) {
    const Eigen::VectorXd stretch = edge_lengths(net, net.nodes()) - net.unstressed_lengths();
    Eigen::VectorXd spans = edge_lengths(net, fitted.form) - net.unstressed_lengths();
    for (int e = 0; e < net.edge_count(); ++e) {
        spans(e) -= common.slip(e, fitted.common);
    }
    Iterate result = fitted;
    result.deviations = result.deviations.cwiseMin((spans - stretch)(net.interior_edges()).eval());
    return result;
}

}  // namespace

DrawnPosterior::DrawnPosterior(const LinearisedFit& fitted, const Observations& sites_of_fit,
                               const PriorKnowledge& known, std::uint64_t seed_of_draws)
    : fit(fitted),
      sites(sites_of_fit),
      knowledge(known),
      seed(seed_of_draws),
      tensile_model(fitted.model()),
      all_taut(with_all_taut(fitted.model().net(), fitted.model().common, fitted.iterate)) {
    tensile_model.slack = knowledge.as_seen(std::vector<bool>(net().edge_count(), false));
    tensile_model.corner_width = corner_of_draws * smallest_noise();
    // Fits follow all but the stiffness of each edge.
    tensile_model.blur.missed.setZero();
    tensile_model.release_tension_laws();
}

double DrawnPosterior::smallest_noise() const {
    return 1.0 / std::sqrt(sites.weights(Eigen::all, net().free_nodes()).maxCoeff());
}

Eigen::VectorXd DrawnPosterior::blur_variances(bool is_refitted) const {
    return model(is_refitted).blur.length_variances(net().interior_edge_count());
}

}  // namespace taut
