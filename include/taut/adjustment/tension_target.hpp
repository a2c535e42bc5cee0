// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "taut/adjustment/limits.hpp"
#include "taut/export/adjustment.hpp"

namespace taut {

/// A tension that an edge is to have under the net's own loads.
struct TensionTarget {
    int edge = 0;            ///< index in the net
    double tension = 0.0;    ///< above 0, as no edge may go slack [N]
    double tolerance = 0.0;  ///< the deviation from it that is near enough, above 0 [N]
};

/// Target tensions as they are given. Those of single edges override those of groups, which
/// override that of all edges.
struct GivenTension {
    double tension = 0.0;                                       ///< [N]
    TensionBound tolerance = {.value = 0.05, .is_part = true};  ///< a force, or part of `tension`
    std::optional<std::string> group = {};                      ///< of edges of the net
    std::optional<int> edge = {};  ///< index in the net; without group and edge: all edges
};

/// What keeps a planned tension out of the tolerance of its target.
enum class TensionObstacle {
    none,         ///< nothing: it is within
    limits,       ///< limits of strokes and forces, whole steps, or too few turned edges
    form,         ///< the target of the form: without it the tension would come within
    turnbuckles,  ///< even with unlimited strokes and any form no strokes were found
};

/// "none", "limits", "form", "turnbuckles".
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::string_view to_string(TensionObstacle obstacle);

/// How near a plan comes to a target tension. All but mean, std and probability are of the estimate
/// [N].
struct TAUT_ADJUSTMENT_EXPORT ReachedTension {
    int edge = 0;                       ///< index in the net
    double target = 0.0;                ///< TensionTarget::tension
    double tolerance = 0.0;             ///< TensionTarget::tolerance
    double as_built = 0.0;              ///< before anything is turned
    double planned = 0.0;               ///< after all strokes
    double unconstrained = 0.0;         ///< with unlimited strokes, no edge slack
    double of_any_form = 0.0;           ///< the same without regard to the form
    std::optional<double> mean;         ///< over the samples, as planned; empty without
    std::optional<double> std_dev;      ///< likewise
    std::optional<double> probability;  ///< that it is within the tolerance; empty without samples
    TensionObstacle obstacle = TensionObstacle::none;  ///< what keeps it out of its tolerance

    /// Deviation of the mean from the target, of the estimate without samples [tolerances].
    [[nodiscard]] double deviation() const;
};

}  // namespace taut
