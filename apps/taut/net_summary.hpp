// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "taut/estimation/edge_status.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/statics/duality.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut::app {

/// "net hilo-quarter: 300 free nodes, 128 supports, 536 interior and 128 adjustable edges"
[[nodiscard]] std::string counts_text(const CableNet& net);

/// The same numbers, keyed as in results.json.
[[nodiscard]] nlohmann::ordered_json counts_json(const CableNet& net);

/// "converged after 4 iterations, 3e-09 N out of balance (7e-13 of the mean tension, 4466 N)"
[[nodiscard]] std::string equilibrium_text(const Equilibrium& equilibrium);

/// "3e-09 N out of balance (7e-13 of the mean tension, 4466 N)"
[[nodiscard]] std::string balance_text(double out_of_balance, double mean_tension);

/// What shows that a form is the one that the net takes.
struct FormCheck {
    double energy = 0.0;  ///< [J]
    /// A bound on how far the energy is above the lowest; none with struts, which have no lowest.
    std::optional<EnergyCertificate> certificate;
    double smallest_stiffness = 0.0;  ///< of a net with struts [N/m]
};
/// @param edge_forces as of energy_certificate(), or 3 x 0
[[nodiscard]] FormCheck check_form(const CableNet& net, const Eigen::VectorXd& lengths,
                                   const Points& form, const Points& edge_forces = Points(3, 0));

/// "energy 5804 J, above the lowest by at most 5e-23 J (8e-27 of the elastic energy)"
[[nodiscard]] std::string check_text(const FormCheck& check);

/// Keys "energy", and "complementary_energy", "duality_gap" and "relative_gap", or with struts
/// "smallest_stiffness", added to a document.
void add_check(nlohmann::ordered_json& document, const FormCheck& check);

/// "0", or "3: 17, 20, 21" with the edges' names, the first twelve of them.
[[nodiscard]] std::string edges_text(const CableNet& net, const std::vector<int>& edges);

/// "weakly determined"; files have an underscore there.
[[nodiscard]] std::string status_text(EdgeStatus status);

}  // namespace taut::app
