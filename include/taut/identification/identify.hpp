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

/// What is told besides net and survey, and what is asked for.
struct IdentifyOptions {
    /// Empty: gp where a model is given; map where the survey has noise or misses nodes, forces are
    /// told or more than lengths is unknown; balance else.
    std::optional<IdentificationMethod> method = {};
    /// Of the length deviations: their prior. Empty: the model's, or one that is next to unknown,
    /// around uniform:5mm.
    std::optional<LengthPrior> prior = {};
    /// Whether that prior is exact. Else its scale is uncertain by a factor of 1.5, and its shape
    /// uniform or normal; both are estimated with the lengths, and what the survey leaves open of
    /// them is in the intervals: Identification::prior, docs/theory.md (hyperprior). A model's is.
    bool prior_exact = false;
    /// What was read and seen of the forces besides the form; for map.
    Forces forces = {};
    /// What else is not known: map estimates it with the lengths; the samples of gp are drawn with
    /// it. A model has its own.
    std::vector<UncertainParameter> uncertain = {};
    /// Of what is not among these taut assumes what is usual on a site, with_site_assumptions():
    /// for map, of a survey that is not exact. Else all that is not given is as the net tells. Of
    /// several surveys only common stiffness and temperature are assumed uncertain.
    bool assume_site = false;
    /// For gp; not copied: it must live until identify() has ended. Null: one is trained now, on
    /// `training_samples` samples of the prior, and forgotten.
    const LengthModel* model = nullptr;
    int training_samples = 1000;  ///< at least 2
    /// Draws of the posterior, for map (the other methods make none); 0: none, and which edges are
    /// slack is told by the linearised fit alone: not to be relied on where cables stretch by less
    /// than their lengths are known to.
    int draws = 0;
    /// Interior edges whose lengths' covariances are wanted: Identification::length_covariance. For
    /// map; each takes the time of one more step of the fit.
    std::vector<int> covariance_of = {};
    /// The noise of the survey is known but for a common factor, which is found with the lengths.
    bool estimate_noise = false;
    std::uint64_t seed = 1;  ///< of the draws
};

/// Draws that the program makes unless told otherwise: 200, of which the 95 % interval ends at the
/// fifth from either side; for more than 10,000 interior edges and for tension laws, where each
/// takes long, 40, of which it ends at the outermost.
[[nodiscard]] TAUT_CORE_EXPORT int default_draws(const CableNet& net);

/// Whether so many draws can be made.
/// @throws std::invalid_argument for draws below 0, or more than the memory of the machine holds
TAUT_CORE_EXPORT void check_draws(const CableNet& net, std::int64_t draws);

/// From one survey of the form to all interior edges' unstressed lengths, with standard deviations
/// and 95 % intervals, and to the form that follows.
///
/// The result is a mixture over priors, unless the prior is exact, of the model, or the survey
/// exact: docs/theory.md (prior-mixture).
///
/// Gross errors are found by data snooping and left out, whatever the method; not by a model as in
/// the paper, which takes the survey as it is. A survey without noise is held to that: where no
/// lengths of the prior give its form to rounding errors, the status is `survey_not_exact`.
///
/// @param survey of the net's free nodes: read_survey(), match_to_nodes(), or made by hand
/// @param progress told of "sampling" and "training" where a model has to be trained; the fit of
/// map
///   tells it nothing, but asks it at each step, as draws do, whether to go on
/// @return status and message tell whether it may be relied on; misuse throws
/// @throws std::invalid_argument for draws as check_draws(), a prior that the net does not bear
///   (check_prior()), forces as check_forces(), or for another method than map; covariances of
///   edges that are not interior or come twice, or for another method than map; uncertain as
///   check_uncertain_parameters(), for balance, or others than the model's; a model of another net
///   (both fingerprints are named) or prior, a model for another method than gp
/// @throws SurveyError as check_survey(), and where a free node was not surveyed though the survey
///   is exact, or the method (balance, a model as in the paper) needs all; and where it is to tell
///   its noise, but does not show it
/// @throws std::runtime_error where the statics are singular at the surveyed form, and where a
///   model has to be trained and the net as designed finds no equilibrium
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_CORE_EXPORT Identification identify(const CableNet& net, const Survey& survey,
                                                       const IdentifyOptions& options = {},
                                                       const Progress& progress = {});

/// Whether a model may be used for a net and, where it is given, a prior: by the fingerprint that
/// it bears and the sizes of its parts.
/// @throws std::invalid_argument as identify()
TAUT_CORE_EXPORT void check_model(const CableNet& net, const LengthModel& model,
                                  const std::optional<LengthPrior>& prior = {});

}  // namespace taut
