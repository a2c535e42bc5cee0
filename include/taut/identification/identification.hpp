// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "taut/identification/form_distribution.hpp"
#include "taut/identification/model.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// What a survey tells of one edge.
enum class EdgeStatus {
    identified,
    slack,       ///< carries no tension in the predicted form: its length shows in nothing
    unobserved,  ///< no narrower known than before the survey
};

/// "identified", "slack", "unobserved".
[[nodiscard]] std::string_view to_string(EdgeStatus status);

/// Half the width of the 95 % interval of a normal distribution, in standard deviations.
inline constexpr double half_interval_95 = 1.959963984540054;

/// Probability that a survey without gross errors loses a target by the test for them. Small: a
/// target less can cost the edges around it all that is known of them, while gross errors worth the
/// name stand far above any threshold.
inline constexpr double default_false_alarm_rate = 0.001;

/// An edge is unobserved when its standard deviation exceeds this part of that of the law of its
/// length: two Gaussian processes trained on other samples differ by as much.
inline constexpr double unobserved_ratio = 0.95;

/// How an identification ended.
enum class IdentificationStatus {
    converged,
    iteration_limit,      ///< lengths and form still moved
    survey_does_not_fit,  ///< so many targets contradict the rest that it is not they who are wrong
};

/// "converged", "iteration limit", "survey does not fit".
[[nodiscard]] std::string_view to_string(IdentificationStatus status);

/// A target that contradicts all others: left out of the identification.
struct Outlier {
    int node = 0;
    double distance = 0.0;   ///< of the surveyed place from the one that all others tell [m]
    double statistic = 0.0;  ///< its square in standard deviations, to be compared with threshold
};

/// What is known of one interior edge's unstressed length after a survey.
struct IdentifiedEdge {
    int edge = 0;
    double nominal = 0.0;           ///< unstressed length as designed [m]
    double length_deviation = 0.0;  ///< estimate of true minus nominal [m]
    double std = 0.0;               ///< standard deviation of the estimate [m]
    double lower = 0.0;             ///< 95 % interval of the length deviation [m]
    double upper = 0.0;
    EdgeStatus status = EdgeStatus::identified;
};

/// The outcome of an identification, by whatever method.
struct Identification {
    std::string method;         ///< "gp", "balance", "map"
    LengthLaw law;              ///< of the length deviations, as reckoned with
    std::string method_reason;  ///< why this method, in words, where somebody chose
    IdentificationStatus status = IdentificationStatus::converged;
    std::vector<IdentifiedEdge> edges;  ///< one an interior edge, in their order
    Equilibrium predicted;              ///< of the net with the identified lengths
    /// |predicted - surveyed| at the surveyed free nodes, in the order of Survey::surveyed [m]
    Eigen::VectorXd residuals;

    // Of the test for gross errors, where the method has one.
    std::vector<Outlier> outliers;  ///< the worst first
    double outlier_threshold = 0.0;
    /// Root mean square of the residuals over what the stated noise lets expect; about 1 where the
    /// noise is stated right. 0 where it was not computed.
    double noise_ratio = 0.0;
};

/// The residuals of the targets that were not left out.
[[nodiscard]] Eigen::VectorXd residuals_in_use(const Identification& result, const Survey& survey);

/// Estimates of many length deviations at once, before any form is predicted from them.
struct LengthEstimates {
    Eigen::MatrixXd mean;  ///< m_I x k [m]
    /// m_I x k [m]. Of the true length deviation: the process's own variance (eq. sigmax_*) and its
    /// noise variance sigma_w^2, the part of the length that the form does not show to it.
    Eigen::MatrixXd std;
};

/// Eq. ident for k forms: their deviations from the model's nominal form (3 n_I x k) [m]. Edges
/// whose process could not be fitted get the law's mean and standard deviation.
[[nodiscard]] LengthEstimates estimate_lengths(
    const CableNet& net, const LengthModel& model,
    const Eigen::Ref<const Eigen::MatrixXd>& form_deviations);

/// Identifies all interior edges from one survey by the trained processes (eq. ident), and predicts
/// the form by solving the equilibrium with the identified lengths.
///
/// Where the survey has noise, or does not hold all free nodes, the processes are asked at the
/// conditional mean of the form. Before the survey, the free coordinates x have the normal
/// distribution that the law of the lengths d gives them through the statics linearised at the
/// nominal form, and through what these miss, e = x - J d, as the training samples show it:
///
///   E x = mean(e),   C = law.std()^2 J J' + cov(e)      (form_before_survey())
///
/// Gaussian conditioning on the surveyed coordinates gives E[x | survey] and C[x | survey]. The
/// uncertainty that is left goes through the processes to first order, with the gradient g of an
/// edge's mean: variance = sigma(x)^2 + sigma_w^2 + g' C[x | survey] g. Law and slack edges then
/// enter as in posterior_of(). Gross errors are looked for, each target
/// against what all others let expect of it, and left out.
///
/// A model as in the paper takes the survey for exact and whole: eq. ident as it stands, with
/// intervals that end at the law's bounds or, where that lies beyond them, the estimate.
/// @param before form_before_survey(), where there are many surveys; else it is made here
/// @throws std::invalid_argument where the model was trained for another net (both fingerprints are
///   named); as identify_by_maximum_a_posteriori(); and where a free node was not surveyed, for a
///   model as in the paper
/// @throws std::runtime_error where an identified length is not positive, or the lengths find no
///   equilibrium
[[nodiscard]] Identification identify_by_processes(const CableNet& net, const LengthModel& model,
                                                   const Survey& survey,
                                                   const FormDistribution* before = nullptr);

}  // namespace taut
