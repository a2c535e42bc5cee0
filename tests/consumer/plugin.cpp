// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/cone_program.hpp"

extern "C" [[gnu::visibility("default")]] int plugin_iterations() {
    const taut::CableNet net = taut::hypar(3, 3);
    return taut::cone_solver_available()
               ? taut::solve_cone_program(net, net.unstressed_lengths()).iterations
               : 0;
}
