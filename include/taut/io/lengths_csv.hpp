// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "taut/export/io.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Lengths of a net as built against those designed, as CSV: the header
/// "edge,nominal,length_deviation" and a row an interior edge, in their order, then one an
/// adjustable edge that differs: CableNet::edge_id(), unstressed length as designed, and by how
/// much the built one differs; in metres.
/// @throws std::invalid_argument where the interior edges of the two nets are not the same
[[nodiscard]] TAUT_IO_EXPORT std::string lengths_to_csv(const CableNet& nominal,
                                                        const CableNet& built);

/// Unstressed lengths of all edges (m) out of such a text, its rows in any order; adjustable edges
/// without a row have those of the net [m].
/// @param file_name for messages
/// @throws InputError at a line for another header, a number that is not finite, an edge that the
///   net does not have or that comes twice, a nominal length other than the net's, and a built
///   length that is not positive; of the file as a whole where an interior edge is missing
[[nodiscard]] TAUT_IO_EXPORT Eigen::VectorXd parse_lengths(const CableNet& nominal,
                                                           std::string_view text,
                                                           const std::string& file_name);

}  // namespace taut
