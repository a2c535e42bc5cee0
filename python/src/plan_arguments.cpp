// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "plan_arguments.hpp"

#include <fmt/core.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <filesystem>
#include <utility>

#include "given.hpp"
#include "taut/adjustment/request_error.hpp"
#include "taut/interchange/foreign_survey.hpp"
#include "taut/io/adjustment_csv.hpp"
#include "taut/net/units.hpp"

namespace taut::python {
namespace {

using Pair = std::pair<nb::object, nb::object>;
using Range = std::pair<std::optional<nb::object>, std::optional<nb::object>>;

/// Calls `take` with the group and each value of a dict, or with no group and the one value.
template <class Value, class Take>
void for_each_group(nb::handle given, const char* name, const char* expected, Take take) {
    if (!nb::isinstance<nb::dict>(given)) {
        take(std::nullopt, of_type<Value>(given, name, expected));
        return;
    }
    for (const auto& [group, value] : nb::borrow<nb::dict>(given)) {
        take(of_type<std::optional<std::string>>(group, name, "names of groups, or None for all"),
             of_type<Value>(value, name, expected));
    }
}

/// A tension, or tension and tolerance [N].
GivenTension tension_argument(nb::handle value) {
    const char* const name = "target_tension";
    if (!nb::isinstance<nb::tuple>(value)) {
        return {.tension =
                    quantity_given(value, name, parse_force, "tensions, or (tension, tolerance)")};
    }
    const auto [tension, tolerance] = of_type<Pair>(value, name, "(tension, tolerance)");
    return {.tension = force_given(tension, name),
            .tolerance = {.value = force_given(tolerance, name)}};
}

/// A surface given as (vertices, triangles).
GivenTarget surface_argument(nb::handle vertices, nb::handle triangles, double unit) {
    const nb::object corners = nb::module_::import_("numpy").attr("asarray")(triangles);
    const auto shape = nb::cast<std::vector<size_t>>(corners.attr("shape"));
    if (shape.size() != 2 || shape[1] != 3 || shape[0] == 0) {
        throw nb::value_error("target: its triangles are not (f, 3), expected three vertices each");
    }
    const std::vector<int> flat = indices_argument(corners.attr("ravel")(), "target");
    GivenTarget target{.points = unit * points_argument(vertices, "target", -1)};
    for (size_t k = 0; k < flat.size(); k += 3) {
        target.triangles.push_back({flat[k], flat[k + 1], flat[k + 2]});
    }
    return target;
}

}  // namespace

void add_tension(PlanRequest& request, const std::optional<RangeLike>& given, const char* name,
                 bool is_part) {
    if (!given) {
        return;
    }
    const auto bound = [&](const std::optional<nb::object>& value) {
        const auto number = [&] {
            return is_part ? of_type<double>(*value, name, "a part from 0 to 1")
                           : force_given(*value, name);
        };
        return value ? std::optional(TensionBound{.value = number(), .is_part = is_part})
                     : std::nullopt;
    };
    for_each_group<Range>(*given, name, "(least, most), either of which may be None",
                          [&](std::optional<std::string> group, const Range& range) {
                              const TensionRange given_range{.least = bound(range.first),
                                                             .most = bound(range.second),
                                                             .group = std::move(group)};
                              try {
                                  check_tension_range(given_range);
                              } catch (const RequestError& error) {
                                  throw RequestError(name, error.problem());
                              }
                              request.tension.push_back(given_range);
                          });
}

void add_strokes(PlanRequest& request, const std::optional<StrokeLike>& given) {
    if (!given) {
        return;
    }
    if (!nb::isinstance<nb::dict>(*given)) {
        request.stroke =
            quantity_given(*given, "stroke", parse_length, "a length, or a dict of edges");
        return;
    }
    for (const auto& [edge, range] : nb::borrow<nb::dict>(*given)) {
        const auto [shortest, longest] =
            of_type<Pair>(range, "stroke", "(shortest, longest) of each edge");
        request.stroke_ranges.push_back({.edge = of_type<int>(edge, "stroke", "indices of edges"),
                                         .shortest = length_given(shortest, "stroke"),
                                         .longest = length_given(longest, "stroke")});
    }
    if (request.stroke_ranges.empty()) {
        throw nb::value_error("stroke: names no edge, expected those that may be turned");
    }
}

void add_target_tensions(PlanRequest& request, const CableNet& net,
                         const std::optional<TensionLike>& of_edges) {
    if (!of_edges) {
        return;
    }
    const TensionLike& given = *of_edges;
    const char* const name = "target_tension";
    if (nb::isinstance<nb::dict>(given)) {
        for (const auto& [key, value] : nb::borrow<nb::dict>(given)) {
            GivenTension one = tension_argument(value);
            if (nb::isinstance<nb::str>(key)) {
                one.group = nb::cast<std::string>(key);
            } else if (!key.is_none()) {
                one.edge = of_type<int>(key, name, "groups, indices of edges, or None for all");
            }
            request.target_tension.push_back(std::move(one));
        }
    } else if (nb::hasattr(given, "__len__") && !nb::isinstance<nb::tuple>(given) &&
               !nb::isinstance<nb::str>(given)) {
        const Eigen::VectorXd tensions = vector_or_number(given, name, net.edge_count());
        for (int edge = 0; edge < net.edge_count(); ++edge) {
            if (!std::isnan(tensions(edge))) {
                GivenTension& one = request.target_tension.emplace_back();
                one.tension = tensions(edge);
                one.edge = edge;
            }
        }
    } else {
        request.target_tension.push_back(tension_argument(given));
    }
    if (request.target_tension.empty()) {
        throw nb::value_error("target_tension: got none, expected those of one edge or more");
    }
}

void add_reactions(PlanRequest& request, const std::optional<ForceLike>& given) {
    if (!given) {
        return;
    }
    for_each_group<nb::object>(
        *given, "reaction", "a force",
        [&](std::optional<std::string> group, const nb::object& upper) {
            request.reaction.push_back(
                {.upper = force_given(upper, "reaction"), .group = std::move(group)});
        });
}

void add_load_cases(PlanRequest& request, const CableNet& net,
                    const std::optional<ArraysByName>& given) {
    if (!given) {
        return;
    }
    for_each_group<ArrayLike>(
        *given, "load_cases", "loads by name",
        [&](std::optional<std::string> name, const ArrayLike& loads) {
            request.load_cases.push_back(
                {.name = name.value_or("load_cases"),
                 .loads = points_argument(loads, "load_cases", net.node_count())});
        });
}

GivenTarget target_argument(const CableNet& net, const std::optional<TargetLike>& given,
                            const std::string& unit_name) {
    const std::optional<double> unit = length_of_unit(unit_name);
    if (!unit) {
        throw nb::value_error(
            fmt::format("target_unit: got '{}', expected a unit such as 'mm'", unit_name).c_str());
    }
    if (!given) {
        return read_target(net, {}, *unit);
    }
    if (nb::isinstance<nb::str>(*given) || nb::hasattr(*given, "__fspath__")) {
        return read_target(net, nb::cast<std::filesystem::path>(*given), *unit);
    }
    if (nb::isinstance<nb::tuple>(*given) && nb::len(*given) == 2 && net.node_count() > 2) {
        return surface_argument((*given)[0], (*given)[1], *unit);
    }
    if (*unit != 1.0) {
        throw nb::value_error("target_unit: is for a surface, which the target is not");
    }
    return {.points = points_argument(*given, "target", net.node_count())};
}

std::vector<NodeWeights> node_weights(const CableNet& net, const ArrayLike& along_normal,
                                      const ArrayLike& across) {
    const Eigen::VectorXd normal = vector_or_number(along_normal, "weights", net.node_count());
    const Eigen::VectorXd tangential = vector_or_number(across, "weights", net.node_count());
    std::vector<NodeWeights> weights;
    for (const int node : net.free_nodes()) {
        weights.push_back({.node = node, .normal = normal(node), .tangential = tangential(node)});
    }
    return weights;
}

FormObjective objective_named(const std::string& name) {
    if (name != "rms" && name != "largest") {
        throw nb::value_error(
            fmt::format("objective: got '{}', expected 'rms' or 'largest'", name).c_str());
    }
    return name == "rms" ? FormObjective::rms : FormObjective::largest;
}

}  // namespace taut::python
