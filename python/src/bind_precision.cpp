// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/map.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "dicts.hpp"
#include "given.hpp"
#include "states.hpp"
#include "taut/identification/predicted_precision.hpp"
#include "taut/identification/suggested_measurements.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut::python {
namespace {

/// In ascending order.
/// @throws nb::value_error for other than free nodes, each once
std::vector<int> target_nodes(const CableNet& net, const ArrayLike& targets) {
    std::vector<int> nodes = indices_argument(targets, "targets");
    std::ranges::sort(nodes);
    const auto refuse = [](int node, const char* why) {
        throw nb::value_error(
            fmt::format("targets: node {} {}, expected free nodes, each once", node, why).c_str());
    };
    for (size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i] < 0 || nodes[i] >= net.node_count()) {
            refuse(nodes[i], "is none of the net's");
        } else if (net.free_index(nodes[i]) < 0) {
            refuse(nodes[i], "is a support");
        } else if (i > 0 && nodes[i] == nodes[i - 1]) {
            refuse(nodes[i], "comes twice");
        }
    }
    return nodes;
}

/// At the designed form.
Survey planned_survey(const CableNet& net, const std::optional<ArrayLike>& targets, double noise) {
    const Equilibrium nominal = solve_equilibrium(net);
    if (!nominal.balanced()) {
        throw std::runtime_error("the net as designed finds no equilibrium");
    }
    if (!std::isfinite(noise) || noise < 0.0) {
        throw nb::value_error(fmt::format("noise: got {} m, expected 0 or more", noise).c_str());
    }
    Survey survey;
    survey.form = nominal.form;
    survey.surveyed = targets ? target_nodes(net, *targets) : net.free_nodes();
    survey.noise_std = Points::Constant(3, net.node_count(), noise);
    std::ranges::set_difference(net.free_nodes(), survey.surveyed,
                                std::back_inserter(survey.missing));
    return survey;
}

void bind_predicted_precision(nb::module_& module) {
    nb::class_<PredictedPrecision> precision(
        module, "PredictedPrecision",
        "How precisely a survey would determine lengths and tensions, before it is made.");
    make_picklable(precision);
    bind_fields<PredictedPrecision>(
        precision, std::identity(),
        {{"prior_std", "Standard deviation of each length deviation before the survey [m]."},
         {"mean_tension", "Mean over all cables, as designed [N]."},
         {"mean_tension_std", "Its standard deviation after the survey [N]."},
         {"force_candidates",
          "Force measurements that would help, the best first. Of each: edge, tension and its std "
          "[N], mean_std_if_measured, mean_tension_std with this one as well [N]."}});
    precision
        .def_prop_ro(
            "edge", [](const PredictedPrecision& self) { return edges_of_each(self.edges); },
            "Interior edges (m_I,), in the order of std and edge_status.")
        .def_prop_ro(
            "std",
            [](const PredictedPrecision& self) {
                return array_of_each(self.edges, &EdgePrecision::std_dev);
            },
            "Standard deviation of each length deviation after the survey (m_I,) [m].")
        .def_prop_ro(
            "edge_status",
            [](const PredictedPrecision& self) { return status_of_each(self.edges); },
            "Most probable status of each interior edge, as Identification.edge_status.")
        .def("to_dict", &dict_of_fields<PredictedPrecision>, nb::sig("def to_dict(self) -> dict"),
             "All of it, SI units.")
        .def(
            "to_dataframe",
            [](nb::handle_t<PredictedPrecision> self) {
                return of_package("taut.tables", "precision_frame")(self);
            },
            nb::sig("def to_dataframe(self) -> object"),
            "The interior edges as a pandas.DataFrame, SI units.")
        .def("__repr__", [](const PredictedPrecision& self) {
            return fmt::format(
                "PredictedPrecision({} edges: {} determined, {} weakly determined, {} not "
                "determined, {} slack; RMS std {:.3g} mm, {:.3g} mm before)",
                self.edges.size(), self.count(EdgeStatus::determined),
                self.count(EdgeStatus::weakly_determined), self.count(EdgeStatus::not_determined),
                self.count(EdgeStatus::slack), 1e3 * self.rms_std(), 1e3 * self.prior_std);
        });
    module.def(
        "inspect",
        [](const CableNet& net, const std::optional<ArrayLike>& targets,
           const QuantityLike& given_noise, const std::string& prior,
           const std::vector<std::string>& uncertain) {
            const double noise = length_given(given_noise, "noise");
            const Survey survey = planned_survey(net, targets, noise);
            return interruptible(nb::none(), [&](const Progress& progress) {
                return predicted_precision(net, survey.form, survey, parse_length_prior(prior),
                                           {.uncertain = uncertain_given(net, uncertain),
                                            .assume_site = assumes_site(uncertain)},
                                           progress);
            });
        },
        nb::arg("net"), nb::kw_only(), nb::arg("targets") = nb::none(), nb::arg("noise") = 0.5e-3,
        nb::arg("prior") = "uniform:5mm", nb::arg("uncertain") = std::vector<std::string>(),
        R"(Predicts how precisely a survey would determine lengths and tensions, before it is made.

Args:
    targets: free nodes that are to be surveyed, by default all.
    noise: standard deviation of each coordinate [m].
    prior: of the length deviations.
    uncertain: as for identify().)");
}

