// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace taut::report {

/// The page that viewer/build.mjs makes, with these places to fill, each once and in this order:
/// "<!--taut:title-->", "<!--taut:style-->", "<!--taut:figures-->", "<!--taut:result-->". Empty
/// where taut was built without Node.js. Its source is made by cmake/embed.cmake.
[[nodiscard]] std::string_view viewer_page();

}  // namespace taut::report
