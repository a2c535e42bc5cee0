// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/model.hpp"

#include <fmt/core.h>

#include <map>
#include <stdexcept>

#include "gp/input_scales.hpp"
#include "identification/form_prior.hpp"
#include "identification/mean_function.hpp"
#include "identification/train_together.hpp"
#include "numerics/fnv1a.hpp"
#include "numerics/memory_budget.hpp"
#include "numerics/parallel.hpp"
#include "shared_work.hpp"
#include "taut/net/cable_runs.hpp"

namespace taut {
namespace {

void check(const CableNet& net, const DataSet& data, const std::vector<int>& samples) {
    if (data.net_fingerprint != net.fingerprint()) {
        throw std::invalid_argument(fmt::format("the data set is of the net {}, expected {} ('{}')",
                                                data.net_fingerprint, net.fingerprint(),
                                                net.name()));
    }
    const Eigen::Index coordinates = Eigen::Index{3} * net.free_node_count();
    if (data.nominal_form.size() != coordinates || data.form_deviations.rows() != coordinates ||
        data.length_deviations.rows() != net.interior_edge_count() ||
        data.length_deviations.cols() != data.form_deviations.cols()) {
        throw std::invalid_argument(fmt::format(
            "the data set holds {} x {} form and {} x {} length deviations, expected "
            "{} and {} rows, and as many columns",
            data.form_deviations.rows(), data.form_deviations.cols(), data.length_deviations.rows(),
            data.length_deviations.cols(), coordinates, net.interior_edge_count()));
    }
    if (samples.size() < 2) {
        throw std::invalid_argument(
            fmt::format("{} training samples, expected at least 2", samples.size()));
    }
    for (const int k : samples) {
        if (k < 0 || k >= data.size()) {
            throw std::invalid_argument(
                fmt::format("training sample {}, expected 0 to {}", k, data.size() - 1));
        }
    }
}

/// Of the forms, of these as scaled inputs and of the outputs of some models.
MemoryCharge charge_training(const CableNet& net, const std::vector<int>& samples, double models) {
    return charge_numbers(static_cast<double>(std::ssize(samples)) *
                          (6.0 * net.free_node_count() + models * net.interior_edge_count()));
}

/// All processes of a team learn from the same.
void require_same_samples(const DataSet& data, const std::vector<int>& samples) {
    if (process_group().size() > 1) {
        Fnv1a hash;
        hash.add(data.form_deviations.data(), data.form_deviations.size());
        hash.add(data.length_deviations.data(), data.length_deviations.size());
        hash.add_list(samples);
        require_same("data set", data.net_fingerprint + hash.text());
    }
}

/// All of a model that is not learnt.
LengthModel untrained(const DataSet& data, const std::vector<int>& samples,
                      const TrainingSettings& settings) {
    if (settings.as_in_paper &&
        (settings.mean != MeanFunction::zero || settings.metric != KernelMetric::isotropic)) {
        throw std::invalid_argument(
            fmt::format("a model as in the paper has mean function {} and kernel {}, expected zero "
                        "and isotropic",
                        to_string(settings.mean), to_string(settings.metric)));
    }
    return {.net_fingerprint = data.net_fingerprint,
            .prior = data.prior,
            .seed = data.seed,
            .uncertain = data.uncertain,
            .mean = settings.mean,
            .metric = settings.metric,
            .as_in_paper = settings.as_in_paper,
            .nominal_form = data.nominal_form,
            .input_scales = {},
            .length_deviations = data.length_deviations(Eigen::all, samples),
            .processes = {},
            .form_prior = {}};
}

/// What the processes are to learn (n x m_I).
Eigen::MatrixXd outputs_of(const CableNet& net, const LengthModel& model,
                           const Eigen::MatrixXd& forms) {
    return (model.length_deviations - mean_values(net, model.mean, model.nominal_form, forms))
        .transpose();
}

/// Some processes that follow each other, with the spectra that they use.
gp::FittedProcesses part_of(const gp::FittedProcesses& all, Eigen::Index first,
                            Eigen::Index count) {
    gp::FittedProcesses part{
        .inputs = all.inputs,
        .spectra = {},
        .processes = {all.processes.begin() + first, all.processes.begin() + first + count},
        .weights = all.weights.middleCols(first, count)};
    std::map<int, int> place;  // in the part, of each spectrum
    for (gp::Process& process : part.processes) {
        if (process.status != gp::FitStatus::fitted) {
            continue;
        }
        const auto [at, is_new] =
            place.emplace(process.spectrum, static_cast<int>(part.spectra.size()));
        if (is_new) {
            part.spectra.push_back(all.spectra[process.spectrum]);
        }
        process.spectrum = at->second;
    }
    return part;
}

Eigen::VectorXd input_scales(KernelMetric metric, const Eigen::MatrixXd& inputs,
                             const Eigen::MatrixXd& outputs, const Progress& progress) {
    if (metric == KernelMetric::isotropic) {
        return Eigen::VectorXd::Ones(inputs.rows());
    }
    std::vector<int> groups(inputs.rows());
    for (size_t i = 0; i < groups.size(); ++i) {
        groups[i] = static_cast<int>(metric == KernelMetric::direction ? i % 3 : i / 3);
    }
    return gp::estimate_input_scales(inputs, outputs, groups, progress);
}

}  // namespace

std::string_view to_string(MeanFunction mean) {
    switch (mean) {
        case MeanFunction::zero:
            return "zero";
        case MeanFunction::geometry:
            return "geometry";
    }
    return "unknown";
}

std::string_view to_string(KernelMetric metric) {
    switch (metric) {
        case KernelMetric::isotropic:
            return "isotropic";
        case KernelMetric::direction:
            return "direction";
        case KernelMetric::node:
            return "node";
    }
    return "unknown";
}

LengthModel train_model(const CableNet& net, const DataSet& data, const std::vector<int>& samples,
                        const TrainingSettings& settings, const Progress& progress) {
    refuse_sliding(net, "training");
    check(net, data, samples);
    require_same_samples(data, samples);
    const MemoryCharge charge = charge_training(net, samples, 1);
    const Eigen::MatrixXd forms = data.form_deviations(Eigen::all, samples);
    LengthModel model = untrained(data, samples, settings);
    const Eigen::MatrixXd outputs = outputs_of(net, model, forms);
    model.input_scales = input_scales(settings.metric, forms, outputs, progress);
    const bool keeps_prior = !settings.as_in_paper && keeps_form_prior(net);
    gp::FittedProcesses processes;
    FormPrior form_prior;
    parallel_invoke(
        [&] {
            processes =
                gp::fit(model.input_scales.asDiagonal() * forms, outputs, settings.fit, progress);
        },
        [&] {
            if (keeps_prior) {
                form_prior = form_prior_of(net, model, forms);
            }
        });
    model.processes = std::move(processes);
    if (keeps_prior) {
        model.form_prior = std::move(form_prior);
        model.form_prior.inputs = inputs_along_directions(model, model.form_prior);
    }
    return model;
}

std::vector<LengthModel> train_together(const CableNet& net, const DataSet& data,
                                        const std::vector<int>& samples,
                                        const std::vector<TrainingSettings>& settings,
                                        const Progress& progress) {
    check(net, data, samples);
    const Eigen::Index m = net.interior_edge_count();
    const MemoryCharge charge = charge_training(net, samples, static_cast<double>(settings.size()));
    const Eigen::MatrixXd forms = data.form_deviations(Eigen::all, samples);
    std::vector<LengthModel> models;
    Eigen::MatrixXd outputs(forms.cols(), m * std::ssize(settings));
    for (const TrainingSettings& of_one : settings) {
        models.push_back(untrained(data, samples, of_one));
        LengthModel& model = models.back();
        model.input_scales = Eigen::VectorXd::Ones(forms.rows());
        outputs.middleCols((std::ssize(models) - 1) * m, m) = outputs_of(net, model, forms);
    }
    // Half of a search looks for valleys, the other half serves one model: with so many more for
    // each further one all are as likely as if each were trained by itself.
    constexpr int further_spectra = 4;
    gp::FitSettings fit;
    fit.max_spectra += further_spectra * (static_cast<int>(settings.size()) - 1);
    const gp::FittedProcesses all = gp::fit(forms, outputs, fit, progress);
    for (size_t k = 0; k < models.size(); ++k) {
        models[k].processes = part_of(all, static_cast<Eigen::Index>(k) * m, m);
    }
    return models;
}

}  // namespace taut
