// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string_view>

#include "taut/abi.hpp"
#include "taut/version_number.hpp"

namespace taut {

/// The version of the library that is linked, as "major.minor.patch"; that of these headers is
/// TAUT_VERSION_MAJOR, _MINOR, _PATCH and _NUMBER.
[[nodiscard]] std::string_view version() noexcept;

}  // namespace taut
