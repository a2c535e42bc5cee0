// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/force_ranges.hpp"

#include <algorithm>
#include <limits>

#include "net/weight_as_load.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {

double ForceRange::violation(const Eigen::Ref<const Eigen::VectorXd>& forces) const {
    return (lower - forces).cwiseMax(forces - upper).cwiseMax(0.0).sum();
}

std::vector<int> supports_of(const std::vector<ReactionLimit>& reactions) {
    std::vector<int> result;
    for (const ReactionLimit& limit : reactions) {
        result.insert(result.end(), limit.supports.begin(), limit.supports.end());
    }
    return result;
}

double least_taut(const CableNet& net) {
    const Eigen::VectorXd pull = tensions_of(net, net.unstressed_lengths(), net.nodes());
    return 2.0 * negligible_violation * std::max(0.0, mean_weights(net).dot(pull));
}

double carried(const CableNet& net, Eigen::Index row, double force) {
    const bool is_cable = row < net.edge_count() && !net.is_strut(static_cast<int>(row));
    return is_cable ? std::max(0.0, force) : force;
}

Eigen::VectorXd carried_tensions(const CableNet& net, const Eigen::VectorXd& forces) {
    Eigen::VectorXd tensions(net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        tensions(e) = carried(net, e, forces(e));
    }
    return tensions;
}

double given_limit(const CableNet& net, double limit) {
    return limit == least_taut(net) ? 0.0 : limit;
}

ForceRange range_of(const CableNet& net, const TensionLimits& tension,
                    const std::vector<ReactionLimit>& reactions) {
    Eigen::Index extra = 0;
    for (const ReactionLimit& limit : reactions) {
        extra += static_cast<Eigen::Index>(limit.supports.size());
    }
    ForceRange range{.lower = Eigen::VectorXd(net.edge_count() + extra),
                     .upper = Eigen::VectorXd(net.edge_count() + extra)};
    range.lower << (tension.lower.array() == 0.0).select(least_taut(net), tension.lower),
        Eigen::VectorXd::Constant(extra, -std::numeric_limits<double>::infinity());
    range.upper.head(net.edge_count()) = tension.upper;
    Eigen::Index row = net.edge_count();
    for (const ReactionLimit& limit : reactions) {
        for (size_t i = 0; i < limit.supports.size(); ++i) {
            range.upper(row++) = limit.upper;
        }
    }
    return range;
}

CableNet with_loads(const CableNet& net, const Points& loads) {
    CableNetData data = with_weight_as_load(net);
    data.loads = loads;
    return CableNet(std::move(data));
}

}  // namespace taut
