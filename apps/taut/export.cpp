// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "command.hpp"
#include "net_summary.hpp"
#include "survey_input.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/files/table_file.hpp"
#include "taut/interchange/compas_json.hpp"
#include "taut/interchange/form_vtk.hpp"
#include "taut/interchange/net_csv.hpp"
#include "taut/interchange/obj.hpp"
#include "taut/io/lengths_csv.hpp"
#include "taut/io/net_json.hpp"
#include "taut/results/draws_h5.hpp"
#include "taut/results/net_or_result.hpp"
#include "taut/results/result_file.hpp"
#include "taut/results/result_xlsx.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/imbalance.hpp"
#include "taut/statics/tensions.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct ExportOptions : CommonOptions {
    std::string net;  ///< or a result of identify
    std::string form;
    std::string lengths;
    std::string format;
    std::string output;
};

/// A net with its lengths in a form, and where both come from.
struct Exported {
    NetOrResult source;  ///< its net at the form
    std::string lengths;
    std::string form;
    Imbalance balance;
    std::vector<int> slack;
    std::vector<std::string> warnings;

    [[nodiscard]] const CableNet& net() const { return source.file.net; }
};

CableNet changed(const CableNet& net, const Eigen::VectorXd& lengths, const Points& form,
                 const std::string& file) {
    CableNetData data = net.data();
    data.unstressed_lengths = lengths;
    data.nodes = form;
    return naming_file(file, [&] { return CableNet(std::move(data)); });
}

/// In its equilibrium, with the lengths that runs have then slid to.
CableNet in_equilibrium(const CableNet& net, const std::string& path) {
    const Equilibrium equilibrium = solve_equilibrium(net);
    if (!equilibrium.balanced()) {
        throw NumericalFailure(
            fmt::format("{}: no equilibrium was found: {}", path, equilibrium_text(equilibrium)));
    }
    return changed(net, equilibrium.unstressed_lengths, equilibrium.form, path);
}

/// The lengths of one net in the form of another give tensions that neither has.
void warn_of_imbalance(Exported& exported) {
    constexpr double balanced = 0.01;  // of the mean tension, as of a form rounded to 0.01 mm
    if (exported.balance.share() > balanced) {
        exported.warnings.push_back(fmt::format(
            "with the lengths of {} it is {}, so its tensions are meaningless. {}",
            exported.lengths, balance_text(exported.balance.largest, exported.balance.mean_tension),
            exported.source.is_identified
                ? "Leave out FORM: a result is exported in its predicted form"
                : "Give the lengths of this form by --lengths, or export the result of identify"));
    }
}

/// What other formats do not have.
void warn_of_left_out(const ExportOptions& options, Exported& exported) {
    const CableNet& net = exported.source.file.net;
    if (!net.is_linear() && options.format != "net") {
        exported.warnings.emplace_back(
            "this format has no piecewise linear tension laws: EA of these edges is their tension "
            "over strain in this form");
    }
    if (net.sags() && options.format != "net") {
        exported.warnings.emplace_back(
            "no other program knows cables that sag: their tensions are more than EA times the "
            "strain between their nodes");
    }
    if (options.format == "obj" && !(net.elastic_supports().empty() && net.data().runs.empty())) {
        exported.warnings.emplace_back(
            "obj has neither cable runs nor supports that give way: they are left out");
    }
    const CableNetData& data = net.data();
    std::vector<std::string_view> absent;
    for (const auto& [is_given, what] :
         {std::pair(data.mass.size() > 0, "masses (their weight is among the loads)"),
          {!data.groups.empty(), "groups"},
          {!data.support_couplings.empty(),
           "what supports on one frame pass on to each other (read back, each stands alone, where "
           "it holds this form)"},
          {data.expansion.size() > 0, "thermal expansion"},
          {data.breaking_load.size() > 0, "breaking loads"},
          {data.buckling_load.size() > 0, "buckling loads"},
          {data.bending_stiffness.size() > 0, "bending stiffnesses"},
          {!data.cable_ends.empty(), "how the ends of cables are held"},
          {!data.thread.empty(), "threads"}}) {
        if (is_given && options.format != "net") {
            absent.emplace_back(what);
        }
    }
    if (!absent.empty()) {
        exported.warnings.push_back(
            fmt::format("left out of this format: {}", fmt::join(absent, ", ")));
    }
    const auto differs = [](const CableRun& run) {
        return std::ranges::any_of(run.ratios, [](double ratio) { return ratio != 1.0; });
    };
    if (options.format != "net" && std::ranges::any_of(data.runs, differs)) {
        exported.warnings.emplace_back(
            "the ratios of tensions at nodes where cables slide are left out: read back, the net "
            "slides to another form");
    }
}

Exported exported_net(const ExportOptions& options) {
    Exported it{.source = read_net_or_result(options.net), .lengths = options.net, .form = {}};
    CableNet& net = it.source.file.net;
    if (!options.lengths.empty()) {
        if (it.source.is_identified) {
            throw std::invalid_argument(fmt::format(
                "--lengths is for a net; {} is a result, which has its own", options.net));
        }
        const std::string text = read_table(options.lengths);
        if (text.starts_with('{')) {
            throw InputError(options.lengths, "",
                             "is JSON, expected a CSV file of lengths as taut form --lengths "
                             "writes it. To export a result: taut export RESULT");
        }
        net = changed(net, parse_lengths(net, text, options.lengths), net.nodes(), options.lengths);
        it.lengths = options.lengths;
    }
    if (!options.form.empty()) {
        it.form = options.form;
        net = changed(net, net.unstressed_lengths(), read_form(net, options.form), options.form);
    } else if (it.source.is_identified) {
        it.form = "predicted";
    } else {
        it.form = "equilibrium";
        net = in_equilibrium(net, it.lengths);
    }
    it.balance = imbalance_of(net, net.unstressed_lengths(), net.nodes());
    it.slack = slack_edges(net, net.unstressed_lengths(), net.nodes());
    warn_of_imbalance(it);
    warn_of_left_out(options, it);
    return it;
}

