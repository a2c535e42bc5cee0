// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "statics/arguments.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// One edge at given ends: what the energy and its derivatives need.
struct EdgeState {
    Eigen::Vector3d direction;  ///< u = (r_s - r_t) / l; zero if the ends coincide
    double length;              ///< l [m]
    double extension;           ///< max(0, l - l_0), of a strut or a sagging cable l - l_0 [m]
    double axial;               ///< dT/dl, axial stiffness, EA / l_0; also if slack [N/m]
    double tension;             ///< T, negative in a compressed strut [N]
    bool is_strut;
    bool sags = false;
    double curvature = 0.0;  ///< d2T/d strain2 / l_0, of a sagging cable alone [N/m]

    /// Whether the edge carries force: a taut cable, a strut, (strut-energy), or one that
    /// sags, (sagging-law).
    [[nodiscard]] bool carries() const { return extension > 0.0 || is_strut || sags; }
    /// The tension, continued below zero for an edge that is too long [N].
    [[nodiscard]] double pull(double unstressed_length) const {
        return carries() ? tension : axial * (length - unstressed_length);
    }
    /// T / l, stiffness across the edge [N/m].
    [[nodiscard]] double force_density() const {
        return carries() && length > 0.0 ? tension / length : 0.0;
    }
};

/// @param law null: linear, with the axial stiffness
inline EdgeState edge_state(const Eigen::Vector3d& source, const Eigen::Vector3d& target,
                            double axial_stiffness, double unstressed_length, const TensionLaw* law,
                            bool is_strut) {
    const Eigen::Vector3d vector = source - target;
    const double length = vector.norm();
    const double stretch = length - unstressed_length;
    const bool sags = law != nullptr && law->sags();
    const double extension = is_strut || sags ? stretch : std::max(0.0, stretch);
    EdgeState state{
        .direction = length > 0.0 ? Eigen::Vector3d(vector / length) : Eigen::Vector3d::Zero(),
        .length = length,
        .extension = extension,
        .axial = axial_stiffness / unstressed_length,
        .tension = axial_stiffness / unstressed_length * extension,
        .is_strut = is_strut,
        .sags = sags};
    if (law != nullptr) {
        const auto [tension, slope, curvature] = law->at(extension / unstressed_length);
        state.axial = slope / unstressed_length;
        state.tension = tension;
        state.curvature = curvature / unstressed_length;
    }
    return state;
}

/// Energy stored between two extensions of an edge, accurate also if they almost agree [J].
inline double energy_between(const EdgeState& from, const EdgeState& to, double unstressed_length,
                             const TensionLaw* law) {
    if (law == nullptr) {
        return 0.5 * to.axial * (to.extension - from.extension) * (to.extension + from.extension);
    }
    return unstressed_length * law->energy_between(from.extension / unstressed_length,
                                                   to.extension / unstressed_length);
}

/// 1/2 EA/l_0 (l - l_0)^2, or the integral of the law [J].
inline double energy_of(const EdgeState& state, double unstressed_length, const TensionLaw* law) {
    return law == nullptr
               ? 0.5 * state.axial * state.extension * state.extension
               : unstressed_length * law->energy_between(0.0, state.extension / unstressed_length);
}

/// The states of all edges of a net at a form (3 x n) [m].
/// @throws std::invalid_argument for wrong sizes and values
inline std::vector<EdgeState> edge_states(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
    const Eigen::Ref<const Points>& form) {
    check_unstressed_lengths(net.edge_count(), unstressed_lengths);
    check_form("form", net.node_count(), form);
    std::vector<EdgeState> states;
    states.reserve(net.edges().size());
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto [s, t] = net.edges()[e];
        states.push_back(edge_state(form.col(s), form.col(t), net.axial_stiffness()(e),
                                    unstressed_lengths(e), net.tension_law(e), net.is_strut(e)));
    }
    return states;
}

}  // namespace taut
