// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/plausibility.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "taut/statics/energy.hpp"
#include "taut/statics/imbalance.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

constexpr double longest_mean_edge = 30.0;  ///< m
/// Mean over the taut edges, at which steel carries 1.7 MPa. A cable at 0.2 % whose tension is
/// given a thousand times too small is at 2e-6.
constexpr double least_mean_strain = 8e-6;
/// More than any steel cable bears. Nets of other materials may.
constexpr double absurd_strain = 0.05;
constexpr double largest_imbalance = 0.1;  ///< of the mean tension

/// A ratio of unstressed to edge lengths that neither strain nor slack explains.
constexpr double impossible_ratio = 100.0;

Eigen::ArrayXd strains_of(const CableNet& net) {
    return edge_lengths(net, net.nodes()).array() / net.unstressed_lengths().array() - 1.0;
}

void add_strain_warnings(const CableNet& net, std::vector<std::string>& warnings) {
    const Eigen::ArrayXd strains = strains_of(net);
    const auto taut_count = static_cast<double>((strains > 0.0).count());
    const double mean = taut_count > 0.0 ? strains.max(0.0).sum() / taut_count : 0.0;
    if (mean > 0.0 && mean < least_mean_strain) {
        warnings.push_back(fmt::format(
            "strains of {:.2g} % on average, hardly any tension: are forces in kN instead "
            "of N, or is axial_stiffness not in N?",
            100.0 * mean));
    }
    Eigen::ArrayXd sizes = strains;
    for (int e = 0; e < net.edge_count(); ++e) {
        sizes(e) = net.is_strut(e) ? std::abs(strains(e)) : strains(e);
    }
    for (const SlidingNode& at : net.sliding_nodes()) {
        sizes(at.before) = sizes(at.after) = 0.0;  // of marks, before anything slid
    }
    Eigen::Index worst = 0;
    if (sizes.maxCoeff(&worst) > absurd_strain) {
        warnings.push_back(
            fmt::format("edge {} has a strain of {:.3g} %, more than a steel cable bears: are "
                        "forces a thousand "
                        "times too large, or is axial_stiffness not in N?",
                        net.edge_id(static_cast<int>(worst)), 100.0 * strains(worst)));
    }
}

}  // namespace

std::vector<std::string> unit_warnings(const CableNet& net) {
    std::vector<std::string> warnings;
    if (const double mean = edge_lengths(net, net.nodes()).mean(); mean > longest_mean_edge) {
        warnings.push_back(fmt::format(
            "edges of {:.4g} m on average: are its coordinates in mm? taut expects metres: "
            "scale the file by 0.001",
            mean));
    }
    add_strain_warnings(net, warnings);
    if (!net.sliding_nodes().empty()) {
        return warnings;  // lengths as marked balance nothing before they have slid
    }
    // Elastic supports may be given where they stand without load.
    const CableNet held = with_supports_in_balance(net);
    const Imbalance found = imbalance_of(held, held.unstressed_lengths(), held.nodes());
    if (found.mean_tension > 0.0 && std::isfinite(found.share()) &&
        found.share() > largest_imbalance) {
        warnings.push_back(
            fmt::format("its nodes are {:.2g} N out of balance ({:.1g} of the mean tension): are "
                        "loads missing, "
                        "or forces in another unit?",
                        found.largest, found.share()));
    }
    return warnings;
}

void refuse_impossible_units(const CableNet& net) {
    Eigen::ArrayXd ratios =
        net.unstressed_lengths().array() / edge_lengths(net, net.nodes()).array();
    const auto middle = ratios.begin() + ratios.size() / 2;
    std::nth_element(ratios.begin(), middle, ratios.end());
    if (*middle > impossible_ratio || *middle < 1.0 / impossible_ratio) {
        throw NetError("unstressed_lengths", {},
                       fmt::format("are {:.3g} times the lengths of their edges in the median, "
                                   "expected about 1: are nodes and lengths both in metres?",
                                   *middle));
    }
}

}  // namespace taut
