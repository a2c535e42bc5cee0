// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "command.hpp"
#include "force_input.hpp"
#include "memory_limit.hpp"
#include "memory_needs.hpp"
#include "net_summary.hpp"
#include "progress_line.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/io/net_json.hpp"
#include "taut/process_group.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/statics/plausibility.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

using Clock = std::chrono::steady_clock;

/// A killed run loses at most the longest interval, and at most about half of its samples.
constexpr std::chrono::seconds first_checkpoint_interval{1};
constexpr std::chrono::seconds longest_checkpoint_interval{30};

struct SampleOptions : CommonOptions {
    std::string net;
    std::string output;
    LengthPrior prior;
    UncertainOptions uncertain;
    std::uint64_t seed = 1;
    int count = 0;
    bool resume = false;

    /// Where finished samples are kept while the data set is not complete: a data set of its own.
    [[nodiscard]] std::string partial() const { return output + ".partial"; }
};

/// The samples of an earlier run, from the larger of its finished and its unfinished data set.
std::optional<DataSet> earlier_samples(const SampleOptions& options, const DataSet& wanted) {
    std::optional<DataSet> found;
    for (const std::string& file : {options.output, options.partial()}) {
        if (!std::filesystem::exists(file)) {
            continue;
        }
        auto [data, net, has_digest] = read_data_set(file);
        note_digest(file, has_digest);
        const auto require = [&](bool same, std::string_view what, const std::string& has,
                                 const std::string& asked) {
            if (!same) {
                throw InputError(
                    file, "",
                    fmt::format("was made with {} {}, expected {} to resume", what, has, asked));
            }
        };
        require(data.net_fingerprint == wanted.net_fingerprint, "net", data.net_fingerprint,
                wanted.net_fingerprint);
        require(data.prior == wanted.prior, "prior", to_string(data.prior),
                to_string(wanted.prior));
        require(data.uncertain == wanted.uncertain, "uncertain parameters",
                to_string(data.uncertain), to_string(wanted.uncertain));
        require(data.seed == wanted.seed, "seed", std::to_string(data.seed),
                std::to_string(wanted.seed));
        if (data.size() > options.count) {
            throw InputError(file, "",
                             fmt::format("holds {} samples, more than the {} asked for",
                                         data.size(), options.count));
        }
        if (!found || data.size() > found->size()) {
            found = std::move(data);
        }
    }
    return found;
}

/// Draws until the data set is complete; keeps what is done from time to time, and when
/// interrupted.
void draw(const SampleOptions& options, const NetFile& net, const Sampler& sampler, DataSet& data) {
    ProgressLine line(options.quiet);
    const auto keep = [&] { write_data_set(options.partial(), data, net); };
    auto last_kept = Clock::now();
    auto interval = first_checkpoint_interval;
    try {
        const auto keep_now_and_then = [&] {
            if (Clock::now() - last_kept > interval) {
                keep();
                last_kept = Clock::now();
                interval = std::min(2 * interval, longest_checkpoint_interval);
            }
        };
        sampler.extend_to(data, options.count, line.progress(), keep_now_and_then);
    } catch (const PeerFailed& failure) {
        if (data.size() > 0) {
            try {
                keep();
            } catch (const OutputError& error) {
                throw PeerFailed(fmt::format("{}; the finished samples could not be kept: {}",
                                             failure.what(), error.what()));
            }
        }
        throw;
    } catch (const Interrupted&) {
        if (data.size() == 0) {
            throw;
        }
        keep();
        throw SampleInterrupted(
            fmt::format("interrupted: {} of {} samples are kept in {}; continue with the same "
                        "command and --resume",
                        data.size(), options.count, options.partial()));
    }
}

void print_outcome(const SampleOptions& options, const CableNet& net, const DataSet& data,
                   int resumed_from, const std::vector<std::string>& warnings) {
    if (options.json) {
        nlohmann::ordered_json uncertain = nlohmann::ordered_json::array();
        for (const UncertainParameter& parameter : data.uncertain) {
            uncertain.push_back(to_string(parameter));
        }
        const nlohmann::ordered_json document{{"format", "taut-sampling"},
                                              {"version", 1},
                                              {"net", counts_json(net)},
                                              {"prior", to_string(data.prior)},
                                              {"seed", data.seed},
                                              {"uncertain", uncertain},
                                              {"samples", data.size()},
                                              {"resumed_from", resumed_from},
                                              {"with_slack", data.with_slack()},
                                              {"not_converged", data.not_converged()},
                                              {"warnings", warnings},
                                              {"output", options.output}};
        say("{}\n", to_text(document));
        return;
    }
    say("{}\n{} samples ({}, seed {}): {} with slack edges, {} not converged\n", counts_text(net),
        data.size(), to_string(data.prior), data.seed, data.with_slack(), data.not_converged());
    if (!data.uncertain.empty()) {
        say("sampled besides the lengths: {}\n", to_string(data.uncertain));
    }
    if (resumed_from > 0) {
        say("resumed from {} earlier samples\n", resumed_from);
    }
    say("written to {}\n", options.output);
}

void run(const SampleOptions& options) {
    const NetFile net = read_net(options.net);
    const Sampler sampler(net.net, options.prior, options.seed,
                          options.uncertain.given(net.net, options.net));
    DataSet data = sampler.no_samples();
    if (!process_group().is_first()) {
        draw(options, net, sampler, data);
        return;
    }
    require_memory(sampling_memory(net.net, options.count),
                   fmt::format("{} samples", options.count));
    if (options.resume) {
        if (auto earlier = earlier_samples(options, data)) {
            data = std::move(*earlier);
        }
    }
    if (!options.resume && std::filesystem::exists(options.partial())) {
        throw InputError(
            options.partial(), "",
            "holds the samples of an interrupted run; continue with --resume, or delete it");
    }
    const int resumed_from = data.size();
    check_outputs({options.output}, {options.net});
    note_left_files(options.partial());
    const std::vector<std::string> warnings = unit_warnings(net.net);
    warn(options.net, warnings);
    draw(options, net, sampler, data);
    write_data_set(options.output, data, net);
    // The output now holds its samples.
    std::error_code error;
    if (std::filesystem::remove(options.partial(), error); error) {
        warn(options.partial(), {"is no longer needed, but cannot be removed: " + error.message()});
    }
    print_outcome(options, net.net, data, resumed_from, warnings);
}

}  // namespace

void add_sample(CLI::App& program) {
    auto options = std::make_shared<SampleOptions>();
    CLI::App& command = add_command(
        program, "sample", "Sample random lengths and compute their forms (Algorithm 2)",
        "  taut sample net.json -n 1000 --prior uniform:5mm -o data.h5\n"
        "\nAn interrupted run keeps its samples in data.h5.partial. The same command with --resume "
        "continues\nfrom there, or from a smaller data.h5, and writes the same bytes as one run.",
        *options);
    command.add_option("NET", options->net, "Net file")->required();
    command.add_option("-n,--samples", options->count, "Number of samples")
        ->required()
        ->check(CLI::Range(1, 10'000'000));
    add_parsed(command, "--prior", options->prior, parse_length_prior,
               "Prior of the length deviations: uniform:5mm (within +-5 mm), normal:2mm (standard "
               "deviation), bimodal:5mm (near +-5 mm)",
               "uniform:5mm");
    add_uncertain_option(command, options->uncertain);
    add_seed_option(command, options->seed);
    add_output_option(command, options->output, "Data set to write (HDF5)");
    command.add_flag("--resume", options->resume, "Continue an earlier data set");
    set_action(command, options, run);
}

}  // namespace taut::app
