// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/frame.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "command.hpp"
#include "net_summary.hpp"
#include "taut/files/file.hpp"
#include "taut/files/table_file.hpp"
#include "taut/io/frame_csv.hpp"
#include "taut/io/net_json.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct FrameOptions : CommonOptions {
    std::string net;
    std::string stiffness;
    std::string output;
};

/// How far the frame is from where it stands without load [m].
double largest_shift(const CableNet& net, const std::vector<int>& supports) {
    double largest = 0.0;
    for (const ElasticSupport& support : net.elastic_supports()) {
        if (std::ranges::find(supports, support.node) != supports.end()) {
            largest = std::max(largest, (support.place - net.nodes().col(support.node)).norm());
        }
    }
    return largest;
}

void run(const FrameOptions& options) {
    check_outputs({options.output}, {options.net, options.stiffness});
    const NetFile file = read_net(options.net);
    const FrameStiffness frame =
        parse_frame(file.net, read_table(options.stiffness), options.stiffness);
    const CableNet net = on_frame(file.net, frame);
    write_file(options.output, net_to_json(net, file.unknown_keys));
    const Eigen::VectorXd strengths = frame.stiffness.diagonal();
    const auto replaced = std::ranges::count_if(
        frame.supports, [&file](int node) { return file.net.free_index(node) >= 0; });
    const double shift = largest_shift(net, frame.supports);
    const size_t pairs = net.support_couplings().size() - file.net.support_couplings().size();
    if (options.json) {
        say("{}\n",
            to_text(nlohmann::ordered_json{
                {"format", "taut-frame"},
                {"version", 1},
                {"net", counts_json(net)},
                {"supports", frame.supports},
                {"coupled_pairs", pairs},
                {"replaced_springs", replaced},
                {"stiffness", {{"min", strengths.minCoeff()}, {"max", strengths.maxCoeff()}}},
                {"largest_shift", shift}}));
        return;
    }
    say("{}\nframe of {} supports, of which {} pairs pass forces on to each other; stiffness of "
        "each by "
        "itself {:.3g} to {:.3g} N/m\n{}unloaded it stands up to {:.2f} mm from the nominal form, "
        "which it balances\nwritten to {}\n",
        counts_text(net), frame.supports.size(), pairs, strengths.minCoeff(), strengths.maxCoeff(),
        replaced > 0 ? fmt::format("it replaces the springs of {} supports\n", replaced) : "",
        1e3 * shift, options.output);
}

}  // namespace

void add_frame(CLI::App& program) {
    auto options = std::make_shared<FrameOptions>();
    CLI::App& command =
        add_command(program, "frame", "Put the supports of a net on a frame of known stiffness",
                    "  taut frame net.json stiffness.csv -o net-on-frame.json", *options);
    command.add_option("NET", options->net, "Net file")->required();
    command
        .add_option("STIFFNESS", options->stiffness,
                    "Stiffness of the frame in N/m, condensed to its supports, as a CSV matrix "
                    "dof,A.x,A.y,A.z,B.x,... or a list row,column,stiffness of its entries")
        ->required();
    add_output_option(command, options->output, "Net file to write");
    set_action(command, options, run);
}

}  // namespace taut::app
