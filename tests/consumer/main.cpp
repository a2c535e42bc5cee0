// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/identification/model.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/statics/cone_program.hpp"
#include "taut/version.hpp"

#include <iostream>
#include <string_view>

// Uses what needs every library that taut links: sparse solves, threads, LAPACK, the conic solver.
int main(int argc, char** argv) {
    const std::string_view expected = argc > 1 ? argv[1] : "";
    const taut::CableNet net = taut::hypar(3, 3);
    const taut::Sampler sampler(net, {.scale = 0.002}, 1);
    taut::DataSet data = sampler.empty();
    sampler.extend(data, 40);
    const taut::LengthModel model = taut::train(net, data, data.converged_in(0, data.size()));
    std::cout << "taut " << taut::version() << ", " << model.processes.processes.size()
              << " processes\n";
    const bool trained =
        static_cast<int>(model.processes.processes.size()) == net.interior_edge_count();
    const bool solved = !taut::cone_solver_available() ||
                        taut::solve_cone_program(net, net.unstressed_lengths()).solved();
    return taut::version() == expected && trained && solved ? 0 : 1;
}
