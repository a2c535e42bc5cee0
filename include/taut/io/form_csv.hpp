// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/export/io.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// A form as CSV: the header "id,x,y,z" and a row a node, supports included, with coordinates in
/// metres that read back to the last bit. The id is CableNet::node_id(), in quotes where it could
/// otherwise be misread. read_survey_points() reads it.
/// @param form 3 x n [m]
/// @throws std::invalid_argument for another size, or a coordinate that is not finite
[[nodiscard]] TAUT_IO_EXPORT std::string form_to_csv(const CableNet& net, const Points& form);

}  // namespace taut
