// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/nested_dissection.hpp"

namespace taut {

std::vector<int> nested_dissection(const MatrixGraph& /*graph*/) {
    return {};
}

}  // namespace taut
