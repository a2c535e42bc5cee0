// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "files/csv_field.hpp"
#include "interchange/form_values.hpp"
#include "taut/interchange/net_csv.hpp"

namespace taut {

NetCsv form_to_net_csv(const CableNet& net, const Points& form) {
    const FormValues values = form_values(net, form);
    const std::vector<bool> adjustable = adjustable_flags(net);
    NetCsv result{.nodes = "id,x,y,z,is_free,u,v,w,px,py,pz\n",
                  .edges = fmt::format("u,v,q,f,l,l0,EA,is_slack,is_adjustable,{}id\n",
                                       net.has_struts() ? "is_strut," : "")};
    for (int node = 0; node < net.node_count(); ++node) {
        const auto load = net.loads().col(node);
        result.nodes += fmt::format("{},{},{},{},{},0,0,0,{},{},{}\n", csv_field(net.node_id(node)),
                                    form(0, node), form(1, node), form(2, node),
                                    net.is_support(node) ? 0 : 1, load.x(), load.y(), load.z());
    }
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto [s, t] = net.edges()[e];
        result.edges +=
            fmt::format("{},{},{},{},{},{},{},{},{},{}{}\n", csv_field(net.node_id(s)),
                        csv_field(net.node_id(t)), values.force_densities(e), values.tensions(e),
                        values.lengths(e), net.unstressed_lengths()(e), values.axial_stiffness(e),
                        int{values.is_slack(net, e)}, int{adjustable[e]},
                        !net.has_struts() ? ""
                        : net.is_strut(e) ? "1,"
                                          : "0,",
                        csv_field(net.edge_id(e)));
    }
    return result;
}

}  // namespace taut
