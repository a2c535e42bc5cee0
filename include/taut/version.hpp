// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string_view>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"
#include "taut/version_number.hpp"

/// All of taut; gp is Gaussian process regression by itself.
namespace taut {

/// The version of the library that is linked, as "major.minor.patch"; that of these headers is
/// TAUT_VERSION_MAJOR, _MINOR, _PATCH and _NUMBER. The text lives as long as the program.
[[nodiscard]] TAUT_CORE_EXPORT std::string_view version() noexcept;

}  // namespace taut
