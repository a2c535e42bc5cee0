// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/stroke_program.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/small_dense.hpp"
#include "statics/conic_solver.hpp"

namespace taut {

/// Builds A x + s = b, s in its cones, row by row.
class ProgramRows {
public:
    /// a . x <= b
    void at_most(double b) {
        ++m_nonnegative;
        m_b.push_back(b);
    }
    void entry(int column, double value) {
        if (value != 0.0) {
            m_entries.emplace_back(static_cast<int>(m_b.size()) - 1, column, value);
        }
    }
    /// The next `dimension` rows make a second-order cone.
    void begin_cone(int dimension) {
        m_cones.push_back({.kind = Cone::Kind::second_order, .dimension = dimension});
    }
    void cone_row(double b) { m_b.push_back(b); }

    void write(ConicProgram& program, int columns) const {
        const auto rows = static_cast<Eigen::Index>(m_b.size());
        program.A.resize(rows, columns);
        program.A.setFromTriplets(m_entries.begin(), m_entries.end());
        program.b = Eigen::VectorXd::Map(m_b.data(), rows);
        if (m_nonnegative > 0) {
            program.cones.push_back({.kind = Cone::Kind::nonnegative, .dimension = m_nonnegative});
        }
        program.cones.insert(program.cones.end(), m_cones.begin(), m_cones.end());
    }

private:
    int m_nonnegative = 0;
    std::vector<Cone> m_cones;
    std::vector<double> m_b;
    std::vector<Eigen::Triplet<double>> m_entries;
};

namespace {

constexpr double program_length = 1e-3;  ///< the program's numbers are of order one [m]
constexpr int most_conic_iterations = 100;

/// low <= x_j <= high for the first columns [m].
void add_stroke_bounds(ProgramRows& rows, const Eigen::VectorXd& low, const Eigen::VectorXd& high) {
    for (int j = 0; j < low.size(); ++j) {
        rows.at_most(high(j) / program_length);
        rows.entry(j, 1.0);
        rows.at_most(-low(j) / program_length);
        rows.entry(j, -1.0);
    }
}

/// excess + gradient . x <= x_broken, x_broken >= 0, in units of force.
void add_force_limit(ProgramRows& rows, double excess, const Eigen::VectorXd& gradient,
                     double force_unit, int broken) {
    rows.at_most(-excess / force_unit);
    for (int j = 0; j < gradient.size(); ++j) {
        rows.entry(j, gradient(j) * program_length / force_unit);
    }
    rows.entry(broken, -1.0);
    rows.at_most(0.0);
    rows.entry(broken, -1.0);
}

Eigen::SparseMatrix<double> upper_triangle(const Eigen::MatrixXd& dense, int size) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < dense.cols(); ++j) {
        for (int i = 0; i <= j; ++i) {
            entries.emplace_back(i, j, dense(i, j));
        }
    }
    Eigen::SparseMatrix<double> result(size, size);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

}  // namespace

StrokeProgram::StrokeProgram(std::vector<LimitedResponse>& responses, const StrokeTask& task,
                             const StrokedState& state)
    : m_responses(&responses),
      m_task(&task),
      m_state(&state),
      m_nodes(responses.front().response.net().free_node_count()) {
    for (size_t i = 0; i < responses.size(); ++i) {
        StrokeRates rates = responses[i].response.rates(state.nets[i]);
        if (i == 0) {
            m_deviations = deviations_from_targets(task, responses.front().response.net(),
                                                   state.nets.front(), rates);
        }
        m_force_rates.push_back(std::move(rates.forces));
    }
    if (!is_largest()) {
        m_normal =
            m_deviations.rates.transpose() * m_deviations.rates / static_cast<double>(m_nodes);
    }
    m_force_unit = std::max(state.nets.front().equilibrium.mean_tension, 1e-9);
}

template <class Take>
void StrokeProgram::for_each_target(Take take) const {
    const Eigen::Index rows = m_deviations.values.size();
    for (Eigen::Index row = 0; row < rows;) {
        const Eigen::Index count = row < 3 * m_nodes ? 3 : 1;
        take(row, count);
        row += count;
    }
}

std::vector<StrokeProgram::Row> StrokeProgram::all_rows() const {
    std::vector<Row> rows;
    for (size_t i = 0; i < m_responses->size(); ++i) {
        const ForceRange& range = (*m_responses)[i].range;
        const Eigen::VectorXd& forces = m_state->nets[i].forces;
        for (Eigen::Index row = 0; row < forces.size(); ++row) {
            if (std::isfinite(range.upper(row))) {
                rows.push_back(
                    {.net = i, .row = row, .sign = 1.0, .excess = forces(row) - range.upper(row)});
            }
            if (std::isfinite(range.lower(row))) {
                rows.push_back(
                    {.net = i, .row = row, .sign = -1.0, .excess = range.lower(row) - forces(row)});
            }
        }
    }
    return rows;
}

double StrokeProgram::excess_after(const Row& row, const Eigen::VectorXd& change) const {
    return row.excess + row.sign * m_force_rates[row.net].row(row.row).dot(change);
}

