// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "adjustment/stroke_search.hpp"
#include "taut/adjustment/plan.hpp"

namespace taut {

/// What strokes lead to in each draw of the built net.
struct DrawnStrokes {
    std::vector<Eigen::MatrixXd> forces;  ///< of each set of loads: StrokedNet::forces x draws [N]
    Eigen::MatrixXd forms;                ///< 3 n_I x draws, under the net's own loads [m]
    std::vector<char> unbalanced;         ///< of each draw: no equilibrium was found
};

/// What is turned for the strokes of a plan, in one draw: of those that are not 0.
[[nodiscard]] Eigen::VectorXd strokes_with_play(Eigen::VectorXd strokes, double actuator_std,
                                                std::uint64_t seed, Eigen::Index draw);

/// How many of some draws must keep all limits so that these hold with a confidence.
[[nodiscard]] int draws_needed(double confidence, Eigen::Index draws);

/// How one draw of a built net answers to strokes.
class DrawnResponse {
public:
    /// @param shared of the built net under some loads; it must live as long, in one thread
    DrawnResponse(const BuiltNet& built, Eigen::Index draw, StrokeResponse& shared);
    DrawnResponse(const DrawnResponse&) = delete;
    DrawnResponse& operator=(const DrawnResponse&) = delete;

    /// As StrokeResponse::at(), of the draw.
    [[nodiscard]] StrokedNet at(const Eigen::VectorXd& strokes, const Points& start);

private:
    std::optional<CableNet> m_net;  ///< where more than lengths differs
    std::optional<StrokeResponse> m_own;
    StrokeResponse* m_response;
    Eigen::VectorXd m_lengths;
};

/// Exact equilibria of all draws under some strokes, each with its own play of what is turned.
[[nodiscard]] DrawnStrokes draw_strokes(const BuiltNet& built,
                                        const std::vector<LimitedResponse>& responses,
                                        const StrokedState& state, double actuator_std,
                                        std::uint64_t seed);

/// What of the limits must be kept free so that they hold in draws, too (limit-margins).
class LimitMargins {
public:
    /// @param told the limits, one range a set of loads
    /// @param draws at the state
    LimitMargins(std::vector<ForceRange> told, const StrokedState& state,
                 const DrawnStrokes& draws);

    /// The part of the draws in which all limits are kept.
    [[nodiscard]] double probability() const;
    /// By how many standard deviations of each force the limits would have to be narrower
    /// (negative: may be wider) so that they hold with a confidence.
    [[nodiscard]] double shortfall(double confidence) const;
    /// Standard deviations of the forces, one vector a set of loads [N].
    [[nodiscard]] const std::vector<Eigen::VectorXd>& std() const { return m_std; }
    /// By how many standard deviations of each force the mean of the draws keeps all limits.
    [[nodiscard]] double kept() const { return m_kept; }
    /// Limits that are `factor` standard deviations inside those told, and corrected for the
    /// difference of the draws' mean from the state.
    [[nodiscard]] std::vector<ForceRange> narrowed(double factor) const;

private:
    std::vector<ForceRange> m_told;
    std::vector<Eigen::VectorXd> m_std;
    std::vector<Eigen::VectorXd> m_bias;
    double m_kept = 0.0;
    std::vector<double> m_worst;  ///< of each draw, in standard deviations beyond; ascending
};

}  // namespace taut
