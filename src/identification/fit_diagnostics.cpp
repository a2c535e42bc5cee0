// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/fit_diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimation/detectable_error.hpp"
#include "estimation/frame_check.hpp"
#include "estimation/length_likelihoods.hpp"
#include "estimation/length_tests.hpp"
#include "estimation/marginal_mode.hpp"
#include "estimation/prior_check.hpp"
#include "estimation/target_tests.hpp"
#include "estimation/variance_components.hpp"
#include "sampling/uncertain_widths.hpp"
#include "taut/statics/imbalance.hpp"

namespace taut {
namespace {

/// (common-mean): score and information of a shift of the prior. None where (marginal-mode) moves
/// it farther than a linearisation holds.
void set_mean(PriorCheck& check, const LinearisedFit& fitted, const Observations& observations,
              const std::vector<bool>& left_out) {
    Eigen::VectorXd weights = observations.variance.cwiseInverse();
    for (size_t i = 0; i < left_out.size(); ++i) {
        if (left_out[i]) {
            weights(static_cast<Eigen::Index>(i)) = 0.0;
        }
    }
    const double information =
        weights.sum() -
        weights.dot(fitted.linearisation.response_to_lengths(weights).lengths.col(0));
    constexpr double rounding = 1e-6;
    if (!(information > rounding * weights.sum())) {
        return;
    }
    double by_mode = 0.0;
    double by_mode_std = 0.0;
    if (weights.size() >= fewest_for_marginal_mode) {
        constexpr double known_to = 0.5;  // the slope changes on the way: by trial
        constexpr double farthest = 4.0;  // standard deviations of the prior
        const double h = 0.1 * check.checked.std_dev();
        Observations moved = observations;
        moved.mean.array() += h * (weights.array() > 0.0).cast<double>();
        by_mode = DeterminantSlope(fitted, observations).change(moved) / h / information;
        if (!(std::abs(by_mode) < farthest * check.checked.std_dev())) {
            return;
        }
        by_mode_std = known_to * std::abs(by_mode);
    }
    const double score = weights.dot(fitted.iterate.deviations - observations.mean);
    check.mean = score / information - by_mode;
    check.mean_std = std::hypot(1.0 / std::sqrt(information), by_mode_std);
}

}  // namespace

FitDiagnostics diagnostics_of(const CableNet& net, const CableNet& fit_net, const Given& given,
                              const SurveyFit& fit, LinearisedFit fitted) {
    const LengthPrior& prior = given.prior;
    FitDiagnostics shown;
    const Iterate at = fitted.iterate;
    const std::vector<bool> slack = fitted.model().slack;
    const Observations observed = fit.observations;
    Observations scaled = observed;
    shown.frame = check_frame(fitted, observed, fit.hypotheses.residual_scale);
    std::vector<bool> left_out = fit.hypotheses.released_lengths();
    shown.adjustable_stds = Eigen::VectorXd::Zero(fit_net.interior_edge_count());
    for (int i = 0; i < fit_net.interior_edge_count(); ++i) {
        const int edge = fit_net.interior_edges()[i];
        const bool is_adjustable = std::ranges::binary_search(net.adjustable_edges(), edge);
        if (is_adjustable && !left_out[i] && !slack[edge]) {
            shown.adjustable_stds(i) = given.unturned_std.value_or(
                std_of(given.uncertain, UncertainParameter::Kind::adjustable));
        }
        left_out[i] = left_out[i] || slack[edge] || fit.knowledge.priors[i] != prior;
    }
    shown.scales = estimate_components(fitted, scaled, left_out);
    const PriorLikelihood likelihood(prior,
                                     length_likelihoods(fit.knowledge, fitted.model(),
                                                        fitted.covariance, scaled, fitted.iterate),
                                     left_out);
    shown.prior = check_prior_by_lengths(prior, likelihood);
    shown.prior.outliers = fit.hypotheses.given_up();
    set_mean(shown.prior, fitted, scaled, left_out);
    if (given.hyperprior) {
        fitted.iterate = at;
        shown.estimate = estimate_prior(*given.hyperprior, std::move(fitted), observed, left_out,
                                        prior, shown.scales.lengths, likelihood);
    }
    shown.left_out = std::move(left_out);
    return shown;
}

DetectableErrors detectable_of(const CableNet& net, const CableNet& fit_net, const Survey& survey,
                               const SurveyFit& fit, const std::vector<LengthPrior>& priors,
                               const FitDiagnostics& shown) {
    const Hypotheses& tested = fit.hypotheses;
    const auto length = [&](const std::vector<int>& edges) {
        return detectable_length(tested, fit_net, priors, edges);
    };
    DetectableErrors result{.target = tested.detectable(Suspect::target),
                            .length = length(net.interior_edges()),
                            .adjustable = std::min(length(net.adjustable_edges()),
                                                   tested.detectable(Suspect::adjustable_edge)),
                            .support = tested.detectable(Suspect::support)};
    const Points arms = net.nodes().colwise() - net.nodes().rowwise().mean();
    const double reach = arms.colwise().norm().maxCoeff();
    const double scale_std =
        shown.frame.scale_std > 0.0 ? std::hypot(shown.frame.scale_std, survey.scale_std) : 0.0;
    result.scale = detectable_error(std::vector<BoundedEstimate>{
        {.bound = std::max(significant_std * scale_std,
                           negligible_scale * survey.rms_noise_std() / reach),
         .std_dev = scale_std}});
    const double mean = detectable_error(std::vector<BoundedEstimate>{
        {.bound = std::max(significant_std * shown.prior.mean_std,
                           negligible_mean * shown.prior.checked.std_dev()),
         .std_dev = shown.prior.mean_std}});
    const double load = detectable_error(std::vector<BoundedEstimate>{
        {.bound = significant_std * shown.loads.std_dev, .std_dev = shown.loads.std_dev}});
    // No net carries more.
    if (load <= imbalance_of(net, net.unstressed_lengths(), net.nodes()).mean_tension) {
        result.load = load;
    }
    constexpr double of_steel = 12e-6;  // [1/K]
    double expansion = 0.0;             // mean, by 1 K [m]
    const Eigen::VectorXd& of_net = net.data().expansion;
    for (const int edge : net.interior_edges()) {
        const double of_edge = of_net.size() > 0 ? of_net(edge) : of_steel;
        expansion += of_edge * net.unstressed_lengths()(edge) / net.interior_edge_count();
    }
    constexpr double largest_difference = 100.0;  // no site has more [K]
    if (const double temperature = mean / std::abs(expansion); temperature <= largest_difference) {
        result.temperature = temperature;
    }
    result.force = detectable_force(tested, fit.knowledge.forces.measurements);
    result.force_scale = detectable_force_scale(tested);
    return result;
}

}  // namespace taut
