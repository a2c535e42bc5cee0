// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/identify_options.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

#include "net/sliding_nodes.hpp"
#include "platform/platform.hpp"
#include "sampling/uncertain_widths.hpp"
#include "taut/identification/force_units.hpp"
#include "taut/identification/model.hpp"

namespace taut {
namespace {

constexpr std::array methods{IdentificationMethod::balance, IdentificationMethod::map,
                             IdentificationMethod::gp};

/// The method asked for, or the one that suits the input.
MethodChoice choose_method(const CableNet& net, const Survey& survey,
                           const IdentifyOptions& options) {
    const bool slides = !net.sliding_nodes().empty();
    if (slides && options.method.value_or(IdentificationMethod::map) != IdentificationMethod::map) {
        throw std::invalid_argument(fmt::format(
            "the method {} takes each edge as clamped at its nodes, but runs of the net "
            "slide: expected the method map",
            to_string(*options.method)));
    }
    if (options.method) {
        return {.method = *options.method, .reason = "this method was asked for"};
    }
    if (options.model != nullptr) {
        return {.method = IdentificationMethod::gp, .reason = "a model is given"};
    }
    if (slides) {
        return {.method = IdentificationMethod::map, .reason = "runs of the net slide"};
    }
    if (!survey.is_whole()) {
        return {.method = IdentificationMethod::map,
                .reason = fmt::format("{} free nodes were not surveyed", survey.missing.size())};
    }
    if (survey.is_noisy()) {
        return {.method = IdentificationMethod::map, .reason = "the survey has noise"};
    }
    if (!options.forces.empty()) {
        return {.method = IdentificationMethod::map, .reason = "forces are given"};
    }
    if (!options.uncertain.empty()) {
        return {.method = IdentificationMethod::map, .reason = "more than lengths is uncertain"};
    }
    return {.method = IdentificationMethod::balance,
            .reason = "all free nodes were surveyed, and the survey is exact"};
}

/// Requirements of a method on the survey.
void check_survey_for(const CableNet& net, const Survey& survey, IdentificationMethod method) {
    if (method == IdentificationMethod::balance) {
        require_whole(net, survey, "all for the method balance");
    }
    if (survey.is_exact()) {
        require_whole(net, survey, "all, or their noise (standard deviations)");
    }
}

/// Refuses input that the method does not use.
void check_for_method(const IdentifyOptions& options, IdentificationMethod method) {
    if (options.model != nullptr && method != IdentificationMethod::gp) {
        throw std::invalid_argument(
            fmt::format("a model is for the method gp, not for {}", to_string(method)));
    }
    if (method == IdentificationMethod::map) {
        return;
    }
    if (!options.covariance_of.empty()) {
        throw std::invalid_argument(fmt::format(
            "covariances of lengths are for the method map, not for {}", to_string(method)));
    }
    if (!options.forces.empty()) {
        throw std::invalid_argument(fmt::format(
            "forces and marks of taut and slack edges are for the method map, not for {}",
            to_string(method)));
    }
    if (options.uncertain.empty()) {
        return;
    }
    if (method != IdentificationMethod::gp) {
        throw std::invalid_argument(fmt::format(
            "uncertain parameters are for the methods map and gp, not for {}", to_string(method)));
    }
    if (options.model != nullptr && options.model->uncertain != options.uncertain) {
        throw std::invalid_argument(
            fmt::format("the model was trained with the uncertain parameters {}, expected {}. Draw "
                        "its samples with these",
                        to_string(options.model->uncertain), to_string(options.uncertain)));
    }
}

void check_covariance_of(const CableNet& net, const std::vector<int>& edges) {
    std::set<int> seen;
    for (const int edge : edges) {
        if (!std::ranges::binary_search(net.interior_edges(), edge)) {
            throw std::invalid_argument(fmt::format(
                "covariances of lengths: edge {} is no interior edge of the net", edge));
        }
        if (!seen.insert(edge).second) {
            throw std::invalid_argument(
                fmt::format("covariances of lengths: edge {} is named twice", edge));
        }
    }
}

}  // namespace

void check_forces_on_runs(const CableNet& net, const Forces& forces) {
    const std::vector<bool> slides = edges_that_slide(net);
    for (const ForceMeasurement& one : forces.measurements) {
        if (slides[one.edge]) {
            throw std::invalid_argument(
                fmt::format("the force measurement of edge '{}', which slides, cannot be used "
                            "yet: measure an edge that is clamped at both ends",
                            net.edge_id(one.edge)));
        }
    }
}

std::string_view to_string(IdentificationMethod method) {
    switch (method) {
        case IdentificationMethod::balance:
            return "balance";
        case IdentificationMethod::map:
            return "map";
        case IdentificationMethod::gp:
            return "gp";
    }
    return "unknown";
}

IdentificationMethod parse_identification_method(std::string_view name) {
    for (const IdentificationMethod method : methods) {
        if (name == to_string(method)) {
            return method;
        }
    }
    throw std::invalid_argument(
        fmt::format("no method is called '{}', expected gp, balance or map", name));
}

int default_draws(const CableNet& net) {
    constexpr int few_edges = 10'000;
    // With tension laws each takes long.
    return net.interior_edge_count() > few_edges || !net.is_linear() ? 40 : 200;
}

int draws_wanted(const CableNet& net, const IdentifyOptions& options) {
    return options.draws.value_or(default_draws(net));
}

double numbers_of_draw(const CableNet& net) {
    // Lengths, form and tensions; as much again of what else is uncertain; and both a second time
    // while they are collected. Measured, it is 2.5 times the first.
    return 3.0 * (net.interior_edge_count() + 3.0 * net.free_node_count() + net.edge_count());
}

void check_draws(const CableNet& net, std::int64_t draws) {
    const double bytes_a_draw = sizeof(double) * numbers_of_draw(net);
    const double most = std::min(platform::physical_memory() / bytes_a_draw, 2147483647.0);
    if (draws < 0 || draws == 1 || static_cast<double>(draws) > most) {
        throw std::invalid_argument(fmt::format(
            "draws is {}, expected 0, or 2 to {:.0f}, as many as fit into memory for this net",
            draws, most));
    }
}

void check_model(const CableNet& net, const LengthModel& model,
                 const std::optional<LengthPrior>& prior) {
    if (model.net_fingerprint != net.fingerprint()) {
        throw std::invalid_argument(
            fmt::format("the model was trained for the net {}, expected {} ('{}')",
                        model.net_fingerprint, net.fingerprint(), net.name()));
    }
    const Eigen::Index coordinates = Eigen::Index{3} * net.free_node_count();
    const gp::FittedProcesses& learnt = model.processes;
    if (model.nominal_form.size() != coordinates || model.input_scales.size() != coordinates ||
        learnt.inputs.rows() != coordinates ||
        std::ssize(learnt.processes) != net.interior_edge_count() ||
        learnt.weights.rows() != learnt.inputs.cols() ||
        learnt.weights.cols() != net.interior_edge_count() ||
        (model.form_prior.mean.size() > 0 &&
         model.form_prior.inputs.cols() != learnt.inputs.cols()) ||
        model.length_deviations.rows() != net.interior_edge_count() ||
        model.length_deviations.cols() != learnt.inputs.cols()) {
        throw std::invalid_argument(
            fmt::format("the model's parts are of {} coordinates, {} processes and {} samples, "
                        "expected {} and {} in each",
                        learnt.inputs.rows(), learnt.processes.size(), learnt.inputs.cols(),
                        coordinates, net.interior_edge_count()));
    }
    if (prior && model.prior != *prior) {
        throw std::invalid_argument(
            fmt::format("the model was trained for the prior {}, expected {}",
                        to_string(model.prior), to_string(*prior)));
    }
}

KnownForces measured_by(const Forces& forces) {
    const auto by_cell = [](const ForceMeasurement& one) { return !one.is_by_mass(); };
    return {.by_cells = std::ranges::any_of(forces.measurements, by_cell)};
}

MethodChoice checked_method(const CableNet& net, const Survey& survey, const LengthPrior& prior,
                            const IdentifyOptions& options) {
    check_prior(net, prior);
    check_draws(net, draws_wanted(net, options));
    check_survey(net, survey);
    MethodChoice choice = choose_method(net, survey, options);
    check_survey_for(net, survey, choice.method);
    check_forces(net, options.forces);
    check_forces_on_runs(net, options.forces);
    (void)force_unit_warning(net, options.forces.measurements);
    check_for_one_survey(net, options.uncertain);
    check_covariance_of(net, options.covariance_of);
    check_for_method(options, choice.method);
    if (options.model != nullptr) {
        check_model(net, *options.model, options.prior);
    }
    return choice;
}

}  // namespace taut
