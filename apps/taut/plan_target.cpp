// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "plan_target.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <map>
#include <stdexcept>

#include "command.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/interchange/surface_mesh.hpp"
#include "taut/io/adjustment_csv.hpp"
#include "taut/io/read_survey.hpp"
#include "taut/net/units.hpp"

namespace taut::app {
namespace {

/// [m]
const std::map<std::string, double> surface_units{
    {"m", 1.0},    {"mm", 1e-3}, {"cm", 1e-2}, {"ft", 0.3048}, {"us-ft", 1200.0 / 3937.0},
    {"in", 0.0254}};

/// "normal:1,tangential:0.1"
DeviationWeights parse_weights(const std::string& text) {
    DeviationWeights weights;
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::string_view one = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(rest.size(), one.size() + 1));
        const size_t colon = one.find(':');
        const std::string_view name = one.substr(0, colon);
        double value = -1.0;
        if (colon != std::string_view::npos) {
            const std::string_view number = one.substr(colon + 1);
            const auto [end, error] =
                std::from_chars(number.data(), number.data() + number.size(), value);
            if (error != std::errc() || end != number.data() + number.size()) {
                value = -1.0;
            }
        }
        if ((name != "normal" && name != "tangential") || !(value >= 0.0) || std::isinf(value)) {
            throw std::invalid_argument(fmt::format(
                "--weights is '{}', expected weights of 0 or more such as normal:1,tangential:0.1",
                text));
        }
        (name == "normal" ? weights.normal : weights.tangential) = value;
    }
    return weights;
}

/// What about a surface may be wrong.
std::vector<std::string> surface_warnings(const CableNet& net, const TargetSurface& surface) {
    std::vector<std::string> result;
    if (surface.left_out() > 0) {
        result.push_back(fmt::format("{} of {} triangles have no area and are not used",
                                     surface.left_out(),
                                     surface.left_out() + surface.triangle_count()));
    }
    int outside = 0;
    int furthest = -1;
    double most = 1e-3;  // below 1 mm no warning
    for (const int node : net.free_nodes()) {
        const double distance = surface.nearest(net.nodes().col(node)).beyond_border;
        outside += distance > 1e-3 ? 1 : 0;
        if (distance > most) {
            most = distance;
            furthest = node;
        }
    }
    if (outside > 0) {
        result.push_back(fmt::format(
            "{} node{} outside the border of the surface, '{}' by {}. The surface is extended "
            "there",
            outside, outside == 1 ? " is" : "s are", net.node_id(furthest),
            format_length(1e-4 * std::round(1e4 * most))));
    }
    return result;
}

FormTarget read_surface_target(const CableNet& net, const TargetOptions& options,
                               DeviationWeights weights, FormObjective objective) {
    SurfaceMesh mesh = parse_surface_mesh(read_file(options.target), options.target);
    mesh.vertices *= surface_units.at(options.unit);
    try {
        const auto surface = std::make_shared<const TargetSurface>(mesh.vertices, mesh.triangles);
        FormTarget target(net, surface, weights, objective);
        warn(options.target, surface_warnings(net, *surface));
        return target;
    } catch (const std::invalid_argument& error) {
        throw InputError(options.target, "", error.what());
    }
}

}  // namespace

void TargetOptions::add_to(CLI::App& command) {
    command
        .add_option("--target", target,
                    "Target form, id,x,y,z, or target surface, .obj or .ply (default: the nodes of "
                    "NET)")
        ->group(heading::input);
    command.add_option("--target-unit", unit, "Unit of a surface's coordinates")
        ->check(CLI::IsMember({"m", "mm", "cm", "ft", "us-ft", "in"}))
        ->capture_default_str()
        ->group(heading::input);
    command
        .add_option("--weights", weights,
                    "Weights of squared deviations along the target's normal and across it "
                    "(default: normal:1,tangential:0.1)")
        ->group(heading::input);
    command
        .add_option("--node-weights", node_weights,
                    "Other weights of single nodes, a file id,normal,tangential")
        ->group(heading::input);
    command
        .add_option("--objective", objective,
                    "What is minimised: the RMS of the deviations, or the largest")
        ->check(CLI::IsMember({"rms", "largest"}))
        ->capture_default_str()
        ->group(heading::input);
}

FormTarget TargetOptions::read_places(const CableNet& net) const {
    const DeviationWeights given = parse_weights(weights);
    const FormObjective sought = objective == "rms" ? FormObjective::rms : FormObjective::largest;
    if (is_surface_mesh_name(target)) {
        return read_surface_target(net, *this, given, sought);
    }
    if (unit != "m") {
        throw std::invalid_argument(
            "--target-unit is for a surface, .obj or .ply, which --target is not");
    }
    return {net, target.empty() ? net.nodes() : read_form(net, target), given, sought};
}

FormTarget TargetOptions::read(const CableNet& net) const {
    FormTarget result = read_places(net);
    if (!node_weights.empty()) {
        Eigen::VectorXd normal = result.normal_weights();
        Eigen::VectorXd tangential = result.tangential_weights();
        for (const NodeWeights& of :
             parse_node_weights(net, read_file(node_weights), node_weights)) {
            normal(of.node) = of.normal;
            tangential(of.node) = of.tangential;
        }
        result.set_weights(std::move(normal), std::move(tangential));
    }
    return result;
}

}  // namespace taut::app
