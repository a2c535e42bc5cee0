// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "adjustment/stroke_search.hpp"
#include "taut/adjustment/plan.hpp"

namespace taut {

/// Forces and forms that strokes lead to, in each posterior sample of the built net.
struct DrawnStrokes {
    std::vector<Eigen::MatrixXd> forces;  ///< of each set of loads: StrokedNet::forces x draws [N]
    Eigen::MatrixXd forms;                ///< 3 n_I x draws, under the net's own loads [m]
    std::vector<char> unbalanced;         ///< 1 for a sample without equilibrium
};

/// The strokes that are turned in one sample: those planned, with a random error where not 0.
[[nodiscard]] Eigen::VectorXd strokes_with_errors(Eigen::VectorXd strokes, double actuator_std,
                                                  std::uint64_t seed, Eigen::Index draw);

/// In how many samples all limits must be kept so that they are with a probability `confidence`.
[[nodiscard]] int draws_needed(double confidence, Eigen::Index draws);

/// How one sample of a built net answers to strokes.
class DrawnResponse {
public:
    /// @param shared of the built net under some loads; it must outlive this, in one thread
    DrawnResponse(const BuiltNet& built, Eigen::Index draw, StrokeResponse& shared);
    DrawnResponse(const DrawnResponse&) = delete;
    DrawnResponse& operator=(const DrawnResponse&) = delete;

    /// As StrokeResponse::at(), of the sample.
    [[nodiscard]] StrokedNet at(const Eigen::VectorXd& strokes, const Points& start);

private:
    std::optional<CableNet> m_net;  ///< where more than lengths differ
    std::optional<StrokeResponse> m_own;
    StrokeResponse* m_response;
    Eigen::VectorXd m_lengths;
};

/// Exact equilibria of all samples under some strokes, each with random errors of its own.
[[nodiscard]] DrawnStrokes draw_strokes(const BuiltNet& built,
                                        const std::vector<LimitedResponse>& responses,
                                        const StrokedState& state, double actuator_std,
                                        std::uint64_t seed, const Progress& progress = {});

/// The margins that limits need to be kept in the samples, too (limit-margins).
class LimitMargins {
public:
    /// @param given the limits, one range a set of loads
    /// @param draws at the state
    LimitMargins(std::vector<ForceRange> given, const StrokedState& state,
                 const DrawnStrokes& draws);

    /// The part of the samples in which all limits are kept.
    [[nodiscard]] double probability() const;
    /// The margin that is missing for a probability `confidence` [standard deviations of each
    /// force]; negative: the margin could be smaller.
    [[nodiscard]] double shortfall(double confidence) const;
    /// Standard deviations of the forces, one vector a set of loads [N].
    [[nodiscard]] const std::vector<Eigen::VectorXd>& std_dev() const { return m_std; }
    /// The margin that the mean of the samples has to all limits [standard deviations].
    [[nodiscard]] double kept() const { return m_kept; }
    /// The given limits less a margin of `factor` standard deviations, corrected for the difference
    /// of the samples' mean from the state.
    [[nodiscard]] std::vector<ForceRange> narrowed(double factor) const;

private:
    std::vector<ForceRange> m_given;
    std::vector<Eigen::VectorXd> m_std;
    std::vector<Eigen::VectorXd> m_bias;
    double m_kept = 0.0;
    std::vector<double> m_worst;  ///< excess of each sample [standard deviations]; ascending
};

}  // namespace taut
