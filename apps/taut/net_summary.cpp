// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "net_summary.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace taut::app {

std::string counts_text(const CableNet& net) {
    const size_t elastic = net.elastic_supports().size();
    return fmt::format(
        "net {}: {} free nodes{}, {} {}supports, {} interior and {} adjustable edges", net.name(),
        net.free_node_count(), elastic > 0 ? fmt::format(" ({} elastic supports)", elastic) : "",
        net.supports().size(), elastic > 0 ? "rigid " : "", net.interior_edge_count(),
        net.adjustable_edges().size());
}

nlohmann::ordered_json counts_json(const CableNet& net) {
    return {{"name", net.name()},
            {"free_nodes", net.free_node_count()},
            {"supports", net.supports().size()},
            {"interior_edges", net.interior_edge_count()},
            {"adjustable_edges", net.adjustable_edges().size()},
            {"fingerprint", net.fingerprint()}};
}

std::string equilibrium_text(const Equilibrium& equilibrium) {
    // Not the status "iteration limit": a search may end before it.
    return fmt::format("{} after {} iterations, {}",
                       equilibrium.balanced() ? to_string(equilibrium.status) : "not balanced",
                       equilibrium.iterations,
                       balance_text(equilibrium.out_of_balance, equilibrium.mean_tension));
}

std::string balance_text(double out_of_balance, double mean_tension) {
    std::string text = fmt::format("{:.2g} N out of balance", out_of_balance);
    if (mean_tension > 0.0) {
        text += fmt::format(" ({:.1g} of the mean tension, {:.4g} N)",
                            out_of_balance / mean_tension, mean_tension);
    }
    return text;
}

std::string certificate_text(const EnergyCertificate& certificate) {
    return fmt::format(
        "energy {:.6g} J, above the lowest by at most {:.1g} J ({:.1g} of the elastic energy)",
        certificate.energy, certificate.duality_gap, certificate.relative_gap);
}

void add_certificate(nlohmann::ordered_json& document, const EnergyCertificate& certificate) {
    document["energy"] = certificate.energy;
    document["complementary_energy"] = certificate.complementary_energy;
    document["duality_gap"] = certificate.duality_gap;
    document["relative_gap"] = certificate.relative_gap;
}

std::string edges_text(const CableNet& net, const std::vector<int>& edges) {
    constexpr size_t most = 12;
    std::string text = std::to_string(edges.size());
    for (size_t i = 0; i < std::min(most, edges.size()); ++i) {
        text += (i == 0 ? ": " : ", ") + net.edge_id(edges[i]);
    }
    return edges.size() > most ? text + ", ..." : text;
}

std::string status_text(EdgeStatus status) {
    std::string text(to_string(status));
    std::ranges::replace(text, '_', ' ');
    return text;
}

}  // namespace taut::app
