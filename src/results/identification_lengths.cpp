// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/identification_parts.hpp"

#include <algorithm>
#include <array>

#include "results/result_parts.hpp"
#include "taut/results/draws_h5.hpp"

namespace taut {
namespace {

std::array<int, 2> ends_of(const CableNet& net, int edge) {
    const auto [s, t] = net.edges()[edge];
    return {s, t};
}

/// Adds the keys of a tension by posterior samples, null without.
/// @param drawn (T, Context) -> const DrawnTension*
template <class T, class Drawn>
void add_tension(Description<T>& of_edge, bool is_required, const Drawn& drawn) {
    const auto add = [&](const char* key, double DrawnEstimate::* number, const char* text) {
        const auto get = [drawn, number](const T& value, const Context& c) {
            const DrawnTension* tension = drawn(value, c);
            return tension == nullptr ? std::nullopt : std::optional(tension->tension.*number);
        };
        is_required ? of_edge.key(key, get, text) : of_edge.newer(key, get, text);
    };
    add("tension", &DrawnEstimate::mean,
        "Mean over the samples, of a compressed strut negative; null without, as all below [N].");
    const auto std_dev = [drawn](const T& value, const Context& c) {
        const DrawnTension* tension = drawn(value, c);
        return tension == nullptr ? std::nullopt : std::optional(tension->tension.std_dev);
    };
    is_required ? of_edge.key("tension_std", std_dev, size)
                : of_edge.newer("tension_std", std_dev, size);
    add("tension_lower", &DrawnEstimate::lower, "95 % interval [N].");
    add("tension_upper", &DrawnEstimate::upper, "");
    const auto slack = [drawn](const T& value, const Context& c) {
        const DrawnTension* tension = drawn(value, c);
        return tension == nullptr ? std::nullopt : std::optional(tension->slack_probability);
    };
    is_required ? of_edge.key("slack_probability", slack, part)
                : of_edge.newer("slack_probability", slack, part);
}

}  // namespace

// The prior and uncertain parameters.

Description<PriorNode> describe(const PriorNode* /*type*/) {
    return Description<PriorNode>("prior_node")
        .key("prior", &PriorNode::prior, R"("uniform:5mm", "normal:2mm".)")
        .key("weight", &PriorNode::weight, part, "Posterior probability.");
}

Description<CommonDeviation> describe(const CommonDeviation* /*type*/) {
    using Common = CommonDeviation;
    return Description<Common>("common_deviation",
                               "Common parts of the length deviations, estimated.")
        .key("mean", &Common::mean, "Mean of all length deviations [m].")
        .key("mean_std", &Common::mean_std, size,
             "Standard deviation of the mean; 0: the mean is assumed to be 0 [m].")
        .key("runs", &Common::runs, "Number of cable runs with a scale of their own.")
        .key("run_std", &Common::run_std, size,
             "Relative standard deviation of the scales of runs, posterior mean.")
        .key("run_probability", &Common::run_probability, part, "That runs have such scales.")
        .newer("struts", &Common::struts, "Common excess of struts [m].")
        .newer("struts_std", &Common::struts_std, size,
               "Its standard deviation; 0: struts have the mean of all [m].")
        .newer("adjustable", &Common::adjustable, "Common excess of adjustable edges [m].")
        .newer("adjustable_std", &Common::adjustable_std, size,
               "Its standard deviation; 0: their lengths are as given [m].");
}

Description<PriorEstimate> describe(const PriorEstimate* /*type*/) {
    using Prior = PriorEstimate;
    return Description<Prior>(
               "prior", "Posterior distribution over priors of the length deviations: a mixture.")
        .key("given", TAUT_VALUE(when(c.found->prior_was_given, it.given)),
             R"("uniform:5mm"; null: none was given, and a broad prior was assumed.)")
        .key("exact", &Prior::exact, "Whether it is exact, not estimated.")
        .key("std", &Prior::std_dev, size,
             "Posterior mean of the standard deviation of a length deviation [m].")
        .key("std_std", &Prior::std_std, size, "Posterior standard deviation of that [m].")
        .key("uniform_probability", &Prior::uniform_probability, part, "Of the uniform shape.")
        .newer("common", &Prior::common)
        .key("nodes", &Prior::nodes, "The priors of the mixture, the most probable first.");
}

Description<ParameterEstimate> describe(const ParameterEstimate* /*type*/) {
    using Estimate = ParameterEstimate;
    return Description<Estimate>("uncertain_parameter")
        .key("name", TAUT_VALUE(to_string(it.parameter.kind)))
        .key("group", TAUT_VALUE(unless_empty(it.parameter.group)), "Of edges; null: all.")
        .key("given", &Estimate::parameter,
             R"("stiffness:5%", its standard deviation before the survey.)")
        .key("mean", &Estimate::mean,
             "Deviation from the design; of a stiffness the logarithm of its factor.")
        .key("std", &Estimate::std_dev, size)
        .newer("prior_std", &Estimate::prior_std, size,
               "Before the survey, in that unit; 1.2 times an assumed width.")
        .key("unit", TAUT_VALUE(it.parameter.unit()))
        .key("observed", &Estimate::is_observed, "Whether the survey improved it.")
        .optional("edge", TAUT_VALUE(when(it.edge >= 0, it.edge)))
        .optional("node", TAUT_VALUE(when(it.node >= 0, it.node)))
        .optional("id",
                  [](const Estimate& estimate, const Context& c) -> std::optional<std::string> {
                      if (estimate.edge >= 0) {
                          return c.net->edge_id(estimate.edge);
                      }
                      return node_id_if_any(&Estimate::node)(estimate, c);
                  })
        .optional("axis",
                  TAUT_VALUE(when(it.node >= 0, std::array{"x", "y", "z"}[std::max(0, it.axis)])),
                  Rule::one_of({"x", "y", "z"}));
}

Description<Assumption> describe(const Assumption* /*type*/) {
    return Description<Assumption>("assumption")
        .key("name", TAUT_VALUE(to_string(it.parameter.kind)))
        .key("value", &Assumption::parameter, R"(As on the command line: "stiffness:5%".)")
        .key("group", TAUT_VALUE(unless_empty(it.parameter.group)), "Of edges; null: all.")
        .key("std", TAUT_VALUE(it.parameter.std_dev), size, "Before the survey.")
        .key("unit", TAUT_VALUE(it.parameter.unit()))
        .key("source", TAUT_VALUE(it.is_default ? "default" : "given"),
             Rule::one_of({"given", "default"}), "Whether it was given, or assumed by taut.")
        .key("testable", &Assumption::is_testable, "Whether the survey can test it.");
}

// Lengths and what follows from posterior samples.

Description<IdentifiedEdge> describe(const IdentifiedEdge* /*type*/) {
    using Edge = IdentifiedEdge;
    std::vector<std::string> words = words_of_enum<EdgeStatus>();
    words.insert(words.end(), {"identified", "unobserved"});
    auto result =
        Description<Edge>("identified_edge")
            .key("edge", &Edge::edge)
            .newer("id", TAUT_VALUE(c.net->edge_id(it.edge)))
            .newer("nodes",
                   [](const Edge& edge, const Context& c) { return ends_of(*c.net, edge.edge); })
            .key("nominal", &Edge::nominal, "Unstressed length as designed [m].")
            .key("length_deviation", &Edge::length_deviation, "Estimate of true less nominal [m].")
            .key("std", &Edge::std_dev, size, "Standard deviation of the estimate [m].")
            .key("lower", &Edge::lower,
                 "95 % interval of the deviation; a slack edge has a lower bound only [m].")
            .key("upper", &Edge::upper)
            .key("status", &Edge::status, Rule::one_of(words),
                 R"("identified" and "unobserved" in files of 0.2.0.)");
    add_tension(result, false, [](const Edge& edge, const Context& c) {
        const std::vector<DrawnTension>& all = c.found->drawn.tensions;
        return all.empty() ? nullptr : &all[edge.edge];
    });
    return result;
}

Description<StretchLength> describe(const StretchLength* /*type*/) {
    using Stretch = StretchLength;
    return Description<Stretch>("stretch_length",
                                "A stretch of cable that slides, from clamp to clamp.")
        .key("edges", &Stretch::edges, "Edge by edge.")
        .key("ids",
             [](const Stretch& stretch, const Context& c) {
                 std::vector<std::string> ids(stretch.edges.size());
                 std::ranges::transform(stretch.edges, ids.begin(),
                                        [&](int edge) { return c.net->edge_id(edge); });
                 return ids;
             })
        .key("nominal", &Stretch::nominal, size, "Unstressed length as designed [m].")
        .key("friction", &Stretch::friction, size, "Largest coefficient that the fit allowed for.")
        .key("length_deviation", &Stretch::length_deviation, "True minus nominal [m].")
        .key("std", &Stretch::std_dev, size, "Standard deviation of that [m].")
        .key("tension", &Stretch::tension, "Mean of its edges [N].")
        .key("tension_std", &Stretch::tension_std, size, "Standard deviation of that [N].");
}

Description<LengthCovariance> describe(const LengthCovariance* /*type*/) {
    using Covariance = LengthCovariance;
    return Description<Covariance>("length_covariance")
        .key("edges", &Covariance::edges)
        .key("ids",
             [](const Covariance& lengths, const Context& c) {
                 std::vector<std::string> ids;
                 ids.reserve(lengths.edges.size());
                 for (const int edge : lengths.edges) {
                     ids.push_back(c.net->edge_id(edge));
                 }
                 return ids;
             })
        .key(
            "covariance",
            [](const Covariance& lengths) {
                std::vector<std::vector<double>> rows;
                for (const auto& row : lengths.covariance.rowwise()) {
                    rows.emplace_back(row.begin(), row.end());
                }
                return rows;
            },
            "Row by row, in the order of edges [m2].");
}

Description<DrawnEstimate> describe(const DrawnEstimate* /*type*/) {
    return Description<DrawnEstimate>(
               "drawn_estimate", "Mean, standard deviation and 95 % interval of a tension [N].")
        .key("mean", &DrawnEstimate::mean)
        .key("std", &DrawnEstimate::std_dev, size)
        .key("lower", &DrawnEstimate::lower)
        .key("upper", &DrawnEstimate::upper);
}

Description<DrawnTension> describe(const DrawnTension* /*type*/) {
    auto result = Description<DrawnTension>("drawn_tension")
                      .key("edge", &DrawnTension::edge)
                      .newer("id", TAUT_VALUE(c.net->edge_id(it.edge)))
                      .newer("nodes", TAUT_VALUE(ends_of(*c.net, it.edge)));
    add_tension(result, true, TAUT_VALUE(&it));
    return result;
}

Description<DrawnPlace> describe(const DrawnPlace* /*type*/) {
    return Description<DrawnPlace>(
               "drawn_place", "Mean, standard deviation and 95 % interval of each coordinate [m].")
        .key("node", &DrawnPlace::node)
        .key("mean", &DrawnPlace::mean)
        .key("std", &DrawnPlace::std_dev, point_of_sizes())
        .key("lower", &DrawnPlace::lower)
        .key("upper", &DrawnPlace::upper);
}

Description<PosteriorDraws> describe(const PosteriorDraws* /*type*/) {
    return Description<PosteriorDraws>("draws")
        .key("count", &PosteriorDraws::count)
        .newer("fingerprint", fingerprint_of,
               "Hash of the samples, to check that the file belongs to the result.")
        .key("seed", &PosteriorDraws::seed)
        .key("how", &PosteriorDraws::method)
        .key("reason", TAUT_VALUE(unless_empty(it.reason)), "Why they are not reliable.");
}

}  // namespace taut
