// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string_view>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"
#include "taut/version_number.hpp"

/// All of taut. The namespace gp is Gaussian process regression, usable by itself.
namespace taut {

/// The version of the linked library, as "major.minor.patch". That of these headers is
/// TAUT_VERSION_MAJOR, _MINOR, _PATCH and _NUMBER. The text lives as long as the program.
[[nodiscard]] TAUT_CORE_EXPORT std::string_view version() noexcept;

}  // namespace taut
