// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "calls.hpp"
#include "documents.hpp"
#include "given.hpp"
#include "taut/results/comparison_files.hpp"
#include "taut/results/control_files.hpp"
#include "taut/results/results_json.hpp"
#include "taut/study/comparison.hpp"
#include "taut/study/control.hpp"
#include "taut/study/study.hpp"

namespace taut::python {

namespace {

nb::object controlled(const CableNet& net, const QuantityLike& stroke,
                      const std::optional<std::pair<QuantityLike, QuantityLike>>& tension,
                      const std::optional<QuantityLike>& turn, const std::optional<double>& step,
                      const QuantityLike& noise, double hidden_part,
                      const QuantityLike& actuator_std, double confidence, const std::string& prior,
                      const std::vector<std::string>& uncertain, int draws, int rounds, int trials,
                      std::uint64_t seed, const nb::object& progress) {
    ControlSettings settings{.prior = parse_length_prior(prior),
                             .uncertain = uncertain_given(net, uncertain),
                             .noise_std = length_given(noise, "noise"),
                             .hidden_part = hidden_part,
                             .actuator_std = length_given(actuator_std, "actuator_std"),
                             .stroke = length_given(stroke, "stroke"),
                             .confidence = confidence,
                             .draws = draws,
                             .rounds = rounds,
                             .trials = trials,
                             .seed = seed};
    if (assumes_site(uncertain)) {
        settings.uncertain = with_site_assumptions(net, settings.uncertain);
    }
    if (tension) {
        const double most = force_given(tension->second, "tension");
        settings.least_tension = force_given(tension->first, "tension");
        settings.most_tension = std::isinf(most) ? 0.0 : most;
    }
    if (turn) {
        settings.turn =
            TurnSize{.pitch = length_given(*turn, "turn"), .smallest = step.value_or(0.0)};
    } else if (step) {
        throw nb::value_error("step: is a part of a turn, and turn is not given");
    }
    return dict_of(control_to_json(interruptible(progress,
                                                 [&](const Progress& reporter) {
                                                     return simulate_control(net, settings,
                                                                             reporter);
                                                 }),
                                   net, settings, {}));
}

}  // namespace

void bind_study(nb::module_& module) {
    module.def(
        "control", &controlled, nb::arg("net"), nb::kw_only(),
        nb::arg("stroke") = ControlSettings().stroke, nb::arg("tension") = nb::none(),
        nb::arg("turn") = nb::none(), nb::arg("step") = nb::none(),
        nb::arg("noise") = ControlSettings().noise_std,
        nb::arg("hidden_part") = ControlSettings().hidden_part,
        nb::arg("actuator_std") = ControlSettings().actuator_std,
        nb::arg("confidence") = ControlSettings().confidence, nb::arg("prior") = "uniform:5mm",
        nb::arg("uncertain") = std::vector<std::string>(),
        nb::arg("draws") = ControlSettings().draws, nb::arg("rounds") = ControlSettings().rounds,
        nb::arg("trials") = ControlSettings().trials, nb::arg("seed") = 1,
        nb::arg("progress") = nb::none(),
        R"(Simulates whole jobs of survey, identification, plan and turns, beside the same with the
true lengths and with the design only: what control.json holds.

Args:
    stroke: largest change of length of a turnbuckle since installation, either way [m].
    tension: least and most tension of all edges [N]; None: no edge slack.
    turn: change of length by one turn [m]; None: any stroke can be turned.
    step: smallest part of a turn.
    noise: standard deviation of a surveyed coordinate [m].
    hidden_part: part of the free nodes that is not surveyed.
    actuator_std: standard deviation of a stroke from the planned one [m].
    confidence: probability with which plans on identified lengths keep the limits.
    prior: of the length deviations of the nets as built.
    uncertain: widths of what else is uncertain, as of identify.
    draws: posterior samples of each identification.
    rounds: number of surveys, each followed by its turns.
    trials: number of simulated nets.

Raises:
    ValueError: for settings out of range.)");
    module.def(
        "compare",
        [](const CableNet& net, const std::vector<QuantityLike>& given_noises,
           const std::vector<int>& training_samples, const std::vector<double>& hidden_parts,
           int surveys, const std::string& prior, const std::vector<std::string>& uncertain,
           std::uint64_t seed, const nb::object& progress) {
            std::vector<double> noises;
            for (const QuantityLike& noise : given_noises) {
                noises.push_back(length_given(noise, "noises"));
            }
            const ComparisonSettings settings{.noises = noises,
                                              .training_samples = training_samples,
                                              .hidden_parts = hidden_parts,
                                              .surveys = surveys,
                                              .prior = parse_length_prior(prior),
                                              .seed = seed,
                                              .uncertain = uncertain_given(net, uncertain)};
            return dict_of(
                comparison_to_json(interruptible(progress, [&](const Progress& reporter) {
                    return compare_methods(net, settings, reporter);
                })));
        },
        nb::arg("net"), nb::kw_only(), nb::arg("noises") = ComparisonSettings().noises,
        nb::arg("training_samples") = ComparisonSettings().training_samples,
        nb::arg("hidden_parts") = ComparisonSettings().hidden_parts,
        nb::arg("surveys") = ComparisonSettings().surveys, nb::arg("prior") = "uniform:5mm",
        nb::arg("uncertain") = std::vector<std::string>(), nb::arg("seed") = 1,
        nb::arg("progress") = nb::none(),
        R"(Compares all methods of identification on simulated surveys: what comparison.json holds.

Args:
    noises: standard deviations of surveyed coordinates [m].
    hidden_parts: parts of the free nodes that have no target.
    surveys: number of each kind.)");
    module.def(
        "reproduce",
        [](const CableNet& net, int samples, int validation, const std::string& prior,
           std::uint64_t seed, const nb::object& progress) {
            const StudySettings settings{.samples = samples,
                                         .validation = validation,
                                         .prior = parse_length_prior(prior),
                                         .seed = seed};
            return dict_of(study_to_json(interruptible(progress, [&](const Progress& reporter) {
                return run_study(net, settings, reporter);
            })));
        },
        nb::arg("net"), nb::kw_only(), nb::arg("samples") = StudySettings().samples,
        nb::arg("validation") = StudySettings().validation, nb::arg("prior") = "uniform:5mm",
        nb::arg("seed") = 1, nb::arg("progress") = nb::none(),
        "The paper's numerical experiment on a net: what results.json holds.");
}

}  // namespace taut::python
