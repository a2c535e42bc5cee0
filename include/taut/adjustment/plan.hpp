// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "taut/adjustment/built_net.hpp"
#include "taut/adjustment/form_target.hpp"
#include "taut/adjustment/limits.hpp"
#include "taut/export/adjustment.hpp"
#include "taut/progress.hpp"

namespace taut {

/// What a crew can turn by.
struct TurnSize {
    double pitch = 0.0;     ///< change of length by one turn [m]
    double smallest = 0.0;  ///< smallest part of a turn that a crew can do, 0 to 1; 0: any
    /// Change of length by the smallest part [m].
    [[nodiscard]] double step() const { return pitch * smallest; }
};

/// Which edges may be turned, and how surely limits are to hold.
struct PlanOptions {
    std::vector<int> edges =
        {};                    ///< that may be turned, ascending; empty: the net's adjustable edges
    double confidence = 0.95;  ///< that all limits are kept together, over the draws
    double actuator_std = 0.0;          ///< of what is turned, from what was told [m]
    std::optional<TurnSize> turn = {};  ///< empty: any stroke can be turned
    /// The fewest edges are turned with which the form comes so near: the root of the mean square
    /// of its deviations along the normal, or the largest of them, as the target's objective [m].
    std::optional<double> tolerance = {};
    /// Noise of targets that might be surveyed before turning: which ones tell most of the planned
    /// form is told, where there are draws [m].
    std::optional<double> survey_noise = {};
    std::uint64_t seed = 1;  ///< of the play of the turnbuckles
    /// Plan on an identification that failed its tests, too: to study it, not to turn by it.
    bool accept_failed = false;
};

/// Refuses to plan on an identification that failed its tests: the message tells why it did.
class TAUT_ADJUSTMENT_EXPORT FailedIdentification : public std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// One edge that is to be turned.
struct PlannedStroke {
    int edge = 0;         ///< index in the net
    double stroke = 0.0;  ///< change of its unstressed length [m]
};

/// A limit that is not kept, or not surely so.
struct LimitBreach {
    /// Of what force the limit is.
    enum class Kind { tension, reaction };
    Kind kind = Kind::tension;  ///< tension of an edge, or reaction of a support
    int index = 0;              ///< an edge, or a support
    std::string load_case;      ///< empty: the loads of the net
    double value = 0.0;         ///< planned [N]
    double limit = 0.0;         ///< [N]
    double probability = 0.0;   ///< that the limit is kept; 0 or 1 without draws
};

/// A target that tells of the planned form what is not known yet.
struct FurtherTarget {
    int node = 0;  ///< index of a free node
    /// Plan::normal_std after a survey of this and those before it [m].
    double normal_std = 0.0;
};

/// Which edges to turn how far, and what comes of it.
struct TAUT_ADJUSTMENT_EXPORT Plan {
    std::vector<PlannedStroke> strokes;  ///< those that are not 0, by edge
    FormDeviation as_built;              ///< of the estimate, before anything is turned
    FormDeviation planned;               ///< of the estimate
    FormDeviation unconstrained;         ///< what strokes without limits leave, no edge slack
    /// Root of the mean square, over nodes and draws, of what the deviation along the normal
    /// differs from the planned one: not known yet, rather than not to be had. 0 without draws [m].
    double normal_std = 0.0;
    /// Where PlanOptions::survey_noise is told: at most ten, those that tell most first. Of other
    /// targets the draws do not show that they tell anything.
    std::vector<FurtherTarget> further_targets;
    Points form;                    ///< planned (3 x n) [m]
    Eigen::MatrixXd form_std;       ///< 3 x n; 0 without draws [m]
    Eigen::VectorXd tensions;       ///< planned (m) [N]
    Eigen::VectorXd tension_lower;  ///< 95 % intervals over the draws (m); empty without [N]
    Eigen::VectorXd tension_upper;  ///< their upper ends (m); empty without [N]
    /// The limits that were held: narrower than those told by what holds them in the draws, too;
    /// of the net's loads, then of each load case.
    std::vector<ForceRange> held;
    int draws = 0;               ///< that limits were held for; 0: for the estimate alone
    std::string no_draws_since;  ///< where there are none
    std::optional<double> limit_probability;  ///< that all limits are kept; empty without draws
    bool is_feasible = false;                 ///< all limits are kept, with the confidence wanted
    bool has_converged = false;  ///< the search for strokes ended where no step promised to help
    std::vector<LimitBreach> breaches;  ///< the worst first
    /// Cost of whole steps: normal RMS with free strokes; that of `planned` where there are no
    /// steps [m].
    double normal_rmse_of_free_strokes = 0.0;
    /// Where a tolerance was told: whether it is reached, and a number of edges below which, to
    /// first order, it cannot be.
    std::optional<bool> is_within_tolerance;
    std::optional<int> fewest_bound;  ///< where it is
    int iterations = 0;               ///< steps of that search

    /// The size of the longest stroke; 0 where none is turned [m].
    [[nodiscard]] double largest_stroke() const;
};

/// Strokes that bring a net near a target and keep its limits: first the limits, then the form,
/// then little turning. docs/theory.md (stroke-program); docs/adjustment.md.
///
/// @param built in equilibrium; limits and options tell of its edges
/// @param target of the same net, which is not checked
/// @param progress told of the stage "planning"
/// @throws FailedIdentification where `built` is of one, and PlanOptions::accept_failed is not set
/// @throws std::invalid_argument as check_limits(), for edges out of range, doubled or none, a
///   confidence outside (0, 1), a tolerance or pitch that is not positive, a smallest part of a
///   turn outside [0, 1], draws of wrong size or too few for the confidence, play of the
///   actuators beyond a quarter of the shortest edge, a net that finds no equilibrium, and where
///   this taut was built without the conic solver
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT Plan plan_strokes(const BuiltNet& built,
                                                       const FormTarget& target,
                                                       const Limits& limits,
                                                       const PlanOptions& options = {},
                                                       const Progress& progress = {});

}  // namespace taut
