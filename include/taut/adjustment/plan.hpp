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
#include "taut/adjustment/tension_target.hpp"
#include "taut/error.hpp"
#include "taut/export/adjustment.hpp"
#include "taut/progress.hpp"

namespace taut {

/// A turn of a turnbuckle or jack.
struct TurnSize {
    double pitch = 0.0;     ///< change of length per turn [m]
    double smallest = 0.0;  ///< smallest part of a turn that a crew can do, 0 to 1; 0: any
    /// Change of length by the smallest part [m].
    [[nodiscard]] double step() const { return pitch * smallest; }
};

/// Form deviation that counts as much as a target tension off by its tolerance, by default [m].
inline constexpr double default_form_tolerance = 5e-3;

/// Which edges may be turned, what they are to reach besides the form, and with which probability
/// limits must be kept.
struct TAUT_ADJUSTMENT_EXPORT PlanOptions {
    std::vector<int> edges =
        {};                    ///< that may be turned, ascending; empty: the net's adjustable edges
    double confidence = 0.95;  ///< required probability that all limits are kept together
    double actuator_std = 0.0;          ///< standard deviation of a stroke from the planned one [m]
    std::optional<TurnSize> turn = {};  ///< empty: any stroke can be turned
    /// Turn the fewest edges with which the form comes so near: the root mean square of its
    /// deviations along the normal, or the largest of them, as the target's objective; and the
    /// target tensions, likewise, within their tolerances [m].
    std::optional<double> tolerance = {};
    /// A-priori standard deviation of targets that might be surveyed before turning. If given, and
    /// there are posterior samples, Plan::suggested_targets says which of them help most [m].
    std::optional<double> survey_noise = {};
    std::uint64_t seed = 1;  ///< of the random errors of the strokes
    /// Plan on an identification that failed its checks, too: to study it, not to turn by it.
    bool accept_failed = false;
    std::vector<TensionTarget> target_tensions = {};  ///< of edges of the net, ascending
    /// Form deviation, root mean square or largest, that counts as much as target tensions that are
    /// off by their tolerances; empty: `tolerance`, else default_form_tolerance [m].
    std::optional<double> form_tolerance = {};

    /// The form tolerance that holds [m].
    [[nodiscard]] double weighing_tolerance() const {
        return form_tolerance.value_or(tolerance.value_or(default_form_tolerance));
    }
};

/// The identification failed its checks, so no plan is made; the message says why it failed.
class TAUT_ADJUSTMENT_EXPORT FailedIdentification : public std::invalid_argument, public Error {
public:
    using std::invalid_argument::invalid_argument;
    [[nodiscard]] ErrorCode code() const noexcept override {
        return ErrorCode::failed_identification;
    }  ///< Error
};

/// One edge that is to be turned.
struct PlannedStroke {
    int edge = 0;         ///< index in the net
    double stroke = 0.0;  ///< change of its unstressed length [m]
};

/// A limit that is broken, or kept with too small a probability.
struct LimitBreach {
    /// What the limit is of.
    enum class Kind { tension, reaction };
    Kind kind = Kind::tension;  ///< tension of an edge, or reaction of a support
    int index = 0;              ///< an edge, or a support
    std::string load_case;      ///< empty: the loads of the net
    double value = 0.0;         ///< planned [N]
    double limit = 0.0;         ///< [N]
    double probability = 0.0;   ///< that the limit is kept; 0 or 1 without samples
};

/// A target whose survey would make the planned form better known.
struct SuggestedTarget {
    int node = 0;  ///< index of a free node
    /// Plan::normal_std after a survey of this and those before it [m].
    double normal_std = 0.0;
};

/// Which edges to turn how far, and the form and forces that follow.
struct TAUT_ADJUSTMENT_EXPORT Plan {
    std::vector<PlannedStroke> strokes;  ///< those that are not 0, by edge
    FormDeviation as_built;              ///< of the estimate, before anything is turned
    FormDeviation planned;               ///< of the estimate
    FormDeviation unconstrained;         ///< what remains with unlimited strokes, no edge slack
    std::vector<ReachedTension> target_tensions;  ///< one per target, in their order
    /// Standard deviation along the normal of the planned form, root mean square over the nodes:
    /// the uncertainty that another survey could reduce. 0 without samples [m].
    double normal_std = 0.0;
    /// With PlanOptions::survey_noise: at most ten, the most informative first. For other targets
    /// the samples show no significant gain.
    std::vector<SuggestedTarget> suggested_targets;
    Points form;               ///< planned (3 x n) [m]
    Eigen::MatrixXd form_std;  ///< 3 x n; 0 without samples [m]
    /// Covariance of each node's place, about the planned one; empty without samples (n) [m2].
    std::vector<Eigen::Matrix3d> form_covariance;
    Eigen::VectorXd tensions;       ///< planned (m) [N]
    Eigen::VectorXd tension_lower;  ///< of 95 % intervals (m); empty without samples [N]
    Eigen::VectorXd tension_upper;  ///< their upper ends (m); empty without samples [N]
    /// The effective limits: the given ones less the margin for uncertainty; of the net's loads,
    /// then of each load case.
    std::vector<ForceRange> effective_limits;
    int draws = 0;         ///< posterior samples that limits were kept in; 0: in the estimate alone
    int draws_needed = 0;  ///< of these must keep all limits for the confidence; 0 without samples
    std::string no_draws_because;             ///< why there are no samples
    std::optional<double> limit_probability;  ///< that all limits are kept; empty without samples
    bool is_feasible = false;    ///< all limits are kept, with the required probability
    bool has_converged = false;  ///< the search for strokes ended where no step promised a gain
    std::vector<LimitBreach> breaches;  ///< the worst first
    /// Normal RMS before strokes were rounded to whole steps [m].
    double normal_rmse_of_free_strokes = 0.0;
    std::optional<bool> is_within_tolerance;  ///< empty without PlanOptions::tolerance
    /// To first order no fewer edges reach the tolerance; empty where it is not reached.
    std::optional<int> fewest_bound;
    int iterations = 0;  ///< steps of the search for strokes

    /// The longest stroke, in absolute value; 0 where none is turned [m].
    [[nodiscard]] double largest_stroke() const;
    /// By how much the strokes lower the root mean square along the normal [m].
    [[nodiscard]] double gain() const { return as_built.normal_rmse - planned.normal_rmse; }
};

/// Strokes that bring a net near a target and keep its limits: first the limits, then the form and
/// the target tensions, then short strokes. docs/theory.md (stroke-program), (tension-targets);
/// docs/adjustment.md.
///
/// @param built in equilibrium; limits and options refer to its edges
/// @param target of the same net, which is not checked; its weights may all be 0 where there are
///   target tensions, which are then all that counts
/// @param progress gets the stage "planning"
/// @throws FailedIdentification where BuiltNet::failed_because is set and
///   PlanOptions::accept_failed is not
/// @throws RequestError for a form tolerance and for target tensions that are not positive, and for
///   those out of range, doubled or outside the limits of their edge
/// @throws std::invalid_argument as check_limits(), for edges out of range, doubled or none, a
///   confidence outside (0, 1), a tolerance or pitch that is not positive, a smallest part of a
///   turn outside [0, 1], samples of wrong size or too few for the confidence, an actuator_std
///   above a quarter of the shortest edge, a net without equilibrium, and where this taut was built
///   without the conic solver
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT Plan plan_strokes(const BuiltNet& built,
                                                       const FormTarget& target,
                                                       const Limits& limits,
                                                       const PlanOptions& options = {},
                                                       const Progress& progress = {});

}  // namespace taut
