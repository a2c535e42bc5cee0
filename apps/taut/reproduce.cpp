// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/chrono.h>
#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <iterator>

#include "command.hpp"
#include "interruption.hpp"
#include "net_summary.hpp"
#include "paper_table.hpp"
#include "progress.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/io/file.hpp"
#include "taut/io/model_h5.hpp"
#include "taut/io/net_json.hpp"
#include "taut/io/results_json.hpp"
#include "taut/io/study_csv.hpp"
#include "taut/report/study_figures.hpp"
#include "taut/report/study_report.hpp"
#include "taut/study/study.hpp"
#include "taut/version.hpp"

namespace taut::app {
namespace {

struct Options : CommonOptions {
    std::string directory;
    std::string net;
    std::string law = "uniform:5mm";
    StudySettings study;
    bool keep = false;
};

NetFile net_of(const Options& options) {
    return options.net.empty() ? NetFile{.net = hilo_quarter(), .unknown_keys = "{}"}
                               : read_net(options.net);
}

/// Refuses a directory that could not be written to, before the work and without making it.
void check_directory(const std::filesystem::path& directory) {
    std::filesystem::path existing = std::filesystem::absolute(directory);
    while (!std::filesystem::exists(existing)) {
        existing = existing.parent_path();
    }
    AtomicFile{existing / "results.json"};
}

std::string now() {
    return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)));
}

void run(Options options) {
    const auto threads = options.limit_threads();
    options.study.law = parse_length_law(options.law);
    options.study.check();
    const NetFile file = net_of(options);
    check_directory(options.directory);

    const std::stop_token stop = Interruption::stop_token();
    Study study = [&] {
        Progress progress(options.quiet);
        return run_study(
            file.net, options.study,
            [&](std::string_view stage, int done, int total) { progress.show(stage, done, total); },
            stop);
    }();
    const std::filesystem::path directory(options.directory);
    const std::string results = study_to_json(study);
    auto files = study_to_csv(study);
    files.emplace_back("results.json", results);
    files.emplace_back("report.html", study_report_html(study, version(), now()));
    std::ranges::move(study_figures_svg(study), std::back_inserter(files));
    if (options.keep) {
        write_data_set(directory / "data.h5", study.data, file);
        write_model(directory / "model.h5", study.model, file);
    }
    write_files(directory, files);

    if (options.json) {
        fmt::print("{}", results);
        return;
    }
    fmt::print("{}\n{}\n", counts_text(file.net), paper_table(study));
    fmt::print("written to {}: results.json, CSV files, figures (SVG){}\nreport: {}\n",
               options.directory, options.keep ? ", data.h5, model.h5" : "",
               (directory / "report.html").string());
}

}  // namespace

void add_reproduce(CLI::App& program) {
    auto options = std::make_shared<Options>();
    CLI::App& command = add_command(
        program, "reproduce", "Run the paper's numerical experiment (its section 5) on a net",
        "  taut reproduce -o study\n  taut reproduce -o study --net net.json --law uniform:2mm",
        *options);
    command.add_option("-o,--output", options->directory, "Directory to write into")->required();
    command.add_option("--net", options->net, "Net file (default: the built-in hilo-quarter)");
    command.add_option("--samples", options->study.samples, "Samples in all")
        ->capture_default_str();
    command
        .add_option("--validation", options->study.validation,
                    "Samples kept from training, to validate on")
        ->capture_default_str();
    command.add_option("--law", options->law, "Law of the length deviations")
        ->capture_default_str();
    command.add_option("--seed", options->study.seed, "Seed of the draws")->capture_default_str();
    command.add_flag("--keep", options->keep, "Write the data set and the model too");
    command.callback([options] { run(*options); });
}

}  // namespace taut::app
