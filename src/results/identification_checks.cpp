// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/identification_parts.hpp"

#include <cmath>

#include "results/result_parts.hpp"

namespace taut {
namespace {

std::optional<double> if_finite(double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool is_support(const BoundaryOutlier& outlier) {
    return outlier.kind == BoundaryOutlier::Kind::support;
}

std::string boundary_id(const CableNet& net, bool of_node, int index) {
    return of_node ? net.node_id(index) : net.edge_id(index);
}

}  // namespace

Description<Trust> describe(const Trust* /*type*/) {
    return Description<Trust>("trust")
        .key("verdict", &Trust::verdict, "The worst of all findings.")
        .newer("reasons", reasons_of, "Those of the findings.");
}

Description<Trust::Remedy> describe(const Trust::Remedy* /*type*/) {
    return Description<Trust::Remedy>("remedy", "Changed option for a new identification.")
        .key("parameter", &Trust::Remedy::parameter,
             R"(Name of the option: "noise", "prior", "uncertain", "frame", "match".)")
        .key("value", &Trust::Remedy::value, "Its value; empty: to be chosen.");
}

Description<Trust::Finding> describe(const Trust::Finding* /*type*/) {
    using Finding = Trust::Finding;
    return Description<Finding>("finding")
        .key("kind", &Finding::kind, "docs/files.md explains the value of each.")
        .key("severity", &Finding::severity, "The verdict by this finding alone.")
        .key("ids", &Finding::ids, "Of its edges or nodes, or of the uncertain parameter.")
        .key("value", &Finding::value, "In SI units.")
        .key("std", &Finding::std_dev, size, "Standard deviation of the value.")
        .key("confounded_with", &Finding::confounded_with,
             "Edges and nodes that the data cannot distinguish from these.")
        .key("remedy", &Finding::remedy)
        .key("reason", &Finding::reason)
        .key("next", &Finding::advice, "What to do about it; may be empty.");
}

Description<DetectableErrors> describe(const DetectableErrors* /*type*/) {
    using Errors = DetectableErrors;
    return Description<Errors>("detectable")
        .key("target", TAUT_VALUE(if_finite(it.target)), size,
             "Distance of a target from its node [m].")
        .key("length", TAUT_VALUE(if_finite(it.length)), size, "Of an interior edge [m].")
        .key("adjustable", TAUT_VALUE(if_finite(it.adjustable)), size,
             "Length of an adjustable edge [m].")
        .key("support", TAUT_VALUE(if_finite(it.support)), size,
             "Distance of a support from its place [m].")
        .key("scale", TAUT_VALUE(if_finite(it.scale)), size, "Of the survey, relative.")
        .key("temperature", TAUT_VALUE(if_finite(it.temperature)), size, "Of all edges [K].")
        .newer("force", TAUT_VALUE(if_finite(it.force)), size,
               "Of one force measurement, relative; null where none is given.")
        .newer("force_scale", TAUT_VALUE(if_finite(it.force_scale)), size,
               "Of all force measurements, relative; null for fewer than two.")
        .newer("load", TAUT_VALUE(if_finite(it.load)), size,
               "Vertical, at each free node, besides those given [N].");
}

Description<FoundScale> describe(const FoundScale* /*type*/) {
    return Description<FoundScale>("found_scale")
        .key("ratio", &FoundScale::ratio, size, "Estimated over given; 0: not shown.")
        .key("std", &FoundScale::std_dev, size, "Of the ratio, if the given is true.");
}

Description<FrameCheck> describe(const FrameCheck* /*type*/) {
    return Description<FrameCheck>(
               "frame_check", "Motion and scale of the survey as a whole that would fit better.")
        .key("scale", &FrameCheck::scale, "Relative excess of the scale.")
        .key("scale_std", &FrameCheck::scale_std, size,
             "Its standard deviation, if the scale is right; 0 where the survey does not show it.")
        .key("translation", &FrameCheck::translation,
             "From the given frame, about the middle of the net [m]; 0 where the frame was "
             "estimated.")
        .key("rotation", &FrameCheck::rotation, "[rad].")
        .key("motion_statistic", &FrameCheck::motion_statistic, size,
             "Chi-squared with six degrees of freedom, if the survey is not moved.");
}

Description<LoadCheck> describe(const LoadCheck* /*type*/) {
    return Description<LoadCheck>("load_check",
                                  "A vertical load at each free node that would fit better.")
        .key("force", &LoadCheck::force, "Downwards, besides the loads given [N].")
        .key("std", &LoadCheck::std_dev, size,
             "Its standard deviation, if there is none; 0 where the survey does not show it [N].");
}

Description<Outlier> describe(const Outlier* /*type*/) {
    return Description<Outlier>("outlier", "A target left out for a gross error.")
        .key("node", &Outlier::node)
        .newer("id", TAUT_VALUE(c.net->node_id(it.node)))
        .newer("distance", &Outlier::distance, size,
               "Of the surveyed place from the one predicted from all others [m].")
        .newer("statistic", &Outlier::statistic, size, "To compare with outlier_threshold.")
        .optional("swapped_with", node_id_if_any(&Outlier::swapped_with),
                  "Name of the node whose target has this one's name, where two are swapped.");
}

Description<ForceOutlier> describe(const ForceOutlier* /*type*/) {
    return Description<ForceOutlier>("force_outlier")
        .key("edge", &ForceOutlier::edge)
        .key("id", TAUT_VALUE(c.net->edge_id(it.edge)))
        .key("measured", &ForceOutlier::measured)
        .key("expected", &ForceOutlier::expected, "By all other data [N].")
        .key("statistic", &ForceOutlier::statistic)
        .newer("source", &ForceOutlier::source, "What it was measured by.")
        .newer("mode", &ForceOutlier::mode, "Of the frequency; 0 where there is none.")
        .newer("probability", &ForceOutlier::probability, part,
               "Of the priors by which it was left out; 0 where it was kept, though doubted.");
}

Description<ForceBias> describe(const ForceBias* /*type*/) {
    return Description<ForceBias>("force_bias")
        .key("part", &ForceBias::part)
        .key("std", &ForceBias::std_dev)
        .newer("probability", &ForceBias::probability, part,
               "Of the priors by which all were left out for it; 0 where they were kept.");
}

Description<LengthOutlier> describe(const LengthOutlier* /*type*/) {
    using Length = LengthOutlier;
    return Description<Length>("length_outlier")
        .key("edge", &Length::edge)
        .key("id", TAUT_VALUE(c.net->edge_id(it.edge)))
        .key("deviation", &Length::deviation, "Estimate by the survey alone [m].")
        .key("std", &Length::std_dev, size)
        .key("statistic", &Length::statistic, size)
        .optional("other", edge_id_if_any(&Length::other),
                  "Edge that is as much shorter as this one is longer, or the reverse: a clamp "
                  "slipped, or both were swapped.")
        .optional("swapped", TAUT_VALUE(when(it.other >= 0, it.is_swapped)),
                  "Whether the two edges were swapped.")
        .optional("beside_target", TAUT_VALUE(when(it.other >= 0, it.is_beside_target)),
                  "Whether an error of the target at the node explains it as well; the target is "
                  "then left out, too, and deviation and std assume it is right.")
        .optional("node", node_id_if_any(&Length::node), "Node where both meet.");
}

Description<BoundaryOutlier> describe(const BoundaryOutlier* /*type*/) {
    using Outlier = BoundaryOutlier;
    const auto numbers = [](Eigen::Vector3d Outlier::* of) {
        return [of](const Outlier& outlier, const Context& c) {
            const Eigen::Vector3d& all = outlier.*of;
            return is_support(outlier) ? json_of(all, c) : ResultJson(all.x());
        };
    };
    return Description<Outlier>("boundary_outlier")
        .optional("edge", TAUT_VALUE(when(it.kind == Outlier::Kind::adjustable_edge, it.index)))
        .optional("node", TAUT_VALUE(when(it.kind == Outlier::Kind::support, it.index)))
        .key("id", TAUT_VALUE(boundary_id(*c.net, is_support(it), it.index)))
        .key("deviation", numbers(&Outlier::deviation), Rule::any_of(Rule::number(), Rule::point()),
             "Of an edge's length, or of a support's place [m].")
        .key("std", numbers(&Outlier::std_dev), Rule::any_of(size, point_of_sizes()))
        .key("statistic", &Outlier::statistic, size)
        .key(
            "confounded_with",
            [](const Outlier& outlier, const Context& c) {
                const int other = outlier.confounded_with;
                return other < 0 ? std::nullopt
                                 : std::optional(boundary_id(*c.net, !is_support(outlier), other));
            },
            "The support of the edge, or an edge at the support, that the data cannot distinguish "
            "from it.");
}

}  // namespace taut
