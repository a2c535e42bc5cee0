// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// How far the centre of a target stands off the axis of the cable, along the net's normal.
struct TargetOffset {
    double offset = 0.0;   ///< positive to the side of node_normals() [m]
    double std_dev = 0.0;  ///< of each target by itself [m]
};

/// Whether a target can stand so far off.
/// @throws std::invalid_argument for an offset of more than 0.5 m either way, and a standard
///   deviation that is negative or more than that
TAUT_CORE_EXPORT void check_target_offset(const TargetOffset& offset);

/// "3mm", "-3mm", "3mm:0.2mm": an offset and its standard deviation (0 where none is given).
/// @throws std::invalid_argument for anything else, and as check_target_offset()
[[nodiscard]] TAUT_CORE_EXPORT TargetOffset parse_target_offset(std::string_view text);

/// Offsets of the targets of a survey.
struct TargetOffsets {
    std::optional<TargetOffset> all;         ///< of those that the table does not name
    std::map<std::string, TargetOffset> of;  ///< by a target's name in the file, or its code

    /// Whether no offset is given.
    [[nodiscard]] bool empty() const { return !all && of.empty(); }
};

/// Unit normals of the net at its nodes (3 x n), 0 where there is none: at supports, and where a
/// node has two edges, or all in one line. The area vector of the polygon of its neighbours,
/// docs/theory.md (normal-of-node). All of a connected net are on one side: that which is up (z) in
/// the mean; where the net stands upright, its mean normal steeper than 1 in 10, the side of y, or
/// else of x.
/// @param form 3 x n, supports included; its size is not checked [m]
[[nodiscard]] TAUT_CORE_EXPORT Points node_normals(const CableNet& net, const Points& form);

/// Moves targets on free nodes from where they were measured to the axis of the cable, along the
/// normals of the nominal form, and adds the standard deviation of the offset to their noise,
/// (offset). Supports are left as they are. Says so in the notes of the survey, and names in its
/// warnings the nodes without a normal, where the target stays and the whole offset counts as
/// noise.
/// @param survey of this net, which is not checked; its noise_std is 3 x n
/// @throws SurveyError where no name or code in the table is that of a point; one that is not,
///   beside others that are, is a note
TAUT_CORE_EXPORT void take_off_offsets(const CableNet& net, const TargetOffsets& offsets,
                                       Survey& survey);

}  // namespace taut
