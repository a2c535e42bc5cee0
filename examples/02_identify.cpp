// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// From one survey of a built net to the lengths of its cables: draw, train, identify.
#include <algorithm>
#include <cmath>
#include <iostream>

#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/identification/model.hpp"
#include "taut/sampling/sampler.hpp"

int main() {
    const taut::CableNet net = taut::hypar(8, 10);
    const taut::LengthPrior prior{.kind = taut::LengthPrior::Kind::uniform, .scale = 0.003};  // m

    // Algorithm 2: random lengths, and the forms that follow from them.
    const taut::Sampler sampler(net, prior, 1);
    taut::DataSet data = sampler.no_samples();
    sampler.extend_to(data, 401);

    // Algorithm 1: one Gaussian process an edge. The last sample is left out: it is the built net.
    const taut::LengthModel model = taut::train_model(net, data, data.converged_in(0, 400));

    taut::Survey survey;
    survey.form =
        taut::with_free_coordinates(net, data.nominal_form + data.form_deviations.col(400));
    survey.surveyed = net.free_nodes();
    const taut::Identification result = taut::identify(net, survey, {.model = &model});

    double worst = 0.0;
    for (size_t i = 0; i < result.edges.size(); ++i) {
        const double truth = data.length_deviations(static_cast<Eigen::Index>(i), 400);
        worst = std::max(worst, std::abs(result.edges[i].length_deviation - truth));
    }
    const taut::IdentifiedEdge& first = result.edges.front();
    std::cout << "edge " << first.edge << ": " << 1e3 * first.length_deviation << " mm, between "
              << 1e3 * first.lower << " and " << 1e3 * first.upper << " mm\n"
              << "largest error of " << result.edges.size() << " lengths: " << 1e3 * worst
              << " mm, predicted form within " << 1e3 * result.residuals.maxCoeff()
              << " mm of the survey\n";
    return worst < prior.scale ? 0 : 1;
}
