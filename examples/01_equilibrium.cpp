// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// The form that a net takes, and how it changes when one cable is 3 mm too short.
#include <iostream>

#include "taut/design/builtin_nets.hpp"
#include "taut/statics/equilibrium.hpp"

int main() {
    const taut::CableNet net = taut::hypar(8, 10);
    taut::EquilibriumSolver solver(net);
    const taut::Equilibrium nominal = solver.solve(net.unstressed_lengths(), net.nodes());

    Eigen::VectorXd lengths = net.unstressed_lengths();
    lengths(net.interior_edges().front()) -= 0.003;  // m
    const taut::Equilibrium built = solver.solve(lengths, nominal.form);

    const double moved = (built.form - nominal.form).colwise().norm().maxCoeff();
    std::cout << taut::to_string(built.status) << " after " << built.iterations
              << " iterations; the largest move of a node is " << 1e3 * moved << " mm\n";
    return built.balanced() ? 0 : 1;
}
