// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "command.hpp"
#include "net_summary.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/files/file.hpp"
#include "taut/io/net_json.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct ExampleOptions : CommonOptions {
    std::string name;
    std::string output;
};

void run(const ExampleOptions& options) {
    const CableNet net = builtin_net(options.name);
    check_outputs({options.output}, {});
    write_file(options.output, net_to_json(net));
    if (options.json) {
        say("{}\n", to_text(counts_json(net)));
    } else {
        say("{}\nwritten to {}\n", counts_text(net), options.output);
    }
}

}  // namespace

void add_example(CLI::App& program) {
    auto options = std::make_shared<ExampleOptions>();
    CLI::App& command = add_command(
        program, "example", "Write a built-in net",
        "  taut example hilo-quarter -o net.json\n  taut example hypar:20x30 -o hypar.json",
        *options);
    command
        .add_option(
            "NAME", options->name,
            "hilo-quarter, steel-roof, cable-dome, spoke-wheel, tensegrity-simplex, sliding-ridge, "
            "or hypar:RxC with R rows and C columns of free nodes (1 to 1000)")
        ->required();
    add_output_option(command, options->output, "Net file to write");
    set_action(command, options, run);
}

}  // namespace taut::app
