// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "adjustment/stroke_search.hpp"
#include "adjustment/target_deviations.hpp"

namespace taut {

/// Weight of the mean square of the strokes beside that of the deviations: among strokes with about
/// the same form it prefers short ones.
constexpr double turning_weight = 1e-5;

class ProgramRows;

struct ProposedStrokes {
    Eigen::VectorXd strokes;  ///< k [m]
    double merit = 0.0;       ///< of the linearised net [m2]
};

/// The convex program about one state (stroke-program): form and forces linear in the strokes,
/// limits with an exact penalty.
class StrokeProgram {
public:
    /// Keeps pointers to the arguments: they must outlive solve().
    StrokeProgram(std::vector<LimitedResponse>& responses, const StrokeTask& task,
                  const StrokedState& state);

    /// The best strokes within `radius` of the state's [m]; empty where the conic solver finds
    /// none.
    [[nodiscard]] std::optional<ProposedStrokes> solve(double radius) const;

    /// The strokes with the least sum_j weight_j |x_j| for which the state is_within_tolerances(),
    /// as far as limits allow.
    [[nodiscard]] std::optional<Eigen::VectorXd> least_turning(const Eigen::VectorXd& weights,
                                                               double radius) const;

    /// The strokes of the state with one changed by a step: those that lower the merit of the
    /// linearised net, the best first.
    [[nodiscard]] std::vector<ProposedStrokes> single_steps(double step) const;

private:
    /// A limit: sign (force - limit) <= 0.
    struct Row {
        size_t net;        ///< of the sets of loads
        Eigen::Index row;  ///< of its forces
        double sign;       ///< 1 of an upper limit, -1 of a lower one
        double excess;     ///< at the state [N]
    };
    [[nodiscard]] std::vector<Row> all_rows() const;
    [[nodiscard]] double excess_after(const Row& row, const Eigen::VectorXd& change) const;
    [[nodiscard]] std::optional<Eigen::VectorXd> change_holding_limits(
        const std::function<std::optional<Eigen::VectorXd>(const std::vector<Row>&)>& best) const;
    void add_limits(ProgramRows& rows, const std::vector<Row>& limits, int broken) const;
    [[nodiscard]] std::optional<Eigen::VectorXd> best_change(const Eigen::VectorXd& low,
                                                             const Eigen::VectorXd& high,
                                                             const std::vector<Row>& limits) const;
    [[nodiscard]] std::optional<Eigen::VectorXd> least_change(const Eigen::VectorXd& weights,
                                                              double radius,
                                                              const std::vector<Row>& limits) const;
    [[nodiscard]] bool is_largest() const {
        return m_task->target->objective() == FormObjective::largest;
    }
    /// Calls `take(first row, rows)` for each node, then for each target tension.
    template <class Take>
    void for_each_target(Take take) const;

    const std::vector<LimitedResponse>* m_responses;
    const StrokeTask* m_task;
    const StrokedState* m_state;
    Eigen::Index m_nodes = 0;  ///< free ones
    TargetDeviations m_deviations;
    Eigen::MatrixXd m_normal;  ///< k x k, of the mean squares [-]
    std::vector<Eigen::MatrixXd> m_force_rates;
    double m_force_unit = 1.0;
};

}  // namespace taut
