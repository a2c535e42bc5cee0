// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "estimation/common_parameters.hpp"
#include "estimation/observations.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"
#include "taut/survey/forces.hpp"

namespace taut {

/// All that a fit is given besides net and survey.
struct PriorKnowledge {
    std::vector<LengthPrior> priors;  ///< of each interior edge's length deviation (m_I)
    std::vector<UncertainParameter> uncertain;
    Forces forces;
    bool frame_is_unknown = false;                   ///< of the survey
    Points test_loads = Points(3, 0);                ///< of the survey, in the net's loads [N]
    std::shared_ptr<const LengthEvidence> evidence;  ///< of other surveys; null: none
    /// Tension of a stretch that slides, (slips).
    struct StretchTension {
        std::vector<int> edges;
        std::vector<double> shares;  ///< tension of each edge in the middle, in that of the stretch
        double mean = 0.0;           ///< [N]
        double friction = 0.0;       ///< largest coefficient
        double scatter = 0.0;  ///< standard deviation of the tension of each edge, as a part of it

        /// Standard deviation of the tension: so wide that nothing is assumed of it [N].
        [[nodiscard]] double unit() const { return 3.0 * mean; }
    };
    std::vector<StretchTension> stretches = {};  ///< in the order of sliding_stretches()

    /// One prior for all lengths, and nothing else but where runs slide.
    PriorKnowledge(const CableNet& net, const LengthPrior& prior);

    /// Takes the tensions of stretches that a fit found as those that friction is a part of.
    /// @param common its common parameters' values
    /// @return whether any differs by more than a fifth, so that the fit is not one under them
    bool take_up_tensions(const CommonParameters& parameters, const Eigen::VectorXd& common);
    /// Root mean square of the priors' standard deviations [m].
    [[nodiscard]] double length_std() const;
    /// Corrects which edges (m) are assumed slack: by the marks, and by force measurements more
    /// than four standard deviations above zero.
    /// @param rejected_forces by force measurement; empty: none
    [[nodiscard]] std::vector<bool> as_seen(std::vector<bool> slack,
                                            const std::vector<bool>& rejected_forces = {}) const;
};

/// The priors of the net's own interior edges (m_I); the fit may have more interior edges.
[[nodiscard]] std::vector<LengthPrior> interior_priors(const CableNet& net,
                                                       const PriorKnowledge& knowledge);

/// A survey with its supports as targets like the others.
[[nodiscard]] Survey with_supports(const CableNet& net, const Survey& survey);

/// Adds a force measurement. What it shares with others is a part of the measured tension, so that
/// the misfit is linear in it; where no parameter holds it, it is a part of the measurement's own
/// error. docs/theory.md, (shared-error).
void observe_force(const ForceMeasurement& force, const std::vector<UncertainParameter>& uncertain,
                   Observations& result);

/// A survey without rejected targets (one flag a node), with all prior knowledge, docs/theory.md
/// (prior), (uncertain-parameters), (force-measurement).
/// @param common_parameters their number
[[nodiscard]] Observations observe(const CableNet& net, const Survey& survey, const Points& noise,
                                   const std::vector<bool>& rejected,
                                   const PriorKnowledge& knowledge, int common_parameters);

}  // namespace taut
