// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// Several threads of the caller, each with one thread in taut: docs/reference/threads.md.
#include <algorithm>
#include <array>
#include <iostream>
#include <thread>
#include <vector>

#include "taut/design/builtin_nets.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"
#include "taut/threads.hpp"

int main() {
    const taut::CableNet net = taut::hilo_quarter();  // read by all threads
    const taut::LengthPrior prior{.kind = taut::LengthPrior::Kind::uniform, .scale = 0.005};  // m
    constexpr int nets_of_each = 20;
    std::array<double, 2> least{};

    const auto build_nets = [&](size_t who) {
        taut::EquilibriumSolver solver(net);  // one a thread
        double least_tension = 1e9;
        for (int k = 0; k < nets_of_each; ++k) {
            const Eigen::VectorXd lengths = taut::with_length_deviations(
                net, taut::draw_length_deviations(prior, who, k, net.interior_edge_count()));
            const taut::Equilibrium form = solver.solve(lengths, net.nodes());
            least_tension =
                std::min(least_tension, taut::tensions_of(net, lengths, form.form).minCoeff());
        }
        least[who] = least_tension;
    };
    std::vector<std::thread> threads;
    for (size_t who = 0; who < least.size(); ++who) {
        threads.emplace_back([&, who] { taut::with_threads(1, [&] { build_nets(who); }); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    std::cout << "least tension of " << nets_of_each << " built nets: " << 1e-3 * least[0]
              << " kN, of " << nets_of_each << " others " << 1e-3 * least[1] << " kN\n";
    return least[0] > 0.0 && least[1] > 0.0 ? 0 : 1;
}
