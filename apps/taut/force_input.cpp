// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "force_input.hpp"

#include <fmt/core.h>

#include <numeric>
#include <stdexcept>

#include "command.hpp"
#include "taut/files/input_error.hpp"
#include "taut/files/table_file.hpp"
#include "taut/identification/force_units.hpp"
#include "taut/identification/identify.hpp"
#include "taut/io/forces_csv.hpp"
#include "taut/io/frequencies_csv.hpp"
#include "taut/io/sag_csv.hpp"
#include "taut/net/units.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/statics/tensions.hpp"
#include "taut/survey/cable_sag.hpp"
#include "taut/survey/cable_vibration.hpp"

namespace taut::app {
namespace {

const std::string uncertain_text =
    "What is uncertain besides the lengths, NAME:WIDTH[@GROUP], WIDTH a standard deviation: "
    "stiffness:5% (one factor), stiffness-each:2%, temperature:5K, adjustable:0.5mm, supports:1mm, "
    "loads:5% (one factor), loads:20N (of each node), forces:1% (one of all load cells), mass:3% "
    "(one factor), test-loads:2% (of --epoch), support-stiffness:25% (of elastic supports), "
    "creep:0.01% (strain from one survey to the next, with --epoch), slip:50mm (at each node where "
    "a run slides); GROUP is a group of edges of the net. May be repeated";

ForceFormat format_of(const ForceOptions& options) {
    ForceFormat format{.unit = options.force_unit == "kN" ? 1e3 : 1.0};
    const bool is_part = options.force_noise.ends_with('%');
    double& std_dev = is_part ? format.relative_std : format.std_dev;
    std_dev = is_part ? parse_part(options.force_noise) : parse_force(options.force_noise);
    if (!(std_dev > 0.0)) {
        throw std::invalid_argument(fmt::format(
            "--force-noise is '{}', expected a standard deviation above 0", options.force_noise));
    }
    return format;
}

}  // namespace

std::vector<std::string> ForceOptions::files() const {
    return {forces, taut == "all" ? "" : taut, slack, frequencies, sag};
}

std::vector<CLI::Option*> add_force_measurement_options(CLI::App& command, ForceOptions& options,
                                                        const std::string& help) {
    CLI::Option* const forces =
        command.add_option("--forces", options.forces, help)->group(heading::known);
    CLI::Option* const unit =
        command.add_option("--force-unit", options.force_unit, "Unit of that file: N or kN")
            ->check(CLI::IsMember({"N", "kN"}))
            ->needs(forces)
            ->group(heading::known)
            ->capture_default_str();
    CLI::Option* const noise =
        command
            .add_option("--force-noise", options.force_noise,
                        "Standard deviation of a force measurement where that file has none: a "
                        "part of it, 2%, or a force, 50N")
            ->needs(forces)
            ->group(heading::known)
            ->capture_default_str();
    return {forces, unit, noise};
}

std::vector<CLI::Option*> add_frequency_noise_options(CLI::App& command, ForceOptions& options) {
    CLI::Option* const noise =
        command
            .add_option("--frequency-noise", options.frequency_noise,
                        "Standard deviation of a frequency, a part of it, where none is given")
            ->group(heading::known)
            ->capture_default_str();
    CLI::Option* const length =
        command
            .add_option("--free-length-std", options.free_length_std,
                        "Standard deviation of the length that vibrates, which clamps shorten")
            ->group(heading::known)
            ->capture_default_str();
    return {noise, length};
}

void add_force_options(CLI::App& command, ForceOptions& options) {
    add_force_measurement_options(command, options,
                                  "Force measurements of load cells or tension meters, a file "
                                  "edge,tension[,std]");
    command
        .add_option("--taut", options.taut,
                    "Edges seen to carry tension: a file that names them, one a line, or all")
        ->group(heading::known);
    command
        .add_option("--slack", options.slack,
                    "Edges seen to hang slack: a file that names them, one a line")
        ->group(heading::known);
    CLI::Option* const frequencies =
        command
            .add_option("--frequencies", options.frequencies,
                        "Natural frequencies of cables, a file edge,frequency[,mode][,std], in Hz; "
                        "the net needs mass")
            ->group(heading::known);
    for (CLI::Option* option : add_frequency_noise_options(command, options)) {
        option->needs(frequencies);
    }
    command
        .add_option("--sag", options.sag,
                    "Points on cables that sag, three or more on each, a file edge,x,y,z[,std] in "
                    "m; the net needs mass")
        ->group(heading::known);
}

double frequency_part(const ForceOptions& options) {
    const double part = parse_part(options.frequency_noise);
    if (!(part > 0.0)) {
        throw std::invalid_argument(
            fmt::format("--frequency-noise is '{}', expected a standard deviation above 0",
                        options.frequency_noise));
    }
    return part;
}

namespace {

/// Adds measurements of a file; warns where they are far from those designed.
void add_measurements(const CableNet& net, const std::vector<ForceMeasurement>& found,
                      const std::string& file, Forces& forces) {
    const std::string warning = naming_file(file, [&] { return force_unit_warning(net, found); });
    if (!warning.empty()) {
        warn(file, {warning});
    }
    forces.measurements.insert(forces.measurements.end(), found.begin(), found.end());
    naming_file(file, [&] { check_forces(net, forces); });
}

void add_cells(const CableNet& net, const ForceOptions& options, Forces& forces) {
    add_measurements(net,
                     parse_force_measurements(net, read_table(options.forces), options.forces,
                                              format_of(options)),
                     options.forces, forces);
}

/// What the natural frequencies say of tensions.
void add_frequencies(const CableNet& net, const ForceOptions& options, const Points& form,
                     Forces& forces) {
    const double part = frequency_part(options);
    const double free_length_std = parse_length(options.free_length_std);
    const std::vector<FrequencyMeasurement> measured =
        parse_frequencies(net, read_table(options.frequencies), options.frequencies, part);
    std::vector<ForceMeasurement> found;
    naming_file(options.frequencies, [&] {
        for (const FrequencyMeasurement& one : measured) {
            found.push_back(tension_by_frequency(net, form, one, free_length_std));
        }
    });
    add_measurements(net, found, options.frequencies, forces);
}

/// What the sags say of tensions.
void add_sags(const CableNet& net, const ForceOptions& options, const Survey& survey,
              Forces& forces) {
    const std::vector<SagPoint> points =
        parse_sag_points(net, read_table(options.sag), options.sag, survey.rms_noise_std());
    std::vector<ForceMeasurement> found;
    naming_file(options.sag, [&] { found = tensions_by_sag(net, survey.form, points); });
    add_measurements(net, found, options.sag, forces);
}

}  // namespace

Forces read_forces(const CableNet& net, const ForceOptions& options, const Survey& survey) {
    Forces forces;
    if (!options.forces.empty()) {
        add_cells(net, options, forces);
    }
    if (!options.frequencies.empty()) {
        add_frequencies(net, options, survey.form, forces);
    }
    if (!options.sag.empty()) {
        add_sags(net, options, survey, forces);
    }
    if (!options.slack.empty()) {
        forces.slack = read_edge_list(net, options.slack);
    }
    if (options.taut == "all") {
        for (int edge = 0; edge < net.edge_count(); ++edge) {
            if (!net.is_strut(edge)) {
                forces.taut.push_back(edge);
            }
        }
    } else if (!options.taut.empty()) {
        forces.taut = read_edge_list(net, options.taut);
    }
    naming_file(!options.slack.empty()                           ? options.slack
                : !options.taut.empty() && options.taut != "all" ? options.taut
                                                                 : options.forces,
                [&] { check_forces(net, forces); });
    return forces;
}

Forces read_planned_forces(const CableNet& net, const ForceOptions& options) {
    if (options.forces.empty()) {
        return {};
    }
    const std::string text = read_table(options.forces);
    Forces forces;
    if (!is_edge_list(text, options.forces)) {
        add_cells(net, options, forces);
        return forces;
    }
    const ForceFormat format = format_of(options);
    const Eigen::VectorXd designed = tensions_of(net, net.unstressed_lengths(), net.nodes());
    for (const int edge : parse_edge_list(net, text, options.forces)) {
        if (!(designed(edge) > 0.0) && !net.is_strut(edge)) {
            throw InputError(options.forces, "",
                             fmt::format("names edge '{}', which is slack as designed: it has no "
                                         "tension to measure",
                                         net.edge_id(edge)));
        }
        const double std_dev =
            format.std_dev > 0.0 ? format.std_dev : format.relative_std * std::abs(designed(edge));
        forces.measurements.push_back(
            {.edge = edge, .tension = designed(edge), .std_dev = std_dev});
    }
    return forces;
}

std::vector<int> read_edge_list(const CableNet& net, const std::string& file) {
    return parse_edge_list(net, read_table(file), file);
}

LengthPrior prior_for(const CableNet& net, const std::string& text, const std::string& net_file) {
    const LengthPrior prior = parse_length_prior(text);
    naming_file(net_file, [&] { check_prior(net, prior); });
    return prior;
}

const char* const assumes_site =
    ". Those not given are assumed with these widths, except loads of each node and creep; none: "
    "what is not given is exact";

CLI::Option* add_uncertain_option(CLI::App& command, UncertainOptions& options,
                                  const std::string& note) {
    return command.add_option("--uncertain", options.texts, uncertain_text + note)
        ->allow_extra_args(false)
        ->group(heading::known);
}

bool UncertainOptions::assume_site() const {
    return std::ranges::find(texts, "none") == texts.end();
}

std::vector<UncertainParameter> UncertainOptions::given(const CableNet& net,
                                                        const std::string& net_file) const {
    std::vector<UncertainParameter> given;
    for (const std::string& text : texts) {
        if (text != "none") {
            given.push_back(parse_uncertain_parameter(text));
        }
    }
    naming_file(net_file, [&] { check_uncertain_parameters(net, given); });
    return given;
}

std::vector<UncertainParameter> UncertainOptions::assumed(const CableNet& net,
                                                          const std::string& net_file) const {
    std::vector<UncertainParameter> all = given(net, net_file);
    return assume_site() ? with_site_assumptions(net, std::move(all)) : all;
}

}  // namespace taut::app
