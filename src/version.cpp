// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#include "taut/version.hpp"

namespace taut {

std::string_view version() noexcept {
    return TAUT_VERSION;
}

}  // namespace taut
