// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/explanation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

#include "estimation/boundary_tests.hpp"
#include "estimation/feasible_descent.hpp"
#include "estimation/gauss_newton.hpp"
#include "estimation/length_likelihoods.hpp"
#include "estimation/length_tests.hpp"
#include "estimation/slack_set.hpp"
#include "estimation/target_tests.hpp"
#include "statics/elastic_stretch.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {
using Family = Hypotheses::Family;

/// A few rounds suffice: the edges that the form shows as slack change little with the fit.
constexpr int most_slack_sets = 12;
constexpr int most_revisions = 100;
constexpr int most_blurs = 8;

/// (rounded-law): widths of the corner, in the smallest standard deviation of the survey at last,
/// and from one to the next; (decrement) at last and on the way there.
constexpr double corner_in_noise = 0.3;
constexpr double corner_factor = 0.3;
constexpr double small_decrement = 0.01;
constexpr double decrement_on_the_way = 0.3;

/// @return the settings, after all input of a fit was checked
SurveyFitSettings checked(const CableNet& net, const Survey& survey,
                          const PriorKnowledge& knowledge, const SurveyFitSettings& settings) {
    check_survey(net, survey);
    check_forces(net, knowledge.forces);
    for (const LengthPrior& prior : knowledge.priors) {
        prior.check();
    }
    if (settings.max_iterations < 1) {
        throw std::invalid_argument(
            fmt::format("max_iterations is {}, expected at least 1", settings.max_iterations));
    }
    if (!(settings.false_alarm_rate >= 0.0 && settings.false_alarm_rate < 1.0)) {
        throw std::invalid_argument(fmt::format(
            "false_alarm_rate is {}, expected at least 0 and below 1", settings.false_alarm_rate));
    }
    return settings;
}

StaticsModel model_of(const CableNet& net, const PriorKnowledge& knowledge) {
    StaticsModel model(net, knowledge.uncertain, knowledge.frame_is_unknown, knowledge.test_loads);
    model.blur = blur_by(net, knowledge.length_std(), knowledge.uncertain);
    return model;
}

std::vector<Hypothesis> all_hypotheses(const CableNet& net, const Survey& survey,
                                       const PriorKnowledge& knowledge,
                                       const SurveyFitSettings& settings) {
    // A widened prior lets lengths explain everything: it cannot be tested.
    const bool tests_priors = survey.is_noisy() && settings.prior_width == 1.0;
    const double rate_of_priors = tests_priors ? settings.false_alarm_rate : 0.0;
    std::vector<Hypothesis> all =
        measurement_hypotheses(survey, knowledge.forces.measurements, settings.false_alarm_rate);
    std::ranges::copy(length_hypotheses(net, knowledge.priors, rate_of_priors),
                      std::back_inserter(all));
    std::ranges::copy(boundary_hypotheses(net, rate_of_priors), std::back_inserter(all));
    return all;
}

/// A fit under way.
struct Search {
    const FitProblem& problem;
    const Assumed& assumed;
    Observations observed;
    double tolerance;  ///< [m]
    StaticsModel model;
    Iterate iterate;
    bool converged = false;
    std::optional<Linearisation> linearisation;
    Covariance covariance;

    void gauss_newton_from(const Iterate& start);
    void follow_tension_laws();
    void find_slack_set(const Iterate& start, std::vector<bool> slack);
    void descend_rounded(double corner_width, double last);
};

/// Gauss-Newton steps under the model as it is.
void Search::gauss_newton_from(const Iterate& start) {
    GaussNewtonResult found =
        gauss_newton(model, observed, start, tolerance, problem.settings.max_iterations,
                     problem.settings.progress, std::move(linearisation));
    iterate = std::move(found.iterate);
    converged = found.converged;
    linearisation = std::move(found.linearisation);
}

/// (blurred-law): fits again with the tension laws blurred by the strains' standard deviations at
/// the fit. Where that does not converge, the fit with the wider blur stands.
void Search::follow_tension_laws() {
    for (int round = 0; !model.blur.empty() && round < most_blurs && converged; ++round) {
        const LawBlur before = model.blur;
        const LawBlur found = blur_found(model, linearisation->covariance(), iterate, observed);
        if (found.agrees_with(before)) {
            return;
        }
        const Iterate start = iterate;
        model.blur = found;
        gauss_newton_from(start);
        if (!converged) {
            model.blur = before;
            gauss_newton_from(start);
            return;
        }
    }
}

/// Fits with those edges slack that the fitted form shows to be slack. An edge that comes out
/// longer than a slack edge can be stays taut, even with some pressure, so that the sets do not
/// cycle.
void Search::find_slack_set(const Iterate& start, std::vector<bool> slack) {
    Iterate from = start;
    std::vector<bool> taut_for_good(slack.size(), false);
    bool has_failed = false;
    for (int round = 0; round < most_slack_sets; ++round) {
        model.slack = slack;
        gauss_newton_from(from);
        follow_tension_laws();
        const std::vector<bool> shown = assumed.shown_slack(iterate);
        for (size_t e = 0; e < slack.size(); ++e) {
            taut_for_good[e] = taut_for_good[e] || (slack[e] && !shown[e]);
            // A search that did not converge can only take edges out of the set.
            slack[e] = shown[e] && !taut_for_good[e] && (converged || slack[e]);
        }
        if (slack == model.slack || (has_failed && !converged)) {
            if (converged) {
                covariance = linearisation->covariance();  // (covariance)
            }
            return;
        }
        has_failed = has_failed || !converged;
        from = converged ? iterate : start;
    }
    converged = false;
}

