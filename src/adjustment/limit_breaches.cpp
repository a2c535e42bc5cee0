// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/limit_breaches.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include "adjustment/force_ranges.hpp"

namespace taut {

std::vector<LimitBreach> limit_breaches(const PlanProblem& problem, const StrokedState& state,
                                        const DrawnStrokes* draws, double least_probability) {
    const CableNet& net = problem.net();
    const std::vector<int> supports = supports_of(problem.limits().reactions);
    std::vector<LimitBreach> of_estimate;
    std::vector<LimitBreach> of_draws;
    for (size_t i = 0; i < problem.given().size(); ++i) {
        const Eigen::VectorXd& forces = state.nets[i].forces;
        for (Eigen::Index row = 0; row < forces.size(); ++row) {
            for (const bool is_lower : {true, false}) {
                const double limit =
                    is_lower ? problem.given()[i].lower(row) : problem.given()[i].upper(row);
                if (std::isinf(limit)) {
                    continue;
                }
                const double sign = is_lower ? -1.0 : 1.0;
                const bool is_kept = sign * (forces(row) - limit) <= problem.negligible_excess();
                double probability = is_kept ? 1.0 : 0.0;
                if (draws != nullptr) {
                    const auto drawn_row = draws->forces[i].row(row).array();
                    probability = (sign * (drawn_row - limit) <= 0.0).cast<double>().mean();
                }
                if (is_kept && probability >= least_probability) {
                    continue;
                }
                const bool is_edge = row < net.edge_count();
                (is_kept ? of_draws : of_estimate)
                    .push_back(
                        {.kind = is_edge ? LimitBreach::Kind::tension : LimitBreach::Kind::reaction,
                         .index = is_edge ? static_cast<int>(row)
                                          : supports[static_cast<size_t>(row - net.edge_count())],
                         .load_case = i == 0 ? "" : problem.limits().load_cases[i - 1].name,
                         .value = carried(net, row, forces(row)),
                         .limit = given_limit(problem.net_under_loads(i), limit),
                         .probability = probability});
            }
        }
    }
    const auto is_worse = [](const LimitBreach& a, const LimitBreach& b) {
        return std::tuple(a.probability, -std::abs(a.value - a.limit)) <
               std::tuple(b.probability, -std::abs(b.value - b.limit));
    };
    std::ranges::stable_sort(of_estimate, is_worse);
    std::ranges::stable_sort(of_draws, is_worse);
    std::ranges::move(of_draws, std::back_inserter(of_estimate));
    return of_estimate;
}

}  // namespace taut
