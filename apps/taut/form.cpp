// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "command.hpp"
#include "net_summary.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/files/table_file.hpp"
#include "taut/io/form_csv.hpp"
#include "taut/io/lengths_csv.hpp"
#include "taut/io/net_json.hpp"
#include "taut/io/turned_csv.hpp"
#include "taut/sampling/built_net.hpp"
#include "taut/statics/cone_program.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/imbalance.hpp"
#include "taut/statics/plausibility.hpp"
#include "taut/statics/tensions.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct FormOptions : CommonOptions {
    std::string net;
    std::string output;
    std::string solver = "newton";
    std::string cone_form = "quadratic";
    std::string prior;
    std::uint64_t seed = 1;
    std::string lengths;
    std::string turned;
};

/// The net as designed, with the turns made since.
CableNet as_turned(const FormOptions& options, const CableNet& net) {
    return options.turned.empty()
               ? net
               : turned_net(net, parse_turned(net, read_table(options.turned), options.turned));
}

/// The net as designed, or as it might be built under the prior.
CableNet net_of(const FormOptions& options, const CableNet& nominal) {
    if (options.prior.empty()) {
        return nominal;
    }
    const LengthPrior prior = parse_length_prior(options.prior);
    return naming_file(options.net, [&] { return built_net(nominal, prior, options.seed); });
}

/// Result of either solver.
struct Found {
    Points form;
    std::string status;
    std::string text;  ///< the status with its numbers
    int iterations;
    double out_of_balance;
    double mean_tension;
    std::vector<int> slack_edges;
    FormCheck check;
    nlohmann::ordered_json details;  ///< of this solver only
};

Found find_by_newton(const FormOptions& options, const CableNet& net) {
    Equilibrium e = solve_equilibrium(net);
    if (!e.balanced()) {
        const char* const what =
            e.status == EquilibriumStatus::unstable
                ? "the equilibrium is not stable, struts give way at the least disturbance"
                : "no equilibrium was found";
        throw NumericalFailure(fmt::format("{}: {}: {}", options.net, what, equilibrium_text(e)));
    }
    std::string text = equilibrium_text(e);
    if (e.status == EquilibriumStatus::slack_mechanism) {
        text +=
            fmt::format("\n{}some nodes free to move: their places are one solution of many",
                        e.slack_edges.empty() ? "struts with hinges leave " : "slack edges leave ");
    }
    const FormCheck check = check_form(net, e.unstressed_lengths, e.form);
    return {.form = std::move(e.form),
            .status = std::string(to_string(e.status)),
            .text = text,
            .iterations = e.iterations,
            .out_of_balance = e.out_of_balance,
            .mean_tension = e.mean_tension,
            .slack_edges = std::move(e.slack_edges),
            .check = check,
            .details = {}};
}

Found find_by_cone_program(const FormOptions& options, const CableNet& net) {
    const ConeForm cone_form = options.cone_form == "paper" ? ConeForm::paper : ConeForm::quadratic;
    const Eigen::VectorXd& lengths = net.unstressed_lengths();
    const ConeSolution s = solve_cone_program(net, lengths, {.form = cone_form});
    const std::string text = fmt::format(
        "cone program ({}): {} after {} iterations, objectives {:.10g} J and {:.10g} J (dual), "
        "residuals {:.1g} and {:.1g} (dual)",
        to_string(cone_form), to_string(s.status), s.iterations, s.primal_objective,
        s.dual_objective, s.primal_residual, s.dual_residual);
    if (!s.solved()) {
        throw NumericalFailure(fmt::format("{}: no equilibrium was found: {}", options.net, text));
    }
    const Imbalance balance = imbalance_of(net, lengths, s.form);
    return {.form = s.form,
            .status = std::string(to_string(s.status)),
            .text = text,
            .iterations = s.iterations,
            .out_of_balance = balance.largest,
            .mean_tension = balance.mean_tension,
            .slack_edges = slack_edges(net, lengths, s.form),
            .check = check_form(net, lengths, s.form, s.edge_forces),
            .details = {{"form", to_string(cone_form)},
                        {"primal_objective", s.primal_objective},
                        {"dual_objective", s.dual_objective},
                        {"gap", s.primal_objective - s.dual_objective},
                        {"primal_residual", s.primal_residual},
                        {"dual_residual", s.dual_residual}}};
}

