// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace taut::report {

/// The page that viewer/build.mjs makes, with two places to fill, in this order:
/// "<!--taut:title-->" and "<!--taut:result-->". Empty where taut was built without Node.js.
/// cmake/embed.cmake makes its source.
[[nodiscard]] std::string_view viewer_page();

}  // namespace taut::report
