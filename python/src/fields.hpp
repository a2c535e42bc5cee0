// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// The fields of the structs that results are made of, in their order, with the names that they have
// in Python: for states.hpp and dicts.hpp. A list that leaves out a field does not compile.
#pragma once

#include <concepts>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "identified.hpp"
#include "planned.hpp"
#include "taut/gp/fit.hpp"
#include "taut/identification/model.hpp"
#include "taut/identification/predicted_precision.hpp"
#include "taut/identification/suggested_measurements.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/survey/cable_frequency.hpp"

namespace taut::python {

/// std::tie, by a name that no field has: one is called std.
template <class... Fields>
std::tuple<Fields&...> references_to(Fields&... fields) {
    return {fields...};
}

#define TAUT_FIELDS(Type, ...)                                      \
    template <class Of>                                             \
        requires std::same_as<std::remove_const_t<Of>, Type>        \
    auto fields_of(Of& object) {                                    \
        auto& [__VA_ARGS__] = object;                               \
        return references_to(__VA_ARGS__);                          \
    }                                                               \
    constexpr std::string_view names_of(std::type_identity<Type>) { \
        return #__VA_ARGS__;                                        \
    }

// sampling, statics
TAUT_FIELDS(LengthPrior, kind, scale)
TAUT_FIELDS(UncertainParameter, kind, std, group)
TAUT_FIELDS(Equilibrium, form, unstressed_lengths, status, iterations, out_of_balance, mean_tension,
            slack_edges, energy_decreases)
TAUT_FIELDS(DataSet, net_fingerprint, prior, seed, uncertain, nominal_form, form_deviations,
            length_deviations, statuses, slack_counts)
TAUT_FIELDS(SamplePart, first, samples)
TAUT_FIELDS(TensionLaw, name, strain, tension, sag)

// survey
TAUT_FIELDS(SurveyPoint, id, position, line, noise_std, noise_correlations, label, code)
TAUT_FIELDS(UnmatchedPoint, point, nearest, distance, reason, swapped_with)
TAUT_FIELDS(SurveyedSupport, node, position, noise_std, noise_correlations)
TAUT_FIELDS(PlacedPoint, name, line, node, distance, code)
TAUT_FIELDS(RigidMotion, rotation, from, to)
TAUT_FIELDS(ControlResidual, id, residual)
TAUT_FIELDS(Registration, motion, residuals)
TAUT_FIELDS(Survey, form, noise_std, noise_correlations, surveyed, missing, supports,
            frame_is_unknown, unmatched, frame, warnings, placed, contradicted_names, notes,
            has_own_noise, scale_std, rounding_std)
TAUT_FIELDS(EdgeTurned, edge, stroke, std)
TAUT_FIELDS(FrequencyRange, lowest, highest)
TAUT_FIELDS(FrequencyPeak, frequency, std, level, mode)
TAUT_FIELDS(Fundamental, frequency, std, inharmonicity, misfit, modes, probability)
TAUT_FIELDS(CableFrequency, peaks, fundamental, message, needs_range, candidates, warnings,
            searched, duration, resolution, spectrum_step, spectrum)

// gp
TAUT_FIELDS(gp::Hyperparameters, inverse_length_scale, signal_std, noise_std)
TAUT_FIELDS(gp::KernelSpectrum, inverse_length_scale, eigenvalues, eigenvectors, tail_mean,
            tail_largest)
TAUT_FIELDS(gp::Process, status, hyperparameters, negative_log_likelihood, leave_one_out_rmse,
            spectrum, approximation_error)
TAUT_FIELDS(gp::FittedProcesses, inputs, spectra, processes, weights, decompositions, is_converged)

// estimation, identification
TAUT_FIELDS(Outlier, node, distance, statistic, swapped_with)
TAUT_FIELDS(ForceOutlier, edge, measured, expected, statistic, source, mode, probability)
TAUT_FIELDS(LengthOutlier, edge, deviation, std, statistic, other, node, is_beside_target,
            is_swapped)
TAUT_FIELDS(BoundaryOutlier, kind, index, deviation, std, statistic, confounded_with)
TAUT_FIELDS(ForceBias, part, std, probability)
TAUT_FIELDS(FoundScale, ratio, std)
TAUT_FIELDS(VarianceComponents, noise, lengths, noise_by_axis)
TAUT_FIELDS(PriorCheck, checked, lengths, likeliest, gain, mean, mean_std, outliers)
TAUT_FIELDS(DetectableErrors, target, length, adjustable, support, scale, temperature, force,
            force_scale, load)
TAUT_FIELDS(PriorNode, prior, weight)
TAUT_FIELDS(CommonDeviation, mean, mean_std, runs, run_std, run_probability, struts, struts_std,
            adjustable, adjustable_std)
TAUT_FIELDS(PriorEstimate, given, exact, std, std_std, uniform_probability, common, nodes)
TAUT_FIELDS(FrameCheck, scale, scale_std, translation, rotation, motion_statistic)
TAUT_FIELDS(LoadCheck, force, std)
TAUT_FIELDS(ModelPerturbations, stiffness, thermal, supports, loads)
TAUT_FIELDS(PosteriorDraws, length_deviations, adjustable_deviations, perturbations, forms,
            tensions, seed, how, is_refitted, reason)
TAUT_FIELDS(DrawnEstimate, mean, std, lower, upper)
TAUT_FIELDS(DrawnTension, edge, tension, slack_probability)
TAUT_FIELDS(DrawnPlace, node, mean, std, lower, upper)
TAUT_FIELDS(DrawnSummary, tensions, mean_tension, missing)
TAUT_FIELDS(Trust::Remedy, parameter, value)
TAUT_FIELDS(Trust::Finding, kind, severity, ids, value, std, confounded_with, remedy, reason, next)
TAUT_FIELDS(Trust, findings)
TAUT_FIELDS(ParameterEstimate, parameter, edge, node, axis, mean, std, prior_std)
TAUT_FIELDS(IdentifiedEdge, edge, nominal, length_deviation, std, lower, upper, status)
TAUT_FIELDS(StretchLength, edges, nominal, friction, length_deviation, std, tension, tension_std)
TAUT_FIELDS(Assumption, parameter, is_default, is_testable)
TAUT_FIELDS(LengthCovariance, edges, covariance)
TAUT_FIELDS(FrameOffset, about, translation, translation_std, rotation, rotation_std)
TAUT_FIELDS(LengthChange, edge, change, std, statistic)
TAUT_FIELDS(EpochResult, surveyed, turned, load, outliers, boundary_outliers, frame_offset,
            noise_ratio, noise_scale, change_ratio, change_limit, changes, excess_actuator_std,
            stroke_factor, stroke_factor_std, trust)
TAUT_FIELDS(Identification, method, method_reason, how, length_prior, prior, status, message, edges,
            stretches, predicted, tensions, residuals, outliers, outlier_threshold, noise_ratio,
            length_outliers, boundary_outliers, boundary_not_released, detectable, noise_scale,
            frame_offset, scales, prior_check, frame_check, load_check, contradicted_prior,
            prior_was_given, force_measurements, force_outliers, force_bias, contradicted_taut,
            contradicted_slack, assumptions, uncertain, draws, epochs, turned, trust,
            length_covariance, form_covariance, drawn)
TAUT_FIELDS(Identified, net, survey, found)
TAUT_FIELDS(FormPrior, mean, variances, directions, inputs)
TAUT_FIELDS(LengthModel, net_fingerprint, prior, seed, uncertain, mean, metric, as_in_paper,
            nominal_form, input_scales, length_deviations, processes, form_prior)
TAUT_FIELDS(EdgePrecision, edge, std, status)
TAUT_FIELDS(TensionPrecision, edge, tension, std, mean_std_if_measured)
TAUT_FIELDS(PredictedPrecision, prior_std, edges, mean_tension, mean_tension_std, force_candidates)
TAUT_FIELDS(SuggestedMeasurement, kind, edge, node, expected, std, remaining_std, total_cost)
TAUT_FIELDS(MeasurementSuggestions, quantity, mean_tension, std, steps, left_out)

// adjustment
TAUT_FIELDS(CableRun, name, edges, slides_at, friction, ratios)
TAUT_FIELDS(ModelPerturbation, stiffness, thermal, supports, adjustable, loads, own_loads,
            support_stiffness, sag, runs)
TAUT_FIELDS(BuiltNet, net, length_draws, perturbations, no_draws_because, failed_because,
            shown_lengths)
TAUT_FIELDS(TensionLimits, lower, upper)
TAUT_FIELDS(ReactionLimit, name, supports, upper)
TAUT_FIELDS(LoadCase, name, loads, tension)
TAUT_FIELDS(ForceRange, lower, upper)
TAUT_FIELDS(DeviationWeights, normal, tangential)
TAUT_FIELDS(NodeWeights, node, normal, tangential)
TAUT_FIELDS(GivenTarget, points, triangles, weights, node_weights, objective)
TAUT_FIELDS(Limits, shortest_stroke, longest_stroke, tension, reactions, load_cases)
TAUT_FIELDS(TurnSize, pitch, smallest)
TAUT_FIELDS(TensionTarget, edge, tension, tolerance)
TAUT_FIELDS(ReachedTension, edge, target, tolerance, as_built, planned, unconstrained, of_any_form,
            mean, std, probability, obstacle)
TAUT_FIELDS(PlanOptions, edges, confidence, actuator_std, turn, tolerance, survey_noise, seed,
            accept_failed, target_tensions, form_tolerance)
TAUT_FIELDS(PlannedStroke, edge, stroke)
TAUT_FIELDS(LimitBreach, kind, index, load_case, value, limit, probability)
TAUT_FIELDS(SuggestedTarget, node, normal_std)
TAUT_FIELDS(SuggestedEdge, edge, stroke, normal_rmse_after, tension_rmse_after)
TAUT_FIELDS(FormDeviation, mean, max, rmse, normal_mean, normal_max, normal_rmse)
TAUT_FIELDS(Plan, strokes, as_built, planned, unconstrained, target_tensions, normal_std,
            suggested_targets, form, form_std, form_covariance, tensions, tension_lower,
            tension_upper, effective_limits, draws, draws_needed, no_draws_because,
            limit_probability, is_feasible, has_converged, breaches, normal_rmse_of_free_strokes,
            is_within_tolerance, fewest_bound, iterations)
TAUT_FIELDS(StageEnd, name, part, step, least_tension, most_tension, safe_probability)
TAUT_FIELDS(Turning, edge, stroke, pass, crew, step, tension, length, frequency)
TAUT_FIELDS(WorstStep, step, breach)
TAUT_FIELDS(TurnOrder, turnings, passes, stages, walk, safe_probability, is_safe, worst)
TAUT_FIELDS(PlannedTurns, options, limits, plan, order, suggested_adjustable, crews, thread)
TAUT_FIELDS(Planned, net, built, trust, target, turns)

#undef TAUT_FIELDS

}  // namespace taut::python
