// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace taut {

/// Text out of a file for a message: in single quotes, cut after 40 bytes.
[[nodiscard]] std::string quote(std::string_view text);

/// What an errno stands for, "No space left on device".
[[nodiscard]] std::string error_text(int code);

}  // namespace taut
