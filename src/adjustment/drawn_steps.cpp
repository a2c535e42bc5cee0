// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/drawn_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "adjustment/force_ranges.hpp"
#include "adjustment/stroke_program.hpp"

namespace taut {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Limits that no step brings nearer than this are left out [standard deviations].
constexpr double far_away = 0.5;

/// Strokes that change by one step each.
using Move = std::vector<std::pair<Eigen::Index, double>>;

Eigen::VectorXd after(const Move& move, Eigen::VectorXd strokes) {
    for (const auto& [j, change] : move) {
        strokes(j) += change;
    }
    return strokes;
}

/// A state with its samples (limit-margins), and the shortfall after moves, to first order.
class DrawnState {
public:
    DrawnState(std::vector<LimitedResponse>& responses, StrokedState state, double step,
               const DrawnLimits& limits)
        : m_state(std::move(state)) {
        const DrawnStrokes draws = limits.draws(m_state);
        const Eigen::Index count = draws.forms.cols();
        m_needed = draws_needed(limits.confidence, count);
        std::vector<ForceRange> ranges;
        ranges.reserve(responses.size());
        for (const LimitedResponse& limited : responses) {
            ranges.push_back(limited.range);
        }
        const LimitMargins margins(ranges, m_state, draws);
        const double slip =
            negligible_violation * std::max(1e-9, m_state.nets.front().equilibrium.mean_tension);
        std::vector<Eigen::VectorXd> excess;  // over a limit in each sample, last the estimate
        std::vector<Eigen::VectorXd> rates;
        Eigen::VectorXd worst = Eigen::VectorXd::Constant(count + 1, -infinity);
        for (size_t i = 0; i < responses.size(); ++i) {
            const StrokeRates by_stroke = responses[i].response.rates(m_state.nets[i]);
            const Eigen::VectorXd& std_dev = margins.std_dev()[i];
            for (Eigen::Index row = 0; row < std_dev.size(); ++row) {
                for (const double sign : {-1.0, 1.0}) {
                    const double limit = sign < 0.0 ? ranges[i].lower(row) : ranges[i].upper(row);
                    if (std::isinf(limit)) {
                        continue;
                    }
                    Eigen::VectorXd z(count + 1);
                    z.head(count) = draws.forces[i].row(row).transpose().array() - limit;
                    z(count) = m_state.nets[i].forces(row) - limit - sign * slip;
                    z *= sign / std_dev(row);
                    worst = worst.cwiseMax(z);
                    Eigen::VectorXd rate =
                        sign / std_dev(row) * by_stroke.forces.row(row).transpose();
                    if (z.maxCoeff() + 2.0 * step * rate.cwiseAbs().maxCoeff() > -far_away) {
                        excess.push_back(std::move(z));
                        rates.push_back(std::move(rate));
                    }
                }
            }
        }
        for (Eigen::Index d = 0; d < count; ++d) {
            if (draws.unbalanced[static_cast<size_t>(d)] != 0) {
                worst(d) = infinity;
            }
        }
        m_shortfall = m_state.balanced() ? shortfall_of(worst) : infinity;
        m_excess.resize(std::ssize(excess), count + 1);
        m_rates.resize(std::ssize(excess), m_state.strokes.size());
        for (Eigen::Index row = 0; row < m_excess.rows(); ++row) {
            m_excess.row(row) = excess[static_cast<size_t>(row)].transpose();
            m_rates.row(row) = rates[static_cast<size_t>(row)].transpose();
        }
    }

    [[nodiscard]] const StrokedState& state() const { return m_state; }

    /// The margin that is missing [standard deviations]; 0 or less where limits are kept.
    [[nodiscard]] double shortfall() const { return m_shortfall; }

