// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "command.hpp"
#include "net_summary.hpp"
#include "taut/files/file.hpp"
#include "taut/files/table_file.hpp"
#include "taut/interchange/compas_json.hpp"
#include "taut/interchange/foreign_format.hpp"
#include "taut/interchange/net_csv.hpp"
#include "taut/interchange/net_import.hpp"
#include "taut/interchange/obj.hpp"
#include "taut/io/net_json.hpp"
#include "taut/net/units.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct ImportOptions : CommonOptions {
    std::string file;
    std::string output;
    std::string format;
    std::string select;
    std::string edges;
    std::string supports;
    std::string stress_strain;
    std::string loads = "file";
    std::string slides = "none";
    ImportSettings settings;  ///< but for what files hold
};

/// The structure in the file.
ImportedStructure read_structure(const ImportOptions& options) {
    const std::string text = read_table(options.file);
    const ForeignFormat format = options.format.empty() ? detect_format(text, options.file)
                                                        : format_named(options.format, text);
    if (format != ForeignFormat::json && !options.select.empty()) {
        throw std::invalid_argument(
            "--select names a structure in a JSON file, but FILE is not JSON");
    }
    if ((format == ForeignFormat::csv) == options.edges.empty()) {
        throw std::invalid_argument(
            format == ForeignFormat::csv
                ? fmt::format(
                      "{}: is taken as the CSV file of the nodes. Give that of the edges by "
                      "--edges",
                      options.file)
                : "--edges belongs to a CSV file of nodes, but FILE is not CSV");
    }
    switch (format) {
        case ForeignFormat::json:
            return parse_compas(text, options.file, options.select);
        case ForeignFormat::obj:
            return parse_obj(text, options.file);
        default:
            return parse_net_csv({.nodes = text, .edges = read_table(options.edges)}, options.file,
                                 options.edges);
    }
}

void add_supports(const std::string& supports, ImportedStructure& structure) {
    if (supports == "boundary") {
        support_boundary(structure);
    } else if (!supports.empty()) {
        support_named(structure, read_table(supports), supports);
    }
}

/// A diameter, or the name of the attribute that gives it.
void set_diameter(ImportSettings& settings, const std::string& text) {
    // A bare number is in mm, by which cables are named.
    if (text.find_first_not_of("0123456789.") == std::string::npos) {
        settings.diameter = parse_length(text + "mm");
    } else if (text[0] >= '0' && text[0] <= '9') {
        settings.diameter = parse_length(text);
    } else {
        settings.diameter_attribute = text;
    }
}

nlohmann::ordered_json to_json(const ImportOptions& options, const ImportedNet& imported) {
    const ImportReport& it = imported.report;
    return {{"format", "taut-import"},
            {"version", 1},
            {"net", counts_json(imported.net)},
            {"file", options.file},
            {"detected", options.format.empty()},
            {"read", it.read},
            {"left_out",
             {{"inactive_edges", it.inactive_edges},
              {"edges_between_supports", it.edges_between_supports},
              {"isolated_nodes", it.isolated_nodes},
              {"all", it.left_out}}},
            {"assumed", it.assumed},
            {"warnings", it.warnings},
            {"loads",
             {{"from", options.loads},
              {"sum", {it.load_sum.x(), it.load_sum.y(), it.load_sum.z()}},
              {"largest_horizontal", it.largest_horizontal_load}}},
            {"strains", {{"min", it.least_strain}, {"max", it.largest_strain}}},
            {"mean_tension", it.mean_tension},
            {"out_of_balance", it.largest_out_of_balance}};
}

void print(const std::string& heading, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
        say("{:<10}{}\n", heading, line);
    }
}

void print(const ImportOptions& options, const ImportedNet& imported) {
    const ImportReport& it = imported.report;
    say("{}\n", counts_text(imported.net));
    print("read", it.read);
    print("left out", it.left_out);
    print("assumed", it.assumed);
    say("loads     {}: sum {:.4g}, {:.4g}, {:.4g} N, largest horizontal part {:.3g} N\n",
        options.loads, it.load_sum.x(), it.load_sum.y(), it.load_sum.z(),
        it.largest_horizontal_load);
    say("strains   {:.3g} to {:.3g} %, mean tension {:.4g} N\n", 100.0 * it.least_strain,
        100.0 * it.largest_strain, it.mean_tension);
    say("balance   {:.2g} N out of balance in the given form", it.largest_out_of_balance);
    if (it.mean_tension > 0.0) {
        say(" ({:.1g} of the mean tension)", it.largest_out_of_balance / it.mean_tension);
    }
    say("\nwritten to {}\n", options.output);
}

