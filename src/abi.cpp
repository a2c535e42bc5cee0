// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#include "taut/abi.hpp"

namespace taut::border {

extern const char TAUT_ABI = 0;

}  // namespace taut::border
