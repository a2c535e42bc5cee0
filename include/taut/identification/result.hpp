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
    survey_does_not_fit,  ///< so many targets contradict the rest that it is not they who are
                          ///< wrong, or no positive lengths give the form
    survey_not_exact,     ///< taken for exact, but no lengths of the prior give its form
    no_equilibrium,       ///< the identified lengths find none: there is no predicted form
};

/// "converged", "iteration limit", "survey does not fit", "survey not exact", "no equilibrium".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(IdentificationStatus status);

/// What is known of one interior edge's unstressed length after a survey.
struct IdentifiedEdge {
    int edge = 0;                                ///< index in the net
    double nominal = 0.0;                        ///< unstressed length as designed [m]
    double length_deviation = 0.0;               ///< estimate of true minus nominal [m]
    double std = 0.0;                            ///< standard deviation of the estimate [m]
    double lower = 0.0;                          ///< 95 % interval of the length deviation [m]
    double upper = 0.0;                          ///< its upper end [m]
    EdgeStatus status = EdgeStatus::determined;  ///< whether the survey tells its length at all
};

/// Posterior covariances between the lengths of some interior edges.
struct LengthCovariance {
    std::vector<int> edges;  ///< k, in the order in which they were asked for
    /// k x k: the correlations of the fit linearised at the result, (covariance) of docs/theory.md,
    /// times the standard deviations of IdentifiedEdge, which the prior itself cuts [m2].
    Eigen::MatrixXd covariance;
};

/// A parameter that was taken as uncertain.
struct Assumption {
    UncertainParameter parameter;  ///< with its standard deviation before the survey
    bool is_default = false;       ///< assumed, since nothing was given
    bool is_testable =
        false;  ///< whether the survey shows any number of it: else it is taken as is
};

/// How far the frame of a survey is from the net's, where it was unknown: a rotation about a point,
/// then a translation, both small.
struct TAUT_CORE_EXPORT FrameOffset {
    Eigen::Vector3d about;            ///< [m]
    Eigen::Vector3d translation;      ///< [m]
    Eigen::Vector3d translation_std;  ///< [m]
    Eigen::Vector3d rotation;         ///< about x, y and z [rad]
    Eigen::Vector3d rotation_std;     ///< [rad]

    /// What it moves these places by, to first order (3 x n) [m].
    [[nodiscard]] Points motion_of(const Points& places) const;
};

/// A length that was not the same in two surveys, one after the other, but for what was turned.
struct LengthChange {
    int edge = 0;            ///< index in the net; of the first survey that of an adjustable edge
    double change = 0.0;     ///< of it, where it was set free [m]
    double std = 0.0;        ///< [m]
    double statistic = 0.0;  ///< in standard deviations, when it was found
};

/// One survey among several, as all together tell it.
struct EpochResult {
    int surveyed = 0;                                ///< free nodes
    std::vector<EdgeTurned> turned;                  ///< since the survey before
    std::vector<Outlier> outliers;                   ///< targets left out, the worst first
    std::vector<BoundaryOutlier> boundary_outliers;  ///< not as told; the worst first
    std::optional<FrameOffset> frame_offset;         ///< where its frame was unknown
    double noise_ratio = 0.0;  ///< as Identification::noise_ratio, of this survey
    double noise_scale = 1.0;  ///< that its noise was multiplied by, where it was unknown
    /// How far the survey moves lengths from where earlier ones have them, root mean square, over
    /// what both let expect: about 1. 0 of the first.
    double change_ratio = 0.0;
    double change_limit = 0.0;  ///< that chance exceeds once in a thousand times
    /// Since the survey before; of the first survey: of adjustable edges from what the net tells.
    /// The worst first.
    std::vector<LengthChange> changes;
    /// How far turns differ from what is told, beyond the play that is told of them, where single
    /// ones do not stand out; 0: no further [m].
    double excess_actuator_std = 0.0;
    /// By which all strokes would have to be multiplied to fit best, and its standard deviation, 0
    /// where nothing was turned; far from 1 where a pitch or unit was told wrong.
    double stroke_factor = 1.0;
    double stroke_factor_std = 0.0;  ///< standard deviation of the factor
    Trust trust;                     ///< of this survey alone
};

