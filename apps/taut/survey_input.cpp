// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey_input.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>

#include "command.hpp"
#include "taut/files/file.hpp"
#include "taut/interchange/foreign_survey.hpp"
#include "taut/io/target_offsets_csv.hpp"
#include "taut/net/units.hpp"
#include "taut/survey/registration.hpp"
#include "terminal.hpp"

namespace taut::app {

namespace {

/// What a survey file tells by itself, mostly.
void add_file_options(CLI::App& command, SurveyOptions& options, std::vector<CLI::Option*>& added) {
    const auto add = [&](const char* name, std::string& value, const char* what) {
        added.push_back(command.add_option(name, value, what));
        return added.back();
    };
    add("--format", options.format, "Format of the survey (default: by its content)")
        ->check(CLI::IsMember({"table", "xyz", "pts", "gsi", "landxml", "jobxml", "gama", "dxf"}));
    add("--unit", options.unit,
        "Unit of the survey's coordinates (default: as it tells; else by the net's extent)")
        ->check(CLI::IsMember({"m", "mm", "cm", "ft", "us-ft", "in"}));
    add("--columns", options.columns,
        "Columns of a survey that is a table, id,x,y,z,sx,sy,sz in their order, - for one to leave "
        "out (default: by its header)");
    add("--separator", options.separator, "Between the columns of a table (default: found)")
        ->check(CLI::IsMember({"comma", "semicolon", "tab", "blank"}));
    add("--decimal", options.decimal, "Decimal sign of a table (default: found)")
        ->check(CLI::IsMember({"point", "comma"}));
    add("--encoding", options.encoding, "Encoding of the survey's text (default: found)")
        ->check(CLI::IsMember({"utf-8", "utf-16", "latin-1"}));
    add("--match", options.match,
        "Points to nodes by name, by place, or auto: by name where that is a node's, else by place")
        ->check(CLI::IsMember({"auto", "name", "place"}))
        ->capture_default_str();
    add("--angle", options.angle,
        "Standard deviation of each direction and zenith angle of a file of readings, \"0.3mgon\", "
        "where it tells none; where it tells no unit of its angles these are in gon, then, or in "
        "degrees with arcsec or deg, radians with mrad or rad");
    add("--range", options.range,
        "The same of each distance, \"1mm+1.5ppm\" (default of both: those of a common total "
        "station)");
    add("--offset", options.offset,
        "How far targets stand off the axis of the cable along the net's normal, up (-3mm: down), "
        "and how sure that is of each: \"3mm:0.2mm\"");
    add("--offsets", options.offsets,
        "Table of offsets by a target's name or code: target,offset[,std], lengths as of --offset; "
        "--offset is then that of all others");
    add("--names", options.names, "Table to write of which point is on which node (CSV)");
}

SurveyFileOptions told_of_file(const SurveyOptions& options) {
    SurveyFileOptions told;
    if (!options.separator.empty()) {
        told.separator = parse_separator(options.separator);
    }
    if (!options.format.empty()) {
        told.format = parse_survey_format(options.format);
    }
    if (!options.columns.empty()) {
        told.columns = parse_survey_columns(options.columns);
    }
    if (!options.decimal.empty()) {
        told.decimal = parse_decimal_sign(options.decimal);
    }
    if (!options.encoding.empty()) {
        told.encoding = parse_text_encoding(options.encoding);
    }
    return told;
}

TargetOffsets told_offsets(const SurveyOptions& options) {
    TargetOffsets offsets;
    if (!options.offsets.empty()) {
        offsets.of = parse_target_offsets(read_file(options.offsets), options.offsets);
    }
    if (!options.offset.empty()) {
        offsets.all = parse_target_offset(options.offset);
    }
    return offsets;
}

}  // namespace

double parse_noise(const std::string& text) {
    const double noise_std = text.empty() ? 0.0 : parse_length(text);
    if (noise_std < 0.0) {
        throw std::invalid_argument(
            fmt::format("--noise is '{}', expected a standard deviation of at least 0", text));
    }
    return noise_std;
}

AngleText parse_angle_std(const std::string& text) {
    const AngleText angle = parse_angle(text);
    if (!(angle.angle > 0.0)) {
        throw std::invalid_argument(
            fmt::format("--angle is '{}', expected a standard deviation above 0", text));
    }
    return angle;
}

std::vector<CLI::Option*> add_survey_options(CLI::App& command, SurveyOptions& options) {
    CLI::Option* const noise =
        command.add_option("--noise", options.noise,
                           "Standard deviation of each surveyed coordinate, \"0.5mm\", where the "
                           "file tells none (default: that of its last digit); identify takes "
                           "estimate, too: its scale is "
                           "then found from the survey");
    CLI::Option* const frame =
        command
            .add_option(
                "--frame", options.frame,
                "Frame of the survey: net (the net's, known), supports (fit a rigid motion to the "
                "supports it names), auto (the net's if its supports agree, else fit). "
                "But for net, what is left of its motion is found with the lengths")
            ->check(CLI::IsMember({"auto", "net", "supports"}))
            ->capture_default_str();
    CLI::Option* const control =
        command.add_option("--control", options.control,
                           "Control points id,x,y,z in the net's frame, to fit the survey's frame "
                           "to instead of the supports");
    std::vector<CLI::Option*> added{noise, frame, control};
    add_file_options(command, options, added);
    return added;
}

ReadSurveyOptions SurveyOptions::reading() const {
    constexpr double first_guess = 0.001;
    ReadSurveyOptions options{.noise_std = noise.empty() ? std::nullopt
                                           : noise == estimated_noise
                                               ? std::optional(first_guess)
                                               : std::optional(parse_noise(noise)),
                              .frame = frame == "net"        ? SurveyFrame::net
                                       : frame == "supports" ? SurveyFrame::supports
                                                             : SurveyFrame::automatic,
                              .control = control,
                              .file = told_of_file(*this),
                              .unit = unit.empty() ? std::nullopt : length_of_unit(unit),
                              .matching = match == "name"    ? PointMatching::name
                                          : match == "place" ? PointMatching::place
                                                             : PointMatching::automatic,
                              .offsets = told_offsets(*this)};
    if (!angle.empty()) {
        const AngleText told = parse_angle_std(angle);
        options.angle_std = told.angle;
        options.file.angle_unit = told.full_unit;
        options.file.takes_readings = true;
    }
    if (!range.empty()) {
        options.distance = parse_distance_precision(range);
        options.file.takes_readings = true;
    }
    return options;
}

void tell_of_survey(const SurveyOptions& options, const Survey& survey, bool with_notes) {
    warn(options.survey, survey.warnings);
    for (const std::string& note : with_notes ? survey.notes : std::vector<std::string>()) {
        tell("note", fmt::format("{}: {}", options.survey, note));
    }
}

std::string survey_text(const CableNet& net, const SurveyOptions& options, const Survey& survey) {
    std::string text = fmt::format("survey {}: {} free nodes, {} not surveyed, noise {:.4g} mm\n",
                                   options.survey, survey.surveyed.size(), survey.missing.size(),
                                   1e3 * survey.largest_noise_std());
    for (const std::string& note : survey.notes) {
        text += fmt::format("  {}\n", note);
    }
    if (!options.noise.empty() && options.noise != estimated_noise) {
        const double told = parse_noise(options.noise);
        const double rounded = std::hypot(told, survey.rounding_std);
        const auto other = std::ranges::count_if(survey.surveyed, [&](int node) {
            const auto noise = survey.noise_std.col(node).array();
            return (noise != told && noise != rounded).any();
        });
        if (survey.tells_noise && other > 0) {
            text += fmt::format("  not --noise {}: the file tells the noise of {} of these\n",
                                options.noise, other);
        }
    }
    if (survey.frame) {
        std::vector<ControlResidual> worst = survey.frame->residuals;
        text += fmt::format("  moved into the net's frame by {} control points, {:.3g} mm RMS\n",
                            worst.size(), 1e3 * root_mean_square(worst));
        std::ranges::sort(worst, std::greater{},
                          [](const ControlResidual& r) { return r.residual.norm(); });
        constexpr size_t shown = 3;
        for (size_t i = 0; i < std::min(shown, worst.size()); ++i) {
            text += fmt::format("    {:<12}{:>10.3g} mm\n", worst[i].id,
                                1e3 * worst[i].residual.norm());
        }
    }
    if (!survey.unmatched.empty()) {
        text += fmt::format("  {} points are on no node, and left out:\n", survey.unmatched.size());
        for (const UnmatchedPoint& p : survey.unmatched) {
            text += fmt::format(
                "    line {:<6}{} {}: {:.4g} mm from node {}{}\n", p.point.line,
                p.point.label.empty() ? "" : fmt::format(" '{}'", p.point.label),
                to_string(p.reason), 1e3 * p.distance, net.node_id(p.nearest),
                p.swapped_with < 0 ? ""
                                   : fmt::format(", swapped with {}", net.node_id(p.swapped_with)));
        }
    }
    return text;
}

}  // namespace taut::app
