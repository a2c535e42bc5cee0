// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "files/message.hpp"
#include "interchange/form_values.hpp"
#include "taut/files/printable.hpp"
#include "taut/interchange/obj.hpp"

namespace taut {

std::string form_to_obj(const CableNet& net, const Points& form) {
    const FormValues values = form_values(net, form);
    // Comments stand on lines of their own: the reader of COMPAS knows no others.
    std::string result =
        "# lengths in m, forces in N\n"
        "# before each v: the node's name\n"
        "# before each l: the edge's name, tension T, force density q, unstressed length l0, axial "
        "stiffness EA\n";
    for (int node = 0; node < net.node_count(); ++node) {
        result += fmt::format("# {}\nv {} {} {}\n", printable(net.node_id(node)), form(0, node),
                              form(1, node), form(2, node));
    }
    result += "g net\n";
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto [s, t] = net.edges()[e];
        result += fmt::format("# {} T={} q={} l0={} EA={}{}\nl {} {}\n", printable(net.edge_id(e)),
                              values.tensions(e), values.force_densities(e),
                              net.unstressed_lengths()(e), values.axial_stiffness(e),
                              values.is_slack(net, e) ? " slack" : "", s + 1, t + 1);
    }
    result += "g supports\n";
    for (const int node : net.all_supports()) {
        result += fmt::format("p {}\n", node + 1);
    }
    return result;
}

}  // namespace taut
