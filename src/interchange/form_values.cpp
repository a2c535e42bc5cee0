// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/form_values.hpp"

#include <fmt/core.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <set>
#include <stdexcept>

#include "taut/statics/energy.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {

FormValues form_values(const CableNet& net, const Points& form) {
    FormValues values{.lengths = edge_lengths(net, form),
                      .tensions = tensions_of(net, net.unstressed_lengths(), form),
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

RunValues run_values(const CableNet& net) {
    RunValues values{.of_edges = std::vector<std::string>(net.edge_count()),
                     .friction = std::vector<std::optional<double>>(net.edge_count()),
                     .slides = std::vector<std::vector<std::string>>(net.node_count())};
    std::set<std::string> taken;
    const std::vector<CableRun>& runs = net.data().runs;
    for (size_t k = 0; k < runs.size(); ++k) {
        std::string name = runs[k].name.empty() ? fmt::format("run {}", k + 1) : runs[k].name;
        while (!taken.insert(name).second) {
            name += fmt::format(" ({})", k + 1);
        }
        std::ranges::replace(name, ';', ',');  // which lists names in CSV
        for (const int edge : runs[k].edges) {
            values.of_edges[edge] = name;
            values.friction[edge] = runs[k].friction;
        }
        for (const int node : runs[k].slides_at) {
            values.slides[node].push_back(name);
        }
    }
    return values;
}

std::optional<ElasticSupport> elastic_support_at(const CableNet& net, const Points& form,
                                                 int node) {
    const auto found = std::ranges::find(net.elastic_supports(), node, &ElasticSupport::node);
    if (found == net.elastic_supports().end()) {
        return std::nullopt;
    }
    ElasticSupport support = *found;
    if (!net.support_couplings().empty()) {
        const Points forces = elastic_forces(net, form);
        support.place = form.col(node) - support.stiffness.llt().solve(forces.col(node));
    }
    return support;
}

std::vector<bool> adjustable_flags(const CableNet& net) {
    std::vector<bool> flags(net.edge_count(), false);
    for (const int edge : net.adjustable_edges()) {
        flags[edge] = true;
    }
    return flags;
}

}  // namespace taut
