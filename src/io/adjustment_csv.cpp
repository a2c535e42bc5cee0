// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/adjustment_csv.hpp"

#include <array>
#include <cmath>

#include "interchange/surface_mesh.hpp"
#include "io/name_column.hpp"
#include "taut/adjustment/request_error.hpp"
#include "taut/files/file.hpp"
#include "taut/io/read_survey.hpp"

namespace taut {
namespace {

/// The numbers behind the name, each below a limit.
template <size_t N>
std::array<double, N> numbers_in(const CsvTable& table, const CsvRecord& row, double below) {
    std::array<double, N> result{};
    for (size_t i = 0; i < N; ++i) {
        result[i] = table.number(row, i + 1);
        if (!(std::abs(result[i]) < below)) {
            table.refuse(row, i + 1, fmt::format("a number of less than {:g}", below));
        }
    }
    return result;
}

}  // namespace

std::vector<StrokeRange> parse_stroke_ranges(const CableNet& net, std::string_view text,
                                             const std::string& file_name) {
    const CsvTable table(text, file_name, {.names = {"edge", "shortest", "longest"}},
                         "holds no edge");
    NameColumn edges = NameColumn::of_edges(table, net);
    std::vector<StrokeRange> ranges;
    for (const CsvRecord& row : table.rows()) {
        constexpr double longest_stroke = 1e3;  // [m]
        const int edge = edges.unique_index(row);
        const auto [shortest, longest] = numbers_in<2>(table, row, longest_stroke);
        if (shortest > 0.0 || longest < 0.0) {
            table.fail(row, fmt::format("the strokes go from {:g} to {:g} m, expected a range that "
                                        "holds 0",
                                        shortest, longest));
        }
        ranges.push_back({.edge = edge, .shortest = shortest, .longest = longest});
    }
    return ranges;
}

Points parse_loads(const CableNet& net, std::string_view text, const std::string& file_name) {
    constexpr double largest_load = 1e12;  // [N]
    const CsvTable table(text, file_name, {.names = {"id", "x", "y", "z"}}, "holds no load");
    NameColumn nodes = NameColumn::of_nodes(table, net);
    Points loads = Points::Zero(3, net.node_count());
    for (const CsvRecord& row : table.rows()) {
        const int node = nodes.unique_index(row);
        const auto [x, y, z] = numbers_in<3>(table, row, largest_load);
        loads.col(node) << x, y, z;
        if (net.free_index(node) < 0 && !loads.col(node).isZero(0.0)) {
            table.fail(row, fmt::format("node {} is a support, which takes a load by itself; "
                                        "expected a free node",
                                        quote(table.text(row, 0))));
        }
    }
    return loads;
}

std::vector<NodeWeights> parse_node_weights(const CableNet& net, std::string_view text,
                                            const std::string& file_name) {
    constexpr double largest_weight = 1e12;
    const CsvTable table(text, file_name, {.names = {"id", "normal", "tangential"}},
                         "holds no node");
    NameColumn nodes = NameColumn::of_nodes(table, net);
    std::vector<NodeWeights> result;
    for (const CsvRecord& row : table.rows()) {
        const int node = nodes.unique_index(row);
        if (net.free_index(node) < 0) {
            table.fail(row, fmt::format("node {} is a support, which does not move; expected a "
                                        "free node",
                                        quote(table.text(row, 0))));
        }
        const auto [normal, tangential] = numbers_in<2>(table, row, largest_weight);
        if (normal < 0.0 || tangential < 0.0) {
            table.fail(row, fmt::format("the weights are {:g} and {:g}, expected 0 or more", normal,
                                        tangential));
        }
        result.push_back({.node = node, .normal = normal, .tangential = tangential});
    }
    return result;
}

std::vector<GivenTension> parse_target_tensions(const CableNet& net, std::string_view text,
                                                const std::string& file_name) {
    const CsvTable table(text, file_name,
                         {.names = {"edge", "tension", "tolerance"}, .optional = 1},
                         "holds no target tension");
    NameColumn edges = NameColumn::of_edges(table, net);
    const auto force_in = [&](const CsvRecord& row, size_t column) {
        const double force = table.number(row, column);
        if (!(force > 0.0)) {
            table.refuse(row, column, "more than 0");
        }
        return force;
    };
    std::vector<GivenTension> result;
    for (const CsvRecord& row : table.rows()) {
        GivenTension& one = result.emplace_back();
        one.edge = edges.unique_index(row);
        one.tension = force_in(row, 1);
        if (table.has(2)) {
            one.tolerance = {.value = force_in(row, 2)};
        }
    }
    return result;
}

GivenTarget read_target(const CableNet& net, const std::filesystem::path& file, double unit) {
    if (is_surface_mesh_name(file)) {
        SurfaceMesh mesh = parse_surface_mesh(read_file(file), file.string());
        return {.points = unit * mesh.vertices, .triangles = std::move(mesh.triangles)};
    }
    if (unit != 1.0) {
        throw RequestError("target_unit",
                           "is for a surface, .obj or .ply, which the target is not");
    }
    return {.points = file.empty() ? net.nodes() : read_form(net, file)};
}

}  // namespace taut
