// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "estimation/epoch_evidence.hpp"
#include "identification/maximum_a_posteriori.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/progress.hpp"

namespace taut {

/// The net with what was turned, its nodes where it then stands: a fit begins there.
/// @throws std::invalid_argument where it finds no equilibrium
[[nodiscard]] CableNet settled_net(const CableNet& net, std::span<const EdgeTurned> turned);

/// More lengths than this, and it is not they who changed.
[[nodiscard]] bool are_too_many_changes(const CableNet& net, size_t changes);

/// Standard deviation of the length of an adjustable edge of which nothing is told [m].
[[nodiscard]] double widest_turn(const CableNet& net);

/// Surveys of a net, one after the other, and what each tells the others of the lengths.
/// docs/theory.md, "Epochs".
class EpochChain {
public:
    /// @param law of the interior edges' length deviations
    /// @param least_play of all adjustable edges at each step; 0: those not turned are known [m]
    EpochChain(const CableNet& net, std::span<const Epoch> epochs, const IdentifyOptions& options,
               const LengthLaw& law, double least_play = 0.0);

    /// Each survey by itself, without what is told of adjustable edges, held against those before
    /// and what is told. Lengths that changed are let go one after the other, until none is left.
    void find_changes(const Progress& progress);
    struct Changes {
        std::vector<LengthChange> lengths;  ///< since the survey before, the worst first
        double ratio = 0.0;                 ///< EpochResult::change_ratio
        /// EpochResult::stroke_factor
        double stroke_factor = 1.0;
        double stroke_factor_std = 0.0;
    };
    /// One a survey; none of the first.
    [[nodiscard]] const std::vector<Changes>& changes() const { return m_changes; }
    /// Lets go of the interior edges among these.
    void let_go(const std::vector<Changes>& changes);

    /// Fits all surveys, each with what the others tell, until the lengths stand still: what a
    /// survey tells is linearised at the lengths that all tell together.
    /// @return false where a survey did not settle
    bool settle(const Progress& progress);

    [[nodiscard]] int count() const { return static_cast<int>(m_states.size()); }
    /// The net at a survey, its fit, and all that was told of it.
    [[nodiscard]] const CableNet& net_at(int k) const { return m_states[k].net; }
    [[nodiscard]] const Identification& found(int k) const { return m_states[k].found; }
    [[nodiscard]] Told told(int k) const;

private:
    struct State {
        CableNet net;
        const Survey* survey;
        const std::vector<EdgeTurned>* turned;  ///< since the survey before
        Eigen::VectorXd stds;    ///< of adjustable edges (m); empty where they are known
        EpochStep step;          ///< from here to the next
        LengthEvidence earlier;  ///< of the surveys before
        LengthEvidence later;    ///< of those behind
        LengthEvidence own;
        Identification found;
    };
    [[nodiscard]] Eigen::Index size() const {
        return static_cast<Eigen::Index>(m_edges.size()) + m_common;
    }
    [[nodiscard]] Eigen::VectorXd prior_of(const State& state) const;
    [[nodiscard]] EpochStep step_to(size_t k, const std::vector<EdgeTurned>& turned,
                                    double least_play) const;
    void let_go(size_t k, int edge);
    void fit(size_t k, const Told& told, const Progress& progress);
    [[nodiscard]] Told told_of_form_alone(int k) const;
    [[nodiscard]] bool has_settled() const;
    [[nodiscard]] Eigen::VectorXd last_lengths() const;
    void tell_stroke_factor(Changes& changes, const EvidenceTest& test,
                            const std::vector<EdgeTurned>& turned) const;
    [[nodiscard]] std::optional<LengthChange> worst_change(
        const EvidenceTest::Changes& changes) const;

    const CableNet& m_net;
    const IdentifyOptions& m_options;
    LengthLaw m_law;
    double m_widest_turn;  ///< widest_turn()
    std::vector<Unknown> m_unknowns;
    int m_common;              ///< unknowns common to many edges
    std::vector<int> m_edges;  ///< of unknown length
    std::vector<State> m_states;
    std::vector<Changes> m_changes;
};

}  // namespace taut
