// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "dicts.hpp"
#include "documents.hpp"
#include "identified.hpp"
#include "states.hpp"
#include "taut/adjustment/built_net.hpp"
#include "taut/files/file.hpp"
#include "taut/net/units.hpp"
#include "taut/results/draws_h5.hpp"
#include "taut/results/results_json.hpp"
#include "taut/statics/equilibrium.hpp"
#include "words.hpp"

namespace taut::python {
namespace {

/// Numbers of each interior edge.
auto of_edges(double IdentifiedEdge::* member) {
    return [member](const Identified& self) { return array_of_each(self.found.edges, member); };
}

/// Numbers of all edges, over the posterior samples; none without.
template <class Get>
auto of_drawn_edges(Get get) {
    return [get](const Identified& self) { return array_of_each(self.found.drawn.tensions, get); };
}

/// What result.json holds under a key.
auto part_of_json(const char* key) {
    return [key](const Identified& self) {
        return nb::object(dict_of(identification_to_json(self.net, self.survey, self.found))[key]);
    };
}

nb::object remedy_in_python(const std::optional<Trust::Remedy>& remedy) {
    if (!remedy) {
        return nb::none();
    }
    nb::dict result;
    const bool is_estimate = remedy->value == "estimate";
    result["parameter"] = is_estimate ? "estimate_noise" : remedy->parameter;
    result["value"] = nb::none();
    if (is_estimate) {
        result["value"] = true;
    } else if (remedy->parameter == "noise") {
        result["value"] = parse_length(remedy->value);
    } else if (remedy->parameter == "uncertain" && !remedy->value.empty()) {
        result["value"] = nb::str(remedy->value.c_str()).attr("split")();
    } else if (!remedy->value.empty()) {
        result["value"] = remedy->value;
    }
    return result;
}

nb::list findings_of(const Trust& trust) {
    nb::list list;
    for (const Trust::Finding& finding : trust.findings) {
        nb::dict one = dict_of_fields(finding);
        one["remedy"] = remedy_in_python(finding.remedy);
        one["reason"] = in_python(finding.reason);
        one["next"] = advice_in_python(finding);
        list.append(one);
    }
    return list;
}

nb::list epochs_of(const Identified& self) {
    nb::list list;
    for (const EpochResult& epoch : self.found.epochs) {
        nb::dict one = dict_of_fields(epoch);
        one["trust"] = to_string(epoch.trust.verdict());
        one["findings"] = findings_of(epoch.trust);
        list.append(one);
    }
    return list;
}

std::string repr(const Identified& self) {
    const Identification& found = self.found;
    if (found.status != IdentificationStatus::converged) {
        return fmt::format("Identification({}: {})", to_string(found.status),
                           in_python(found.message));
    }
    int slack = 0;
    int not_determined = 0;
    for (const IdentifiedEdge& edge : found.edges) {
        slack += edge.status == EdgeStatus::slack ? 1 : 0;
        not_determined += edge.status == EdgeStatus::not_determined ? 1 : 0;
    }
    return fmt::format(
        "Identification({}; {} edges by {}, {} slack, {} not determined; {})",
        to_string(found.trust.verdict()), found.edges.size(), found.method, slack, not_determined,
        found.trust.findings.empty() ? "no findings"
                                     : in_python(found.trust.findings.front().reason));
}

void bind_numbers(nb::class_<Identified>& result) {
    result
        .def_prop_ro(
            "edge", [](const Identified& self) { return edges_of_each(self.found.edges); },
            "Interior edges (m_I,), in the order of all arrays of lengths below.")
        .def_prop_ro("nominal", of_edges(&IdentifiedEdge::nominal),
                     "Unstressed lengths as designed (m_I,) [m].")
        .def_prop_ro("length_deviation", of_edges(&IdentifiedEdge::length_deviation),
                     "Estimate of the true length minus the nominal one (m_I,) [m].")
        .def_prop_ro("std", of_edges(&IdentifiedEdge::std_dev),
                     "Standard deviation of the estimate (m_I,) [m].")
        .def_prop_ro("lower", of_edges(&IdentifiedEdge::lower),
                     "Lower end of the 95 % interval of the deviation (m_I,) [m].")
        .def_prop_ro("upper", of_edges(&IdentifiedEdge::upper),
                     "Upper end of the 95 % interval of the deviation (m_I,) [m].")
        .def_prop_ro(
            "edge_status", [](const Identified& self) { return status_of_each(self.found.edges); },
            "Of each interior edge 'determined', 'weakly_determined', 'not_determined' or 'slack' "
            "(only a lower bound is known).")
        .def_prop_ro(
            "tension",
            [](nb::handle_t<Identified> self) {
                return view_of(nb::cast<const Identified&>(self).found.tensions, self);
            },
            "Of all edges in the predicted form (m,) [N].")
        .def_prop_ro("tension_lower",
                     of_drawn_edges([](const DrawnTension& of) { return of.tension.lower; }),
                     "Lower ends of the 95 % intervals (m,); empty without posterior samples [N].")
        .def_prop_ro("tension_upper",
                     of_drawn_edges([](const DrawnTension& of) { return of.tension.upper; }),
                     "Upper ends of the 95 % intervals (m,); empty without posterior samples [N].")
        .def_prop_ro(
            "slack_probability",
            of_drawn_edges([](const DrawnTension& of) { return of.slack_probability; }),
            "Probability that an edge carries nothing (m,); empty without posterior samples.")
        .def_prop_ro(
            "form",
            [](nb::handle_t<Identified> self) {
                return view_of(nb::cast<const Identified&>(self).found.predicted.form, self);
            },
            "Predicted form, supports included (n, 3) [m].")
        .def_prop_ro(
            "predicted",
            [](const Identified& self) -> const Equilibrium& { return self.found.predicted; },
            nb::rv_policy::reference_internal,
            "Equilibrium of the net with the identified lengths.")
        .def_prop_ro(
            "length_draws",
            [](nb::handle_t<Identified> self) -> std::optional<Array> {
                const auto& found = nb::cast<const Identified&>(self).found;
                return found.draws
                           ? std::optional(rows_of_columns(found.draws->length_deviations, self))
                           : std::nullopt;
            },
            "Posterior samples of length_deviation (draws, m_I) [m]; None without.")
        .def_prop_ro(
            "length_covariance",
            [](nb::handle_t<Identified> self) -> std::optional<Array> {
                const auto& found = nb::cast<const Identified&>(self).found;
                return found.length_covariance ? std::optional(rows_of_columns(
                                                     found.length_covariance->covariance, self))
                                               : std::nullopt;
            },
            "Between the lengths of the edges of covariance_of, in their order (k, k) [m2]; None "
            "without.");
}

/// What the checks are made of, as C++ has it.
void bind_checks(nb::class_<Identified>& result) {
    bind_fields<Identification>(
        result, &Identified::found,
        {{"method_reason", "Why this method was used."},
         {"stretches",
          "Cables that slide, one length from clamp to clamp. Of each: edges, nominal, "
          "length_deviation and its std [m], tension and tension_std [N]."},
         {"residuals",
          "Distances of the surveyed free nodes from the predicted form, in the order of "
          "survey.surveyed (k,) [m]."},
         {"outliers",
          "Targets that were left out, the worst first. Of each: node, distance [m] of the survey "
          "from where all else puts it, statistic, swapped_with (node; -1: none)."},
         {"outlier_threshold", "Limit of statistic of the outliers; 0: no test."},
         {"noise_ratio",
          "Variance factor: residuals over those expected, root mean square; 0: not computed."},
         {"noise_scale",
          "Factor by which the survey's standard deviation was multiplied, with estimate_noise."},
         {"length_outliers",
          "Edges whose length the prior does not explain, the worst first. Of each: edge, "
          "deviation and std [m], statistic; other, the edge that a slipped or swapped cable "
          "changed as well, and node between them (-1: none); is_beside_target, whether a wrong "
          "target explains it as well; is_swapped."},
         {"boundary_outliers",
          "Adjustable edges and supports that are not as designed, the worst first. Of each: kind "
          "('adjustable_edge', 'support'), index, deviation and std (3,) [m] (of an edge the first "
          "alone), statistic, confounded_with (-1: none)."},
         {"boundary_not_released",
          "Number of other adjustable edges and supports that contradict the survey and were taken "
          "as designed."},
         {"frame_offset",
          "Small motion of the survey's frame from the net's, where it was estimated: rotation "
          "[rad] about a point, then translation [m], with their std; else None."},
         {"scales",
          "Factors that fit the survey best, with their std: noise, of its standard deviation; "
          "lengths, of the prior; noise_by_axis, of the noise along x, y and z."},
         {"prior_check",
          "How the lengths fit the prior: checked, lengths (their number), likeliest prior, gain "
          "in log likelihood, mean and mean_std [m], outliers."},
         {"frame_check",
          "How the survey as a whole would fit better: scale and scale_std, translation [m], "
          "rotation [rad], motion_statistic."},
         {"load_check",
          "With which vertical load at each free node the survey would fit better: force, "
          "downwards, and its std if there is none [N]."},
         {"contradicted_prior",
          "prior_check of the prior given, where the survey contradicts it; else None."},
         {"prior_was_given", "Whether a prior was given."},
         {"force_measurements", "Number of force measurements."},
         {"force_outliers",
          "Force measurements that were left out, or are doubted (probability 0), the worst first. "
          "Of each: edge, measured and expected [N], statistic, source, mode, and the probability "
          "of the priors by which it was left out."},
         {"force_bias",
          "Where all were left out since each is off by the same part, or are doubted "
          "(probability 0): part, std, and the probability of the priors by which; else None."},
         {"contradicted_taut", "Edges that were marked taut and contradict the survey."},
         {"contradicted_slack", "Edges that were marked slack and contradict the survey."},
         {"uncertain",
          "Estimates of the uncertain parameters. Of each: parameter ('supports:1mm'), edge, node "
          "and axis that it is of (-1: of none), mean and std of the deviation from the net's, "
          "prior_std. Units: logarithm of a factor (stiffness), K, m, N, a part of the loads."},
         {"draws",
          "Posterior samples, a row each: length_deviations (draws, m_I) and adjustable_deviations "
          "(draws, m_A) [m], perturbations, forms (draws, 3 n_I) [m], tensions (draws, m) [N]; "
          "seed, how, is_refitted, and reason why they are not to be relied on; None without."},
         {"drawn",
          "What follows from the samples, mean, std, lower and upper each: tensions of all edges, "
          "with slack_probability, and mean_tension [N]; places of missing nodes [m]."},
         {"form_covariance",
          "Posterior covariance of each node's place in form, a list of (3, 3) arrays [m2]: of the "
          "samples at free nodes where there are 30 or more, else linearised; 0 of a known "
          "support. "
          "Empty of other methods than map, of an exact survey, and with unreliable samples."},
         {"turned",
          "What was turned since the net was as designed, with epochs: edge, stroke and std "
          "[m]."}});
}

}  // namespace

void bind_identification_result(nb::module_& module) {
    nb::class_<Identified> result(module, "Identification",
                                  "Length and tension of each cable with their intervals, and "
                                  "whether they may be relied on.");
    make_picklable(result);
    result.def_ro("net", &Identified::net, "As designed.")
        .def_ro("survey", &Identified::survey)
        .def_prop_ro(
            "status", [](const Identified& self) { return to_string(self.found.status); },
            "'converged'; with any other, numbers must not be used: see message.")
        .def_prop_ro(
            "message", [](const Identified& self) { return in_python(self.found.message); },
            "Why it did not converge, and what may help; else empty.")
        .def_prop_ro(
            "trust", [](const Identified& self) { return to_string(self.found.trust.verdict()); },
            "'passed', 'doubtful' or 'failed': whether it may be acted on.")
        .def_prop_ro(
            "findings", [](const Identified& self) { return findings_of(self.found.trust); },
            "What the checks found, the worst first. Of each: kind, severity ('passed', "
            "'doubtful', 'failed'), ids of its edges or nodes, value and std in SI units, "
            "confounded_with, remedy (parameter: an argument of identify() or read_survey(); "
            "value: None where it is to be chosen), reason, and what to do next.")
        .def_prop_ro(
            "epochs", &epochs_of,
            "Of each survey, where epochs were given: surveyed, turned, load, outliers, "
            "boundary_outliers, frame_offset, noise_ratio and noise_scale as here; change_ratio of "
            "the lengths over what both surveys let expect, and change_limit that chance exceeds "
            "once in a thousand; changes of single lengths [m]; excess_actuator_std [m]; "
            "stroke_factor that fits all strokes best, and stroke_factor_std; trust and findings.")
        .def_prop_ro(
            "method", [](const Identified& self) { return self.found.method; },
            "'map', 'balance' or 'gp'.")
        .def_prop_ro(
            "how", [](const Identified& self) { return in_python(self.found.description); },
            "What was done, in words.")
        .def_prop_ro(
            "length_prior",
            [](const Identified& self) { return to_string(self.found.length_prior); },
            "The most probable prior of the length deviations.")
        .def_prop_ro(
            "detectable", part_of_json("detectable"), nb::sig("def detectable(self) -> dict"),
            "The smallest error of each kind that the checks find with a probability of 80 %: "
            "target, length, adjustable, support [m], scale [-], temperature [K]; None: none is.")
        .def_prop_ro("assumptions", part_of_json("assumptions"),
                     nb::sig("def assumptions(self) -> list"),
                     "What was uncertain besides the lengths: name, value, std, unit, source "
                     "('given' or 'default') and whether the survey shows it (testable).")
        .def_prop_ro(
            "prior", part_of_json("prior"), nb::sig("def prior(self) -> dict"),
            "Prior of the length deviations after the survey: given, exact, std and std_std [m], "
            "uniform_probability, nodes with prior and weight; common, what the deviations have in "
            "common: mean and mean_std [m], run_std and run_probability of the runs of cable, "
            "adjustable and adjustable_std of the adjustable edges [m].")
        .def_prop_ro("noise", part_of_json("noise"), nb::sig("def noise(self) -> float"),
                     "Standard deviation of a surveyed coordinate, root mean square [m].")
        .def_prop_ro("frame", part_of_json("frame"), nb::sig("def frame(self) -> dict | None"),
                     "How the survey was moved to the net; None where it was in its frame.")
        .def_prop_ro("mean_tension", part_of_json("mean_tension"),
                     nb::sig("def mean_tension(self) -> dict | None"),
                     "Of all cables: mean, std, lower and upper [N]; None without samples.")
        .def_prop_ro("missing_places", part_of_json("missing_places"),
                     nb::sig("def missing_places(self) -> list"),
                     "Of each node that the survey misses: node, and mean, std, lower and upper of "
                     "its place [m]; empty without samples.")
        .def_prop_ro("diagnostics", part_of_json("diagnostics"),
                     nb::sig("def diagnostics(self) -> dict"),
                     "What result.json holds of the checks: noise, lengths, prior, frame, "
                     "length_outliers, boundary.")
        .def_prop_ro(
            "built", [](const Identified& self) { return built_net_of(self.net, self.found).net; },
            "The net as built: lengths as identified, nodes in equilibrium.")
        .def(
            "to_json",
            [](const Identified& self) {
                return identification_to_json(self.net, self.survey, self.found);
            },
            "What result.json holds.")
        .def(
            "to_dict",
            [](const Identified& self) {
                return dict_of(identification_to_json(self.net, self.survey, self.found));
            },
            "What result.json holds, as a dict.")
        .def(
            "save",
            [](const Identified& self, const std::filesystem::path& path) {
                std::vector<std::pair<std::filesystem::path, std::string>> files;
                if (self.found.draws) {
                    files.emplace_back(draws_path(path), draws_bytes(self.net, self.found));
                }
                files.emplace_back(path, identification_to_json(self.net, self.survey, self.found));
                write_files(files);
            },
            nb::arg("path"),
            "Writes result.json, and the posterior samples beside it, as taut identify does.")
        .def(
            "to_dataframe",
            [](nb::handle_t<Identified> self) {
                return of_package("taut.tables", "identification_frame")(self);
            },
            nb::sig("def to_dataframe(self) -> object"),
            "All edges as a pandas.DataFrame, SI units. Lengths of adjustable edges are known.")
        .def("_repr_html_",
             [](nb::handle_t<Identified> self) {
                 return of_package("taut.notebook", "result_html")(self);
             })
        .def("__repr__", &repr);
    bind_numbers(result);
    bind_checks(result);
}

}  // namespace taut::python
