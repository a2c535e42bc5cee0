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

/// One sample of the uncertain parameters of a net: all that may differ from the design besides the
/// lengths of its interior edges.
struct ModelPerturbation {
    Eigen::VectorXd stiffness;  ///< m, natural logarithm of the factor of EA or of the tension law
    Eigen::VectorXd thermal;    ///< m, thermal strain of the unstressed lengths
    /// 3 x n, displacements of supports, of elastic ones without load; 0 for other nodes [m]
    Points supports;
    /// m, changes of unstressed lengths of adjustable edges, what slid to them included; 0 for
    /// interior edges [m]
    Eigen::VectorXd adjustable;
    double loads = 0.0;              ///< relative change of all loads
    Points own_loads;                ///< 3 x n, change of the load of each node [N]
    double support_stiffness = 0.0;  ///< logarithm of the factor of all elastic supports
    double sag = 0.0;  ///< relative change of all sag weights, as of the mass that makes them
    std::vector<CableRun> runs = {};  ///< in place of the net's; empty: as there
};

/// No perturbation: all as designed.
[[nodiscard]] TAUT_CORE_EXPORT ModelPerturbation unperturbed(const CableNet& net);

/// Draws one sample. It depends on the seed and on the lower 32 bits of the sample's index alone.
/// @param uncertain of this net; not checked, see check_uncertain_parameters()
[[nodiscard]] TAUT_CORE_EXPORT ModelPerturbation
draw_perturbation(const CableNet& net, const std::vector<UncertainParameter>& uncertain,
                  std::uint64_t seed, std::uint64_t sample);

/// The net under a perturbation.
/// @param perturbation of the sizes of unperturbed(net), not checked
/// @param unstressed_lengths l_0 of all edges before the perturbation (m) [m]
/// @throws NetError where a length is no longer positive
[[nodiscard]] TAUT_CORE_EXPORT CableNet
net_under(const CableNet& net, const ModelPerturbation& perturbation,
          const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths);

}  // namespace taut
