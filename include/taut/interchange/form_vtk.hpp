// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/export/io.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// A form as a legacy VTK file, an unstructured grid of lines that ParaView and meshio open: at the
/// points is_support and load [N]; on the lines tension [N], force_density [N/m], length and
/// unstressed_length [m], axial_stiffness [N], is_slack and is_adjustable. Where a net has them: on
/// the lines is_strut, sag_weight [N/m] and, if any slides, run (its index, or -1), at the points
/// slides, support_stiffness (3 x 3 [N/m], 0 of rigid ones) and support_place [m]. Points and lines
/// stand in the order of the net's nodes and edges.
/// @param form 3 x n [m]
/// @throws std::invalid_argument for another size, a coordinate that is not finite, and an edge of
///   no length
[[nodiscard]] TAUT_IO_EXPORT std::string form_to_vtk(const CableNet& net, const Points& form);

}  // namespace taut
