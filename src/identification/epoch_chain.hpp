// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "estimation/epoch_evidence.hpp"
#include "identification/maximum_a_posteriori.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/progress.hpp"

namespace taut {

/// What was turned until a survey, together.
[[nodiscard]] std::vector<EdgeTurned> turned_until(std::span<const Epoch> epochs, size_t k);

/// The net at a survey, turned and loaded, with its nodes in equilibrium: a fit begins there.
/// @throws std::runtime_error where it finds no equilibrium
[[nodiscard]] CableNet net_at_survey(const CableNet& net, std::span<const Epoch> epochs, size_t k);

/// Whether more lengths changed than can have: then the turns are wrong.
[[nodiscard]] bool are_too_many_changes(const CableNet& net, size_t changes);

/// Standard deviation of the length of an adjustable edge that nothing is known of [m].
[[nodiscard]] double widest_turn(const CableNet& net);

/// Surveys of a net, one after another, and the evidence that each is for the others.
/// docs/theory.md, "Epochs".
class EpochChain {
public:
    struct Changes {
        /// Since the survey before; of the first survey: of adjustable edges from the net. The
        /// largest first.
        std::vector<LengthChange> lengths;
        Agreement agreement;               ///< of all others
        double excess_actuator_std = 0.0;  ///< EpochResult::excess_actuator_std
        /// EpochResult::stroke_factor
        double stroke_factor = 1.0;
        double stroke_factor_std = 0.0;
        /// Whether that factor explains all: then no length is let go.
        bool is_of_all_turns = false;
        /// A strain in common of all interior edges, or those of a group, that chance does not
        /// explain.
        struct CommonStrain {
            std::string group;  ///< empty: of all
            double strain = 0.0;
            double std = 0.0;

            [[nodiscard]] double statistic() const { return std::abs(strain) / std; }
        };
        std::optional<CommonStrain> common_strain;

        /// By how many of its standard deviations the factor is not 1.
        [[nodiscard]] double stroke_factor_statistic() const {
            return stroke_factor_std > 0.0 ? std::abs(stroke_factor - 1.0) / stroke_factor_std
                                           : 0.0;
        }
        [[nodiscard]] bool are_strokes_off() const {
            return stroke_factor_statistic() > significant_std;
        }
    };

    /// @param prior of the interior edges' length deviations
    /// @param least_actuator_std of all adjustable edges at each survey; 0: those not turned are
    ///   known [m]
    /// @param changes known already: from these on lengths are changed, and turns have the
    ///   additional standard deviation
    EpochChain(const CableNet& net, std::span<const Epoch> epochs, const IdentifyOptions& options,
               const LengthPrior& prior, double least_actuator_std,
               const std::vector<Changes>& changes = {});

    /// Fits each survey alone with adjustable lengths uncertain, and compares it with those before
    /// and the turns given. Lengths that changed are let go one after another, until none is left.
    /// @return false where a survey alone did not converge: then nothing was compared
    [[nodiscard]] bool find_changes(const Progress& progress);
    [[nodiscard]] const std::vector<Changes>& changes() const { return m_changes; }  ///< by survey

    /// Fits all surveys, each with the evidence of the others, until the lengths converge: evidence
    /// is linearised at the common lengths.
    /// @return last movement of the lengths in standard deviations, root mean square; none where
    ///   a survey did not converge
    [[nodiscard]] std::optional<double> converge(const Progress& progress);
    /// A movement below this counts as converged.
    static constexpr double still = 0.1;

    /// How far the errors of two surveys differ, with the same lengths, relative to what they are:
    /// about 1. After converge(); 0 where they have too few targets in common.
    [[nodiscard]] double difference_ratio(size_t a, size_t b) const;

    [[nodiscard]] int count() const { return static_cast<int>(m_states.size()); }
    /// reported_epoch()
    [[nodiscard]] int reported() const { return m_reported; }
    /// The net at a survey, its fit, and all that the fit was given.
    [[nodiscard]] const CableNet& net_at(int k) const { return m_states[k].net; }
    [[nodiscard]] const Identification& found(int k) const { return m_states[k].found; }
    [[nodiscard]] Given given(int k) const;

private:
    struct State {
        CableNet net;
        const Survey* survey;
        const std::vector<EdgeTurned>* turned;  ///< since the survey before
        const Points* loads;                    ///< Epoch::loads
        Eigen::VectorXd prior;                  ///< prior variances of x
        Eigen::VectorXd added;                  ///< variances of x since the survey before
        LengthEvidence earlier;                 ///< by the surveys before
        LengthEvidence later;                   ///< by the surveys after
        LengthEvidence own;
        Identification found;
    };
    [[nodiscard]] Eigen::Index size() const {
        return static_cast<Eigen::Index>(m_edges.size()) + m_common;
    }
    [[nodiscard]] bool is_adjustable(int edge) const;
    [[nodiscard]] Eigen::Index place_of(int edge) const;  ///< in x
    [[nodiscard]] EpochStep step_from(size_t k) const;    ///< to the next
    /// Variances of x before any turn.
    /// @param stds of adjustable edges' lengths (m)
    [[nodiscard]] Eigen::VectorXd first_prior(const Eigen::VectorXd& stds) const;
    void add_variance(size_t k, int edge, double std);
    void let_go(const std::vector<Changes>& changes);
    void fit(size_t k, const Given& given, const Progress& progress);
    [[nodiscard]] Given given_for_form_alone(int k) const;
    [[nodiscard]] bool has_converged() const;
    [[nodiscard]] double movement_since(const Eigen::VectorXd& before) const;
    [[nodiscard]] Eigen::VectorXd last_lengths() const;
    /// @param edges that may have changed
    void find_changes_at(size_t k, EvidenceTest test, const std::vector<int>& edges);
    [[nodiscard]] bool explains_changes(const Changes& all_at_once,
                                        const std::vector<LengthChange>& let_go,
                                        const std::vector<EdgeTurned>& turned) const;
    [[nodiscard]] std::optional<Changes::CommonStrain> common_strain(
        const EvidenceTest& test, const std::vector<LengthChange>& let_go) const;
    void set_stroke_factor(Changes& changes, const EvidenceTest& test,
                           const std::vector<EdgeTurned>& turned) const;
    [[nodiscard]] std::optional<LengthChange> worst_change(const EvidenceTest::Changes& changes,
                                                           const std::vector<int>& edges) const;
    /// Edges turned before a survey; where none are given, all adjustable ones.
    [[nodiscard]] std::vector<int> turned_edges(size_t k) const;

    const CableNet& m_net;
    const IdentifyOptions& m_options;
    LengthPrior m_prior;
    double m_widest_turn;     ///< widest_turn()
    bool m_has_actuator_std;  ///< whether lengths of adjustable edges are uncertain
    std::vector<UncertainParameter> m_uncertain;
    int m_common;              ///< number of common parameters
    int m_reported;            ///< reported_epoch()
    std::vector<int> m_edges;  ///< with uncertain length
    std::vector<State> m_states;
    std::vector<Changes> m_changes;
};

}  // namespace taut
