// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "estimation/epoch_evidence.hpp"
#include "identification/epoch_changes.hpp"
#include "identification/maximum_a_posteriori.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/progress.hpp"

namespace taut {

/// Surveys of a net, one after another, and the evidence that each is for the others.
/// docs/theory.md, "Epochs".
class EpochChain {
public:
    /// Keeps references to net and epochs.
    /// @param prior of the interior edges' length deviations
    /// @param least_actuator_std of all adjustable edges at each survey; 0: those not turned are
    ///   known [m]
    /// @param changes known already: from these on lengths are changed, and turns have the
    ///   additional standard deviation
    EpochChain(const CableNet& net, std::span<const Epoch> epochs, const IdentifyOptions& options,
               const LengthPrior& prior, double least_actuator_std,
               const std::vector<EpochChanges>& changes = {});

    /// Fits each survey alone with adjustable lengths uncertain, and compares it with those before
    /// and the turns given. Lengths that changed are let go one after another, until none is left.
    /// @return false where a survey alone did not converge: then nothing was compared
    [[nodiscard]] bool find_changes(const Progress& progress);
    /// By survey.
    [[nodiscard]] const std::vector<EpochChanges>& changes() const { return m_changes; }

    /// Fits all surveys, each with the evidence of the others, until the lengths converge: evidence
    /// is linearised at the common lengths.
    /// @return last movement of the lengths in standard deviations, root mean square; none where
    ///   a survey did not converge
    [[nodiscard]] std::optional<double> converge(const Progress& progress);
    /// A movement below this counts as converged.
    static constexpr double still = 0.1;

    [[nodiscard]] int count() const { return static_cast<int>(m_states.size()); }
    /// reported_epoch()
    [[nodiscard]] int reported() const { return m_reported; }
    /// The net at a survey, its fit, and all that the fit was given.
    [[nodiscard]] const CableNet& net_at(int k) const { return m_states[k].net; }
    [[nodiscard]] const Survey& survey_at(int k) const { return m_states[k].survey; }
    [[nodiscard]] const Identification& found(int k) const { return m_states[k].found; }
    [[nodiscard]] Given given(int k) const;

private:
    struct State {
        CableNet net;
        Survey survey;  ///< without targets beside which a clamp may have slipped
        const std::vector<EdgeTurned>* turned;  ///< since the survey before
        const Points* loads;                    ///< Epoch::loads
        Eigen::VectorXd prior;                  ///< prior variances of x
        Eigen::VectorXd added;                  ///< variances of x since the survey before
        LengthEvidence earlier;                 ///< by the surveys before
        LengthEvidence later;                   ///< by the surveys after
        LengthEvidence own;
        Identification found;
    };
    [[nodiscard]] bool is_adjustable(int edge) const;
    [[nodiscard]] EpochStep step_from(size_t k) const;  ///< to the next
    /// Variances of x before any turn.
    /// @param stds of adjustable edges' lengths (m)
    [[nodiscard]] Eigen::VectorXd first_prior(const Eigen::VectorXd& stds) const;
    void add_variance(size_t k, int edge, double std_dev);
    /// Widens what these changes say.
    void allow(const std::vector<EpochChanges>& changes);
    void fit(size_t k, const Given& given, const Progress& progress);
    [[nodiscard]] Given given_for_form_alone(int k) const;
    [[nodiscard]] bool has_converged() const;
    [[nodiscard]] double movement_since(const Eigen::VectorXd& before) const;
    [[nodiscard]] Eigen::VectorXd last_lengths() const;
    /// Edges whose turns before a survey may scatter more than given: those turned, or where none
    /// are given, all adjustable ones.
    [[nodiscard]] std::vector<int> scattering_edges(size_t k) const;
    /// (epoch-slip) of a survey fitted by itself.
    [[nodiscard]] std::vector<SlipOrTarget> slips_or_targets(size_t k) const;
    /// Lets lengths at a survey be free from now on.
    void free_lengths(size_t k, const std::vector<LengthChange>& changed);

    const CableNet& m_net;
    IdentifyOptions m_options;
    LengthPrior m_prior;
    double m_widest_turn;     ///< widest_turn()
    bool m_has_actuator_std;  ///< whether lengths of adjustable edges are uncertain
    std::vector<UncertainParameter> m_uncertain;
    int m_reported;          ///< reported_epoch()
    EpochEntries m_entries;  ///< of x
    std::vector<State> m_states;
    std::vector<EpochChanges> m_changes;
};

}  // namespace taut
