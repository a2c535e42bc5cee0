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
    if (directory.empty()) {
        throw std::invalid_argument("the output directory has no name");
    }
    std::filesystem::path first_new = std::filesystem::absolute(directory) / "results.json";
    while (!std::filesystem::exists(first_new.parent_path())) {
        first_new = first_new.parent_path();
    }
    AtomicFile{first_new};
}

/// Writes the text files, and the data set and the model if they are to be kept: all or nothing.
void write_outputs(const Options& options, const Study& study, const NetFile& net,
                   const std::vector<std::pair<std::string, std::string>>& files) {
    const std::filesystem::path directory(options.directory);
    if (!options.keep) {
        write_files(directory, files);
        return;
    }
    std::filesystem::create_directories(directory);
    AtomicFile data(directory / "data.h5");
    AtomicFile model(directory / "model.h5");
    write_data_set(data.temporary(), study.data, net);
    write_model(model.temporary(), study.model, net);
    write_files(directory, files);
    data.commit();
    model.commit();
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
    write_outputs(options, study, file, files);

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
    command.add_option("--seed", options->study.seed, "Seed of the draws")->check(CLI::NonNegativeNumber)->capture_default_str();
    command.add_flag("--keep", options->keep, "Write the data set and the model too");
    command.callback([options] { run(*options); });
}

}  // namespace taut::app
