// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/adjustment/limits.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "adjustment/check_plan.hpp"
#include "statics/arguments.hpp"

namespace taut {
namespace {

void check_tension_limits(const CableNet& net, const TensionLimits& limits) {
    if (limits.lower.size() != net.edge_count() || limits.upper.size() != net.edge_count()) {
        throw std::invalid_argument(fmt::format("tension limits of {} and {} edges, expected {}",
                                                limits.lower.size(), limits.upper.size(),
                                                net.edge_count()));
    }
    for (int e = 0; e < net.edge_count(); ++e) {
        const bool is_strut = net.is_strut(e);
        if (!(is_strut || limits.lower(e) >= 0.0) || !(limits.upper(e) > limits.lower(e)) ||
            limits.lower(e) == std::numeric_limits<double>::infinity()) {
            throw std::invalid_argument(
                fmt::format("the tension limits of {} '{}' are {:g} and {:g} N, expected a lower "
                            "limit{} and an upper limit above it",
                            is_strut ? "strut" : "edge", net.edge_id(e), limits.lower(e),
                            limits.upper(e), is_strut ? "" : " of at least 0"));
        }
    }
}

void check_strokes(const CableNet& net, const std::vector<int>& edges, const Limits& limits) {
    const auto count = static_cast<Eigen::Index>(edges.size());
    if (limits.shortest_stroke.size() != count || limits.longest_stroke.size() != count) {
        throw std::invalid_argument(fmt::format("stroke limits of {} and {} edges, expected {}",
                                                limits.shortest_stroke.size(),
                                                limits.longest_stroke.size(), count));
    }
    for (Eigen::Index k = 0; k < count; ++k) {
        const double shortest = limits.shortest_stroke(k);
        const double longest = limits.longest_stroke(k);
        const std::string name = net.edge_id(edges[static_cast<size_t>(k)]);
        if (!std::isfinite(shortest) || !std::isfinite(longest) || shortest > 0.0 ||
            longest < 0.0) {
            throw std::invalid_argument(
                fmt::format("the stroke limits of edge '{}' are {:g} and {:g} m, expected a range "
                            "that contains 0",
                            name, shortest, longest));
        }
        const double length = net.unstressed_lengths()(edges[static_cast<size_t>(k)]);
        if (!(-shortest < 0.9 * length)) {
            throw std::invalid_argument(fmt::format(
                "the lower stroke limit of edge '{}' is {:g} m, expected to leave more than "
                "a tenth of its length of {:g} m",
                name, shortest, length));
        }
    }
}

}  // namespace

TensionLimits TensionLimits::no_slack(const CableNet& net) {
    TensionLimits limits{.lower = Eigen::VectorXd::Zero(net.edge_count()),
                         .upper = Eigen::VectorXd::Constant(
                             net.edge_count(), std::numeric_limits<double>::infinity())};
    const Eigen::VectorXd& buckling = net.data().buckling_load;
    for (int e = 0; e < net.edge_count(); ++e) {
        if (net.is_strut(e)) {
            limits.lower(e) =
                buckling.size() > 0 ? -buckling(e) : -std::numeric_limits<double>::infinity();
        }
    }
    return limits;
}

bool Limits::has_forces(const CableNet& net) const {
    for (int e = 0; e < net.edge_count(); ++e) {
        if (net.is_strut(e) ? std::isfinite(tension.lower(e)) : tension.lower(e) > 0.0) {
            return true;
        }
    }
    return std::isfinite(tension.upper.minCoeff()) || !reactions.empty() || !load_cases.empty();
}

Limits stroke_limits(const CableNet& net, const std::vector<int>& edges, double stroke) {
    const Eigen::Index count = std::ssize(edges);
    return {.shortest_stroke = Eigen::VectorXd::Constant(count, -stroke),
            .longest_stroke = Eigen::VectorXd::Constant(count, stroke),
            .tension = TensionLimits::no_slack(net),
            .reactions = {},
            .load_cases = {}};
}

void check_limits(const CableNet& net, const std::vector<int>& edges, const Limits& limits) {
    check_strokes(net, edges, limits);
    check_force_limits(net, limits);
}

void check_force_limits(const CableNet& net, const Limits& limits) {
    check_tension_limits(net, limits.tension);
    for (const ReactionLimit& limit : limits.reactions) {
        if (!(limit.upper > 0.0)) {
            throw std::invalid_argument(
                fmt::format("the reaction limit of '{}' is {:g} N, expected more than 0",
                            limit.name, limit.upper));
        }
        for (const int node : limit.supports) {
            if (node < 0 || node >= net.node_count() || !net.is_support(node)) {
                throw std::invalid_argument(
                    fmt::format("the reaction limit of '{}' names node {}, which is no support",
                                limit.name, node));
            }
        }
    }
    for (const LoadCase& load_case : limits.load_cases) {
        check_form(load_case.name.c_str(), net.node_count(), load_case.loads);
        check_tension_limits(net, load_case.tension);
    }
}

}  // namespace taut