/// The outcome of an identification, by whatever method. Only where the status is `converged` may
/// lengths and form be relied on; else `message` says what was found, and `edges` and `predicted`
/// are what the search ended with, or empty.
struct Identification {
    std::string method;         ///< "gp", "balance", "map"
    std::string method_reason;  ///< why this method, in words
    std::string how;            ///< what was done, in words: the method, its prior, its training
    /// Prior of the length deviations that explains the survey best, of those assumed.
    LengthPrior length_prior;
    PriorEstimate prior;  ///< all that were assumed, with their posterior probabilities
    IdentificationStatus status = IdentificationStatus::converged;  ///< how it ended
    std::string message;                ///< why it did not converge, and what may help; else empty
    std::vector<IdentifiedEdge> edges;  ///< one an interior edge, in their order
    Equilibrium predicted;     ///< of the net with the identified lengths, and all else identified
    Eigen::VectorXd tensions;  ///< of all edges in that form (m); empty where there is none [N]
    /// |predicted - surveyed| at the surveyed free nodes, in the order of Survey::surveyed [m]
    Eigen::VectorXd residuals;

    // Of data snooping; as here where the survey is exact or taken for it.
    std::vector<Outlier> outliers;   ///< the worst first
    double outlier_threshold = 0.0;  ///< that Outlier::statistic is held against; 0: no test
    /// Root mean square of the residuals over what the stated noise lets expect; about 1 where the
    /// noise is stated right. 0 where it was not computed.
    double noise_ratio = 0.0;

    /// Edges beyond the prior: their intervals are those of the survey alone; the worst first.
    std::vector<LengthOutlier> length_outliers;

    /// Adjustable edges and supports that are not as told; the worst first. Their intervals and
    /// what else is told take them so.
    std::vector<BoundaryOutlier> boundary_outliers;
    int boundary_not_released = 0;  ///< of the others, what contradicts the survey and was not set free

    DetectableErrors detectable;  ///< what the checks would have found; infinite where not computed

    double noise_scale = 1.0;  ///< that the survey's noise was multiplied by, where it was unknown
    /// Where the frame was unknown; forms and places are then told in that of the survey.
    std::optional<FrameOffset> frame_offset;
    VarianceComponents scales;  ///< of noise and lengths; as here where not computed
    PriorCheck prior_check;     ///< how lengths fit `prior`; as here where not computed
    FrameCheck frame_check;     ///< how the survey would fit better; as here where not computed
    /// The prior told, or the default where none was, if the survey contradicts it: `prior` is then
    /// the one that the survey shows.
    std::optional<PriorCheck> contradicted_prior;
    bool prior_was_given = false;  ///< false: `prior` began as the default, or the model's

    int force_measurements = 0;                  ///< how many were given
    std::vector<ForceOutlier> force_outliers;  ///< those left out, the worst first
    /// Where all of them were left out, since they fit only if each is off by the same part.
    std::optional<ForceBias> force_bias;
    /// Edges seen taut or slack where the survey tells otherwise: then nothing that was seen is
    /// used.
    std::vector<int> contradicted_taut;
    std::vector<int> contradicted_slack;  ///< of those seen slack, likewise

    std::vector<Assumption> assumptions;  ///< of what is uncertain, in their order
    /// What else was unknown, in the order in which it was told.
    std::vector<ParameterEstimate> uncertain;

    /// Of the posterior; empty where none were asked for, or the method gives none.
    std::optional<PosteriorDraws> draws;
    std::vector<EpochResult> epochs;  ///< of identify_epochs(), by survey; else empty
    /// Since the net was as designed, until the last survey, by edge.
    std::vector<EdgeTurned> turned;
    Trust trust;  ///< whether all this may be acted on; identify() tells it

    /// Where it was asked for, and the survey is not exact.
    std::optional<LengthCovariance> length_covariance;

    DrawnSummary drawn;  ///< what follows from them; empty without, and where they are in doubt
};

/// The residuals of the targets that were not left out.
/// @param survey the one that was identified from; only the number of its targets is checked
/// @throws std::invalid_argument for another number of them
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd residuals_in_use(const Identification& result,
                                                                const Survey& survey);

}  // namespace taut
