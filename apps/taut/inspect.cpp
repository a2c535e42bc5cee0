// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "command.hpp"
#include "net_summary.hpp"
#include "taut/io/net_json.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut::app {
namespace {

struct Options : CommonOptions {
    std::string net;
};

struct Range {
    double min;
    double mean;
    double max;
};

Range range_of(const Eigen::VectorXd& values) {
    return {values.minCoeff(), values.mean(), values.maxCoeff()};
}

nlohmann::ordered_json to_json(const Range& range) {
    return {{"min", range.min}, {"mean", range.mean}, {"max", range.max}};
}

/// What is worth knowing of a net before anything is done with it.
struct Inspection {
    Eigen::Vector3d lower;            ///< corners of the bounding box [m]
    Eigen::Vector3d upper;
    Range lengths;                    ///< at the given nodes [m]
    Range unstressed_lengths;         ///< [m]
    Range tensions;                   ///< at the given nodes [N]
    Range strains;                    ///< likewise
    double out_of_balance;            ///< at the given nodes, largest nodal force [N]
    std::vector<int> slack_edges;     ///< at the given nodes
    Eigen::Vector3d load;             ///< sum over the free nodes [N]
    Equilibrium equilibrium;
    double move;                      ///< largest distance of a given node from its equilibrium [m]
};

Inspection inspect(const CableNet& net) {
    const Eigen::VectorXd& unstressed = net.unstressed_lengths();
    const Eigen::VectorXd lengths = edge_lengths(net, net.nodes());
    const Eigen::VectorXd forces = out_of_balance_forces(net, unstressed, net.nodes());
    const Eigen::VectorXd edge_tensions = tensions(net, unstressed, net.nodes());
    Equilibrium equilibrium = solve_equilibrium(net);
    const double move = (equilibrium.form - net.nodes()).colwise().norm().maxCoeff();
    return {.lower = net.nodes().rowwise().minCoeff(),
            .upper = net.nodes().rowwise().maxCoeff(),
            .lengths = range_of(lengths),
            .unstressed_lengths = range_of(unstressed),
            .tensions = range_of(edge_tensions),
            .strains = range_of(edge_tensions.cwiseQuotient(net.axial_stiffness())),
            .out_of_balance = forces.reshaped(3, net.free_node_count()).colwise().norm().maxCoeff(),
            .slack_edges = slack_edges(net, unstressed, net.nodes()),
            .load = net.loads()(Eigen::all, net.free_nodes()).rowwise().sum(),
            .equilibrium = std::move(equilibrium),
            .move = move};
}

nlohmann::ordered_json to_json(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

nlohmann::ordered_json to_json(const CableNet& net, const Inspection& it) {
    return {{"format", "taut-inspection"},
            {"version", 1},
            {"net", counts_json(net)},
            {"bounding_box", {{"lower", to_json(it.lower)}, {"upper", to_json(it.upper)}}},
            {"lengths", to_json(it.lengths)},
            {"unstressed_lengths", to_json(it.unstressed_lengths)},
            {"tensions", to_json(it.tensions)},
            {"strains", to_json(it.strains)},
            {"load", to_json(it.load)},
            {"out_of_balance", it.out_of_balance},
            {"slack_edges", it.slack_edges},
            {"equilibrium",
             {{"status", to_string(it.equilibrium.status)},
              {"iterations", it.equilibrium.iterations},
              {"out_of_balance", it.equilibrium.out_of_balance},
              {"mean_tension", it.equilibrium.mean_tension},
              {"largest_move", it.move},
              {"slack_edges", it.equilibrium.slack_edges}}}};
}

void print(const CableNet& net, const Inspection& it) {
    const auto line = [](std::string_view name, std::string_view unit, const Range& r, double scale) {
        fmt::print("  {:<28}{:>12.4g}{:>12.4g}{:>12.4g}  {}\n", name, scale * r.min, scale * r.mean,
                   scale * r.max, unit);
    };
    const Eigen::Vector3d size = it.upper - it.lower;
    fmt::print("{}\nfingerprint {}\n", counts_text(net), net.fingerprint());
    fmt::print("bounding box {:.4g} x {:.4g} x {:.4g} m\n", size.x(), size.y(), size.z());
    fmt::print("sum of loads {:.4g}, {:.4g}, {:.4g} N\n\n", it.load.x(), it.load.y(), it.load.z());
    fmt::print("  {:<28}{:>12}{:>12}{:>12}\n", "as given", "least", "mean", "most");
    line("length", "m", it.lengths, 1.0);
    line("unstressed length", "m", it.unstressed_lengths, 1.0);
    line("tension", "kN", it.tensions, 1e-3);
    line("strain", "%", it.strains, 100.0);
    fmt::print("  largest out-of-balance force: {:.4g} N\n", it.out_of_balance);
    fmt::print("  slack edges: {}\n\n", edges_text(net, it.slack_edges));
    fmt::print("in equilibrium: {}\n", equilibrium_text(it.equilibrium));
    fmt::print("  largest move of a node from where it is given: {:.4g} mm\n", 1e3 * it.move);
    fmt::print("  slack edges: {}\n", edges_text(net, it.equilibrium.slack_edges));
}

void run(const Options& options) {
    const auto threads = options.limit_threads();
    const CableNet net = read_net(options.net).net;
    const Inspection inspection = inspect(net);
    if (options.json) {
        fmt::print("{}\n", to_json(net, inspection).dump(2));
    } else {
        print(net, inspection);
    }
}

}  // namespace

void add_inspect(CLI::App& program) {
    auto options = std::make_shared<Options>();
    CLI::App& command =
        add_command(program, "inspect", "Tell what a net is: counts, lengths, tensions, balance",
                    "  taut inspect net.json", *options);
    command.add_option("NET", options->net, "Net file")->required();
    command.callback([options] { run(*options); });
}

}  // namespace taut::app
