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

namespace taut {
namespace {

using Verdict = Trust::Verdict;

/// An error of the model of sag, as a length.
struct SagError {
    int edge;
    double error;  ///< [m]
    double share;  ///< of the standard deviation of the edge's length
};

/// Standard deviations of the lengths (m); of an adjustable edge that counts as known one that no
/// survey shows [m].
Eigen::VectorXd length_stds(const CableNet& net, const Identification& result) {
    constexpr double known = 1e-4;
    Eigen::VectorXd stds = Eigen::VectorXd::Constant(net.edge_count(), known);
    for (const ParameterEstimate& one : result.uncertain) {
        if (one.parameter.kind == UncertainParameter::Kind::adjustable) {
            stds(one.edge) = one.std_dev;
        }
    }
    for (const IdentifiedEdge& edge : result.edges) {
        stds(edge.edge) = edge.std_dev;
    }
    return stds;
}

/// The errors that matter, the worst first.
/// @param is_modelled of cables that sag in the net, else of those taken as straight
std::vector<SagError> sag_errors(const CableNet& net, const Identification& result,
                                 bool is_modelled) {
    constexpr double least_share = 0.25;
    const CableNetData& data = net.data();
    std::vector<SagError> errors;
    const Eigen::VectorXd stds = length_stds(net, result);
    for (int e = 0; e < net.edge_count(); ++e) {
        const double tension = result.tensions(e);
        const bool sags = !net.is_strut(e) && !net.can_be_slack(e);
        if (net.is_strut(e) || sags != is_modelled || !(tension > 0.0) || !(stds(e) > 0.0)) {
            continue;
        }
        const auto [s, t] = net.edges()[e];
        const Eigen::Vector3d chord = result.predicted.form.col(s) - result.predicted.form.col(t);
        const double length = chord.norm();
        const double across = chord.head<2>().norm() / length;  // cosine of the slope
        const double weight =
            length * (is_modelled ? data.sag_weight(e) : gravity * data.mass(e) * across);
        const double longer = length * std::pow(weight / tension, 2) / 24.0;
        const double depth = weight / (8.0 * tension);                               // f
        const double next = std::abs(7.2 - 12.8 * (1.0 / (across * across) - 1.0));  // (sag-error)
        const double error = is_modelled ? longer * next * depth * depth : longer;
        if (error > least_share * stds(e)) {
            errors.push_back({.edge = e, .error = error, .share = error / stds(e)});
        }
    }
    std::ranges::stable_sort(errors, std::greater{}, &SagError::share);
    return errors;
}

Trust::Finding finding_of(const CableNet& net, const std::vector<SagError>& errors,
                          bool is_modelled) {
    constexpr size_t shown = 6;
    const SagError& worst = errors.front();
    Trust::Finding finding{.kind = Trust::Finding::Kind::sag,
                           .severity = worst.share > 1.0 ? Verdict::doubtful : Verdict::passed,
                           .value = worst.error};
    bool may_all_sag = true;
    for (const SagError& one : errors) {
        finding.ids.push_back(net.edge_id(one.edge));
        may_all_sag = may_all_sag && net.bent_law(one.edge) == nullptr;
    }
    const auto named = static_cast<std::ptrdiff_t>(std::min(shown, finding.ids.size()));
    const std::vector<std::string> names(finding.ids.begin(), finding.ids.begin() + named);
    const bool is_one = errors.size() == 1;
    const std::string edges =
        fmt::format("{} {}{} {}", is_one ? "Edge" : "Edges", fmt::join(names, ", "),
                    errors.size() > shown ? fmt::format(" and {} more", errors.size() - shown) : "",
                    is_one ? "sags" : "sag");
    const std::string size =
        fmt::format("up to {:.2g} mm, {:.2g} times the standard deviation of that edge's length",
                    1e3 * worst.error, worst.share);
    finding.reason =
        is_modelled ? fmt::format("{} too much for a parabola, which makes the length wrong by {}.",
                                  edges, size)
                    : fmt::format(
                          "{} under the cable's own weight, which the net leaves out: the cable is "
                          "longer than taken here by {}.",
                          edges, size);
    finding.advice =
        is_modelled || !may_all_sag
            ? "Divide these edges by nodes."
            : R"(Give the net the sag of its cables: "sag_weight": "mass" in net.json.)";
    return finding;
}

}  // namespace

std::vector<Trust::Finding> sag_findings(const CableNet& net, const Identification& result) {
    std::vector<Trust::Finding> findings;
    for (const bool is_modelled : {true, false}) {
        const bool has_any = is_modelled ? net.sags() : net.data().mass.size() > 0;
        if (!has_any || result.tensions.size() == 0) {
            continue;
        }
        const std::vector<SagError> errors = sag_errors(net, result, is_modelled);
        if (!errors.empty()) {
            findings.push_back(finding_of(net, errors, is_modelled));
        }
    }
    return findings;
}

}  // namespace taut
