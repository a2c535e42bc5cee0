// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "estimation/common_parameters.hpp"
#include "estimation/observations.hpp"
#include "estimation/saddle_point_layout.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"
#include "taut/survey/forces.hpp"

namespace taut {

/// What is told besides net and survey.
struct PriorKnowledge {
    std::vector<LengthPrior> priors;  ///< of each interior edge's length deviation (m_I)
    std::vector<UncertainParameter> uncertain;
    Forces forces;
    bool frame_is_unknown = false;                   ///< of the survey
    BoundaryReleases released;                       ///< what was found not to be as told
    std::shared_ptr<const LengthEvidence> evidence;  ///< of other surveys; null: there is none

    /// One prior for all, and nothing else.
    PriorKnowledge(const CableNet& net, const LengthPrior& prior)
        : priors(net.interior_edge_count(), prior) {}

    [[nodiscard]] Lengths coupling() const {
        return evidence ? Lengths::coupled : Lengths::independent;
    }
    /// Root mean square standard deviation of the priors [m].
    [[nodiscard]] double length_std() const;
    /// Corrects which edges (m) are taken to be slack by what was seen; and by what was read, where
    /// that is more than four standard deviations above nothing.
    /// @param rejected_forces by reading; empty: none
    [[nodiscard]] std::vector<bool> as_seen(std::vector<bool> slack,
                                            const std::vector<bool>& rejected_forces = {}) const;
};

/// Of the net's own interior edges (m_I), where those of the fit may be more.
[[nodiscard]] std::vector<LengthPrior> interior_priors(const CableNet& net,
                                                       const PriorKnowledge& knowledge);

/// A survey with its supports as targets like others.
[[nodiscard]] Survey with_supports(const CableNet& net, const Survey& survey);

/// A survey without the targets that are rejected (one flag a node), and all that is known besides,
/// docs/theory.md (prior), (uncertain-parameters), (force-measurement).
/// @param common_parameters how many there are
[[nodiscard]] Observations observe(const CableNet& net, const Survey& survey, const Points& noise,
                                   const std::vector<bool>& rejected,
                                   const PriorKnowledge& knowledge, int common_parameters);

}  // namespace taut
