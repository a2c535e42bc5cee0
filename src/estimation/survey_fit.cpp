// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/survey_fit.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "estimation/length_tests.hpp"
#include "estimation/other_explanations.hpp"
#include "estimation/slack_set.hpp"
#include "estimation/target_tests.hpp"

namespace taut {
namespace {
using BoundaryTest = Hypotheses::BoundaryTest;
using Family = Hypotheses::Family;

/// (continuation): the noise is at first so large that no target is more than so many standard
/// deviations off, then smaller by this factor at each step.
constexpr double largest_misfit_at_first = 0.3;
constexpr double continuation_factor = 0.3;

/// Whether anything is released, or above its threshold.
bool has_suspects(const Hypotheses& hypotheses) {
    const auto families = {Family::targets, Family::forces, Family::lengths, Family::boundary};
    return std::ranges::any_of(families, [&](Family family) {
        return hypotheses.released_count(family) + hypotheses.suspicious_count(family) > 0;
    });
}

double first_inflation(const FitProblem& problem) {
    const Points misfit = (problem.survey.form - problem.net.nodes()).cwiseQuotient(problem.noise);
    return misfit(Eigen::all, problem.survey.surveyed).cwiseAbs().maxCoeff() /
           largest_misfit_at_first;
}

/// (continuation): fits with a large noise, then with less and less, each from the result before.
/// The less a survey binds the form, the farther a linearisation holds. The gross errors show one
/// after another, the largest first. Once some are rejected, a fit from the nominal net is tried.
Explanation from_coarse_to_fine(const FitProblem& problem, Hypotheses hypotheses, bool is_rounded) {
    hypotheses.readmit_all();
    FitState from = nominal_state(problem);
    from.slack = Assumed(problem, hypotheses).as_seen(std::move(from.slack));
    const auto refine = [&](double inflation) {
        const FitMode mode{.inflation = inflation, .is_rounded = is_rounded};
        FitState start = from;
        start.slack = Assumed(problem, hypotheses).measured_slack(inflation);
        Explanation found = explain(problem, std::move(hypotheses), std::move(start), mode);
        if (!found.converged) {
            const Assumed assumed(problem, found.hypotheses);
            start = from;
            start.slack = assumed.as_seen(
                where_measured(problem.net, assumed.observations(inflation), from.slack));
            found = explain(problem, std::move(found.hypotheses), std::move(start), mode);
        }
        if (found.converged) {
            from = found.at;
        }
        hypotheses = found.hypotheses;
        return found;
    };
    for (double inflation = first_inflation(problem); inflation > 1.0;
         inflation *= continuation_factor) {
        const int rejected = hypotheses.released_count(Family::targets);
        static_cast<void>(refine(inflation));
        if (hypotheses.released_count(Family::targets) > rejected) {
            Explanation direct =
                explain_from_nominal(problem, std::move(hypotheses), {.is_rounded = is_rounded});
            if (direct.is_sound()) {
                return direct;
            }
            hypotheses = std::move(direct.hypotheses);
        }
    }
    return refine(1.0);
}

/// Rounded tension laws need no slack set, which can cycle, and have no pressure, under which a net
/// can buckle; every step lowers the objective. Their result starts a fit with a slack set. The
/// first of these that converges is taken: that fit, a continuation with slack sets, the rounded
/// fit.
Explanation by_rounded_tension_laws(const FitProblem& problem, Hypotheses hypotheses) {
    hypotheses.readmit_all();
    Explanation rounded =
        explain(problem, std::move(hypotheses), nominal_state(problem), {.is_rounded = true});
    Hypotheses last = rounded.hypotheses;
    if (rounded.is_sound()) {
        Explanation found = explain(problem, std::move(last), rounded.at);
        if (found.is_sound()) {
            return found;
        }
        last = std::move(found.hypotheses);
    }
    Explanation found = from_coarse_to_fine(problem, std::move(last), false);
    if (found.is_sound()) {
        return found;
    }
    return rounded.is_sound() ? rounded
                              : from_coarse_to_fine(problem, std::move(found.hypotheses), true);
}

/// Linearises what a search ended with that did not converge, with all edges taut.
void linearise_there(const FitProblem& problem, Explanation& best) {
    const Assumed assumed(problem, best.hypotheses);
    StaticsModel model = assumed.model;
    model.blur = best.at.blur;
    model.slack = assumed.as_seen(std::vector<bool>(problem.net.edge_count(), false));
    if (best.linearisation != nullptr) {
        model.corner_width = best.linearisation->model().corner_width;
        best.linearisation.reset();  // no two factors at once
    }
    LinearisedFit there = linearised_fit(model, best.at.iterate, assumed.observations());
    best.linearisation = std::make_shared<Linearisation>(std::move(there.linearisation));
    best.covariance = std::move(there.covariance);
}

/// What else may explain a fit, where anything is suspicious.
/// @return whether the boundary is to be tested at the result
bool try_others(const FitProblem& problem, Explanation& best) {
    bool tests_boundary = false;
    if (best.hypotheses.is_active(Family::boundary)) {
        test_hypotheses(problem, best, {.boundary = BoundaryTest::at_once});
        tests_boundary = best.hypotheses.may_be_boundary();
    }
    if (tests_boundary) {
        best = with_boundary(problem, std::move(best));
    }
    if (has_suspects(best.hypotheses)) {
        best = with_taut_edges(problem, std::move(best));
    }
    if (best.hypotheses.is_active(Family::lengths) && has_suspects(best.hypotheses)) {
        best = with_clamps(problem, std::move(best));
    }
    return tests_boundary || best.hypotheses.released_count(Family::boundary) > 0;
}

/// Tests of the force measurements in use at a fit without them; nothing where there are none, or
/// it does not converge.
std::optional<Hypotheses> tests_without_forces(const FitProblem& problem, const Explanation& best) {
    const std::vector<int> left_out = best.hypotheses.released(Suspect::force);
    if (!best.is_sound() || !best.hypotheses.is_active(Family::forces) ||
        left_out.size() == best.hypotheses.of(Suspect::force).size()) {
        return std::nullopt;
    }
    Hypotheses none = best.hypotheses;
    none.release_forces();
    FitState start = nominal_state(problem);
    start.slack = Assumed(problem, none).measured_slack(1.0);
    Explanation without = fit(problem, std::move(none), std::move(start));
    if (!without.is_sound()) {
        return std::nullopt;
    }
    test_hypotheses(problem, without);
    return std::move(without.hypotheses);
}

}  // namespace

SurveyFit fit_survey(const CableNet& net, const Survey& survey, const PriorKnowledge& knowledge,
                     const SurveyFitSettings& settings) {
    const FitProblem problem(net, survey, knowledge, settings);
    Explanation best = explain_from_nominal(problem, problem.hypotheses);  // (map), (snooping)
    if (!best.is_sound()) {
        best = by_rounded_tension_laws(problem, std::move(best.hypotheses));  // (rounded-law)
    }
    FitMode last;
    if (best.is_sound() && try_others(problem, best)) {  // (boundary), (slip)
        last.boundary = BoundaryTest::at_once;
    }
    if (!best.converged) {
        linearise_there(problem, best);
    }
    test_hypotheses(problem, best, last);
    double cost = best.cost;
    const bool contradicts_too_many = best.hypotheses.is_active(Family::targets) &&
                                      best.hypotheses.contradicts_too_many(Family::targets);
    if (contradicts_too_many) {
        cost = std::numeric_limits<double>::infinity();
        best.hypotheses.release_outliers(Suspect::target);
    }
    const std::optional<Hypotheses> without = tests_without_forces(problem, best);
    const Assumed assumed(problem, best.hypotheses);
    return {.at = {std::move(best.at.iterate), std::move(*best.linearisation),
                   std::move(best.covariance)},
            .converged = best.converged,
            .cost = cost,
            .contradicts_too_many = contradicts_too_many,
            .hypotheses = best.hypotheses,
            .knowledge = assumed.knowledge,
            .observations = assumed.observations(),
            .tolerance = problem.tolerance(),
            .outliers = target_outliers(best.hypotheses, problem.survey, problem.noise),
            .force_outliers = force_outliers(best.hypotheses, knowledge.forces.measurements,
                                             without ? &*without : nullptr),
            .length_outliers = length_outliers(best.hypotheses, net, knowledge.priors)};
}

}  // namespace taut
