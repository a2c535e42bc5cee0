// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// A length written with its unit, "5mm", "0.5 mm", "1.2 cm", "0.005 m", or as a bare number of
/// metres.
/// @return [m]
/// @throws std::invalid_argument for anything else, naming the text
[[nodiscard]] TAUT_CORE_EXPORT double parse_length(std::string_view text);

/// A length for people, "5mm": the shortest number of millimetres that parse_length() reads back
/// with a relative error of at most 1e-12, which hides rounding errors. In metres if millimetres
/// overflow.
[[nodiscard]] TAUT_CORE_EXPORT std::string format_length(double metres);

/// The same, but read back to the last bit: for files that store a length as text.
[[nodiscard]] TAUT_CORE_EXPORT std::string format_length_exactly(double metres);

/// A force written with its unit, "200kN", "0.2 MN", "50 N", or as a bare number of newtons.
/// @return [N]
/// @throws std::invalid_argument for anything else, naming the text
[[nodiscard]] TAUT_CORE_EXPORT double parse_force(std::string_view text);

/// A stress or modulus written with its unit, "205GPa", "205000 MPa", "2.05e11 Pa", or as a bare
/// number of pascals.
/// @return [Pa]
/// @throws std::invalid_argument for anything else, naming the text
[[nodiscard]] TAUT_CORE_EXPORT double parse_stress(std::string_view text);

/// A percentage, "5%", "0.5 %".
/// @return 0.05 for 5 %
/// @throws std::invalid_argument for anything else, including a bare number, naming the text
[[nodiscard]] TAUT_CORE_EXPORT double parse_part(std::string_view text);

/// A size of memory, "8GiB", "500 MB": a number and MB, MiB, GB, GiB, TB or TiB.
/// @return [bytes]; of whatever sign, as the other quantities
/// @throws std::invalid_argument for anything else, including a bare number, naming the text
[[nodiscard]] TAUT_CORE_EXPORT double parse_memory(std::string_view text);

/// A temperature difference, "10K".
/// @return [K]
/// @throws std::invalid_argument for anything else, including a bare number, naming the text
[[nodiscard]] TAUT_CORE_EXPORT double parse_temperature(std::string_view text);

}  // namespace taut
