// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <compare>
#include <optional>
#include <utility>
#include <vector>

#include "adjustment/stroke_search.hpp"
#include "taut/adjustment/turn_order.hpp"

namespace taut {

/// What a state of the work does to limits that were kept before it began.
struct Harm {
    double excess = 0.0;  ///< of the estimate: beyond its limits [mean tensions]; 0 if negligible
    int broken = 0;       ///< draws, kept so far, in which a limit is broken now
    auto operator<=>(const Harm&) const = default;
    [[nodiscard]] bool is_none() const { return excess == 0.0 && broken == 0; }
};

/// What comes of an order of work in all draws.
struct DrawnWork {
    int kept = 0;                      ///< draws in which no step breaks a limit kept before
    std::optional<WorstMoment> worst;  ///< the limit that is broken in most draws, and when
};

/// Work under way: the strokes done, and which limits they break that were kept before
/// (turn-order). Later loads do not act yet while the crews turn.
class OrderWork {
public:
    /// Keeps pointers to the arguments.
    OrderWork(const BuiltNet& built, const Limits& limits, const Plan& plan,
              const TurnOrderOptions& options);

    /// Back to where nothing is turned yet.
    void restart();
    [[nodiscard]] const Eigen::VectorXd& strokes() const { return m_strokes; }
    [[nodiscard]] StrokedNet at(const Eigen::VectorXd& strokes);
    /// Of draws their forces are predicted: those of the estimate, with the difference that a draw
    /// has before the work and after it, in between by the part that is turned.
    [[nodiscard]] Harm harm(const Eigen::VectorXd& strokes, const StrokedNet& net) const;
    /// The same after stroke j becomes `stroke`, by the tangents before the work and after it.
    /// @param net at `strokes`
    [[nodiscard]] Harm predicted_harm(const Eigen::VectorXd& strokes, const StrokedNet& net,
                                      Eigen::Index j, double stroke) const;
    void accept(Eigen::VectorXd strokes, StrokedNet net);
    [[nodiscard]] const StrokedNet& now() const { return m_now; }

    /// The worst limit that the estimate breaks.
    [[nodiscard]] LimitBreach worst_breach(const StrokedNet& net) const;
    /// The worst limit that all strokes together break in the estimate, and that was kept before,
    /// or by more.
    [[nodiscard]] const std::optional<LimitBreach>& breach_at_end() const {
        return m_breach_at_end;
    }

    /// Draws in which all strokes together break no limit.
    [[nodiscard]] int kept_at_end() const;
    /// Draws in which no limit was broken until now, as predicted, and none is when all is done.
    [[nodiscard]] int predicted_kept() const;
    [[nodiscard]] Eigen::Index draws() const { return m_built->length_draws.cols(); }
    /// Exact equilibria of the draws wherever a limit may be broken, each with its own play of what
    /// is turned.
    /// @param states strokes after each moment, and the forces of the estimate then
    [[nodiscard]] DrawnWork drawn(
        const std::vector<std::pair<Eigen::VectorXd, Eigen::VectorXd>>& states) const;

private:
    [[nodiscard]] bool is_below(Eigen::Index row, double force) const;
    [[nodiscard]] LimitBreach breach(Eigen::Index row, double force, bool is_below) const;
    [[nodiscard]] Eigen::VectorXd beyond(const Eigen::Ref<const Eigen::VectorXd>& forces) const;
    /// The part of all strokes that is done.
    [[nodiscard]] double part_of(const Eigen::VectorXd& strokes) const;
    /// The most by which each draw is predicted to be beyond its limits and was not before, where
    /// that is more than `least`; else less than that [N].
    /// @param forces of the estimate
    [[nodiscard]] Eigen::VectorXd predicted_excess(const Eigen::VectorXd& strokes,
                                                   const Eigen::VectorXd& forces,
                                                   double least) const;
    [[nodiscard]] Harm harm_of(const Eigen::VectorXd& strokes, const Eigen::VectorXd& forces) const;
    [[nodiscard]] std::vector<char> broken_draws(const Eigen::VectorXd& strokes,
                                                 const Eigen::VectorXd& forces) const;
    void draw(const TurnOrderOptions& options, const StrokedNet& end);

    const BuiltNet* m_built;
    const Limits* m_limits;
    TurnOrderOptions m_options;
    std::vector<LimitedResponse> m_response;
    Eigen::VectorXd m_all;  ///< strokes of the plan [m]
    Eigen::VectorXd m_strokes;
    StrokedNet m_now;
    StrokedNet m_before;
    Eigen::VectorXd m_allowed;       ///< of the estimate [N]
    Eigen::MatrixXd m_rates_before;  ///< of its forces, forces x strokes [N/m]
    Eigen::MatrixXd m_rates_end;
    std::optional<LimitBreach> m_breach_at_end;
    double m_unit = 1.0;  ///< mean tension [N]

    Eigen::MatrixXd m_offset_before;  ///< draws x forces: less those of the estimate [N]
    Eigen::MatrixXd m_offset_end;
    Eigen::VectorXd m_least_offset;      ///< of both, over the draws [N]
    Eigen::VectorXd m_most_offset;       ///< likewise
    Eigen::MatrixXd m_allowed_in_draws;  ///< draws x forces [N]
    std::vector<char> m_has_no_form;     ///< draws without equilibrium before the work or after it
    std::vector<char> m_lost_at_end;     ///< draws in which all strokes together break a limit
    std::vector<char> m_lost;            ///< those, and what the work broke until now
};

}  // namespace taut
