// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "given.hpp"
#include "identified.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/identification/force_units.hpp"
#include "taut/identification/identify.hpp"
#include "taut/identification/model.hpp"
#include "taut/survey/cable_sag.hpp"
#include "taut/survey/cable_vibration.hpp"

namespace taut::python {
namespace {

/// Edge, value, standard deviation: a measured tension [N], or a stroke [m].
using OfEdges = std::vector<std::tuple<int, QuantityLike, QuantityLike>>;

/// A later survey, what was turned before it, and loads that hung on the net then alone.
using LaterSurvey =
    std::variant<std::tuple<Survey, OfEdges>, std::tuple<Survey, OfEdges, ArrayLike>>;

/// Edge, frequency [Hz], mode, standard deviation [Hz].
using Frequencies = std::vector<std::tuple<int, double, int, double>>;

/// Edge, points (k, 3) [m], standard deviation [m].
using Sags = std::vector<std::tuple<int, ArrayLike, QuantityLike>>;

Forces forces_given(const CableNet& net, const Survey& survey, const OfEdges& measured,
                    const Frequencies& frequencies, double free_length_std, const Sags& sags,
                    const std::optional<ArrayLike>& taut_edges,
                    const std::optional<ArrayLike>& slack_edges) {
    Forces forces;
    for (const auto& [edge, tension, std_dev] : measured) {
        forces.measurements.push_back({.edge = edge,
                                       .tension = force_given(tension, "forces"),
                                       .std_dev = force_given(std_dev, "forces")});
    }
    for (const auto& [edge, frequency, mode, std_dev] : frequencies) {
        forces.measurements.push_back(tension_by_frequency(
            net, survey.form,
            {.edge = edge, .frequency = frequency, .mode = mode, .std_dev = std_dev},
            free_length_std));
    }
    std::vector<SagPoint> on_cables;
    for (const auto& [edge, places, std_dev] : sags) {
        const Points points = points_argument(places, "sag", -1);
        for (Eigen::Index k = 0; k < points.cols(); ++k) {
            on_cables.push_back(
                {.edge = edge, .position = points.col(k), .std_dev = length_given(std_dev, "sag")});
        }
    }
    std::ranges::move(tensions_by_sag(net, survey.form, on_cables),
                      std::back_inserter(forces.measurements));
    if (taut_edges) {
        forces.taut = indices_argument(*taut_edges, "taut_edges");
    }
    if (slack_edges) {
        forces.slack = indices_argument(*slack_edges, "slack_edges");
    }
    check_forces(net, forces);
    if (const std::string warning = force_unit_warning(net, forces.measurements);
        !warning.empty()) {
        warn("forces: " + warning);
    }
    return forces;
}

Identified identified(const CableNet& net, const Survey& survey, const IdentifyOptions& options,
                      const std::vector<LaterSurvey>& epochs, const nb::object& progress) {
    if (epochs.empty()) {
        Identification found = interruptible(progress, [&](const Progress& reporter) {
            return identify(net, survey, options, reporter);
        });
        return {.net = net, .survey = survey, .found = std::move(found)};
    }
    std::vector<Epoch> all{{.survey = survey, .turned = {}}};
    for (const LaterSurvey& later : epochs) {
        std::visit(
            [&](const auto& parts) {
                Epoch epoch{.survey = std::get<0>(parts), .turned = {}};
                for (const auto& [edge, stroke, std_dev] : std::get<1>(parts)) {
                    epoch.turned.push_back({.edge = edge,
                                            .stroke = length_given(stroke, "epochs"),
                                            .std_dev = length_given(std_dev, "epochs")});
                }
                if constexpr (std::tuple_size_v<std::decay_t<decltype(parts)>> == 3) {
                    epoch.loads = points_argument(std::get<2>(parts), "loads", net.node_count());
                }
                all.push_back(std::move(epoch));
            },
            later);
    }
    Identification found = interruptible(progress, [&](const Progress& reporter) {
        return identify_epochs(net, all, options, reporter);
    });
    return {.net = net, .survey = all[reported_epoch(all)].survey, .found = std::move(found)};
}

}  // namespace

void bind_identification(nb::module_& module) {
    bind_identification_result(module);
    module.def(
        "identify",
        [](const CableNet& net, const Survey& survey, const std::optional<std::string>& method,
           const std::optional<std::string>& prior, const LengthModel* model, const OfEdges& forces,
           const std::optional<ArrayLike>& taut_edges, const std::optional<ArrayLike>& slack_edges,
           const std::vector<std::string>& uncertain, const std::optional<std::int64_t>& draws,
           const std::optional<ArrayLike>& covariance_of, bool estimate_noise, bool prior_exact,
           const std::vector<LaterSurvey>& epochs, const Frequencies& frequencies,
           const QuantityLike& free_length_std, const Sags& sag, std::uint64_t seed,
           const nb::object& progress) {
            if (draws) {
                check_draws(net, *draws);
            }
            IdentifyOptions options{
                .prior = prior_given(prior),
                .prior_exact = prior_exact,
                .forces = forces_given(net, survey, forces, frequencies,
                                       length_given(free_length_std, "free_length_std"), sag,
                                       taut_edges, slack_edges),
                .uncertain = uncertain_given(net, uncertain),
                .assume_site = assumes_site(uncertain),
                .model = model,
                .draws = draws,
                .estimate_noise = estimate_noise,
                .seed = seed};
            if (method) {
                options.method = parse_identification_method(*method);
            }
            if (covariance_of) {
                options.covariance_of = indices_argument(*covariance_of, "covariance_of");
            }
            return identified(net, survey, options, epochs, progress);
        },
        nb::arg("net"), nb::arg("survey"), nb::kw_only(), nb::arg("method") = nb::none(),
        nb::arg("prior") = nb::none(), nb::arg("model") = nb::none(), nb::arg("forces") = OfEdges(),
        nb::arg("taut_edges") = nb::none(), nb::arg("slack_edges") = nb::none(),
        nb::arg("uncertain") = std::vector<std::string>(), nb::arg("draws") = nb::none(),
        nb::arg("covariance_of") = nb::none(), nb::arg("estimate_noise") = false,
        nb::arg("prior_exact") = false, nb::arg("epochs") = std::vector<LaterSurvey>(),
        nb::arg("frequencies") = Frequencies(), nb::arg("free_length_std") = 0.01,
        nb::arg("sag") = Sags(), nb::arg("seed") = 1, nb::arg("progress") = nb::none(),
        R"(Estimates the unstressed lengths of all interior edges from one survey of the form.

Args:
    method: 'map', 'balance' or 'gp'; by default the one that suits what is given.
    prior: of the length deviations, 'uniform:5mm'; by default a broad one.
    model: of train(), for 'gp'.
    forces: measured tensions, (edge, tension, std) each, in N or as '12kN'.
    taut_edges: seen to carry tension.
    slack_edges: seen to carry none.
    uncertain: what else is uncertain, as in 'stiffness:10%', 'loads:20N'. Of what is not given taut
        assumes 'stiffness:5%', 'stiffness-each:2%', 'temperature:5K', 'adjustable:0.5mm',
        'supports:1mm', where some are elastic 'support-stiffness:25%', of edges with a mass
        'mass:3%', of loads 'loads:5%', where forces are measured 'forces:1%', where runs slide
        'slip:100mm'. 'none': all that is not given is exact.
    draws: number of posterior samples, which give tensions their intervals; by default 200.
    covariance_of: interior edges whose lengths' covariances are wanted.
    estimate_noise: estimate a common factor of the survey's standard deviations.
    prior_exact: take scale and shape of the prior as exact; else both are estimated with the
        lengths.
    epochs: later surveys, each with what was turned before it: (survey, [(edge, stroke, std), ...]),
        in m or as '5mm'; and with loads (n, 3) that hung on the net then alone [N]: (survey, [],
        loads).
        The result is of the last survey without such loads.
    frequencies: natural frequencies of cables, (edge, frequency [Hz], mode, std [Hz]) each; the net
        needs mass.
    free_length_std: standard deviation of the length that vibrates, which clamps shorten [m].
    sag: points on sagging cables, (edge, (k, 3) [m], std) each, three points or more of one, std in
        m or as '3mm'; the net needs mass.
    seed: of the posterior samples.
    progress: called with stage, done, total.

Returns:
    Lengths, tensions and form; status and trust say whether they may be relied on.

Raises:
    SurveyError: for a survey that cannot be one of the net.
    ValueError: for arguments that contradict each other.)");
    module.def("default_draws", &default_draws, nb::arg("net"),
               "Number of posterior samples that identify() makes by default.");
}

}  // namespace taut::python
