// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/sampling/length_law.hpp"

namespace taut::test {

inline constexpr LengthLaw uniform_5mm{LengthLaw::Kind::uniform, 0.005};

}  // namespace taut::test
