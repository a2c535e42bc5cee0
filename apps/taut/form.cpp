// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "command.hpp"
#include "net_summary.hpp"
#include "taut/io/file.hpp"
#include "taut/io/form_csv.hpp"
#include "taut/io/net_json.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut::app {
namespace {

struct Options : CommonOptions {
    std::string net;
    std::string output;
    std::string solver = "newton";
};

void run(const Options& options) {
    const auto threads = options.limit_threads();
    const CableNet net = read_net(options.net).net;
    const Equilibrium equilibrium = solve_equilibrium(net);
    if (!equilibrium.balanced()) {
        throw NumericalFailure(
            fmt::format("{}: no equilibrium: {}", options.net, equilibrium_text(equilibrium)));
    }
    if (!options.output.empty()) {
        write_file(options.output, form_to_csv(net, equilibrium.form));
    }
    const double move = (equilibrium.form - net.nodes()).colwise().norm().maxCoeff();
    if (options.json) {
        nlohmann::ordered_json form = nlohmann::ordered_json::array();
        for (const auto& node : equilibrium.form.colwise()) {
            form.push_back({node.x(), node.y(), node.z()});
        }
        const nlohmann::ordered_json document{{"format", "taut-form"},
                                              {"version", 1},
                                              {"net", counts_json(net)},
                                              {"solver", options.solver},
                                              {"status", to_string(equilibrium.status)},
                                              {"iterations", equilibrium.iterations},
                                              {"out_of_balance", equilibrium.out_of_balance},
                                              {"mean_tension", equilibrium.mean_tension},
                                              {"largest_move", move},
                                              {"slack_edges", equilibrium.slack_edges},
                                              {"form", form}};
        fmt::print("{}\n", document.dump(2));
        return;
    }
    fmt::print("{}\n{}\n", counts_text(net), equilibrium_text(equilibrium));
    fmt::print("largest move of a node from its nominal place: {:.4g} mm\nslack edges: {}\n",
               1e3 * move, edges_text(net, equilibrium.slack_edges));
    if (equilibrium.status == EquilibriumStatus::slack_mechanism) {
        fmt::print("slack edges leave some nodes loose: their places are one choice of many\n");
    }
    if (!options.output.empty()) {
        fmt::print("written to {}\n", options.output);
    }
}

}  // namespace

void add_form(CLI::App& program) {
    auto options = std::make_shared<Options>();
    CLI::App& command =
        add_command(program, "form", "Compute the form a net takes in equilibrium",
                    "  taut form net.json -o form.csv", *options);
    command.add_option("NET", options->net, "Net file")->required();
    command.add_option("-o,--output", options->output, "Form file to write (id,x,y,z; in m)");
    command.add_option("--solver", options->solver, "How to solve: newton (Newton on the energy)")
        ->check(CLI::IsMember({"newton"}))
        ->capture_default_str();
    command.callback([options] { run(*options); });
}

}  // namespace taut::app
