// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/sampling/length_prior.hpp"

namespace taut::test {

inline constexpr LengthPrior uniform_5mm{LengthPrior::Kind::uniform, 0.005};

}  // namespace taut::test