/// (rounded-law): from a wide corner to the last one, far below the noise.
void Search::descend_rounded(double corner_width, double last) {
    model.slack = assumed.as_seen(std::vector<bool>(problem.net.edge_count(), false));
    model.corner_width = std::max(corner_width, last);
    while (true) {
        const bool is_last = model.corner_width == last;
        GaussNewtonResult found = feasible_descent(
            model, observed, std::move(iterate), is_last ? small_decrement : decrement_on_the_way,
            most_descents, problem.settings.progress, std::move(linearisation));
        linearisation = std::move(found.linearisation);
        iterate = std::move(found.iterate);
        converged = found.converged;
        if (is_last || !linearisation) {
            break;
        }
        model.corner_width = std::max(last, corner_factor * model.corner_width);
    }
    model.slack = assumed.shown_slack(iterate);
    if (linearisation) {
        covariance = linearisation->covariance();
        linearisation = (*std::move(linearisation)).under(model);
    }
}

/// The memory of a linearisation that no other explanation shares.
std::optional<Linearisation> memory_of(Explanation&& last) {
    if (last.linearisation == nullptr || last.linearisation.use_count() > 1) {
        return std::nullopt;
    }
    return std::move(*last.linearisation);
}

}  // namespace

FitProblem::FitProblem(const CableNet& of, const Survey& survey_of_it, const PriorKnowledge& known,
                       const SurveyFitSettings& given)
    : net(of),
      settings(checked(of, survey_of_it, known, given)),
      survey(with_supports(of, survey_of_it)),
      knowledge(known),
      noise(with_noise_floor(of, survey)),
      smallest_noise(noise(Eigen::all, survey_of_it.surveyed).minCoeff()),
      model(model_of(of, known)),
      hypotheses(of, all_hypotheses(of, survey, known, given)) {}

double FitProblem::widest_corner() const {
    const double std_dev = knowledge.length_std();
    return std::min(std_dev, std::sqrt(mean_stretch(net) * std_dev));
}

Assumed::Assumed(const FitProblem& of, const Hypotheses& hypotheses)
    : problem(of),
      knowledge(of.knowledge),
      rejected(hypotheses.is_released(Suspect::target, of.net.node_count())),
      rejected_forces(hypotheses.is_released(
          Suspect::force, static_cast<int>(of.knowledge.forces.measurements.size()))),
      model(of.model) {
    knowledge.priors = priors_with_released(hypotheses, of.net, of.knowledge.priors);
    if (BoundaryReleases released = boundary_releases(hypotheses); released.count() > 0) {
        model.common = CommonParameters(of.net, knowledge.uncertain, knowledge.frame_is_unknown,
                                        knowledge.test_loads, std::move(released));
    }
}

Observations Assumed::observations(double inflation) const {
    Observations result = observe(problem.net, problem.survey, problem.noise, rejected, knowledge,
                                  model.common.count());
    const std::vector<ForceMeasurement>& forces = knowledge.forces.measurements;
    for (size_t k = 0; k < forces.size(); ++k) {
        if (rejected_forces[k]) {
            result.tension_weights(forces[k].edge) = 0.0;
        }
    }
    const double width = problem.settings.prior_width;
    result.variance *= width * width;
    const double squared_inflation = inflation * inflation;
    for (const int node : problem.net.free_nodes()) {
        result.scale_weight(node, 1.0 / squared_inflation);
    }
    result.tension_weights /= squared_inflation;
    return result;
}

std::vector<bool> Assumed::shown_slack(const Iterate& iterate) const {
    const Eigen::VectorXd lengths =
        model.common.cold(edge_lengths(problem.net, iterate.form), iterate.common);
    return as_seen(slack_by_lengths(problem.net, lengths, knowledge.priors));
}

std::vector<bool> Assumed::measured_slack(double inflation) const {
    const Observations observed = observations(inflation);
    return as_seen(
        slack_by_survey(problem.net, observed, knowledge.priors,
                        model.common.length_stds(edge_lengths(problem.net, observed.form))));
}

Iterate Assumed::with_released(Iterate iterate) const {
    const CommonParameters& common = model.common;
    Eigen::VectorXd values = Eigen::VectorXd::Zero(common.count());
    values.head(common.kept_count()) = iterate.common.head(common.kept_count());
    iterate.common = std::move(values);
    if (!model.are_supports_uncertain()) {
        const Points motion = common.support_motion(iterate.common);
        for (const int node : problem.net.supports()) {
            iterate.form.col(node) = problem.net.nodes().col(node) + motion.col(node);
        }
    }
    return iterate;
}

