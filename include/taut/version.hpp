// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string_view>

namespace taut {

/// The version of the library that is linked, as "major.minor.patch".
[[nodiscard]] std::string_view version() noexcept;

}  // namespace taut
