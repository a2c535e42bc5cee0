// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "taut/export/io.hpp"

namespace taut {

/// Text that a terminal or a message may show, whatever bytes it holds: control characters (C0,
/// DEL, C1) and those that turn the direction of writing become "\u001b", as JSON calls them, and
/// bytes that are no UTF-8 U+FFFD.
/// @param kept control characters that stay as they are
[[nodiscard]] TAUT_IO_EXPORT std::string printable(std::string_view text,
                                                   std::string_view kept = {});

}  // namespace taut
