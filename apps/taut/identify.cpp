// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "command.hpp"
#include "epoch_input.hpp"
#include "force_input.hpp"
#include "identification_text.hpp"
#include "progress_line.hpp"
#include "run_record.hpp"
#include "survey_input.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/identification/identify.hpp"
#include "taut/identification/model.hpp"
#include "taut/io/adjustment_csv.hpp"
#include "taut/io/model_h5.hpp"
#include "taut/io/net_json.hpp"
#include "taut/results/draws_h5.hpp"
#include "taut/results/results_json.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct Options : CommonOptions, SurveyOptions, ForceOptions {
    IdentifyOptions settings;  ///< but for what files hold
    std::string net;
    std::string model;
    std::string prior;  ///< empty: the model's, or a broad one
    std::string output;
    std::string covariance_of;
    UncertainOptions uncertain;
    std::vector<EpochFiles> epochs;     ///< of later surveys
    std::optional<std::int64_t> draws;  ///< empty: default_draws()

    /// The file of the posterior samples, beside the result.
    [[nodiscard]] std::string draws_file() const {
        return output.empty() ? "" : draws_path(output).string();
    }
    [[nodiscard]] std::vector<std::string> inputs() const {
        std::vector<std::string> all = ForceOptions::files();
        all.insert(all.end(), {net, survey, model, control, offsets, covariance_of});
        for (const EpochFiles& files : epochs) {
            all.insert(all.end(), {files.survey, files.turned, files.loads});
        }
        return all;
    }
};

/// The edges of --covariance-of.
std::vector<int> covariance_edges(const CableNet& net, const Options& options) {
    const std::string& file = options.covariance_of;
    if (file.empty()) {
        return {};
    }
    if (options.output.empty() && !options.json) {
        throw std::invalid_argument(
            "--covariance-of is for the result only, which needs -o or --json");
    }
    std::vector<int> edges = read_edge_list(net, file);
    for (const int edge : edges) {
        if (!std::ranges::binary_search(net.interior_edges(), edge)) {
            throw InputError(file, "",
                             fmt::format("names edge '{}', which is adjustable: only interior "
                                         "edges have covariances",
                                         net.edge_id(edge)));
        }
    }
    return edges;
}

std::optional<LengthModel> model_of(const CableNet& net, const Options& options,
                                    const std::optional<LengthPrior>& prior) {
    if (options.model.empty()) {
        return std::nullopt;
    }
    auto [model, of_net, has_digest] = read_model(options.model);
    note_digest(options.model, has_digest);
    naming_file(options.model, [&] { check_model(net, model, prior); });
    return model;
}

void print_written(const Options& options, const Identification& result) {
    if (options.output.empty()) {
        return;
    }
    say("\nwritten to {}: all {} edges and the predicted form\n", options.output,
        result.edges.size());
    if (result.draws) {
        say("written to {}: {} posterior samples of lengths, forms and tensions\n",
            options.draws_file(), result.draws->count());
    }
}

/// @throws InputError where the survey is not what it was taken for
/// @throws NumericalFailure for any other result that did not converge
void refuse_unless_converged(const Options& options, const Identification& result) {
    switch (result.status) {
        case IdentificationStatus::converged:
            return;
        case IdentificationStatus::survey_not_exact:
            throw InputError(options.survey, "",
                             result.message + ": give it by --noise, or by sx, sy, sz in the file");
        case IdentificationStatus::iteration_limit:
        case IdentificationStatus::survey_does_not_fit:
        case IdentificationStatus::no_equilibrium:
            break;
    }
    std::vector<std::string> surveys{options.survey};
    for (const EpochFiles& files : options.epochs) {
        surveys.push_back(files.survey);
    }
    throw NumericalFailure(
        fmt::format("{}: method {}: {}", fmt::join(surveys, ", "), result.method, result.message));
}

Identification identified_epochs(const CableNet& net, const std::vector<Epoch>& epochs,
                                 const IdentifyOptions& settings, const Options& options,
                                 const Progress& progress) {
    try {
        return identify_epochs(net, epochs, settings, progress);
    } catch (const EpochError& error) {
        const size_t k = error.epoch();
        throw InputError(k == 0 ? options.survey : options.epochs[k - 1].survey, "", error.what());
    }
}

