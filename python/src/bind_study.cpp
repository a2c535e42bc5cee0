// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <nanobind/nanobind.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <string>
#include <vector>

#include "bindings.hpp"
#include "calls.hpp"
#include "documents.hpp"
#include "given.hpp"
#include "taut/results/comparison_files.hpp"
#include "taut/results/results_json.hpp"
#include "taut/study/comparison.hpp"
#include "taut/study/study.hpp"

namespace taut::python {

void bind_study(nb::module_& module) {
    module.def(
        "compare",
        [](const CableNet& net, const std::vector<double>& noises,
           const std::vector<int>& training_samples, const std::vector<double>& hidden_parts,
           int surveys, const std::string& prior, const std::vector<std::string>& uncertain,
           std::uint64_t seed, const nb::object& progress) {
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
