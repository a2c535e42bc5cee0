// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/sampling/length_prior.hpp"

namespace taut {

/// One prior of a mixture.
struct PriorNode {
    LengthPrior prior;    ///< shape and scale
    double weight = 1.0;  ///< its posterior probability; all of a mixture sum to 1
};

/// What the deviations have in common, after the survey, docs/theory.md (length-trend).
struct CommonDeviation {
    double mean = 0.0;             ///< of all [m]
    double mean_std = 0.0;         ///< of that; 0: taken to be none [m]
    int runs = 0;                  ///< of cable, cable_runs(), whose lengths were tried for a scale
    double run_std = 0.0;          ///< of the scales of the runs, posterior mean, relative
    double run_probability = 0.0;  ///< that there are such scales
    double struts = 0.0;           ///< what all struts are longer than that [m]
    double struts_std = 0.0;       ///< of that; 0: struts share the mean of all [m]
    double adjustable = 0.0;       ///< what all adjustable edges are longer than given [m]
    double adjustable_std = 0.0;   ///< of that; 0: their lengths are taken as given [m]
};

/// The prior of the length deviations after the survey: a distribution over shapes and scales,
/// represented by the nodes of a quadrature, docs/theory.md (hyperprior), (prior-evidence).
struct PriorEstimate {
    LengthPrior given;                 ///< given, or assumed where none was
    bool exact = true;                 ///< taken as exact: the one node is it
    double std_dev = 0.0;              ///< posterior mean of the deviations' standard deviation [m]
    double std_std = 0.0;              ///< posterior standard deviation of that [m]
    double uniform_probability = 0.0;  ///< posterior probability of the uniform shape
    CommonDeviation common;            ///< of the most probable node
    std::vector<PriorNode> nodes;      ///< most probable first; at least one where estimated
};

/// A prior that is taken as exact.
[[nodiscard]] inline PriorEstimate exact_prior(const LengthPrior& prior) {
    return {.given = prior,
            .std_dev = prior.std_dev(),
            .uniform_probability = prior.kind == LengthPrior::Kind::uniform ? 1.0 : 0.0,
            .nodes = {{.prior = prior}}};
}

}  // namespace taut