void run(const Options& options) {
    const CableNet net = read_net(options.net).net;
    IdentifyOptions settings = options.settings;
    if (!options.prior.empty()) {
        settings.prior = prior_for(net, options.prior, options.net);
    }
    Survey survey = read_survey(net, options.survey, options.read_options());
    print_survey_notes(options, survey, options.json);
    const std::optional<LengthModel> model = model_of(net, options, settings.prior);
    settings.model = model ? &*model : nullptr;
    settings.forces = read_forces(net, options, survey);
    settings.uncertain = options.uncertain.given(net, options.net);
    settings.assume_site = options.uncertain.assume_site();
    if (options.draws) {
        check_draws(net, *options.draws);
        settings.draws = static_cast<int>(*options.draws);
    }
    settings.estimate_noise = options.noise == estimated_noise;
    std::vector<Epoch> epochs = read_epochs(net, survey, options.epochs, options, options.json);
    check_outputs({options.output, options.draws != 0 ? options.draws_file() : "", options.names},
                  options.inputs());
    settings.covariance_of = covariance_edges(net, options);
    ProgressLine line(options.quiet);
    const Identification result =
        epochs.size() > 1 ? identified_epochs(net, epochs, settings, options, line.progress())
                          : with_survey_of(options.survey, [&] {
                                return identify(net, survey, settings, line.progress());
                            });
    const size_t reported = reported_epoch(epochs);
    survey = with_noise_times(std::move(epochs[reported].survey), result.noise_scale);
    refuse_unless_converged(options, result);
    const std::string document = identification_to_json(net, survey, result, run_record());
    std::vector<std::pair<std::filesystem::path, std::string>> files;
    if (!options.output.empty()) {
        if (result.draws) {
            if (keeps_draws()) {
                files.emplace_back(options.draws_file(), draws_bytes(net, result));
            } else {
                print_message(
                    "note",
                    "the posterior samples are not kept, as this taut was built without HDF5");
            }
        }
        files.emplace_back(options.output, document);
    }
    if (!options.names.empty()) {
        files.emplace_back(options.names, survey_names_csv(net, survey));
    }
    write_files(files);
    if (options.json) {
        say("{}", document);
    } else {
        SurveyOptions of_last = options;
        of_last.survey = reported == 0 ? options.survey : options.epochs[reported - 1].survey;
        print_identification(net, of_last, survey, result);
        print_written(options, result);
    }
}

}  // namespace

void add_identify(CLI::App& program) {
    auto options = std::make_shared<Options>();
    CLI::App& command = add_command(
        program, "identify", "Estimate each edge's unstressed length from one survey of the form",
        "  taut identify net.json survey.csv --noise 0.5mm -o result.json\n"
        "  taut identify net.json survey.csv --noise 0.5mm --prior uniform:3mm \\\n"
        "      --uncertain stiffness:3% --forces cells.csv --force-unit kN -o result.json",
        *options);
    command.add_option("NET", options->net, "Net file, as designed")->required();
    command
        .add_option("SURVEY", options->survey,
                    "Surveyed points: [id,]x,y,z[,sx,sy,sz[,rxy,rxz,ryz]] in m, any other table of "
                    "points, PTS, XYZ, Leica GSI, LandXML, Trimble JXL, GNU Gama XML or DXF. "
                    "Targets without a name are matched by their place")
        ->required();
    command.add_option("-o,--output", options->output, "Result to write (JSON)");
    add_survey_options(command, *options);
    command.add_option("--prior", options->prior,
                       "Prior of the length deviations, that is the fabrication tolerance: "
                       "uniform:5mm, normal:2mm, bimodal:5mm (default: the model's, or a broad one "
                       "around uniform:5mm)");
    add_epoch_option(command, options->epochs);
    command
        .add_flag("--prior-exact", options->settings.prior_exact,
                  "Take scale and shape of the prior as exact. Without it the scale is uncertain "
                  "by a factor of 1.5 and estimated with the lengths")
        ->group(heading::known);
    add_force_options(command, *options);
    add_uncertain_option(command, options->uncertain, assumes_site);
    command
        .add_option("--draws", options->draws,
                    "Number of posterior samples of lengths, forms and tensions, for map, kept "
                    "beside the result (_draws.h5). 0: none, and slack edges by the linearised "
                    "fit only (default: 200; 40 for more than 10,000 interior edges and for "
                    "tension laws)")
        ->group(heading::output);
    command
        .add_option("--covariance-of", options->covariance_of,
                    "Interior edges whose length covariances the result holds, for map: a file "
                    "that names them, one a line")
        ->group(heading::output);
    add_parsed(command, "--method", options->settings.method, parse_identification_method,
               "map (maximum a posteriori), balance (force balance) or gp (Gaussian "
               "processes); default: by the survey")
        ->check(CLI::IsMember({"gp", "balance", "map"}))
        ->group(heading::advanced);
    command
        .add_option("--model", options->model,
                    "Model of taut train, for gp (default: trained now, on 1000 samples)")
        ->group(heading::advanced);
    add_seed_option(command, options->settings.seed);
    set_action(command, options, run);
}

}  // namespace taut::app
