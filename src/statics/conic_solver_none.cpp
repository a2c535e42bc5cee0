// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "statics/conic_solver.hpp"

namespace taut {

bool cone_solver_available() {
    return false;
}

ConicSolution solve_conic(const ConicProgram&, int) {
    throw std::invalid_argument(
        "taut was built without the conic solver Clarabel: build it with TAUT_WITH_CLARABEL (needs "
        "a recent cargo), or use the solver newton");
}

}  // namespace taut
