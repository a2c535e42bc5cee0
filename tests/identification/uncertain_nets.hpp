// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "identification/simulated_survey.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/sampling/model_perturbation.hpp"

/// What the tests of uncertain parameters and of force measurements share.
namespace of_forces {

using namespace taut;
using namespace taut::test;

inline constexpr LengthPrior prior{LengthPrior::Kind::uniform, 0.002};
inline constexpr double noise = 0.5e-3;

inline CableNet loaded_net(double load = -60.0) {
    CableNetData data = hypar(5, 5).data();
    const auto edges = static_cast<Eigen::Index>(data.edges.size());
    data.loads = Points::Zero(3, data.nodes.cols());
    data.loads.row(2).setConstant(load);
    data.expansion = Eigen::VectorXd::Constant(edges, 1.2e-5);
    const CableNet draft{CableNetData(data)};
    data.nodes = solve_equilibrium(draft).form;
    return CableNet(std::move(data));
}

/// A built net that differs from the design in lengths and in uncertain parameters.
struct Built {
    ModelPerturbation perturbation;
    SimulatedSurvey simulated;
    Eigen::VectorXd tensions;  ///< m, the truth [N]
};

inline Built built(const CableNet& net, const std::vector<UncertainParameter>& uncertain,
                   std::uint64_t seed) {
    Built result;
    result.perturbation = draw_perturbation(net, uncertain, 5, seed);
    const CableNet changed = net_under(net, result.perturbation, net.unstressed_lengths());
    result.simulated = simulate(changed, prior, noise, seed);
    result.tensions = true_tensions(changed, result.simulated);
    return result;
}

inline IdentifyOptions options_with(const std::vector<UncertainParameter>& uncertain,
                                    int draws = 0) {
    return {.method = IdentificationMethod::map,
            .prior = prior,
            .uncertain = uncertain,
            .draws = draws};
}

}  // namespace of_forces
