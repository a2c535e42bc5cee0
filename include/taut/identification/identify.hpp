// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/progress.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"
#include "taut/survey/forces.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

struct LengthModel;

/// A way from a survey to lengths. docs/theory.md derives each; docs/methods.md compares them.
enum class IdentificationMethod {
    balance,  ///< force balance: linear in 1/l_0; needs every free node
    map,      ///< maximum a posteriori under the statics: any subset of nodes, any noise
    gp,       ///< Gaussian processes (eq. ident): a trained model
};

/// "balance", "map", "gp".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(IdentificationMethod method);

/// The method that to_string() calls so.
/// @throws std::invalid_argument for another name
[[nodiscard]] TAUT_CORE_EXPORT IdentificationMethod
parse_identification_method(std::string_view name);

/// All that is given besides net and survey, and what is wanted.
struct IdentifyOptions {
    /// Empty: gp where a model is given; map where the survey has noise or misses nodes, forces are
    /// given or more than lengths is uncertain; balance else.
    std::optional<IdentificationMethod> method = {};
    /// Prior of the length deviations. Empty: the model's, or a very broad one around uniform:5mm.
    std::optional<LengthPrior> prior = {};
    /// Whether that prior is exact. Else its scale is uncertain by a factor of 1.5, and its shape
    /// uniform or normal. Both are estimated with the lengths, and their remaining uncertainty is
    /// in the intervals: Identification::prior, docs/theory.md (hyperprior). A model's prior is
    /// exact.
    bool prior_exact = false;
    /// Force measurements and marks of taut and slack edges; for map.
    Forces forces = {};
    /// Further uncertain parameters: map estimates them with the lengths; the samples of gp are
    /// drawn with them. A model has its own.
    std::vector<UncertainParameter> uncertain = {};
    /// Whether taut assumes what is usual on a site for all others, with_site_assumptions(): for
    /// map, of a survey that is not exact. Empty: it does. False: these are exactly as in the net.
    /// For several surveys masses are not assumed uncertain unless a force measurement is by mass.
    std::optional<bool> assume_site = {};
    /// For gp; not copied: it must live until identify() has ended. Null: one is trained now, on
    /// `training_samples` samples of the prior, and discarded.
    const LengthModel* model = nullptr;
    int training_samples = 1000;  ///< at least 2
    /// Draws of the posterior, for map (the other methods make none). Empty: default_draws(). 0:
    /// none; slack edges are then those of the linearised fit, which is not reliable where cables
    /// stretch by less than their lengths are known to.
    std::optional<int> draws = {};
    /// Interior edges whose lengths' covariances are wanted: Identification::length_covariance. For
    /// map; each takes the time of one more step of the fit.
    std::vector<int> covariance_of = {};
    /// Whether the noise of the survey has an unknown common factor, which is estimated with the
    /// lengths.
    bool estimate_noise = false;
    std::uint64_t seed = 1;  ///< of the draws
};

/// Number of draws where none is given: 200, where the 95 % interval ends at the fifth from
/// either side. For more than 10,000 interior edges and for tension laws, where each takes long,
/// 40, where it ends at the outermost.
[[nodiscard]] TAUT_CORE_EXPORT int default_draws(const CableNet& net);

/// Checks that this many draws can be made.
/// @throws std::invalid_argument for draws below 0, for one alone, and for more than the memory of
///   the machine holds
TAUT_CORE_EXPORT void check_draws(const CableNet& net, std::int64_t draws);

/// What these tensions were measured by, for with_site_assumptions().
[[nodiscard]] TAUT_CORE_EXPORT KnownForces measured_by(const Forces& forces);

/// From one survey of the form to all interior edges' unstressed lengths, with standard deviations
/// and 95 % intervals, and to the form that follows.
///
/// The result is a mixture over priors, unless the prior is exact, of the model, or the survey
/// exact: docs/theory.md (prior-mixture).
///
/// Gross errors are found by data snooping and left out, whatever the method; not by a model as in
/// the paper, which takes the survey as it is. A survey without noise must be exact: where no
/// lengths of the prior give its form to rounding errors, the status is `survey_not_exact`.
///
/// @param survey of the net's free nodes: read_survey(), match_to_nodes(), or made by hand
/// @param progress gets "sampling" and "training" where a model has to be trained; of map
///   "identification" at each step of each fit, whose number is not known before, and "posterior
///   samples"
/// @return status and message show whether it is reliable; misuse throws
/// @throws std::invalid_argument for draws as check_draws(), a prior that does not fit the net
///   (check_prior()), forces as check_forces(), or for another method than map; covariances of
///   edges that are not interior or come twice, or for another method than map; uncertain
///   parameters as check_uncertain_parameters(), for balance, or others than the model's; a model
///   of another net (both fingerprints are named) or prior, a model for another method than gp
/// @throws SurveyError as check_survey(); where a free node was not surveyed though the survey is
///   exact, or the method (balance, a model as in the paper) needs all; and where its noise is to
///   be estimated, but it does not show it
/// @throws std::runtime_error where the statics are singular at the surveyed form, and where a
///   model has to be trained and the net as designed finds no equilibrium
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_CORE_EXPORT Identification identify(const CableNet& net, const Survey& survey,
                                                       const IdentifyOptions& options = {},
                                                       const Progress& progress = {});

/// Checks that a model is for a net and, where it is given, a prior: by its fingerprint and the
/// sizes of its parts.
/// @throws std::invalid_argument as identify()
TAUT_CORE_EXPORT void check_model(const CableNet& net, const LengthModel& model,
                                  const std::optional<LengthPrior>& prior = {});

}  // namespace taut
