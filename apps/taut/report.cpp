// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "taut/files/file.hpp"
#include "taut/report/figures_svg.hpp"
#include "taut/report/report_html.hpp"
#include "taut/results/result_file.hpp"

namespace taut::app {
namespace {

struct ReportOptions : CommonOptions {
    std::string result;
    std::string output;
    std::string svg_directory;
};

void run(const ReportOptions& options) {
    if (options.output.empty() && options.svg_directory.empty()) {
        throw std::invalid_argument("nothing to write: expected -o FILE or --svg DIR, or both");
    }
    if (!options.output.empty() && !has_report_viewer()) {
        throw std::invalid_argument(
            "this taut was built without Node.js and makes no reports; --svg still writes figures");
    }
    check_outputs({options.output}, {options.result});
    const ResultFile result = read_result(options.result);
    std::vector<std::string> written;
    // The page first, under its temporary name: a failure to write figures leaves it away.
    std::optional<AtomicFile> page;
    if (!options.output.empty()) {
        page.emplace(options.output);
        write_file(page->temporary(), report_html(result));
    }
    if (!options.svg_directory.empty()) {
        const auto figures = figures_svg(result);
        for (const auto& [name, content] : figures) {
            written.push_back((std::filesystem::path(options.svg_directory) / name).string());
        }
        std::vector<std::string> outputs = written;
        outputs.push_back(options.output);
        refuse_overwriting(outputs, {options.result});
        write_files(options.svg_directory, figures);
    }
    if (page) {
        page->commit();
        written.insert(written.begin(), options.output);
    }
    if (options.json) {
        fmt::print("{}\n", nlohmann::json{{"written", written}}.dump());
        return;
    }
    for (const std::string& file : written) {
        fmt::print("written to {}\n", file);
    }
}

}  // namespace

void add_report(CLI::App& program) {
    auto options = std::make_shared<ReportOptions>();
    CLI::App& command = add_command(
        program, "report", "Make the report of a saved result: one HTML file, or figures as SVG",
        "  taut report study/results.json -o report.html\n"
        "  taut report result.json --svg figures",
        *options);
    command
        .add_option("RESULT", options->result,
                    "Result of reproduce, identify, compare, plan or control")
        ->required();
    command.add_option("-o,--output", options->output, "HTML file to write");
    command.add_option("--svg", options->svg_directory, "Directory to write the figures into");
    set_action(command, options, run);
}

}  // namespace taut::app
