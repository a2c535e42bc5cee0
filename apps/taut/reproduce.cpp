// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <filesystem>

#include "command.hpp"
#include "memory_limit.hpp"
#include "memory_needs.hpp"
#include "net_summary.hpp"
#include "output_directory.hpp"
#include "paper_table.hpp"
#include "progress_line.hpp"
#include "run_record.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/io/model_h5.hpp"
#include "taut/io/net_json.hpp"
#include "taut/net/cable_runs.hpp"
#include "taut/results/results_json.hpp"
#include "taut/results/study_csv.hpp"
#include "taut/study/study.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct ReproduceOptions : CommonOptions {
    std::string directory;
    std::string net;
    StudySettings study;
    bool keep = false;
};

NetFile net_of(const ReproduceOptions& options) {
    return options.net.empty() ? NetFile{.net = hilo_quarter(), .unknown_keys = "{}"}
                               : read_net(options.net);
}

/// Refuses what check_output_directory() does, and a directory that would keep the data set and
/// model of an earlier study.
void check_directory(const ReproduceOptions& options) {
    const std::filesystem::path directory(options.directory);
    check_output_directory(directory,
                           {"results.json", "report.html", "edges.csv", "errors.csv", "nodes.csv",
                            "data.h5", "model.h5"},
                           {options.net});
    for (const char* name : {"data.h5", "model.h5"}) {
        if (!options.keep && std::filesystem::exists(directory / name)) {
            throw InputError((directory / name).string(), "",
                             "belongs to an earlier study; replace it with --keep, or name another "
                             "directory");
        }
    }
}

void run(const ReproduceOptions& options) {
    options.study.check();
    const NetFile file = net_of(options);
    naming_file(options.net, [&] { refuse_sliding(file.net, "training"); });
    require_memory(training_memory(file.net, options.study.samples),
                   fmt::format("{} samples", options.study.samples));
    check_directory(options);

    Study study = [&] {
        ProgressLine line(options.quiet);
        return run_study(file.net, options.study, line.progress());
    }();
    const std::filesystem::path directory(options.directory);
    const std::string results = study_to_json(study, run_record());
    auto files = study_to_csv(study);
    if (options.keep) {
        files.emplace_back("data.h5", data_set_bytes(study.data, file));
        files.emplace_back("model.h5", model_bytes(study.model, file));
    }
    write_with_report(directory, "results.json", results, std::move(files));

    if (options.json) {
        say("{}", results);
        return;
    }
    say("{}\n{}\n", counts_text(file.net), paper_table(study));
    say("written to {}: results.json, CSV files{}\nreport: {}\n", options.directory,
        options.keep ? ", data.h5, model.h5" : "", report_text(directory));
}

}  // namespace

void add_reproduce(CLI::App& program) {
    auto options = std::make_shared<ReproduceOptions>();
    CLI::App& command = add_command(
        program, "reproduce", "Run the paper's numerical experiment (its section 5) on a net",
        "  taut reproduce -o study\n  taut reproduce -o study --net net.json --prior uniform:2mm",
        *options);
    command.add_option("-o,--output", options->directory, "Directory to write into")->required();
    command.add_option("--net", options->net, "Net file (default: the built-in hilo-quarter)");
    command.add_option("--samples", options->study.samples, "Number of samples")
        ->capture_default_str();
    command
        .add_option("--validation", options->study.validation,
                    "Number of samples kept from training, to validate on")
        ->capture_default_str();
    add_parsed(command, "--prior", options->study.prior, parse_length_prior,
               "Prior of the length deviations", "uniform:5mm");
    add_seed_option(command, options->study.seed);
    command.add_flag("--keep", options->keep, "Write the data set and the model as well");
    set_action(command, options, run);
}

}  // namespace taut::app
