// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/form_values.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "taut/statics/tensions.hpp"

namespace taut {

FormValues form_values(const CableNet& net, const Points& form) {
    FormValues values{.lengths = edge_lengths(net, form),
                      .tensions = tensions(net, net.unstressed_lengths(), form),
                      .force_densities = {},
                      .axial_stiffness = net.axial_stiffness()};
    for (int e = 0; e < net.edge_count(); ++e) {
        if (values.lengths(e) == 0.0) {
            throw std::invalid_argument(
                fmt::format("edge {} has no length in the form", net.edge_id(e)));
        }
        if (const TensionLaw* law = net.bent_law(e); law != nullptr) {
            const double strain = values.lengths(e) / net.unstressed_lengths()(e) - 1.0;
            values.axial_stiffness(e) =
                values.is_slack(net, e) ? law->at(0.0).slope : values.tensions(e) / strain;
        }
    }
    values.force_densities = values.tensions.cwiseQuotient(values.lengths);
    return values;
}

std::vector<bool> adjustable_flags(const CableNet& net) {
    std::vector<bool> flags(net.edge_count(), false);
    for (const int edge : net.adjustable_edges()) {
        flags[edge] = true;
    }
    return flags;
}

}  // namespace taut
