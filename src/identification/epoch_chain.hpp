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
/// @throws std::runtime_error where it finds no equilibrium
[[nodiscard]] CableNet balanced_net(const CableNet& net, std::span<const EdgeTurned> turned);

/// More lengths than this, and it is not they who changed.
[[nodiscard]] bool are_too_many_changes(const CableNet& net, size_t changes);

/// Standard deviation of the length of an adjustable edge of which nothing is told [m].
[[nodiscard]] double widest_turn(const CableNet& net);

/// Surveys of a net, one after the other, and what each tells the others of the lengths.
/// docs/theory.md, "Epochs".
class EpochChain {
public:
    struct Changes {
        /// Since the survey before, of the first: of adjustable edges from the net; the worst
        /// first.
        std::vector<LengthChange> lengths;
        Agreement agreement;  ///< of all others
        double play = 0.0;    ///< EpochResult::excess_actuator_std
        /// EpochResult::stroke_factor
        double stroke_factor = 1.0;
        double stroke_factor_std = 0.0;
    };

    /// @param prior of the interior edges' length deviations
    /// @param least_actuator_std of all adjustable edges at each survey; 0: those not turned are known [m]
    /// @param changes that are known: lengths change from there on, and turns have as much more
    /// play
    EpochChain(const CableNet& net, std::span<const Epoch> epochs, const IdentifyOptions& options,
               const LengthPrior& prior, double least_actuator_std,
               const std::vector<Changes>& changes = {});

    /// Each survey by itself, without what is told of adjustable edges, held against those before
    /// and what is told. Lengths that changed are let go one after the other, until none is left.
    /// @return false where a survey by itself did not settle: then nothing was compared
    [[nodiscard]] bool find_changes(const Progress& progress);
    [[nodiscard]] const std::vector<Changes>& changes() const { return m_changes; }  ///< by survey

    /// Fits all surveys, each with what the others tell, until the lengths stand still: what a
    /// survey tells is linearised at the lengths that all tell together.
    /// @return how far they moved at last, in standard deviations, root mean square; none where a
    ///   survey did not settle
    [[nodiscard]] std::optional<double> settle(const Progress& progress);
    /// Of settle(): a movement below this is none.
    static constexpr double still = 0.1;

    /// How far the places of targets in both surveys differ, where the same lengths explain both,
    /// over what their noise lets expect: about 1. After settle(); 0 where too few are in both.
    [[nodiscard]] double difference_ratio(size_t a, size_t b) const;

    [[nodiscard]] int count() const { return static_cast<int>(m_states.size()); }
    /// The net at a survey, its fit, and all that was told of it.
    [[nodiscard]] const CableNet& net_at(int k) const { return m_states[k].net; }
    [[nodiscard]] const Identification& found(int k) const { return m_states[k].found; }
    [[nodiscard]] Given told(int k) const;

private:
    struct State {
        CableNet net;
        const Survey* survey;
        const std::vector<EdgeTurned>* turned;  ///< since the survey before
        Eigen::VectorXd prior;                  ///< variances of x before any survey
        Eigen::VectorXd added;                  ///< variances of x since the survey before
        LengthEvidence earlier;                 ///< of the surveys before
        LengthEvidence later;                   ///< of those behind
        LengthEvidence own;
        Identification found;
    };
    [[nodiscard]] Eigen::Index size() const {
        return static_cast<Eigen::Index>(m_edges.size()) + m_common;
    }
    [[nodiscard]] bool is_adjustable(int edge) const;
    [[nodiscard]] Eigen::Index place_of(int edge) const;  ///< in x
    [[nodiscard]] EpochStep step_from(size_t k) const;    ///< to the next
    /// Variances of x before anything was turned.
    /// @param stds of adjustable edges' lengths (m)
    [[nodiscard]] Eigen::VectorXd first_prior(const Eigen::VectorXd& stds) const;
    void add_variance(size_t k, int edge, double std);
    void let_go(const std::vector<Changes>& changes);
    void fit(size_t k, const Given& told, const Progress& progress);
    [[nodiscard]] Given given_for_form_alone(int k) const;
    [[nodiscard]] bool has_converged() const;
    [[nodiscard]] double movement_since(const Eigen::VectorXd& before) const;
    [[nodiscard]] Eigen::VectorXd last_lengths() const;
    /// @param edges that may have changed
    void find_changes_at(size_t k, EvidenceTest test, const std::vector<int>& edges);
    void set_stroke_factor(Changes& changes, const EvidenceTest& test,
                            const std::vector<EdgeTurned>& turned) const;
    [[nodiscard]] std::optional<LengthChange> worst_change(const EvidenceTest::Changes& changes,
                                                           const std::vector<int>& edges) const;
    /// Edges that were turned before a survey; where none was told, all that could have been.
    [[nodiscard]] std::vector<int> turned_edges(size_t k) const;

    const CableNet& m_net;
    const IdentifyOptions& m_options;
    LengthPrior m_prior;
    double m_widest_turn;  ///< widest_turn()
    bool m_has_actuator_std;       ///< whether lengths of adjustable edges are unknown
    std::vector<UncertainParameter> m_uncertain;
    int m_common;              ///< uncertain common to many edges
    std::vector<int> m_edges;  ///< of unknown length
    std::vector<State> m_states;
    std::vector<Changes> m_changes;
};

}  // namespace taut
