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
        "this taut was built without the conic solver Clarabel, expected a build with "
        "TAUT_WITH_CLARABEL (it needs a recent cargo), or the solver newton");
}

}  // namespace taut
