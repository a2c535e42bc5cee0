// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "command.hpp"
#include "memory_limit.hpp"
#include "memory_needs.hpp"
#include "net_summary.hpp"
#include "progress_line.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/identification/model.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/io/model_h5.hpp"
#include "taut/net/cable_runs.hpp"
#include "taut/process_group.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct TrainOptions : CommonOptions {
    std::string data;
    std::string output;
    TrainingSettings settings;
    bool as_in_paper = false;
};

/// Edges whose Gaussian process could not be fitted.
std::vector<int> unfitted_edges(const CableNet& net, const LengthModel& model) {
    std::vector<int> edges;
    for (size_t i = 0; i < model.processes.processes.size(); ++i) {
        if (model.processes.processes[i].status != gp::FitStatus::fitted) {
            edges.push_back(net.interior_edges()[i]);
        }
    }
    return edges;
}

/// The weights that the kernel gives to the inputs.
void print_scales(const LengthModel& model) {
    if (model.metric == KernelMetric::direction) {
        say("scales of the kernel: x {:.3g}, y {:.3g}, z {:.3g}\n", model.input_scales(0),
            model.input_scales(1), model.input_scales(2));
    } else if (model.metric == KernelMetric::node) {
        say("scales of the kernel: {:.3g} to {:.3g}\n", model.input_scales.minCoeff(),
            model.input_scales.maxCoeff());
    }
}

/// Root mean square over the fitted processes.
double mean_over_processes(const LengthModel& model, double gp::Process::* number) {
    double sum = 0.0;
    double count = 0.0;
    for (const gp::Process& process : model.processes.processes) {
        if (process.status == gp::FitStatus::fitted) {
            sum += process.*number * (process.*number);
            count += 1.0;
        }
    }
    return std::sqrt(sum / std::max(1.0, count));
}

void run(const TrainOptions& options) {
    if (std::error_code none; std::filesystem::is_regular_file(options.data, none)) {
        require_memory(static_cast<double>(std::filesystem::file_size(options.data)), options.data);
    }
    const StoredDataSet stored = read_data_set(options.data);
    note_digest(options.data, stored.has_digest);
    naming_file(options.data, [&] { refuse_sliding(stored.net.net, "training"); });
    const std::vector<int> samples = stored.data.converged_in(0, stored.data.size());
    if (samples.size() < 2) {
        throw InputError(
            options.data, "",
            fmt::format("has {} samples in equilibrium, expected at least 2", samples.size()));
    }
    require_memory(training_memory(stored.net.net, static_cast<double>(samples.size())),
                   fmt::format("{} samples", samples.size()));
    if (process_group().is_first()) {
        check_outputs({options.output}, {options.data});
    }
    const auto start = std::chrono::steady_clock::now();
    const LengthModel model = [&] {
        ProgressLine line(options.quiet);
        return train_model(stored.net.net, stored.data, samples,
                           options.as_in_paper ? TrainingSettings::paper() : options.settings,
                           line.progress());
    }();
    if (!process_group().is_first()) {
        return;
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    write_model(options.output, model, stored.net);

    const CableNet& net = stored.net.net;
    const std::vector<int> unfitted = unfitted_edges(net, model);
    const size_t processes = model.processes.processes.size();
    const double leave_one_out = mean_over_processes(model, &gp::Process::leave_one_out_rmse);
    const double approximation = mean_over_processes(model, &gp::Process::approximation_error);
    const std::optional<Eigen::Index> rank = model.processes.rank();
    if (options.json) {
        const nlohmann::ordered_json document{
            {"format", "taut-training"},
            {"version", 1},
            {"net", counts_json(net)},
            {"mean", to_string(model.mean)},
            {"kernel", to_string(model.metric)},
            {"training_samples", samples.size()},
            {"left_out_not_converged", stored.data.not_converged()},
            {"processes", processes},
            {"not_fitted", unfitted},
            {"leave_one_out_rmse", leave_one_out},
            {"rank", rank ? nlohmann::ordered_json(*rank) : nlohmann::ordered_json()},
            {"rank_left_out", model.processes.left_out()},
            {"approximation_error", approximation},
            {"seconds", took.count()},
            {"output", options.output}};
        say("{}\n", to_text(document));
        return;
    }
    say("{}\n{} processes (mean: {}, kernel: {}) trained on {} samples in {:.1f} s\n",
        counts_text(net), processes - unfitted.size(), to_string(model.mean),
        to_string(model.metric), samples.size(), took.count());
    print_scales(model);
    if (stored.data.not_converged() > 0) {
        say("left out: {} samples that did not converge\n", stored.data.not_converged());
    }
    if (!unfitted.empty()) {
        say("edges that could not be fitted: {}\n", edges_text(net, unfitted));
    }
    say("leave-one-out error of the length deviations: {:.3g} mm RMS\n", 1e3 * leave_one_out);
    if (rank) {
        say("by low rank, {} of {} directions: {:.2g} % of the correlation is left out,\n"
            "  means at the samples deviate from the exact ones of these hyperparameters\n"
            "  by at most {:.2g} mm RMS\n",
            *rank, samples.size(), 100.0 * model.processes.left_out(), 1e3 * approximation);
    }
    say("written to {}\n", options.output);
}

}  // namespace

void add_train(CLI::App& program) {
    auto options = std::make_shared<TrainOptions>();
    CLI::App& command =
        add_command(program, "train",
                    "Train one Gaussian process per interior edge on a data set (Algorithm 1)",
                    "  taut train data.h5 -o model.h5", *options);
    command.add_option("DATA", options->data, "Data set of taut sample")->required();
    add_output_option(command, options->output, "Model to write (HDF5)");
    CLI::Option* paper = command.add_flag(
        "--as-in-paper", options->as_in_paper,
        "The paper's settings: zero mean, isotropic kernel, surveys taken as exact");
    add_parsed(
        command, "--mean", options->settings.mean,
        [](const std::string& name) {
            return name == "zero" ? MeanFunction::zero : MeanFunction::geometry;
        },
        "Mean function: geometry (nominal strain in the edges as measured; default) or "
        "zero (with the isotropic kernel the same as --as-in-paper)")
        ->check(CLI::IsMember({"geometry", "zero"}))
        ->excludes(paper);
    add_parsed(
        command, "--kernel", options->settings.metric,
        [](const std::string& name) {
            return name == "direction" ? KernelMetric::direction
                   : name == "node"    ? KernelMetric::node
                                       : KernelMetric::isotropic;
        },
        "Metric of the kernel: isotropic (default), or with a scale for each direction "
        "or each node")
        ->check(CLI::IsMember({"isotropic", "direction", "node"}))
        ->excludes(paper);
    set_action(command, options, run);
}

}  // namespace taut::app
