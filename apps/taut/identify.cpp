// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "command.hpp"
#include "interruption.hpp"
#include "net_summary.hpp"
#include "progress.hpp"
#include "taut/identification/identification.hpp"
#include "taut/io/file.hpp"
#include "taut/io/input_error.hpp"
#include "taut/io/model_h5.hpp"
#include "taut/io/net_json.hpp"
#include "taut/io/results_json.hpp"
#include "taut/io/survey_csv.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/study/study.hpp"
#include "training.hpp"

namespace taut::app {
namespace {

/// Samples to train on where no model is given.
constexpr int default_samples = 1000;

struct Options : CommonOptions {
    std::string net;
    std::string survey;
    std::string method = "gp";
    std::string model;
    std::string law = "uniform:5mm";
    bool law_given = false;
    std::string output;
};

Survey read_survey(const CableNet& net, const std::string& file) {
    try {
        return match_by_name(net, read_survey_points(file));
    } catch (const SurveyError& error) {
        throw InputError(file, error.line() > 0 ? std::to_string(error.line()) : "", error.what());
    }
}

LengthModel stored_model(const Options& options, const CableNet& net) {
    LengthModel model = read_model(options.model).model;
    if (model.net_fingerprint != net.fingerprint()) {
        throw InputError(options.model, "",
                         fmt::format("was trained for the net {}, expected {}, that of {}",
                                     model.net_fingerprint, net.fingerprint(), options.net));
    }
    if (options.law_given && model.law != parse_length_law(options.law)) {
        throw InputError(options.model, "",
                         fmt::format("was trained for the law {}, expected {}",
                                     model.law.to_string(), options.law));
    }
    return model;
}

/// Where no model is given: one is trained for the net and the law, and forgotten.
LengthModel trained_model(const Options& options, const CableNet& net) {
    const std::stop_token stop = Interruption::stop_token();
    const Sampler sampler(net, parse_length_law(options.law), 1);
    DataSet data = sampler.empty();
    {
        Progress progress(options.quiet);
        constexpr int block = 50;
        while (data.size() < default_samples) {
            progress.show("sampling", data.size(), default_samples);
            if (!sampler.extend(data, data.size() + block, stop)) {
                throw Interrupted();
            }
        }
    }
    return train_with_progress(data, data.converged_in(0, data.size()), options.quiet);
}

int count(const Identification& result, EdgeStatus status) {
    return static_cast<int>(std::ranges::count(result.edges, status, &IdentifiedEdge::status));
}

void print(const Options& options, const CableNet& net, const LengthModel& model,
           const Survey& survey, const Identification& result) {
    fmt::print("{}\nsurvey {}: {} free nodes\n", counts_text(net), options.survey,
               survey.surveyed.size());
    fmt::print("method gp: Gaussian processes trained on {} samples of {}{}\n\n",
               model.training_count(), model.law.to_string(),
               options.model.empty() ? " (no --model was given, so they were drawn now)" : "");
    fmt::print("edges: {} identified, {} slack, {} unobserved\n",
               count(result, EdgeStatus::identified), count(result, EdgeStatus::slack),
               count(result, EdgeStatus::unobserved));
    fmt::print("predicted form: {}\n", equilibrium_text(result.predicted));
    fmt::print("  distance from the surveyed form: {:.3g} mm RMS, {:.3g} mm at most\n\n",
               1e3 * std::sqrt(result.residuals.squaredNorm() /
                               static_cast<double>(result.residuals.size())),
               1e3 * result.residuals.maxCoeff());
    fmt::print("largest length deviations [mm]\n  {:<12}{:>12}{:>10}{:>22}  status\n", "edge",
               "deviation", "std", "95 % interval");
    std::vector<IdentifiedEdge> edges = result.edges;
    std::ranges::sort(edges, std::greater{},
                      [](const IdentifiedEdge& e) { return std::abs(e.length_deviation); });
    constexpr size_t shown = 8;
    for (size_t i = 0; i < std::min(shown, edges.size()); ++i) {
        const IdentifiedEdge& e = edges[i];
        fmt::print("  {:<12}{:>12.3f}{:>10.3f}{:>11.3f} {:>10.3f}  {}\n", net.edge_id(e.edge),
                   1e3 * e.length_deviation, 1e3 * e.std, 1e3 * e.lower, 1e3 * e.upper,
                   to_string(e.status));
    }
    if (!options.output.empty()) {
        fmt::print("\nwritten to {}: all {} edges, and the predicted form\n", options.output,
                   edges.size());
    }
}

void run(const Options& options) {
    const auto threads = options.limit_threads();
    const CableNet net = read_net(options.net).net;
    const Survey survey = read_survey(net, options.survey);
    if (!survey.missing.empty()) {
        throw InputError(options.survey, "",
                         fmt::format("holds {} of {} free nodes, expected all for --method gp: node "
                                     "'{}' is the first missing",
                                     survey.surveyed.size(), net.free_node_count(),
                                     net.node_id(survey.missing.front())));
    }
    if (!options.output.empty()) {
        AtomicFile{options.output};  // fails here, not after the work, where it cannot be written
    }
    const LengthModel model =
        options.model.empty() ? trained_model(options, net) : stored_model(options, net);
    const Identification result = identify_by_processes(net, model, survey);
    const std::string document = identification_to_json(net, survey, result);
    if (!options.output.empty()) {
        write_file(options.output, document);
    }
    if (options.json) {
        fmt::print("{}", document);
    } else {
        print(options, net, model, survey, result);
    }
}

}  // namespace

void add_identify(CLI::App& program) {
    auto options = std::make_shared<Options>();
    CLI::App& command = add_command(
        program, "identify", "Tell each edge's unstressed length from one survey of the form",
        "  taut identify net.json survey.csv --model model.h5 -o result.json", *options);
    command.add_option("NET", options->net, "Net file")->required();
    command.add_option("SURVEY", options->survey, "Surveyed nodes: id,x,y,z in m")->required();
    command.add_option("--method", options->method, "How to identify: gp (Gaussian processes)")
        ->check(CLI::IsMember({"gp"}))
        ->capture_default_str();
    command.add_option("--model", options->model,
                       "Model of taut train (default: trained now, on 1000 samples)");
    command
        .add_option_function<std::string>(
            "--law",
            [options](const std::string& law) {
                options->law = law;
                options->law_given = true;
            },
            "Law of the length deviations (default: the model's, or uniform:5mm)");
    command.add_option("-o,--output", options->output, "Result to write (JSON)");
    command.callback([options] { run(*options); });
}

}  // namespace taut::app
