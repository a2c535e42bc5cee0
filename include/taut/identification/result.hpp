// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/estimation/detectable.hpp"
#include "taut/estimation/diagnostics.hpp"
#include "taut/estimation/edge_status.hpp"
#include "taut/estimation/outlier.hpp"
#include "taut/estimation/prior_estimate.hpp"
#include "taut/export/core.hpp"
#include "taut/identification/parameter_estimate.hpp"
#include "taut/identification/posterior_draws.hpp"
#include "taut/identification/trust.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/survey/survey.hpp"
#include "taut/survey/turned_net.hpp"

namespace taut {

/// How an identification ended.
enum class IdentificationStatus {
    converged,
    iteration_limit,      ///< lengths and form still moved
    survey_does_not_fit,  ///< more targets contradict the rest than can have
    survey_not_exact,     ///< taken for exact, but no lengths of the prior give its form
    no_equilibrium,       ///< the identified lengths find none: there is no predicted form
};

/// "converged", "iteration limit", "survey does not fit", "survey not exact", "no equilibrium".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(IdentificationStatus status);

/// Posterior of one interior edge's unstressed length.
struct IdentifiedEdge {
    int edge = 0;                                ///< index in the net
    double nominal = 0.0;                        ///< unstressed length as designed [m]
    double length_deviation = 0.0;               ///< estimate of true minus nominal [m]
    double std_dev = 0.0;                        ///< standard deviation of the estimate [m]
    double lower = 0.0;                          ///< 95 % interval of the length deviation [m]
    double upper = 0.0;                          ///< its upper end [m]
    EdgeStatus status = EdgeStatus::determined;  ///< whether the survey determines its length
};

/// Posterior of a stretch of cable that slides, from clamp to clamp: of its edges only their sum is
/// determined.
struct StretchLength {
    std::vector<int> edges;         ///< edge by edge, adjustable ones among them
    double nominal = 0.0;           ///< unstressed length as designed [m]
    double friction = 0.0;          ///< largest coefficient that the fit allowed for
    double length_deviation = 0.0;  ///< estimate of true minus nominal [m]
    double std_dev = 0.0;           ///< standard deviation of the estimate [m]
    double tension = 0.0;           ///< mean of its edges [N]
    double tension_std = 0.0;       ///< standard deviation of that [N]
};

/// Posterior covariances between the lengths of some interior edges.
struct LengthCovariance {
    std::vector<int> edges;  ///< k, in the order in which they were asked for
    /// k x k: the correlations of the fit linearised at the result, (covariance) of docs/theory.md,
    /// times the standard deviations of IdentifiedEdge, which the prior itself cuts [m2].
    Eigen::MatrixXd covariance;
};

/// An uncertain parameter of an identification.
struct Assumption {
    UncertainParameter parameter;  ///< with its standard deviation before the survey
    bool is_default = false;       ///< assumed by taut, not given
    bool is_testable =
        false;  ///< whether the survey shows any number of it: else it is taken as is
};

/// Offset of a survey's frame from the net's, where it was unknown: a rotation about a point, then
/// a translation, both small.
struct TAUT_CORE_EXPORT FrameOffset {
    Eigen::Vector3d about;            ///< [m]
    Eigen::Vector3d translation;      ///< [m]
    Eigen::Vector3d translation_std;  ///< [m]
    Eigen::Vector3d rotation;         ///< about x, y and z [rad]
    Eigen::Vector3d rotation_std;     ///< [rad]

