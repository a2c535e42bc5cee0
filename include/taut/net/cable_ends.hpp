// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace taut {

/// How the ends of a vibrating cable are held. Unknown: between hinged and fixed.
enum class CableEnds { unknown, hinged, fixed };

/// In files, in their order.
inline constexpr std::array<std::string_view, 3> cable_ends_names{"unknown", "hinged", "fixed"};

/// The word of a file.
[[nodiscard]] inline std::string to_string(CableEnds ends) {
    return std::string(cable_ends_names[static_cast<size_t>(ends)]);
}

/// The ends of a word; none of another one.
[[nodiscard]] inline std::optional<CableEnds> cable_ends_named(std::string_view name) {
    const auto* const found = std::ranges::find(cable_ends_names, name);
    return found == cable_ends_names.end()
               ? std::nullopt
               : std::optional(static_cast<CableEnds>(found - cable_ends_names.begin()));
}

}  // namespace taut
