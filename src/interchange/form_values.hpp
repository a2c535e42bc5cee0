// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "taut/net/cable_net.hpp"

namespace taut {

/// What is exported of the edges of a net in a form.
struct FormValues {
    Eigen::VectorXd lengths;          ///< [m]
    Eigen::VectorXd tensions;         ///< [N]
    Eigen::VectorXd force_densities;  ///< T / l [N/m]
    /// EA; of a taut edge with a tension law T over strain, by which a reader who knows no law
    /// finds the same tension; of a slack one the first slope [N].
    Eigen::VectorXd axial_stiffness;

    [[nodiscard]] bool is_slack(const CableNet& net, int edge) const {
        return tensions(edge) <= 0.0 && !net.is_strut(edge);
    }
};

/// @param form 3 x n [m]
/// @throws std::invalid_argument for another size, a coordinate that is not finite, and an edge
///   without length
[[nodiscard]] FormValues form_values(const CableNet& net, const Points& form);

/// What is exported of the cable runs of a net. Runs without a name get one.
struct RunValues {
    std::vector<std::string> of_edges;             ///< m: name of the run, or empty
    std::vector<std::optional<double>> friction;   ///< m: that of the run
    std::vector<std::vector<std::string>> slides;  ///< n: names of the runs that slide there
};
[[nodiscard]] RunValues run_values(const CableNet& net);

/// The elastic support at a node, if any. One on a frame with others alone, where it holds the form
/// as it does on the frame.
/// @param form 3 x n [m]
[[nodiscard]] std::optional<ElasticSupport> elastic_support_at(const CableNet& net,
                                                               const Points& form, int node);

/// Whether each edge is adjustable.
[[nodiscard]] std::vector<bool> adjustable_flags(const CableNet& net);

}  // namespace taut