void run(const ImportOptions& options) {
    ImportSettings settings = options.settings;
    if (!options.stress_strain.empty()) {
        settings.stress_strain =
            parse_stress_strain(read_table(options.stress_strain), options.stress_strain);
    }
    using Loads = ImportSettings::Loads;
    settings.loads = options.loads == "balance" ? Loads::balance
                     : options.loads == "none"  ? Loads::none
                                                : Loads::file;
    settings.slides = parse_slides(options.slides);
    const bool is_file = options.supports != "boundary";
    check_outputs({options.output}, {options.file, options.edges, options.stress_strain,
                                     is_file ? options.supports : ""});
    ImportedStructure structure = read_structure(options);
    add_supports(options.supports, structure);
    ImportedNet imported = import_net(structure, settings);
    if (options.format.empty()) {
        imported.report.read.front() += ", by its content";
    }
    write_file(options.output, net_to_json(imported.net));
    warn(options.file, imported.report.warnings);
    if (options.json) {
        say("{}\n", to_text(to_json(options, imported)));
    } else {
        print(options, imported);
    }
}

}  // namespace

void add_import(CLI::App& program) {
    auto options = std::make_shared<ImportOptions>();
    CLI::App& command =
        add_command(program, "import", "Convert a net of another program",
                    "  taut import cablenet.json --young 205GPa --diameter size --force-unit kN"
                    " --loads balance -o hilo.json\n"
                    "  taut import nodes.csv --edges edges.csv --axial-stiffness 200kN -o net.json",
                    *options);
    command
        .add_option("FILE", options->file, "COMPAS or JAX FDM file (JSON), OBJ, or CSV of nodes")
        ->required();
    add_output_option(command, options->output, "Net file to write");
    command.add_option("--from", options->format, "Format of FILE (default: by its content)")
        ->check(CLI::IsMember({"compas", "jax-fdm", "csv", "obj"}));
    command.add_option("--select", options->select,
                       "Key of the mesh or network in FILE, where it has several");
    command.add_option("--edges", options->edges,
                       "CSV file of the edges, where FILE is that of nodes");
    command.add_option("--supports", options->supports,
                       "Further supports: boundary, or a file of node ids");
    ImportSettings& settings = options->settings;
    add_parsed(command, "--axial-stiffness", settings.axial_stiffness, parse_force,
               "EA of all edges, such as 200kN (a bare number is in N)");
    add_parsed(command, "--young", settings.young, parse_stress,
               "Young's modulus of all edges, such as 205GPa (a bare number is in Pa)");
    command.add_option("--stress-strain", options->stress_strain,
                       "CSV table strain,stress (stress in Pa) of a piecewise linear tension law, "
                       "with --diameter or the radii of FILE");
    command.add_option_function<std::string>(
        "--diameter", [&settings](const std::string& text) { set_diameter(settings, text); },
        "Diameter of all edges in mm, or the name of the attribute that gives it");
    add_parsed(
        command, "--force-unit", settings.force_unit,
        [](const std::string& unit) { return unit == "kN" ? 1e3 : 1.0; },
        "Unit of forces, force densities and loads in FILE")
        ->check(CLI::IsMember({"N", "kN"}));
    command
        .add_option(
            "--loads", options->loads,
            "file: the loads of FILE; balance: those that keep the given form in equilibrium; none")
        ->check(CLI::IsMember({"balance", "file", "none"}))
        ->capture_default_str();
    command
        .add_option("--slides", options->slides,
                    "Cables that slide through their nodes: names: edges of one name but for the "
                    "number at its end; straight: edges that go straight on; none")
        ->check(CLI::IsMember({"names", "none", "straight"}))
        ->capture_default_str();
    set_action(command, options, run);
}

}  // namespace taut::app
