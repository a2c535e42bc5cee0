// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "taut/files/file.hpp"
#include "taut/report/report_html.hpp"
#include "taut/results/draws_h5.hpp"
#include "taut/results/result_file.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct ReportOptions : CommonOptions {
    std::string result;
    std::string output;
};

void run(const ReportOptions& options) {
    check_outputs({options.output}, {options.result, draws_path(options.result).string()});
    const ResultFile result = read_result(options.result);
    if (!has_report_viewer()) {
        throw std::invalid_argument("this taut was built without Node.js and cannot make reports");
    }
    write_file(options.output, report_html(result));
    if (options.json) {
        say("{}\n", to_text({{"written", nlohmann::ordered_json::array({options.output})}}));
        return;
    }
    say("written to {}\n", options.output);
}

}  // namespace

void add_report(CLI::App& program) {
    auto options = std::make_shared<ReportOptions>();
    CLI::App& command =
        add_command(program, "report", "Write the report of a result: one HTML file",
                    "  taut report result.json -o report.html\n"
                    "  taut report plan.json -o plan.html",
                    *options);
    command
        .add_option("RESULT", options->result,
                    "Result of reproduce, identify, compare, plan or control")
        ->required();
    add_output_option(command, options->output, "HTML file to write");
    set_action(command, options, run);
}

}  // namespace taut::app