/// The files that the format consists of.
std::vector<std::string> output_files(const ExportOptions& options) {
    if (options.format != "csv") {
        return {options.output};
    }
    const std::filesystem::path nodes = options.output;
    std::filesystem::path edges = nodes;
    edges.replace_filename(nodes.stem().string() + "_edges" + nodes.extension().string());
    return {nodes.string(), edges.string()};
}

void write(const std::vector<std::string>& files, const std::string& format, const NetFile& file) {
    const CableNet& net = file.net;
    const Points& form = net.nodes();
    if (format == "csv") {
        NetCsv csv = form_to_net_csv(net, form);
        write_files({{files[0], std::move(csv.nodes)}, {files[1], std::move(csv.edges)}});
    } else {
        write_file(files[0], format == "net"      ? net_to_json(net, file.unknown_keys)
                             : format == "compas" ? form_to_compas(net, form)
                             : format == "obj"    ? form_to_obj(net, form)
                                                  : form_to_vtk(net, form));
    }
}

nlohmann::ordered_json to_json(const ExportOptions& options, const Exported& it,
                               const std::vector<std::string>& files) {
    return {{"format", "taut-export"},
            {"version", 1},
            {"net", counts_json(it.net())},
            {"lengths", it.lengths},
            {"form", it.form},
            {"to", options.format},
            {"slack_edges", it.slack},
            {"lengths_not_known",
             {{"slack", it.source.slack}, {"not_determined", it.source.not_determined}}},
            {"out_of_balance", it.balance.largest},
            {"mean_tension", it.balance.mean_tension},
            {"warnings", it.warnings},
            {"files", files}};
}

void print(const Exported& it, const std::vector<std::string>& files) {
    const CableNet& net = it.net();
    say("{}\nlengths: {}\n", counts_text(net), it.lengths);
    if (it.source.is_identified) {
        say("  estimates of lengths that are not known: {} slack, {} not determined, of {}\n",
            it.source.slack.size(), it.source.not_determined.size(), net.interior_edge_count());
    }
    say("form: {}\n  {}\nslack edges: {}\n",
        it.form == "equilibrium" ? "equilibrium of the net"
        : it.form == "predicted" ? "as the result predicts it"
                                 : it.form,
        balance_text(it.balance.largest, it.balance.mean_tension), edges_text(net, it.slack));
    for (const std::string& file : files) {
        say("written to {}\n", file);
    }
}

/// The tables of a result; with other keys than a net's document has.
void export_tables(const ExportOptions& options) {
    if (!options.form.empty() || !options.lengths.empty()) {
        throw std::invalid_argument(
            "FORM and --lengths are for a net; xlsx takes the tables of a result as they are");
    }
    const ResultFile result = read_result(options.net);
    check_outputs({options.output}, {options.net, draws_path(options.net).string()});
    const ResultXlsx tables = result_to_xlsx(result, options.net);
    write_file(options.output, tables.bytes);
    warn(options.net, tables.remarks);
    if (options.json) {
        say("{}\n", to_text(nlohmann::ordered_json{{"format", "taut-export"},
                                                   {"version", 1},
                                                   {"to", options.format},
                                                   {"warnings", tables.remarks},
                                                   {"files", {options.output}}}));
    } else {
        say("written to {}\n", options.output);
    }
}

void run(const ExportOptions& options) {
    if (options.format == "xlsx") {
        export_tables(options);
        return;
    }
    const Exported exported = exported_net(options);
    const std::vector<std::string> files = output_files(options);
    check_outputs(files, {options.net, options.form, options.lengths,
                          exported.source.is_identified ? draws_path(options.net).string() : ""});
    write(files, options.format, exported.source.file);
    warn(exported.form, exported.warnings);
    if (options.json) {
        say("{}\n", to_text(to_json(options, exported, files)));
    } else {
        print(exported, files);
    }
}

}  // namespace

void add_export(CLI::App& program) {
    auto options = std::make_shared<ExportOptions>();
    CLI::App& command = add_command(
        program, "export",
        "Write a net, also as built, or the tables of a result, for another program",
        "  taut export net.json --to vtk -o net.vtk\n"
        "  taut export net.json built.csv --lengths truth.csv --to compas -o graph.json\n"
        "  taut export result.json --to net -o built.json     (the net as built)\n"
        "  taut export plan.json --to xlsx -o turns.xlsx     (the list for the crews)",
        *options);
    command
        .add_option("NET", options->net,
                    "Net file, or a result of identify: the net with its identified lengths in "
                    "the predicted form. For xlsx a result of identify or plan")
        ->required();
    command.add_option("FORM", options->form,
                       "Form file (id,x,y,z; default: the equilibrium of the net)");
    command.add_option("--lengths", options->lengths,
                       "Lengths of the form, as taut form --lengths writes them (default: NET's)");
    command
        .add_option("--to", options->format,
                    "Format: net is taut's own; csv writes a second file, ..._edges; xlsx writes "
                    "tables for Excel: edges and nodes, or the list of turns")
        ->required()
        ->check(CLI::IsMember({"net", "compas", "obj", "csv", "vtk", "xlsx"}));
    add_output_option(command, options->output, "File to write");
    set_action(command, options, run);
}

}  // namespace taut::app
