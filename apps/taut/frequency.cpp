// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fast_float/fast_float.h>
#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "command.hpp"
#include "taut/files/file.hpp"
#include "taut/files/table_file.hpp"
#include "taut/io/net_json.hpp"
#include "taut/io/record_csv.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct FrequencyOptions : CommonOptions {
    std::string record;
    std::string edge;
    std::string net;
    std::string output;
    std::optional<double> rate;
    std::optional<FrequencyRange> range;
};

/// "200Hz", "200 Hz" or "200" [Hz].
std::optional<double> frequency_in(std::string_view text) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = fast_float::from_chars(text.data(), end, value);
    const std::string_view unit(rest, static_cast<size_t>(end - rest));
    const bool is_frequency = error == std::errc() && std::isfinite(value) && value > 0.0 &&
                              (unit.empty() || unit == "Hz" || unit == " Hz");
    return is_frequency ? std::optional(value) : std::nullopt;
}

double parse_rate(const std::string& text) {
    const auto rate = frequency_in(text);
    if (!rate) {
        throw std::invalid_argument(
            fmt::format("--rate is '{}', expected a frequency such as 200Hz", text));
    }
    return *rate;
}

FrequencyRange parse_frequency_range(const std::string& text) {
    const size_t dots = text.find("..");
    const auto lowest = frequency_in(text.substr(0, dots));
    const auto highest =
        dots == std::string::npos ? std::nullopt : frequency_in(text.substr(dots + 2));
    if (!lowest || !highest || !(*lowest < *highest)) {
        throw std::invalid_argument(
            fmt::format("--range is '{}', expected two frequencies, such as 2Hz..30Hz", text));
    }
    return {.lowest = *lowest, .highest = *highest};
}

nlohmann::ordered_json to_json(const Fundamental& of) {
    return {{"frequency", of.frequency},
            {"std", of.std_dev},
            {"inharmonicity", of.inharmonicity},
            {"misfit", of.misfit},
            {"probability", of.probability}};
}

nlohmann::ordered_json to_json(const FrequencyOptions& options, const VibrationRecord& record,
                               const CableFrequency& found) {
    nlohmann::ordered_json peaks = nlohmann::ordered_json::array();
    for (const FrequencyPeak& peak : found.peaks) {
        peaks.push_back({{"frequency", peak.frequency},
                         {"std", peak.std_dev},
                         {"level", peak.level},
                         {"mode", peak.mode}});
    }
    nlohmann::ordered_json candidates = nlohmann::ordered_json::array();
    for (const Fundamental& one : found.candidates) {
        candidates.push_back(to_json(one));
    }
    return {
        {"format", "taut-frequency"},
        {"version", 1},
        {"record", options.record},
        {"edge", options.edge},
        {"rate", record.rate},
        {"jitter", record.jitter},
        {"duration", found.duration},
        {"resolution", found.resolution},
        {"searched", {found.searched.lowest, found.searched.highest}},
        {"fundamental", found.fundamental ? to_json(*found.fundamental) : nlohmann::ordered_json()},
        {"message", found.message},
        {"peaks", peaks},
        {"candidates", candidates},
        {"warnings", found.warnings},
        {"output", found.fundamental ? options.output : ""}};
}

void print(const FrequencyOptions& options, const VibrationRecord& record,
           const CableFrequency& found) {
    say("record {}: {:.4g} s, {} column{} at {:.4g} Hz{}\n", options.record, found.duration,
        record.signals.cols(), record.signals.cols() == 1 ? "" : "s", record.rate,
        record.is_resampled
            ? fmt::format(" (steps vary by {:.1f} %, interpolated)", 100.0 * record.jitter)
            : "");
    say("  searched from {:.3g} Hz to {:.4g} Hz, resolution {:.3g} Hz\n\n", found.searched.lowest,
        found.searched.highest, found.resolution);
    say("  {:<16}{:>15}{:>10}{:>19}\n", "mode", "frequency [Hz]", "std [Hz]", "above noise [dB]");
    for (const FrequencyPeak& peak : found.peaks) {
        say("  {:<16}{:>15.4f}{:>10.4f}{:>19.0f}\n",
            peak.mode > 0 ? std::to_string(peak.mode) : "not explained", peak.frequency,
            peak.std_dev, 10.0 * std::log10(peak.level));
    }
    for (const Fundamental& one : found.candidates) {
        constexpr double least_shown = 0.01;
        const auto count = std::ranges::count_if(one.modes, [](int mode) { return mode > 0; });
        if (&one == &found.candidates.front() || one.probability >= least_shown) {
            say("{}fundamental {:.4f} Hz, std {:.4f} Hz: probability {:.0f} %, explains {} of {} "
                "peaks, misfit {:.2g} % RMS, B {:.2g}\n",
                &one == &found.candidates.front() ? "\n" : "  or ", one.frequency, one.std_dev,
                100.0 * one.probability, count, one.modes.size(), 100.0 * one.misfit,
                one.inharmonicity);
        }
    }
    if (found.fundamental && !options.output.empty()) {
        say("written to {}\n", options.output);
    }
}

void run(const FrequencyOptions& options) {
    if (!options.net.empty() && read_net(options.net).net.find_edge(options.edge) < 0) {
        throw InputError(options.net, "", fmt::format("has no edge '{}'", options.edge));
    }
    const VibrationRecord record =
        parse_vibration_record(read_table(options.record), options.record, options.rate);
    check_outputs({options.output}, {options.record, options.net});
    const CableFrequency found =
        naming_file(options.record, [&] { return cable_frequency(record, options.range); });
    if (found.fundamental && !options.output.empty()) {
        write_file(options.output, frequency_to_csv(options.edge, *found.fundamental));
    }
    warn(options.record, found.warnings);
    if (options.json) {
        say("{}\n", to_text(to_json(options, record, found)));
    } else {
        print(options, record, found);
    }
    if (!found.fundamental) {
        throw NumericalFailure(fmt::format(
            "{}: {}{}", options.record, found.message,
            found.needs_range ? ". If you know where it lies, give --range LOW..HIGH" : ""));
    }
}

}  // namespace

void add_frequency(CLI::App& program) {
    auto options = std::make_shared<FrequencyOptions>();
    CLI::App& command = add_command(
        program, "frequency", "Find the natural frequency of a cable in a vibration record",
        "  taut frequency record.csv --edge 12 -o frequencies.csv\n"
        "  taut frequency record.csv --edge 12 --range 4Hz..6Hz -o frequencies.csv",
        *options);
    command
        .add_option("RECORD", options->record,
                    "Record of a sensor on the cable: a table of times [s] and accelerations, as "
                    "apps of phones write it")
        ->required();
    CLI::Option* const edge =
        command.add_option("--edge", options->edge, "The cable: its name in the net, or its index");
    command
        .add_option("-o,--output", options->output,
                    "File for taut identify --frequencies to write: edge,frequency,mode,std")
        ->needs(edge);
    add_parsed(command, "--range", options->range, parse_frequency_range,
               "Where the fundamental is known to lie, such as 2Hz..30Hz (default: anywhere)");
    add_parsed(command, "--rate", options->rate, parse_rate,
               "Samples in a second, where RECORD has no times")
        ->group(heading::input);
    command.add_option("--net", options->net, "Net file that must have the edge")
        ->needs(edge)
        ->group(heading::input);
    set_action(command, options, run);
}

}  // namespace taut::app
