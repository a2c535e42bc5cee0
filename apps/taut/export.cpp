// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "command.hpp"
#include "net_summary.hpp"
#include "survey_input.hpp"
#include "taut/files/file.hpp"
#include "taut/interchange/compas_json.hpp"
#include "taut/interchange/form_vtk.hpp"
#include "taut/interchange/net_csv.hpp"
#include "taut/interchange/obj.hpp"
#include "taut/io/net_json.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut::app {
namespace {

struct ExportOptions : CommonOptions {
    std::string net;
    std::string form;
    std::string format;
    std::string output;
};

Points equilibrium_form(const CableNet& net, const std::string& path) {
    Equilibrium equilibrium = solve_equilibrium(net);
    if (!equilibrium.balanced()) {
        throw NumericalFailure(
            fmt::format("{}: no equilibrium: {}", path, equilibrium_text(equilibrium)));
    }
    return std::move(equilibrium.form);
}

/// The files that the format takes.
std::vector<std::string> output_files(const ExportOptions& options) {
    if (options.format != "csv") {
        return {options.output};
    }
    const std::filesystem::path nodes = options.output;
    std::filesystem::path edges = nodes;
    edges.replace_filename(nodes.stem().string() + "_edges" + nodes.extension().string());
    return {nodes.string(), edges.string()};
}

void write(const std::vector<std::string>& files, const std::string& format, const CableNet& net,
           const Points& form) {
    if (format == "csv") {
        NetCsv csv = form_to_net_csv(net, form);
        write_files({{files[0], std::move(csv.nodes)}, {files[1], std::move(csv.edges)}});
    } else {
        write_file(files[0], format == "compas" ? form_to_compas(net, form)
                             : format == "obj"  ? form_to_obj(net, form)
                                                : form_to_vtk(net, form));
    }
}

void run(const ExportOptions& options) {
    const auto threads = options.limit_threads();
    const CableNet net = read_net(options.net).net;
    const std::vector<std::string> files = output_files(options);
    check_outputs(files, {options.net, options.form});
    const bool is_given = !options.form.empty();
    const Points form =
        is_given ? read_form(net, options.form) : equilibrium_form(net, options.net);
    write(files, options.format, net, form);
    const std::vector<int> slack = slack_edges(net, net.unstressed_lengths(), form);
    if (options.json) {
        const nlohmann::ordered_json document{
            {"format", "taut-export"}, {"version", 1},
            {"net", counts_json(net)}, {"form", is_given ? options.form : "equilibrium"},
            {"to", options.format},    {"slack_edges", slack},
            {"files", files}};
        fmt::print("{}\n", to_text(document));
        return;
    }
    fmt::print("{}\nform: {}\nslack edges: {}\n", counts_text(net),
               is_given ? options.form : "equilibrium of the net", edges_text(net, slack));
    for (const std::string& file : files) {
        fmt::print("written to {}\n", file);
    }
}

}  // namespace

void add_export(CLI::App& program) {
    auto options = std::make_shared<ExportOptions>();
    CLI::App& command =
        add_command(program, "export", "Write a net and its form for another program",
                    "  taut export net.json --to vtk -o net.vtk\n"
                    "  taut export net.json form.csv --to compas -o graph.json",
                    *options);
    command.add_option("NET", options->net, "Net file")->required();
    command.add_option("FORM", options->form,
                       "Form file (id,x,y,z; default: the equilibrium of the net)");
    command.add_option("--to", options->format, "Format; csv writes a second file, ..._edges")
        ->required()
        ->check(CLI::IsMember({"compas", "obj", "csv", "vtk"}));
    add_output_option(command, options->output, "File to write");
    command.callback([options] { run(*options); });
}

}  // namespace taut::app