    /// Displacement of these places by it, to first order (3 x n) [m].
    [[nodiscard]] Points motion_of(const Points& places) const;
};

/// A length that differs between two consecutive surveys, apart from the turns.
struct LengthChange {
    int edge = 0;            ///< index in the net; of the first survey: an adjustable edge
    double change = 0.0;     ///< when it was set free [m]
    double std_dev = 0.0;    ///< [m]
    double statistic = 0.0;  ///< in standard deviations, when it was detected
};

/// One survey of several, by all together.
struct EpochResult {
    int surveyed = 0;                ///< free nodes
    std::vector<EdgeTurned> turned;  ///< since the survey before
    /// Loads that hung on the net at this survey alone, sum of their magnitudes [N].
    double load = 0.0;
    std::vector<Outlier> outliers;                   ///< targets left out, the worst first
    std::vector<BoundaryOutlier> boundary_outliers;  ///< different from the design; the worst first
    std::optional<FrameOffset> frame_offset;         ///< where its frame was unknown
    double noise_ratio = 0.0;  ///< as Identification::noise_ratio, of this survey
    double noise_scale = 1.0;  ///< estimated factor on its noise; 1 where not estimated
    /// Change of the lengths against earlier surveys, root mean square, over its expectation: about
    /// 1. 0 of the first.
    double change_ratio = 0.0;
    double change_limit = 0.0;  ///< exceeded by chance once in a thousand times
    /// Since the survey before; of the first survey: of adjustable edges from the net. The worst
    /// first.
    std::vector<LengthChange> changes;
    /// Scatter of the turns in addition to their given standard deviation, where single ones do not
    /// stand out; 0: none [m].
    double excess_actuator_std = 0.0;
    /// Factor on all strokes that fits best, and its standard deviation, 0 where nothing was
    /// turned; far from 1 where a pitch or unit is wrong.
    double stroke_factor = 1.0;
    double stroke_factor_std = 0.0;  ///< standard deviation of the factor
    Trust trust;                     ///< of this survey alone
};

/// The outcome of an identification, by whatever method. Lengths and form are reliable only where
/// the status is `converged`; else `message` gives the reason, and `edges` and `predicted` are
/// where the search ended, or empty.
struct Identification {
    std::string method;         ///< "gp", "balance", "map"
    std::string method_reason;  ///< why this method, in words
    std::string description;    ///< method, prior and training, in words
    /// Prior of the length deviations that explains the survey best, of those assumed.
    LengthPrior length_prior;
    PriorEstimate prior;  ///< all priors assumed, with their posterior probabilities
    IdentificationStatus status = IdentificationStatus::converged;  ///< how it ended
    std::string message;                ///< why it did not converge, and what may help; else empty
    std::vector<IdentifiedEdge> edges;  ///< one an interior edge, in their order
    std::vector<StretchLength> stretches;  ///< where runs slide; the slips are in `uncertain`
    Equilibrium predicted;     ///< of the net with the identified lengths, and all else identified
    Eigen::VectorXd tensions;  ///< of all edges in that form (m); empty where there is none [N]
    /// |predicted - surveyed| at the surveyed free nodes, in the order of Survey::surveyed [m]
    Eigen::VectorXd residuals;

    // By data snooping; as here where the survey is exact or assumed so.
    std::vector<Outlier> outliers;   ///< the worst first
    double outlier_threshold = 0.0;  ///< threshold of Outlier::statistic; 0: no test
    /// Root mean square of the residuals over its expectation by the noise given; about 1 where
    /// that is right. 0 where not computed.
    double noise_ratio = 0.0;

    /// Length outliers: their intervals are those of the survey alone; the worst first.
    std::vector<LengthOutlier> length_outliers;

    /// Adjustable edges and supports that differ from the design; the worst first. All other
    /// results use the values found.
    std::vector<BoundaryOutlier> boundary_outliers;
    /// Number of others that contradict the survey and were not released.
    int boundary_not_released = 0;

    DetectableErrors detectable;  ///< what the checks would have found; infinite where not computed

    double noise_scale = 1.0;  ///< estimated factor on the survey's noise; 1 where not estimated
    /// Where the frame was unknown; forms and places are then in that of the survey.
    std::optional<FrameOffset> frame_offset;
    VarianceComponents scales;  ///< of noise and lengths; as here where not computed
    PriorCheck prior_check;     ///< how lengths fit `length_prior`; as here where not computed
    FrameCheck frame_check;     ///< how the survey would fit better; as here where not computed
    LoadCheck load_check;       ///< with which loads it would; as here where not computed
    /// The given or default prior, if the survey contradicts it: `length_prior` is then the one
    /// that the survey shows.
    std::optional<PriorCheck> contradicted_prior;
    bool prior_was_given = false;  ///< false: the default, or the model's

    int force_measurements = 0;                ///< how many were given
    std::vector<ForceOutlier> force_outliers;  ///< left out or doubted, the worst first
    /// Where all were left out, since they fit only if each is off by the same part.
    std::optional<ForceBias> force_bias;
    /// Edges marked taut though the survey contradicts it: then no marks are used.
    std::vector<int> contradicted_taut;
    std::vector<int> contradicted_slack;  ///< edges marked slack, likewise

    std::vector<Assumption> assumptions;  ///< of the uncertain parameters, in their order
    /// Estimates of the uncertain parameters, in the order given.
    std::vector<ParameterEstimate> uncertain;

    /// Of the posterior; empty where none were wanted, or the method gives none.
    std::optional<PosteriorDraws> draws;
    std::vector<EpochResult> epochs;  ///< of identify_epochs(), by survey; else empty
    /// Since the net was as designed, until the last survey, by edge.
    std::vector<EdgeTurned> turned;
    Trust trust;  ///< whether the result can be used; by identify()

    /// Where it was asked for, and the survey is not exact.
    std::optional<LengthCovariance> length_covariance;
    /// Posterior covariance of each node's place in `predicted`, supports included (n) [m2]: of the
    /// draws at free nodes where there are 30 or more, else linearised, (covariance) of
    /// docs/theory.md, which leaves out what the lengths have in common. 0 of a support that is
    /// known. Empty of other methods than map, of an exact survey, and with unreliable draws.
    std::vector<Eigen::Matrix3d> form_covariance;

    DrawnSummary drawn;  ///< what follows from them; empty without, and where they are unreliable
};

/// The residuals of the targets that were not left out.
/// @param survey the one that was identified from; only the number of its targets is checked
/// @throws std::invalid_argument for another number of them
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd residuals_in_use(const Identification& result,
                                                                const Survey& survey);

}  // namespace taut