/// Few limits matter: those that are near are active at first. Those that the change would break
/// are added, until it breaks none.
std::optional<Eigen::VectorXd> StrokeProgram::change_holding_limits(
    const std::function<std::optional<Eigen::VectorXd>(const std::vector<Row>&)>& best) const {
    constexpr double near = 0.05;        // of the mean tension
    constexpr double negligible = 1e-9;  // of it
    std::vector<Row> others = all_rows();
    std::vector<Row> active;
    const auto activate = [&](const auto& is_needed) {
        const auto rest = std::stable_partition(others.begin(), others.end(),
                                                [&](const Row& row) { return !is_needed(row); });
        const bool is_any = rest != others.end();
        active.insert(active.end(), rest, others.end());
        others.erase(rest, others.end());
        return is_any;
    };
    activate([&](const Row& row) { return row.excess > -near * m_force_unit; });
    while (true) {
        std::optional<Eigen::VectorXd> change = best(active);
        if (!change || !activate([&](const Row& row) {
                return excess_after(row, *change) > negligible * m_force_unit;
            })) {
            return change;
        }
    }
}

void StrokeProgram::add_limits(ProgramRows& rows, const std::vector<Row>& limits,
                               int broken) const {
    for (size_t i = 0; i < limits.size(); ++i) {
        add_force_limit(rows, limits[i].excess,
                        limits[i].sign * m_force_rates[limits[i].net].row(limits[i].row),
                        m_force_unit, broken + static_cast<int>(i));
    }
}

std::optional<ProposedStrokes> StrokeProgram::solve(double radius) const {
    const Eigen::VectorXd& at = m_state->strokes;
    const Eigen::VectorXd low = (m_task->shortest - at).cwiseMax(-radius).cwiseMin(0.0);
    const Eigen::VectorXd high = (m_task->longest - at).cwiseMin(radius).cwiseMax(0.0);
    const std::optional<Eigen::VectorXd> change = change_holding_limits(
        [&](const std::vector<Row>& limits) { return best_change(low, high, limits); });
    if (!change) {
        return std::nullopt;
    }
    double violation = 0.0;
    for (const Row& row : all_rows()) {
        violation += std::max(0.0, excess_after(row, *change));
    }
    ProposedStrokes proposed{.strokes = at + *change};
    const double cost = cost_of(*m_task, m_deviations.values + m_deviations.rates * *change);
    proposed.merit = merit_of(*m_task, cost, proposed.strokes, violation);
    return proposed;
}

std::optional<Eigen::VectorXd> StrokeProgram::best_change(const Eigen::VectorXd& low,
                                                          const Eigen::VectorXd& high,
                                                          const std::vector<Row>& limits) const {
    const Eigen::VectorXd& at = m_state->strokes;
    const Eigen::Index k = at.size();

    // Columns: changes of the strokes, the excess over each limit, the largest deviation.
    const auto changes = static_cast<int>(k);
    const int broken = changes;
    const int largest = broken + static_cast<int>(limits.size());
    const int columns = largest + (is_largest() ? 1 : 0);

    const double turning = 2.0 * turning_weight / static_cast<double>(k);
    const Eigen::VectorXd deviation = m_deviations.values / program_length;
    ConicProgram program;
    Eigen::MatrixXd quadratic = Eigen::MatrixXd::Zero(k, k);
    program.q = Eigen::VectorXd::Zero(columns);
    if (!is_largest()) {
        quadratic = 2.0 * m_normal;
        program.q.head(k) =
            2.0 / static_cast<double>(m_nodes) * m_deviations.rates.transpose() * deviation;
    }
    quadratic.diagonal().array() += turning;
    program.q.head(k) += turning / program_length * at;
    program.P = upper_triangle(quadratic, columns);
    if (is_largest()) {
        program.P.coeffRef(largest, largest) = 2.0;
        program.P.makeCompressed();
    }
    const double penalty =
        m_task->violation_weight * m_force_unit / (program_length * program_length);
    program.q.segment(broken, static_cast<Eigen::Index>(limits.size())).setConstant(penalty);

    ProgramRows rows;
    add_stroke_bounds(rows, low, high);
    add_limits(rows, limits, broken);
    if (is_largest()) {
        for_each_target([&](Eigen::Index first, Eigen::Index count) {
            rows.begin_cone(static_cast<int>(count) + 1);
            rows.cone_row(0.0);
            rows.entry(largest, -1.0);
            for (Eigen::Index row = first; row < first + count; ++row) {
                rows.cone_row(deviation(row));
                for (int j = 0; j < changes; ++j) {
                    rows.entry(j, -m_deviations.rates(row, j));
                }
            }
        });
    }
    rows.write(program, columns);
    const ConicSolution solution = solve_conic(program, most_conic_iterations);
    if (solution.status != ConeStatus::solved && solution.status != ConeStatus::almost_solved) {
        return std::nullopt;
    }

    return (program_length * solution.x.head(k)).cwiseMax(low).cwiseMin(high);
}

