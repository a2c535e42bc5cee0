// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "net_summary.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "taut/statics/energy.hpp"
#include "taut/statics/stability.hpp"

namespace taut::app {

std::string counts_text(const CableNet& net) {
    const size_t elastic = net.elastic_supports().size();
    const auto struts = std::ranges::count(net.data().kind, EdgeKind::strut);
    int sagging = 0;
    for (int e = 0; net.sags() && e < net.edge_count(); ++e) {
        sagging += net.can_be_slack(e) || net.is_strut(e) ? 0 : 1;
    }
    const std::string kinds =
        (struts > 0 ? fmt::format(" ({} struts)", struts) : "") +
        (sagging > 0 ? fmt::format(" ({} with sag)", sagging) : std::string());
    return fmt::format(
        "net {}: {} free nodes{}, {} {}supports, {} interior and {} adjustable edges{}", net.name(),
        net.free_node_count(), elastic > 0 ? fmt::format(" ({} elastic supports)", elastic) : "",
        net.supports().size(), elastic > 0 ? "rigid " : "", net.interior_edge_count(),
        net.adjustable_edges().size(), kinds);
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
    return fmt::format(
        "{} after {} iterations, {}",
        equilibrium.status == EquilibriumStatus::iteration_limit ? "not balanced"
                                                                 : to_string(equilibrium.status),
        equilibrium.iterations, balance_text(equilibrium.out_of_balance, equilibrium.mean_tension));
}

std::string balance_text(double out_of_balance, double mean_tension) {
    std::string text = fmt::format("{:.2g} N out of balance", out_of_balance);
    if (mean_tension > 0.0) {
        text += fmt::format(" ({:.1g} of the mean tension, {:.4g} N)",
                            out_of_balance / mean_tension, mean_tension);
    }
    return text;
}

FormCheck check_form(const CableNet& net, const Eigen::VectorXd& lengths, const Points& form,
                     const Points& edge_forces) {
    if (net.has_struts()) {
        return {.energy = potential_energy(net, lengths, form),
                .smallest_stiffness = smallest_stiffness(net, lengths, form)};
    }
    const EnergyCertificate certificate = edge_forces.cols() > 0
                                              ? energy_certificate(net, lengths, form, edge_forces)
                                              : energy_certificate(net, lengths, form);
    return {.energy = certificate.energy, .certificate = certificate};
}

std::string check_text(const FormCheck& check) {
    if (check.certificate) {
        return fmt::format(
            "energy {:.6g} J, above the lowest by at most {:.1g} J ({:.1g} of the elastic energy)",
            check.energy, check.certificate->duality_gap, check.certificate->relative_gap);
    }
    return fmt::format(
        "energy {:.6g} J; smallest stiffness against any motion {:.4g} N/m{}. With struts other "
        "forms may be stable, too",
        check.energy, check.smallest_stiffness,
        check.smallest_stiffness > 0.0    ? ": stable"
        : check.smallest_stiffness == 0.0 ? ": free to move"
                                          : ": not stable");
}

void add_check(nlohmann::ordered_json& document, const FormCheck& check) {
    document["energy"] = check.energy;
    if (check.certificate) {
        document["complementary_energy"] = check.certificate->complementary_energy;
        document["duality_gap"] = check.certificate->duality_gap;
        document["relative_gap"] = check.certificate->relative_gap;
    } else {
        document["smallest_stiffness"] = check.smallest_stiffness;
    }
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
