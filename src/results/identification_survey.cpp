// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/identification_parts.hpp"

#include "results/result_parts.hpp"

namespace taut {

std::vector<Eigen::Vector3d> columns_of(const Points& points) {
    std::vector<Eigen::Vector3d> columns;
    for (const auto& column : points.colwise()) {
        columns.emplace_back(column);
    }
    return columns;
}

// The survey.

Description<IdentificationResult::Residual> describe(
    const IdentificationResult::Residual* /*type*/) {
    using Residual = IdentificationResult::Residual;
    return Description<Residual>("residual", "Surveyed less predicted [m].")
        .key("node", &Residual::node)
        .key("dx", [](auto& one) -> auto& { return one.surveyed_less_predicted.x(); })
        .key("dy", [](auto& one) -> auto& { return one.surveyed_less_predicted.y(); })
        .key("dz", [](auto& one) -> auto& { return one.surveyed_less_predicted.z(); })
        .optional("standardised", &Residual::standardised, Rule::point().or_null());
}

Description<UnmatchedPoint> describe(const UnmatchedPoint* /*type*/) {
    using Point = UnmatchedPoint;
    return Description<Point>("unmatched", "A target that was matched to no node.")
        .key("id", TAUT_VALUE(it.point.id.empty() ? "line " + std::to_string(it.point.line)
                                                  : it.point.id))
        .newer("line", TAUT_VALUE(it.point.line))
        .newer("reason", &Point::reason, Rule::text())
        .newer("nearest", TAUT_VALUE(c.net->node_id(it.nearest)), "Name of a node.")
        .newer("distance", &Point::distance, size)
        .optional("swapped_with", node_id_if_any(&Point::swapped_with),
                  "Name of the node whose target has this one's name, where two are swapped.");
}

Description<ControlResidual> describe(const ControlResidual* /*type*/) {
    using Residual = ControlResidual;
    return Description<Residual>("control_residual",
                                 "Measured, moved into the net's frame, less known [m].")
        .key("id", &Residual::id)
        .key("dx", [](auto& one) -> auto& { return one.residual.x(); })
        .key("dy", [](auto& one) -> auto& { return one.residual.y(); })
        .key("dz", [](auto& one) -> auto& { return one.residual.z(); });
}

Description<Registration> describe(const Registration* /*type*/) {
    return Description<Registration>("frame",
                                     "The rigid motion x -> rotation (x - from) + to from the "
                                     "instrument's frame to the net's.")
        .key("rotation", TAUT_VALUE(columns_of(it.motion.rotation.transpose())),
             Rule::list_of(Rule::point(), 3), "Rows of the matrix.")
        .key("from", TAUT_VALUE(it.motion.from))
        .key("to", TAUT_VALUE(it.motion.to))
        .object("fit", Description<Registration>()
                           .key("rms", TAUT_VALUE(root_mean_square(it.residuals)), size,
                                "Root mean square distance of the control points [m].")
                           .key("count", TAUT_VALUE(it.residuals.size()), Rule::count()))
        .key("control", &Registration::residuals);
}

Description<FrameOffset> describe(const FrameOffset* /*type*/) {
    return Description<FrameOffset>(
               "frame_offset", "A rotation about a point, then a translation, both small [rad, m].")
        .key("about", &FrameOffset::about)
        .key("translation", &FrameOffset::translation)
        .key("translation_std", &FrameOffset::translation_std, point_of_sizes())
        .key("rotation", &FrameOffset::rotation)
        .key("rotation_std", &FrameOffset::rotation_std, point_of_sizes());
}

// Several surveys.

Description<EdgeTurned> describe(const EdgeTurned* /*type*/) {
    return Description<EdgeTurned>("edge_turned")
        .key("edge", &EdgeTurned::edge)
        .key("id", TAUT_VALUE(c.net->edge_id(it.edge)))
        .key("stroke", &EdgeTurned::stroke, "Change of the unstressed length [m].")
        .key("std", &EdgeTurned::std_dev, size, "Standard deviation of the stroke [m].");
}

Description<LengthChange> describe(const LengthChange* /*type*/) {
    return Description<LengthChange>("length_change")
        .key("edge", &LengthChange::edge)
        .key("id", TAUT_VALUE(c.net->edge_id(it.edge)))
        .key("change", &LengthChange::change)
        .key("std", &LengthChange::std_dev, size)
        .key("statistic", &LengthChange::statistic);
}

Description<EpochResult> describe(const EpochResult* /*type*/) {
    using Epoch = EpochResult;
    return Description<Epoch>("epoch", "One survey among several of the same net.")
        .key("used", &Epoch::surveyed, "Free nodes that were surveyed.")
        .key("turned", &Epoch::turned, "Since the survey before.")
        .newer("load", &Epoch::load, size,
               "Loads that hung on the net at this survey alone, sum of magnitudes [N].")
        .key("outliers", &Epoch::outliers, "Targets left out.")
        .newer("boundary", &Epoch::boundary_outliers)
        .newer("frame_offset", &Epoch::frame_offset)
        .newer("noise_ratio", &Epoch::noise_ratio, size)
        .newer("noise_scale", &Epoch::noise_scale, size)
        .key("change_ratio", &Epoch::change_ratio, size,
             "Root mean square difference of its lengths from those of the surveys before, over "
             "its expectation; about 1. 0 for the first.")
        .newer("change_limit", &Epoch::change_limit, size,
               "Limit of change_ratio, exceeded by chance with a probability of 0.1 %.")
        .newer("excess_actuator_std", &Epoch::excess_actuator_std, size,
               "Scatter of the turns in excess of the given actuator std; 0: none [m].")
        .key("changes", &Epoch::changes,
             "Lengths that changed since the survey before, other than by turns, the worst first; "
             "for the first survey adjustable edges against the design.")
        .newer("stroke_factor", &Epoch::stroke_factor,
               "Common factor of all strokes that fits best; 1 where nothing was turned.")
        .newer("stroke_factor_std", &Epoch::stroke_factor_std, size)
        .key("trust", &Epoch::trust, "Of this survey alone.")
        .newer("findings", TAUT_VALUE(it.trust.findings));
}

}  // namespace taut