std::optional<Eigen::VectorXd> StrokeProgram::least_turning(const Eigen::VectorXd& weights,
                                                            double radius) const {
    const std::optional<Eigen::VectorXd> change = change_holding_limits(
        [&](const std::vector<Row>& limits) { return least_change(weights, radius, limits); });
    return change ? std::optional<Eigen::VectorXd>(m_state->strokes + *change) : std::nullopt;
}

std::optional<Eigen::VectorXd> StrokeProgram::least_change(const Eigen::VectorXd& weights,
                                                           double radius,
                                                           const std::vector<Row>& limits) const {
    const Eigen::VectorXd& at = m_state->strokes;
    const Eigen::Index k = at.size();
    const Eigen::VectorXd low = (m_task->shortest - at).cwiseMax(-radius).cwiseMin(0.0);
    const Eigen::VectorXd high = (m_task->longest - at).cwiseMin(radius).cwiseMax(0.0);

    // Columns: changes of the strokes, absolute values of the strokes, the excess over each limit,
    // the excess of the deviation over its bound.
    const auto changes = static_cast<int>(k);
    const int sizes = changes;
    const int broken = 2 * changes;
    const int over_bound = broken + static_cast<int>(limits.size());
    const int columns = over_bound + 1;
    ConicProgram program;
    program.P.resize(columns, columns);
    program.q = Eigen::VectorXd::Zero(columns);
    program.q.segment(sizes, k) = weights;
    const double penalty = 1e3 * weights.maxCoeff();
    program.q.tail(columns - broken).setConstant(penalty);

    ProgramRows rows;
    add_stroke_bounds(rows, low, high);
    for (int j = 0; j < changes; ++j) {
        for (const double sign : {1.0, -1.0}) {  // +-(x_j + change) <= size
            rows.at_most(-sign * at(j) / program_length);
            rows.entry(j, sign);
            rows.entry(sizes + j, -1.0);
        }
    }
    add_limits(rows, limits, broken);
    rows.at_most(0.0);
    rows.entry(over_bound, -1.0);
    const double bound =
        m_task->form_tolerance * (is_largest() ? 1.0 : std::sqrt(static_cast<double>(m_nodes)));
    const auto add_cone = [&](const Eigen::MatrixXd& rates, const Eigen::VectorXd& deviation) {
        rows.begin_cone(static_cast<int>(deviation.size()) + 1);
        rows.cone_row(bound / program_length);
        rows.entry(over_bound, -1.0);
        for (Eigen::Index row = 0; row < deviation.size(); ++row) {
            rows.cone_row(deviation(row) / program_length);
            for (int j = 0; j < changes; ++j) {
                rows.entry(j, -rates(row, j));
            }
        }
    };
    const Eigen::VectorXd& deviation = m_deviations.values;
    const Eigen::MatrixXd& rates = m_deviations.rates;
    if (is_largest()) {
        for_each_target([&](Eigen::Index first, Eigen::Index count) {
            add_cone(rates.middleRows(first, count), deviation.segment(first, count));
        });
    } else {
        // The form, then the tensions.
        for (const auto& [first, count] :
             {std::pair(Eigen::Index{0}, 3 * m_nodes),
              std::pair(3 * m_nodes, deviation.size() - 3 * m_nodes)}) {
            if (count == 0) {
                continue;
            }
            // |Z x + z| = |R x + r| with the triangle of Z, z: as many rows as columns.
            Eigen::MatrixXd both(count, k + 1);
            both << rates.middleRows(first, count), deviation.segment(first, count);
            const Eigen::MatrixXd triangle = triangle_of(both);
            add_cone(triangle.leftCols(k), triangle.rightCols(1));
        }
    }
    rows.write(program, columns);
    const ConicSolution solution = solve_conic(program, most_conic_iterations);
    if (solution.status != ConeStatus::solved && solution.status != ConeStatus::almost_solved) {
        return std::nullopt;
    }
    return (program_length * solution.x.head(k)).cwiseMax(low).cwiseMin(high);
}

std::vector<ProposedStrokes> StrokeProgram::single_steps(double step) const {
    const Eigen::VectorXd& at = m_state->strokes;
    const double before = merit_of(*m_task, *m_state);
    std::vector<ProposedStrokes> better;
    for (Eigen::Index j = 0; j < at.size(); ++j) {
        for (const double change : {-step, step}) {
            ProposedStrokes proposed{.strokes = at};
            proposed.strokes(j) += change;
            const double slip = 1e-9 * step;
            if (proposed.strokes(j) < m_task->shortest(j) - slip ||
                proposed.strokes(j) > m_task->longest(j) + slip) {
                continue;
            }
            double violation = 0.0;
            for (size_t i = 0; i < m_responses->size(); ++i) {
                violation += (*m_responses)[i].range.violation(m_state->nets[i].forces +
                                                               change * m_force_rates[i].col(j));
            }
            const double cost =
                cost_of(*m_task, m_deviations.values + change * m_deviations.rates.col(j));
            proposed.merit = merit_of(*m_task, cost, proposed.strokes, violation);
            if (proposed.merit < before) {
                better.push_back(std::move(proposed));
            }
        }
    }
    std::ranges::sort(better, {}, &ProposedStrokes::merit);
    return better;
}

}  // namespace taut
