// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {

/// Values of what is not known of a net besides the lengths of its interior edges, as deviations
/// from what the net tells.
struct ModelPerturbation {
    Eigen::VectorXd stiffness;   ///< m, by which EA or the tension law is larger, natural logarithm
    Eigen::VectorXd thermal;     ///< m, thermal strain of the unstressed lengths
    Points supports;             ///< 3 x n, of the supports' places; 0 for free nodes [m]
    Eigen::VectorXd adjustable;  ///< m, of unstressed lengths; 0 for interior edges [m]
    double loads = 0.0;          ///< relative, of all loads
    Points own_loads;            ///< 3 x n, of the loads of each node [N]
};

/// All as the net tells.
[[nodiscard]] TAUT_CORE_EXPORT ModelPerturbation unperturbed(const CableNet& net);

/// One draw of what is unknown; it depends on the seed and the sample's index alone, of which the
/// lower 32 bits count.
/// @param uncertain of this net, which is not checked: check_uncertain_parameters() does
[[nodiscard]] TAUT_CORE_EXPORT ModelPerturbation
draw_perturbation(const CableNet& net, const std::vector<UncertainParameter>& uncertain,
                  std::uint64_t seed, std::uint64_t sample);

/// The net under perturbation, with unstressed lengths of its own.
/// @param perturbation sizes as of unperturbed(net), not checked
/// @param unstressed_lengths l_0 of all edges as they would be as told (m) [m]
/// @throws NetError where a length is no longer positive
[[nodiscard]] TAUT_CORE_EXPORT CableNet
net_under(const CableNet& net, const ModelPerturbation& perturbation,
          const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths);

}  // namespace taut