FitState nominal_state(const FitProblem& problem) {
    return {.iterate = nominal_iterate(problem.net, problem.model.common.count()),
            .slack = std::vector<bool>(problem.net.edge_count(), false),
            .blur = problem.model.blur,
            .corner_width = problem.widest_corner()};
}

Explanation fit(const FitProblem& problem, Hypotheses hypotheses, FitState start,
                const FitMode& mode, std::optional<Linearisation> memory) {
    const Assumed assumed(problem, hypotheses);
    Search search{.problem = problem,
                  .assumed = assumed,
                  .observed = assumed.observations(mode.inflation),
                  .tolerance = mode.inflation * problem.tolerance(),
                  .model = assumed.model,
                  .iterate = assumed.with_released(std::move(start.iterate)),
                  .linearisation = std::move(memory)};
    search.model.blur = std::move(start.blur);
    const double last = std::min(problem.widest_corner(),
                                 corner_in_noise * mode.inflation * problem.smallest_noise);
    if (mode.is_rounded) {
        search.descend_rounded(start.corner_width, last);
    } else {
        search.find_slack_set(Iterate(search.iterate), std::move(start.slack));
    }
    Explanation result{.hypotheses = std::move(hypotheses),
                       .at = {.iterate = std::move(search.iterate),
                              .slack = search.model.slack,
                              .blur = search.model.blur,
                              .corner_width = mode.is_rounded ? last : start.corner_width},
                       .converged = search.converged,
                       .cost = std::numeric_limits<double>::infinity(),
                       .covariance = std::move(search.covariance)};
    if (search.linearisation) {
        result.linearisation = std::make_shared<Linearisation>(*std::move(search.linearisation));
    }
    if (result.is_sound() && !result.hypotheses.has_too_many(Family::boundary)) {
        const Observations observed = assumed.observations();
        result.cost =
            2.0 * search.model.objective(observed, result.at.iterate) + result.hypotheses.cost();
    }
    return result;
}

void test_hypotheses(const FitProblem& problem, Explanation& found, const FitMode& mode) {
    Hypotheses& hypotheses = found.hypotheses;
    const Linearisation& linearisation = *found.linearisation;
    const Iterate& at = found.at.iterate;
    const Assumed assumed(problem, hypotheses);
    const Observations observed = assumed.observations(mode.inflation);
    const std::vector<ForceMeasurement>& forces = problem.knowledge.forces.measurements;
    hypotheses.begin_tests();
    test_targets(
        hypotheses, problem.survey, problem.noise, at.form,
        [&](int node) { return found.covariance.places[node]; }, mode.inflation);
    if (!forces.empty()) {
        test_forces(
            hypotheses, forces, observed.measured(linearisation.model().tensions(at), at.common),
            found.covariance.measured,
            [&](const Eigen::VectorXd& weights) {
                return linearisation.measured_variance(weights);
            },
            mode.inflation);
    }
    if (mode.boundary != Hypotheses::BoundaryTest::none && hypotheses.is_active(Family::boundary)) {
        test_boundary(hypotheses, linearisation, found.covariance, at, observed);
    }
    if (!mode.is_rounded && hypotheses.is_active(Family::lengths)) {
        test_lengths(hypotheses, problem.net, problem.knowledge.priors,
                     length_likelihoods(assumed.knowledge, linearisation.model(), found.covariance,
                                        observed, at),
                     linearisation, observed, at);
    }
}

Explanation explain(const FitProblem& problem, Hypotheses hypotheses, FitState start,
                    const FitMode& mode) {
    hypotheses.reopen();
    Explanation found = fit(problem, std::move(hypotheses), std::move(start), mode);
    // A descent that was cut short shows the largest gross errors, too.
    const auto can_be_tested = [&] {
        return found.hypotheses.is_active(Family::targets) &&
               (found.converged || (mode.is_rounded && found.linearisation != nullptr));
    };
    for (int revision = 0; can_be_tested() && revision < most_revisions; ++revision) {
        test_hypotheses(problem, found, mode);          // (snooping), (length-snooping), (slip)
        if (!found.hypotheses.revise(mode.boundary)) {  // (score), (threshold)
            break;
        }
        const bool has_too_many = found.hypotheses.has_too_many(Family::targets) ||
                                  found.hypotheses.has_too_many(Family::boundary);
        const Assumed assumed(problem, found.hypotheses);
        found.at.slack = assumed.as_seen(
            where_measured(problem.net, assumed.observations(mode.inflation), found.at.slack));
        Hypotheses revised = found.hypotheses;
        FitState at = found.at;
        found = fit(problem, std::move(revised), std::move(at), mode, memory_of(std::move(found)));
        if (has_too_many) {
            break;
        }
    }
    return found;
}

Explanation explain_from_nominal(const FitProblem& problem, Hypotheses hypotheses,
                                 const FitMode& mode) {
    FitState start = nominal_state(problem);
    start.slack = Assumed(problem, hypotheses).measured_slack(mode.inflation);
    return explain(problem, std::move(hypotheses), std::move(start), mode);
}

}  // namespace taut
