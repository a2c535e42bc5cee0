// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "command.hpp"
#include "net_summary.hpp"
#include "progress_line.hpp"
#include "run_record.hpp"
#include "survey_input.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/identification/force_balance.hpp"
#include "taut/identification/identification.hpp"
#include "taut/identification/maximum_a_posteriori.hpp"
#include "taut/identification/model.hpp"
#include "taut/io/model_h5.hpp"
#include "taut/io/net_json.hpp"
#include "taut/io/survey_csv.hpp"
#include "taut/net/units.hpp"
#include "taut/results/results_json.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/statics/tensions.hpp"

namespace taut::app {
namespace {

/// Samples to train on where no model is given.
constexpr int default_samples = 1000;

struct IdentifyOptions : CommonOptions, SurveyOptions {
    std::string net;
    std::string method;  ///< empty: chosen by what is there
    std::string model;
    std::string law = "uniform:5mm";
    bool law_given = false;
    std::string output;
};

struct Choice {
    std::string method;
    std::string reason;
};

/// The method that was asked for, or the one that suits what is there.
Choice choose_method(const IdentifyOptions& options, const CableNet& net, const Survey& survey) {
    const bool has_noise = is_noisy(survey);
    const bool has_hidden = !survey.missing.empty();
    Choice choice{.method = options.method, .reason = "asked for by --method"};
    if (choice.method.empty() && !options.model.empty()) {
        choice = {.method = "gp", .reason = "a model is given"};
    } else if (choice.method.empty() && has_hidden) {
        choice = {.method = "map",
                  .reason = fmt::format("{} free nodes were not surveyed", survey.missing.size())};
    } else if (choice.method.empty() && has_noise) {
        choice = {.method = "map", .reason = "the survey has noise"};
    } else if (choice.method.empty()) {
        choice = {.method = "balance",
                  .reason = "all free nodes were surveyed, and no noise is told"};
    }
    if (has_hidden && (choice.method == "balance" || !has_noise)) {
        const std::string expected =
            choice.method == "balance" ? "all for --method balance" : all_or_their_noise;
        refuse_hidden_nodes(net, survey, options.survey, expected);
    }
    return choice;
}

LengthModel stored_model(const IdentifyOptions& options, const CableNet& net) {
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
LengthModel trained_model(const IdentifyOptions& options, const CableNet& net) {
    ProgressLine line(options.quiet);
    const Progress progress = line.progress();
    const Sampler sampler(net, parse_length_law(options.law), 1);
    const DataSet data = draw_samples(sampler, default_samples, progress);
    return train(net, data, data.converged_in(0, data.size()), {}, progress);
}

/// The identification, and how it came about, in words.
struct Outcome {
    Identification result;
    std::string how;
};

Outcome identify(const IdentifyOptions& options, const CableNet& net, const Survey& survey,
                 const std::string& method) {
    if (method == "gp") {
        const LengthModel model =
            options.model.empty() ? trained_model(options, net) : stored_model(options, net);
        if (model.as_in_paper()) {
            refuse_hidden_nodes(net, survey, options.survey, "all for a model as in the paper");
        }
        return {
            identify_by_processes(net, model, survey),
            fmt::format(
                "Gaussian processes trained on {} samples of {}{}", model.training_count(),
                model.law.to_string(),
                options.model.empty() ? " (no --model was given, so they were drawn now)" : "") +
                (model.as_in_paper() && is_noisy(survey)
                     ? "\n  as in the paper, which takes the survey for exact: its noise is not in "
                       "their intervals"
                     : "")};
    }
    const LengthLaw law = parse_length_law(options.law);
    if (method == "map") {
        return {identify_by_maximum_a_posteriori(net, survey, law),
                fmt::format("maximum a posteriori under the statics, lengths {}", law.to_string())};
    }
    return {identify_by_force_balance(net, survey, law),
            fmt::format("force balance at the surveyed form, lengths {}", law.to_string())};
}

int count(const Identification& result, EdgeStatus status) {
    return static_cast<int>(std::ranges::count(result.edges, status, &IdentifiedEdge::status));
}

void print(const IdentifyOptions& options, const CableNet& net, const Survey& survey,
           const Outcome& outcome) {
    const Identification& result = outcome.result;
    fmt::print("{}\n{}", counts_text(net), survey_text(net, options, survey));
    fmt::print("method {}: {}\n  chosen because: {}\n\n", result.method, outcome.how,
               result.method_reason);
    if (!result.outliers.empty()) {
        fmt::print("gross errors, left out: {} {}\n", result.outliers.size(),
                   result.outliers.size() == 1 ? "target" : "targets");
        for (const Outlier& outlier : result.outliers) {
            fmt::print("  {:<12}{:>12.3f} mm from where all others tell\n",
                       net.node_id(outlier.node), 1e3 * outlier.distance);
        }
    }
    if (result.noise_ratio > 0.0) {
        fmt::print("the survey's residuals are {:.2f} times what its noise lets expect\n",
                   result.noise_ratio);
        constexpr double least = 0.7;
        constexpr double most = 1.3;
        if (result.noise_ratio < least || result.noise_ratio > most) {
            const double told = survey.noise_std(Eigen::all, survey.surveyed).maxCoeff();
            fmt::print(
                "  the noise told seems too {}, and so all standard deviations: {:.2g} mm "
                "would fit\n",
                result.noise_ratio > 1.0 ? "small" : "large", 1e3 * told * result.noise_ratio);
        }
    }
    fmt::print("edges: {} identified, {} slack, {} unobserved\n",
               count(result, EdgeStatus::identified), count(result, EdgeStatus::slack),
               count(result, EdgeStatus::unobserved));
    const auto slack_adjustable = std::ranges::count_if(
        result.predicted.slack_edges,
        [&](int edge) { return std::ranges::binary_search(net.adjustable_edges(), edge); });
    if (slack_adjustable > 0) {
        fmt::print("  besides, {} adjustable edges are slack\n", slack_adjustable);
    }
    fmt::print("predicted form: {}\n", equilibrium_text(result.predicted));
    const Eigen::VectorXd residuals = residuals_in_use(result, survey);
    fmt::print("  distance from the surveyed form: {:.3g} mm RMS, {:.3g} mm at most\n\n",
               1e3 * std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size())),
               1e3 * residuals.maxCoeff());
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

std::string failure_text(const IdentifyOptions& options, const Survey& survey,
                         const Identification& result) {
    if (result.status == IdentificationStatus::survey_does_not_fit) {
        return fmt::format(
            "{}: {} of {} targets contradict the others: are net, frame, law and noise ({}) right?",
            options.survey, result.outliers.size(), survey.surveyed.size(),
            format_length(survey.noise_std(Eigen::all, survey.surveyed).maxCoeff()));
    }
    return fmt::format("{}: method {} found no lengths that settle: {}{}", options.survey,
                       result.method, to_string(result.status),
                       result.method == "gp" ? "" : "; --method gp needs no such search");
}

/// Checks of a law for a net, by the rules of the sampler.
void check_law_of(const CableNet& net, const IdentifyOptions& options) {
    try {
        check_law(net, parse_length_law(options.law));
    } catch (const std::invalid_argument& error) {
        throw InputError(options.net, "", error.what());
    }
}

/// An exact form is met to rounding errors by the lengths that balance it. Where it is not, the
/// intervals would be those of an exact survey around lengths that are not.
void refuse_inexact_form(const IdentifyOptions& options, const CableNet& net, const Survey& survey,
                         const Identification& result) {
    constexpr double rounding = 1e-5;  // of an edge length
    const double miss =
        std::sqrt(result.residuals.squaredNorm() / static_cast<double>(result.residuals.size()));
    if (result.method != "gp" && !is_noisy(survey) &&
        miss > rounding * edge_lengths(net, net.nodes()).mean()) {
        throw InputError(options.survey, "",
                         fmt::format("is taken for exact, but no lengths of the law {} give its "
                                     "form: those found miss it by {:.3g} mm RMS. Tell its noise "
                                     "(--noise, or sx, sy, sz in the file), or another law",
                                     options.law, 1e3 * miss));
    }
}

void run(const IdentifyOptions& options) {
    const auto threads = options.limit_threads();
    const CableNet net = read_net(options.net).net;
    check_law_of(net, options);
    const Survey survey = read_survey(net, options);
    const Choice choice = choose_method(options, net, survey);
    if (!options.model.empty() && choice.method != "gp") {
        throw std::invalid_argument(
            fmt::format("--model is for --method gp, not for {}", choice.method));
    }
    check_outputs({options.output}, {options.net, options.survey, options.model, options.control});
    Outcome outcome = identify(options, net, survey, choice.method);
    outcome.result.method_reason = choice.reason;
    if (outcome.result.status != IdentificationStatus::converged) {
        throw NumericalFailure(failure_text(options, survey, outcome.result));
    }
    refuse_inexact_form(options, net, survey, outcome.result);
    const std::string document = identification_to_json(net, survey, outcome.result, run_record());
    if (!options.output.empty()) {
        write_file(options.output, document);
    }
    if (options.json) {
        fmt::print("{}", document);
    } else {
        print(options, net, survey, outcome);
    }
}

}  // namespace

void add_identify(CLI::App& program) {
    auto options = std::make_shared<IdentifyOptions>();
    CLI::App& command = add_command(
        program, "identify", "Tell each edge's unstressed length from one survey of the form",
        "  taut identify net.json survey.csv --noise 0.5mm -o result.json", *options);
    command.add_option("NET", options->net, "Net file")->required();
    command
        .add_option("SURVEY", options->survey,
                    "Surveyed points in m: [id,]x,y,z[,sx,sy,sz], or PTS. Targets without a name "
                    "are matched by their place")
        ->required();
    add_survey_options(command, *options);
    command
        .add_option("--method", options->method,
                    "gp (Gaussian processes), balance (force balance) or map (maximum a "
                    "posteriori); default: by what is there")
        ->check(CLI::IsMember({"gp", "balance", "map"}));
    command.add_option("--model", options->model,
                       "Model of taut train, for gp (default: trained now, on 1000 samples)");
    command.add_option_function<std::string>(
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
