// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "taut/abi.hpp"
#include "taut/export/io.hpp"

namespace taut {

/// Formats of nets that other programs write.
enum class ForeignFormat {
    json,  ///< COMPAS, JAX FDM
    csv,   ///< nodes of a pair of CSV files
    obj,
};

/// The format of a text, by its first line that says something.
/// @throws InputError where it is none of them
[[nodiscard]] TAUT_IO_EXPORT ForeignFormat detect_format(std::string_view text,
                                                         const std::string& file_name);

/// The format that the command line calls "compas", "jax-fdm" (whose networks are JSON or CSV),
/// "csv" or "obj".
/// @throws std::invalid_argument for another name
[[nodiscard]] TAUT_IO_EXPORT ForeignFormat format_named(std::string_view name,
                                                        std::string_view text);

}  // namespace taut
