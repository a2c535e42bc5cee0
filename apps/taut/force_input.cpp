// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "force_input.hpp"

#include <fmt/core.h>

#include <numeric>
#include <stdexcept>

#include "command.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/io/forces_csv.hpp"
#include "taut/net/units.hpp"
#include "taut/statics/tensions.hpp"

namespace taut::app {
namespace {

const std::string uncertain_text =
    "What else is uncertain, NAME:WIDTH[@GROUP], WIDTH a standard deviation: stiffness:5% (one "
    "factor), stiffness-each:2%, temperature:5K, adjustable:0.5mm, supports:1mm, loads:20N (of "
    "each "
    "node), loads:10% (one factor); GROUP of edges, of the net. May be repeated";

ForceFormat format_of(const ForceOptions& options) {
    ForceFormat format{.unit = options.force_unit == "kN" ? 1e3 : 1.0};
    const bool is_part = options.force_noise.ends_with('%');
    double& std = is_part ? format.relative_std : format.std;
    std = is_part ? parse_part(options.force_noise) : parse_force(options.force_noise);
    if (!(std > 0.0)) {
        throw std::invalid_argument(fmt::format(
            "--force-noise is '{}', expected a standard deviation above 0", options.force_noise));
    }
    return format;
}

}  // namespace

std::vector<std::string> ForceOptions::files() const {
    return {forces, taut == "all" ? "" : taut, slack};
}

std::vector<CLI::Option*> add_reading_options(CLI::App& command, ForceOptions& options,
                                              const std::string& help) {
    CLI::Option* const forces = command.add_option("--forces", options.forces, help);
    CLI::Option* const unit =
        command.add_option("--force-unit", options.force_unit, "Unit of that file: N or kN")
            ->check(CLI::IsMember({"N", "kN"}))
            ->needs(forces)
            ->capture_default_str();
    CLI::Option* const noise =
        command
            .add_option("--force-noise", options.force_noise,
                        "Standard deviation of a reading where that file tells none: a part of "
                        "it, 2%, or a force, 50N")
            ->needs(forces)
            ->capture_default_str();
    return {forces, unit, noise};
}

void add_force_options(CLI::App& command, ForceOptions& options) {
    add_reading_options(command, options,
                        "Tensions read from load cells or tension meters: edge,tension[,std]");
    command.add_option("--taut", options.taut,
                       "Edges seen to carry tension: a file that names them, one a line, or all");
    command.add_option("--slack", options.slack,
                       "Edges seen to hang slack: a file that names them, one a line");
}

Forces read_forces(const CableNet& net, const ForceOptions& options) {
    Forces forces;
    if (!options.forces.empty()) {
        forces.readings = parse_force_readings(net, read_file(options.forces), options.forces,
                                               format_of(options));
        if (const std::string warning = force_unit_warning(net, forces.readings, options.forces);
            !warning.empty()) {
            warn(options.forces, {warning});
        }
    }
    if (!options.slack.empty()) {
        forces.slack = parse_edge_list(net, read_file(options.slack), options.slack);
    }
    if (options.taut == "all") {
        forces.taut.resize(net.edge_count());
        std::iota(forces.taut.begin(), forces.taut.end(), 0);
    } else if (!options.taut.empty()) {
        forces.taut = parse_edge_list(net, read_file(options.taut), options.taut);
    }
    try {
        check_forces(net, forces);
    } catch (const std::invalid_argument& error) {
        throw InputError(options.slack.empty() ? options.forces : options.slack, "", error.what());
    }
    return forces;
}

Forces read_planned_forces(const CableNet& net, const ForceOptions& options) {
    if (options.forces.empty()) {
        return {};
    }
    const std::string text = read_file(options.forces);
    if (!is_edge_list(text, options.forces)) {
        return read_forces(net, options);
    }
    const ForceFormat format = format_of(options);
    const Eigen::VectorXd designed = tensions(net, net.unstressed_lengths(), net.nodes());
    Forces forces;
    for (const int edge : parse_edge_list(net, text, options.forces)) {
        if (!(designed(edge) > 0.0)) {
            throw InputError(options.forces, "",
                             fmt::format("names edge '{}', which is slack as designed: there is "
                                         "nothing to read",
                                         net.edge_id(edge)));
        }
        const double std = format.std > 0.0 ? format.std : format.relative_std * designed(edge);
        forces.readings.push_back({.edge = edge, .tension = designed(edge), .std = std});
    }
    return forces;
}

CLI::Option* add_unknown_option(CLI::App& command, std::vector<std::string>& unknowns) {
    return command.add_option("--uncertain,--unknown", unknowns, uncertain_text)
        ->allow_extra_args(false);
}

bool UncertainOptions::assume_site() const {
    return unknowns.empty() && std::ranges::find(uncertain, "none") == uncertain.end();
}

std::vector<Unknown> UncertainOptions::given(const CableNet& net,
                                             const std::string& net_file) const {
    if (!unknowns.empty() && !uncertain.empty()) {
        throw std::invalid_argument(
            "--uncertain and --unknown cannot stand together: --uncertain none takes all else as "
            "exact, as --unknown does");
    }
    std::vector<std::string> texts = unknowns.empty() ? uncertain : unknowns;
    std::erase(texts, "none");
    return unknowns_of(net, texts, net_file);
}

void add_uncertain_option(CLI::App& command, UncertainOptions& options, CLI::Option* needed) {
    CLI::Option* uncertain =
        command
            .add_option("--uncertain", options.uncertain,
                        uncertain_text +
                            ". Of those but loads so much is assumed where they are not given; "
                            "none: all that is not given is exact")
            ->allow_extra_args(false);
    CLI::Option* unknown =
        command
            .add_option("--unknown", options.unknowns,
                        "As --uncertain none and each of these (the option of versions before 0.3)")
            ->allow_extra_args(false);
    if (needed != nullptr) {
        uncertain->needs(needed);
        unknown->needs(needed);
    }
}

std::vector<Unknown> unknowns_of(const CableNet& net, const std::vector<std::string>& texts,
                                 const std::string& net_file) {
    std::vector<Unknown> unknowns;
    unknowns.reserve(texts.size());
    for (const std::string& text : texts) {
        unknowns.push_back(parse_unknown(text));
    }
    try {
        check_unknowns(net, unknowns);
    } catch (const std::invalid_argument& error) {
        throw InputError(net_file, "", error.what());
    }
    return unknowns;
}

}  // namespace taut::app
