// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "gp/minimise.hpp"

namespace taut::gp {

void minimise(const Objective& /*objective*/, const std::vector<double>& /*start*/,
              const MinimiseSettings& /*settings*/) {
    throw std::invalid_argument("this taut was built without NLopt, which trains models");
}

}  // namespace taut::gp
