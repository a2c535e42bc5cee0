// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "taut/export/io.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/statics/frame.hpp"

namespace taut {

/// Reads the condensed stiffness of a frame [N/m]. Its rows and columns are named after a support
/// and an axis, "N4.x". Either all of it, a line a row:
///
///     dof,N4.x,N4.y,N4.z,N9.x,...
///     N4.x,1.2e6,0,...
///
/// or an entry a line, of one triangle or both, the rest being 0:
///
///     row,column,stiffness
///     N4.x,N9.y,-3400
/// @throws InputError with the line for a name that is no support and axis, a support of which an
///   axis is missing, a number that is none, an entry given twice with another value; and where the
///   stiffness is not symmetric or not positive definite
[[nodiscard]] TAUT_IO_EXPORT FrameStiffness parse_frame(const CableNet& net, std::string_view text,
                                                        const std::string& file_name);

}  // namespace taut
