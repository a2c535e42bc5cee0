// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/sag_check.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using Verdict = Trust::Verdict;

/// An error of the model of sag, as a length.
struct SagError {
    int edge;
    double error;  ///< [m]
    double share;  ///< of the standard deviation of the edge's length
    bool is_modelled;
};

std::vector<SagError> sag_errors(const CableNet& net, const Identification& result) {
    constexpr double least_share = 0.25;
    constexpr double next_term = 2.4;  // of the arc of a parabola: 8/3 f^2 - 32/5 f^4
    const CableNetData& data = net.data();
    std::vector<SagError> errors;
    if ((data.mass.size() == 0 && !net.sags()) || result.tensions.size() == 0) {
        return errors;
    }
    const Eigen::VectorXd by_mass =
        data.mass.size() > 0 ? sag_weights_by_mass(data) : Eigen::VectorXd::Zero(net.edge_count());
    const Eigen::VectorXd lengths = edge_lengths(net, result.predicted.form);
    for (const IdentifiedEdge& edge : result.edges) {
        const int e = edge.edge;
        const double tension = result.tensions(e);
        if (net.is_strut(e) || !(tension > 0.0) || !(edge.std > 0.0)) {
            continue;
        }
        const bool is_modelled = !net.can_be_slack(e);
        const double weight = (is_modelled ? data.sag_weight(e) : by_mass(e)) * lengths(e);
        const double longer = lengths(e) * std::pow(weight / tension, 2) / 24.0;
        const double depth = weight / (8.0 * tension);  // of the chord
        const double error = is_modelled ? longer * next_term * depth * depth : longer;
        if (error > least_share * edge.std) {
            errors.push_back({e, error, error / edge.std, is_modelled});
        }
    }
    std::ranges::stable_sort(errors, std::greater{}, &SagError::share);
    return errors;
}

}  // namespace

std::optional<Trust::Finding> sag_finding(const CableNet& net, const Identification& result) {
    constexpr size_t shown = 6;
    const std::vector<SagError> errors = sag_errors(net, result);
    if (errors.empty()) {
        return std::nullopt;
    }
    const SagError& worst = errors.front();
    Trust::Finding finding{.kind = Trust::Finding::Kind::sag,
                           .severity = worst.share > 1.0 ? Verdict::doubtful : Verdict::passed,
                           .value = worst.error};
    for (const SagError& one : errors) {
        finding.ids.push_back(net.edge_id(one.edge));
    }
    const std::vector<std::string> names(
        finding.ids.begin(),
        finding.ids.begin() + static_cast<std::ptrdiff_t>(std::min(shown, finding.ids.size())));
    const std::string edges = fmt::format(
        "{} {}{}", errors.size() == 1 ? "edge" : "edges", fmt::join(names, ", "),
        errors.size() > shown ? fmt::format(" and {} more", errors.size() - shown) : "");
    finding.reason =
        worst.is_modelled
            ? fmt::format(
                  "The sag of {} is too large for a parabola: the length is wrong by up to "
                  "{:.2g} mm, {:.2g} of its standard deviation.",
                  edges, 1e3 * worst.error, worst.share)
            : fmt::format(
                  "Under its own weight {} sags between its nodes, which the net leaves "
                  "out: the cable is up to {:.2g} mm longer than taken here, {:.2g} of its "
                  "standard deviation.",
                  edges, 1e3 * worst.error, worst.share);
    finding.next = worst.is_modelled ? "Divide these edges by nodes."
                                     : "Give the net the sag of its cables: \"sag_weight\": "
                                       "\"mass\" in net.json.";
    return finding;
}

}  // namespace taut