nlohmann::ordered_json to_json(const FormOptions& options, const CableNet& net, const Found& found,
                               double move, const std::vector<std::string>& warnings) {
    nlohmann::ordered_json document{{"format", "taut-form"},
                                    {"version", 1},
                                    {"net", counts_json(net)},
                                    {"solver", options.solver},
                                    {"status", found.status},
                                    {"iterations", found.iterations},
                                    {"out_of_balance", found.out_of_balance},
                                    {"mean_tension", found.mean_tension},
                                    {"largest_move", move},
                                    {"slack_edges", found.slack_edges},
                                    {"warnings", warnings}};
    add_check(document, found.check);
    if (!found.details.is_null()) {
        document["cone_program"] = found.details;
    }
    document["form"] = nlohmann::ordered_json::array();
    for (const auto& node : found.form.colwise()) {
        document["form"].push_back({node.x(), node.y(), node.z()});
    }
    return document;
}

void run(const FormOptions& options) {
    const CableNet designed = read_net(options.net).net;
    const CableNet net = net_of(options, as_turned(options, designed));
    check_outputs({options.output, options.lengths}, {options.net, options.turned});
    const std::vector<std::string> warnings = unit_warnings(designed);
    warn(options.net, warnings);
    if (options.solver == "socp" && net.has_struts()) {
        throw InputError(options.net, "",
                         "has struts: its energy is not convex, expected --solver newton");
    }
    if (options.solver == "socp" && !net.sliding_nodes().empty()) {
        throw InputError(
            options.net, "",
            "has runs that slide, expected --solver newton: the cone program has none");
    }
    if (options.solver == "socp" && net.sags()) {
        throw InputError(
            options.net, "",
            "has cables that sag, expected --solver newton: the cone program has none");
    }
    const Found found = options.solver == "socp" ? find_by_cone_program(options, net)
                                                 : find_by_newton(options, net);
    std::vector<std::pair<std::filesystem::path, std::string>> files;
    if (!options.output.empty()) {
        files.emplace_back(options.output, form_to_csv(net, found.form));
    }
    if (!options.lengths.empty()) {
        files.emplace_back(options.lengths, lengths_to_csv(designed, net));
    }
    write_files(files);
    const double move = (found.form - net.nodes()).colwise().norm().maxCoeff();
    if (options.json) {
        say("{}\n", to_text(to_json(options, net, found, move, warnings)));
        return;
    }
    say("{}\n{}\n{}\n", counts_text(net), found.text, check_text(found.check));
    say("largest distance of a node from its nominal place: {:.4g} mm\nslack edges: {}\n",
        1e3 * move, edges_text(net, found.slack_edges));
    for (const auto& [file, content] : files) {
        say("written to {}\n", file.string());
    }
}

}  // namespace

void add_form(CLI::App& program) {
    auto options = std::make_shared<FormOptions>();
    CLI::App& command =
        add_command(program, "form", "Compute the equilibrium form of a net",
                    "  taut form net.json -o form.csv\n"
                    "  taut form net.json --solver socp    (the paper's cone program, as a check)",
                    *options);
    command.add_option("NET", options->net, "Net file")->required();
    command.add_option("-o,--output", options->output, "Form file to write (id,x,y,z; in m)");
    command
        .add_option("--solver", options->solver,
                    "newton (Newton's method on the energy) or socp (the paper's cone program, by "
                    "Clarabel)")
        ->check(CLI::IsMember({"newton", "socp"}))
        ->capture_default_str()
        ->group(heading::advanced);
    command
        .add_option(
            "--cone-form", options->cone_form,
            "Form of socp: quadratic (the energy as objective), paper (with v and its large cone)")
        ->check(CLI::IsMember({"quadratic", "paper"}))
        ->capture_default_str()
        ->group(heading::advanced);
    command.add_option("--prior", options->prior,
                       "Simulate a built net: sample the interior edges' lengths from this prior, "
                       "uniform:5mm, normal:2mm or bimodal:5mm");
    add_seed_option(command, options->seed);
    command.add_option("--lengths", options->lengths, "True length deviations to write (CSV, m)");
    command.add_option("--turned", options->turned,
                       "Turns made since installation: edge,stroke in m, or the list of taut plan "
                       "--csv. With the same --prior and --seed they are applied to the same built "
                       "net");
    set_action(command, options, run);
}

}  // namespace taut::app
