// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "statics/edge_state.hpp"
#include "statics/local_net.hpp"

namespace taut {

/// How forces and tensions of a net at one form change with its unstressed lengths. Refers to its
/// parts.
struct LengthRates {
    const LocalNet& net;
    const std::vector<EdgeState>& states;
    const Eigen::VectorXd& lengths;  ///< l_0 (m) [m]

    /// -dh_s/dl_0 = dh_t/dl_0 of an edge (s, t) [N/m].
    [[nodiscard]] Eigen::Vector3d force_rate(int edge) const {
        const EdgeState& state = states[edge];
        if (!state.carries()) {
            return Eigen::Vector3d::Zero();
        }
        return state.axial * state.length / lengths(edge) * state.direction;
    }

    /// Adds a force at an edge's source, and its opposite at the target.
    void add_force(int edge, const Eigen::Vector3d& force, Eigen::Ref<Eigen::VectorXd> rhs) const {
        const auto [s, t] = net.edges[edge];
        if (s < net.free_count) {
            rhs.segment<3>(Eigen::Index{3} * s) += force;
        }
        if (t < net.free_count) {
            rhs.segment<3>(Eigen::Index{3} * t) -= force;
        }
    }

    /// The transpose of add_force(): values at an edge's source less those at its target.
    [[nodiscard]] Eigen::Vector3d across(int edge,
                                         const Eigen::Ref<const Eigen::VectorXd>& local) const {
        const auto [s, t] = net.edges[edge];
        Eigen::Vector3d difference = Eigen::Vector3d::Zero();
        if (s < net.free_count) {
            difference += local.segment<3>(Eigen::Index{3} * s);
        }
        if (t < net.free_count) {
            difference -= local.segment<3>(Eigen::Index{3} * t);
        }
        return difference;
    }

    /// The gradient by lengths, at a fixed form, of a sum of tensions (weights: m) [N/m of these].
    [[nodiscard]] Eigen::VectorXd lengths_by(const Eigen::VectorXd& weights) const {
        Eigen::VectorXd result(weights.size());
        for (int e = 0; e < weights.size(); ++e) {
            result(e) = -weights(e) * states[e].axial * states[e].length / lengths(e);
        }
        return result;
    }
};

}  // namespace taut
