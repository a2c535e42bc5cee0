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

/// How a state of the work breaks limits that were kept before it began.
struct Harm {
    double excess = 0.0;  ///< of the estimate over its limits [mean tensions]; 0 if negligible
    int broken = 0;       ///< samples without a breach so far, in which a limit is broken now
    auto operator<=>(const Harm&) const = default;
    [[nodiscard]] bool is_none() const { return excess == 0.0 && broken == 0; }
};

/// An order of work in all samples.
struct DrawnWork {
    int kept = 0;                    ///< samples in which no step breaks a limit
    std::vector<int> first_broken;   ///< step that breaks one first, by sample; -1: none
    std::optional<WorstStep> worst;  ///< the limit that is broken in most samples, and when
};

/// Work under way: the strokes done, and the limits they break (turn-order). Later loads do not act
/// while the crews turn.
class OrderWork {
public:
    /// Keeps pointers to the arguments.
    OrderWork(const BuiltNet& built, const Limits& limits, const Plan& plan,
              const TurnOrderOptions& options);

    /// Back to the start, where nothing is turned.
    void restart();
    [[nodiscard]] const CableNet& net() const { return m_built->net; }
    [[nodiscard]] const Eigen::VectorXd& strokes() const { return m_strokes; }
    [[nodiscard]] StrokedNet at(const Eigen::VectorXd& strokes);
    /// Forces of samples are predicted: those of the estimate plus the sample's difference from it,
    /// interpolated between the start and the end of the work by the part that is turned.
    [[nodiscard]] Harm harm(const Eigen::VectorXd& strokes, const StrokedNet& net) const;
    /// harm() after stroke j becomes `stroke`, by the tangents before the work and after it.
    /// @param net at `strokes`
    [[nodiscard]] Harm predicted_harm(const Eigen::VectorXd& strokes, const StrokedNet& net,
                                      Eigen::Index j, double stroke) const;
    void accept(Eigen::VectorXd strokes, StrokedNet net);
    [[nodiscard]] const StrokedNet& now() const { return m_now; }

    /// The worst limit that the estimate breaks.
    [[nodiscard]] LimitBreach worst_breach(const StrokedNet& net) const;
    /// The worst limit that all strokes together break in the estimate by more than before.
    [[nodiscard]] const std::optional<LimitBreach>& breach_at_end() const {
        return m_breach_at_end;
    }

    /// Samples in which all strokes together break no limit.
    [[nodiscard]] int kept_at_end() const;
    /// Samples in which no limit was broken until now, by prediction, and none is at the end.
    [[nodiscard]] int predicted_kept() const;
    [[nodiscard]] Eigen::Index draws() const { return m_built->length_draws.cols(); }
    /// Exact equilibria of the samples wherever a limit may be broken, each with random errors of
    /// its own in what is turned.
    /// @param states strokes after each step, and the forces of the estimate then
    [[nodiscard]] DrawnWork drawn(
        const std::vector<std::pair<Eigen::VectorXd, Eigen::VectorXd>>& states) const;

private:
    [[nodiscard]] bool is_below(Eigen::Index row, double force) const;
    [[nodiscard]] LimitBreach breach(Eigen::Index row, double force, bool is_below) const;
    [[nodiscard]] Eigen::VectorXd excess_of(const Eigen::Ref<const Eigen::VectorXd>& forces) const;
    /// The part of all strokes that is done.
    [[nodiscard]] double part_of(const Eigen::VectorXd& strokes) const;
    /// The largest predicted excess of each sample over its limits, beyond its excess before the
    /// work; where it is below `least`, any value below that [N].
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

    Eigen::MatrixXd m_offset_before;  ///< samples x forces: less those of the estimate [N]
    Eigen::MatrixXd m_offset_end;
    Eigen::VectorXd m_least_offset;      ///< of both, over the samples [N]
    Eigen::VectorXd m_most_offset;       ///< likewise
    Eigen::MatrixXd m_allowed_in_draws;  ///< samples x forces [N]
    std::vector<char> m_has_no_form;     ///< samples without equilibrium before or after the work
    std::vector<char> m_lost_at_end;     ///< samples in which all strokes together break a limit
    std::vector<char> m_lost;            ///< those, and samples in which the work broke one
};

}  // namespace taut
