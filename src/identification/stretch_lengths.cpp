// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/stretch_lengths.hpp"

#include <algorithm>
#include <cmath>

namespace taut {

std::vector<StretchLength> stretch_lengths(const CableNet& net, const PriorKnowledge& knowledge,
                                           const LinearisedFit& fitted) {
    std::vector<StretchLength> result;
    const StaticsModel& model = fitted.model();
    const CommonParameters& common = model.common;
    for (size_t k = 0; k < knowledge.stretches.size() && common.slip_std() > 0.0; ++k) {
        const PriorKnowledge::StretchTension& tension = knowledge.stretches[k];
        StretchLength stretch{.edges = tension.edges,
                              .nominal = net.unstressed_lengths()(tension.edges).sum()};
        std::vector<int> unknown;
        for (const int edge : tension.edges) {
            if (model.numbering().interior_of[edge] >= 0) {
                unknown.push_back(edge);
            }
        }
        const double variance = fitted.linearisation.length_covariance(unknown).sum();
        stretch.std = std::sqrt(std::max(0.0, variance));
        const int place = common.first_of_stretches() + static_cast<int>(k);
        stretch.tension = tension.mean + tension.std * fitted.iterate.common(place);
        stretch.tension_std =
            tension.std * std::sqrt(std::max(0.0, fitted.covariance.common(place, place)));
        result.push_back(std::move(stretch));
    }
    return result;
}

void set_stretch_deviations(Identification& result) {
    for (StretchLength& stretch : result.stretches) {
        const auto is_part = [&](int edge) {
            return std::ranges::find(stretch.edges, edge) != stretch.edges.end();
        };
        stretch.length_deviation = 0.0;
        for (const IdentifiedEdge& one : result.edges) {
            stretch.length_deviation += is_part(one.edge) ? one.length_deviation : 0.0;
        }
        for (const ParameterEstimate& one : result.uncertain) {
            if (one.parameter.kind == UncertainParameter::Kind::adjustable && is_part(one.edge)) {
                stretch.length_deviation += one.mean;
            }
        }
        for (const BoundaryOutlier& one : result.boundary_outliers) {
            if (one.kind == BoundaryOutlier::Kind::adjustable_edge && is_part(one.index)) {
                stretch.length_deviation += one.deviation.x();
            }
        }
    }
}

}  // namespace taut