    [[nodiscard]] double shortfall_after(const Move& move) const {
        Eigen::VectorXd change = Eigen::VectorXd::Zero(m_excess.rows());
        for (const auto& [j, stroke] : move) {
            change += stroke * m_rates.col(j);
        }
        Eigen::VectorXd worst = Eigen::VectorXd::Constant(m_excess.cols(), -far_away);
        for (Eigen::Index d = 0; d < worst.size() && change.size() > 0; ++d) {
            worst(d) = std::max(worst(d), (m_excess.col(d) + change).maxCoeff());
        }
        return shortfall_of(std::move(worst));
    }

private:
    /// @param worst excess of each sample, last of the estimate
    [[nodiscard]] double shortfall_of(Eigen::VectorXd worst) const {
        const auto last = worst.end() - 1;
        std::nth_element(worst.begin(), worst.begin() + (m_needed - 1), last);
        return std::max(worst(m_needed - 1), *last);
    }

    StrokedState m_state;
    int m_needed = 0;
    double m_shortfall = infinity;
    Eigen::MatrixXd m_excess;  ///< limits x (samples + 1) [standard deviations]
    Eigen::MatrixXd m_rates;   ///< limits x strokes [1/m]
};

std::vector<Move> single_moves(const StrokeTask& task, const Eigen::VectorXd& strokes,
                               double step) {
    std::vector<Move> moves;
    const double slip = 1e-9 * step;
    for (Eigen::Index j = 0; j < strokes.size(); ++j) {
        for (const double change : {-step, step}) {
            const double stroke = strokes(j) + change;
            if (stroke >= task.shortest(j) - slip && stroke <= task.longest(j) + slip) {
                moves.push_back({{j, change}});
            }
        }
    }
    return moves;
}

/// The moves that lower the shortfall, the best first: single steps, and pairs of the best of
/// them.
std::vector<Move> moves_to_limits(const DrawnState& at, const StrokeTask& task, double step) {
    constexpr size_t paired = 48;
    std::vector<std::pair<double, Move>> ranked;
    for (Move& move : single_moves(task, at.state().strokes, step)) {
        const double shortfall = at.shortfall_after(move);
        ranked.emplace_back(shortfall, std::move(move));
    }
    const auto by_shortfall = &std::pair<double, Move>::first;
    std::ranges::stable_sort(ranked, {}, by_shortfall);
    const size_t count = std::min(paired, ranked.size());
    for (size_t a = 0; a < count; ++a) {
        for (size_t b = 0; b < a; ++b) {
            Move both{ranked[a].second.front(), ranked[b].second.front()};
            if (both[0].first != both[1].first) {
                const double shortfall = at.shortfall_after(both);
                ranked.emplace_back(shortfall, std::move(both));
            }
        }
    }
    std::ranges::stable_sort(ranked, {}, by_shortfall);
    std::vector<Move> better;
    for (auto& [shortfall, move] : ranked) {
        if (shortfall < at.shortfall()) {
            better.push_back(std::move(move));
        }
    }
    return better;
}

}  // namespace

StrokedState steps_holding_draws(std::vector<LimitedResponse>& responses, const StrokeTask& task,
                                 const StrokedState& start, double step,
                                 const DrawnLimits& limits) {
    constexpr int most_moves = 100;
    constexpr size_t tries = 3;
    constexpr double smallest_gain = 1e-3;  // standard deviations
    DrawnState at(responses, start, step, limits);
    for (int moves = 0; moves < most_moves && at.state().balanced(); ++moves) {
        bool has_moved = false;
        std::vector<Move> better =
            at.shortfall() > 0.0 ? moves_to_limits(at, task, step) : std::vector<Move>{};
        for (size_t i = 0; i < std::min(tries, better.size()) && !has_moved; ++i) {
            DrawnState next(
                responses,
                state_at(responses, task, after(better[i], at.state().strokes), &at.state()), step,
                limits);
            if (next.shortfall() < at.shortfall() - smallest_gain) {
                at = std::move(next);
                has_moved = true;
            }
        }
        if (!has_moved) {
            break;
        }
    }
    return at.state();
}

}  // namespace taut
