// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <fmt/ranges.h>

#include "files/csv_field.hpp"
#include "interchange/form_values.hpp"
#include "taut/interchange/net_csv.hpp"

namespace taut {

namespace {

std::string run_text(const RunValues& runs, int edge) {
    const std::optional<double> friction = runs.friction[edge];
    return fmt::format("{},{},", csv_field(runs.of_edges[edge]),
                       friction ? fmt::format("{}", *friction) : "");
}

}  // namespace

NetCsv form_to_net_csv(const CableNet& net, const Points& form) {
    const FormValues values = form_values(net, form);
    const std::vector<bool> adjustable = adjustable_flags(net);
    const RunValues runs = run_values(net);
    const bool has_runs = !net.data().runs.empty();
    const bool has_springs = !net.elastic_supports().empty();
    NetCsv result{
        .nodes = fmt::format("id,x,y,z,is_free,u,v,w,px,py,pz{}{}\n",
                             has_springs ? ",kxx,kyy,kzz,kxy,kxz,kyz,x0,y0,z0" : "",
                             has_runs ? ",slides" : ""),
        .edges = fmt::format("u,v,q,f,l,l0,EA,is_slack,is_adjustable,{}{}{}id\n",
                             net.has_struts() ? "is_strut," : "", net.sags() ? "sag_weight," : "",
                             has_runs ? "run,friction," : "")};
    for (int node = 0; node < net.node_count(); ++node) {
        const auto load = net.loads().col(node);
        result.nodes += fmt::format("{},{},{},{},{},0,0,0,{},{},{}", csv_field(net.node_id(node)),
                                    form(0, node), form(1, node), form(2, node),
                                    net.is_support(node) ? 0 : 1, load.x(), load.y(), load.z());
        if (const auto support = elastic_support_at(net, form, node)) {
            const Eigen::Matrix3d& K = support->stiffness;
            const Eigen::Vector3d& place = support->place;
            result.nodes += fmt::format(",{},{},{},{},{},{},{},{},{}", K(0, 0), K(1, 1), K(2, 2),
                                        K(0, 1), K(0, 2), K(1, 2), place.x(), place.y(), place.z());
        } else if (has_springs) {
            result.nodes += ",,,,,,,,,";
        }
        if (has_runs) {
            result.nodes += "," + csv_field(fmt::format("{}", fmt::join(runs.slides[node], ";")));
        }
        result.nodes += "\n";
    }
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto [s, t] = net.edges()[e];
        result.edges +=
            fmt::format("{},{},{},{},{},{},{},{},{},{}{}{}{}\n", csv_field(net.node_id(s)),
                        csv_field(net.node_id(t)), values.force_densities(e), values.tensions(e),
                        values.lengths(e), net.unstressed_lengths()(e), values.axial_stiffness(e),
                        int{values.is_slack(net, e)}, int{adjustable[e]},
                        !net.has_struts() ? ""
                        : net.is_strut(e) ? "1,"
                                          : "0,",
                        net.sags() ? fmt::format("{},", net.data().sag_weight(e)) : "",
                        has_runs ? run_text(runs, e) : "", csv_field(net.edge_id(e)));
    }
    return result;
}

}  // namespace taut
