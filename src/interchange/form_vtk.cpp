// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/interchange/form_vtk.hpp"

#include <fmt/core.h>

#include "files/message.hpp"
#include "interchange/form_values.hpp"
#include "taut/files/printable.hpp"

namespace taut {
namespace {

/// One attribute, "double" or "int", a value a line.
template <typename At>
std::string scalars(const char* name, const char* type, int count, const At& at) {
    std::string result = fmt::format("SCALARS {} {} 1\nLOOKUP_TABLE default\n", name, type);
    for (int i = 0; i < count; ++i) {
        result += fmt::format("{}\n", at(i));
    }
    return result;
}

std::string triples(const Points& points) {
    std::string result;
    for (const auto& point : points.colwise()) {
        result += fmt::format("{} {} {}\n", point.x(), point.y(), point.z());
    }
    return result;
}

/// The second line of the file: at most 255 bytes.
std::string title(const std::string& name) {
    constexpr size_t longest = 200;
    return "cable net " + printable(name).substr(0, longest) + ", in m and N";
}

}  // namespace

std::string form_to_vtk(const CableNet& net, const Points& form) {
    const FormValues values = form_values(net, form);
    const std::vector<bool> adjustable = adjustable_flags(net);
    const int n = net.node_count();
    const int m = net.edge_count();
    std::string result = fmt::format(
        "# vtk DataFile Version 3.0\n{}\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double\n{}",
        title(net.name()), n, triples(form));
    result += fmt::format("CELLS {} {}\n", m, 3 * m);
    for (const auto& [s, t] : net.edges()) {
        result += fmt::format("2 {} {}\n", s, t);
    }
    result += fmt::format("CELL_TYPES {}\n", m);
    for (int e = 0; e < m; ++e) {
        constexpr int line = 3;  // VTK_LINE
        result += fmt::format("{}\n", line);
    }

    const auto numbers = [m](const char* name, const Eigen::VectorXd& of_edges) {
        return scalars(name, "double", m, [&](int e) { return of_edges(e); });
    };
    result += fmt::format("CELL_DATA {}\n", m);
    result += numbers("tension", values.tensions);
    result += numbers("force_density", values.force_densities);
    result += numbers("length", values.lengths);
    result += numbers("unstressed_length", net.unstressed_lengths());
    result += numbers("axial_stiffness", values.axial_stiffness);
    result += scalars("is_slack", "int", m, [&](int e) { return int{values.is_slack(net, e)}; });
    if (net.has_struts()) {
        result += scalars("is_strut", "int", m, [&](int e) { return int{net.is_strut(e)}; });
    }
    result += scalars("is_adjustable", "int", m, [&](int e) { return int{adjustable[e]}; });
    const RunValues runs = run_values(net);
    if (net.sags()) {
        result += numbers("sag_weight", net.data().sag_weight);
    }
    if (!net.sliding_nodes().empty()) {
        std::vector<int> run_of(static_cast<size_t>(m), -1);
        for (size_t k = 0; k < net.data().runs.size(); ++k) {
            for (const int e : net.data().runs[k].edges) {
                run_of[e] = static_cast<int>(k);
            }
        }
        result += scalars("run", "int", m, [&](int e) { return run_of[e]; });
    }
    result += fmt::format("POINT_DATA {}\n", n);
    result += scalars("is_support", "int", n, [&](int i) { return net.is_support(i) ? 1 : 0; });
    if (!net.sliding_nodes().empty()) {
        result +=
            scalars("slides", "int", n, [&](int i) { return runs.slides[i].empty() ? 0 : 1; });
    }
    if (!net.elastic_supports().empty()) {
        Points places = form;
        result += "TENSORS support_stiffness double\n";
        for (int node = 0; node < n; ++node) {
            const auto support = elastic_support_at(net, form, node);
            Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
            if (support) {
                stiffness = support->stiffness;
                places.col(node) = support->place;
            }
            result += triples(stiffness);
        }
        result += "VECTORS support_place double\n" + triples(places);
    }
    return result + "VECTORS load double\n" + triples(net.loads());
}

}  // namespace taut