void bind_suggestions(nb::module_& module) {
    nb::class_<MeasurementSuggestions> result(
        module, "MeasurementSuggestions",
        "Which measurements to make besides a survey, one after the other.");
    make_picklable(result);
    bind_fields<MeasurementSuggestions>(
        result, std::identity(),
        {{"quantity", "What they make sure: mean-tension, worst-tension or form."},
         {"mean_tension", "Over all cables, as designed [N]."},
         {"std", "Of that quantity after the survey alone: of a tension [N], of the form [m]."},
         {"steps",
          "The best first. Of each: kind (load-cell, frequency, sag, target or load), edge or node "
          "(-1 where it is not at one), expected value (N, Hz, m; of a load its size) and std of "
          "the measurement in that unit, remaining_std of the quantity with this one and those "
          "before it, total_cost with those before it."},
         {"left_out", "Kinds that are not among them, and why."}});
    result
        .def("to_dict", &dict_of_fields<MeasurementSuggestions>,
             nb::sig("def to_dict(self) -> dict"), "All of it, SI units.")
        .def("__repr__", [](const MeasurementSuggestions& self) {
            const auto first = self.steps.begin();
            return self.steps.empty()
                       ? fmt::format("MeasurementSuggestions({}: no further measurement helps)",
                                     to_string(self.quantity))
                       : fmt::format(
                             "MeasurementSuggestions({}: first {} at {} {}; std {:.4g}, "
                             "{:.4g} with all {})",
                             to_string(self.quantity), to_string(first->kind),
                             first->edge >= 0 ? "edge" : "node",
                             first->edge >= 0 ? first->edge : first->node, self.std_dev,
                             self.steps.back().remaining_std, self.steps.size());
        });
    module.def(
        "suggest_measurements",
        [](const CableNet& net, const std::optional<ArrayLike>& targets,
           const QuantityLike& given_noise, const std::string& prior,
           const std::vector<std::string>& uncertain, const std::string& quantity,
           const std::map<std::string, double>& costs, const QuantityLike& load,
           double frequency_noise, const QuantityLike& free_length_std, int count) {
            const double noise = length_given(given_noise, "noise");
            const Survey survey = planned_survey(net, targets, noise);
            const double hung = force_given(load, "load");
            const double free_std = length_given(free_length_std, "free_length_std");
            return interruptible(nb::none(), [&](const Progress& progress) {
                SuggestOptions options{.quantity = parse_sought_quantity(quantity),
                                       .load = hung,
                                       .frequency_std = frequency_noise,
                                       .free_length_std = free_std,
                                       .most = count,
                                       .assume_site = assumes_site(uncertain)};
                for (const auto& [kind, cost] : costs) {
                    options.costs[parse_measurement_kind(kind)] = cost;
                }
                return suggested_measurements(net, survey.form, survey, parse_length_prior(prior),
                                              {}, uncertain_given(net, uncertain), options,
                                              progress);
            });
        },
        nb::arg("net"), nb::kw_only(), nb::arg("targets") = nb::none(), nb::arg("noise") = 0.5e-3,
        nb::arg("prior") = "uniform:5mm", nb::arg("uncertain") = std::vector<std::string>(),
        nb::arg("quantity") = "mean-tension", nb::arg("costs") = std::map<std::string, double>(),
        nb::arg("load") = 0.0, nb::arg("frequency_noise") = SuggestOptions().frequency_std,
        nb::arg("free_length_std") = SuggestOptions().free_length_std, nb::arg("count") = 5,
        R"(Suggests which measurements to make besides a survey, each the best given those before it.

Args:
    targets: free nodes that are to be surveyed, by default all.
    noise: standard deviation of each coordinate [m].
    prior: of the length deviations.
    uncertain: as for identify().
    quantity: whose standard deviation they lower: "mean-tension", "worst-tension" or "form".
    costs: of one measurement, by kind: "load-cell", "frequency", "sag", "target", "load"; 1 of
        those that are not given.
    load: that could be hung on a node; 0: a twentieth of the mean tension [N].
    frequency_noise: standard deviation of a frequency, as a part of it.
    free_length_std: standard deviation of the length that vibrates [m].
    count: of measurements, at most.)");
}

}  // namespace

void bind_precision(nb::module_& module) {
    bind_predicted_precision(module);
    bind_suggestions(module);
}

}  // namespace taut::python
