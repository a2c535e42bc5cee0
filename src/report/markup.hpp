// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace taut::report {

/// Text as it may stand in an element or a quoted attribute of HTML and XML: & < > " ' become
/// entities; what is not UTF-8, or a control character that XML forbids, becomes U+FFFD.
[[nodiscard]] std::string escape(std::string_view text);

}  // namespace taut::report
