// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "command.hpp"
#include "force_input.hpp"
#include "net_summary.hpp"
#include "progress_line.hpp"
#include "run_record.hpp"
#include "survey_input.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/files/table_file.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/identification/identify.hpp"
#include "taut/identification/model.hpp"
#include "taut/io/adjustment_csv.hpp"
#include "taut/io/forces_csv.hpp"
#include "taut/io/model_h5.hpp"
#include "taut/io/net_json.hpp"
#include "taut/io/turned_csv.hpp"
#include "taut/results/draws_h5.hpp"
#include "taut/results/results_json.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

/// --epoch, as given.
struct EpochFiles {
    std::string survey;
    std::string turned;  ///< empty: nothing was turned
    std::string loads;   ///< empty: nothing was hung on the net
};

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

int count(const Identification& result, EdgeStatus status) {
    return static_cast<int>(std::ranges::count(result.edges, status, &IdentifiedEdge::status));
}

/// "3.21 kN, 95 % interval 3.02 to 3.41 kN"
std::string tension_text(const DrawnEstimate& tension) {
    return fmt::format("{:.4g} kN, 95 % interval {:.4g} to {:.4g} kN", 1e-3 * tension.mean,
                       1e-3 * tension.lower, 1e-3 * tension.upper);
}

/// Force measurements and edges seen taut or slack, and which of them contradict the survey.
void print_forces(const CableNet& net, const Identification& result) {
    if (result.force_measurements > 0) {
        say("force measurements: {}, of which {} not used\n", result.force_measurements,
            result.force_outliers.size());
    }
    for (const ForceOutlier& outlier : result.force_outliers) {
        say("  {:<12} measured {:.4g} kN, expected {:.4g} kN from everything else\n",
            net.edge_id(outlier.edge), 1e-3 * outlier.measured, 1e-3 * outlier.expected);
    }
    if (result.force_bias) {
        say("  together they contradict the survey, by which tensions are {:.2g} +- {:.2g} times "
            "the measured ones.\n  taut used none of them. Check their unit, their calibration "
            "and the net's stiffness.\n",
            1.0 - result.force_bias->part, result.force_bias->std);
    }
    if (result.contradicted_taut.empty() && result.contradicted_slack.empty()) {
        return;
    }
    say("The edges you marked as slack or taut contradict the survey. taut ignored all marks.\n");
    if (!result.contradicted_taut.empty()) {
        say("  marked taut, slack by the survey: {}\n", edges_text(net, result.contradicted_taut));
    }
    if (!result.contradicted_slack.empty()) {
        say("  marked slack, taut by the survey: {}\n", edges_text(net, result.contradicted_slack));
    }
}

/// A value of an uncertain parameter, in the unit that people use.
std::string in_unit(UncertainParameter::Kind kind, double value) {
    const auto scaled = [value](double scale, int digits) {
        const double unit = std::pow(10.0, digits);
        const double rounded = std::round(scale * value * unit) / unit + 0.0;  // no -0
        return fmt::format("{:+.{}f}", rounded, digits);
    };
    switch (kind) {
        case UncertainParameter::Kind::stiffness:
        case UncertainParameter::Kind::stiffness_each:
        case UncertainParameter::Kind::loads:
        case UncertainParameter::Kind::forces:
        case UncertainParameter::Kind::mass:
        case UncertainParameter::Kind::test_loads:
        case UncertainParameter::Kind::support_stiffness:
            return scaled(100.0, 2) + " %";
        case UncertainParameter::Kind::creep:
            return scaled(100.0, 4) + " %";
        case UncertainParameter::Kind::temperature:
            return scaled(1.0, 1) + " K";
        case UncertainParameter::Kind::supports:
        case UncertainParameter::Kind::adjustable:
            return scaled(1e3, 2) + " mm";
        case UncertainParameter::Kind::loads_each:
            return scaled(1.0, 2) + " N";
    }
    return {};
}

/// Parameters common to many edges in full. Of the others how many the survey determines, and the
/// one that is farthest from the design.
void print_uncertain(const CableNet& net, const Identification& result) {
    for (auto first = result.uncertain.begin(); first != result.uncertain.end();) {
        const auto last = std::find_if(first, result.uncertain.end(), [&](const auto& other) {
            return other.parameter != first->parameter;
        });
        const UncertainParameter& parameter = first->parameter;
        const auto text = [&](double value) { return in_unit(parameter.kind, value); };
        const auto count = std::distance(first, last);
        if (count == 1 && first->edge < 0 && first->node < 0) {
            say("{}: {} from the {}, std {}{}\n", parameter.to_string(), text(first->mean),
                parameter.kind == UncertainParameter::Kind::creep ? "first survey" : "design",
                text(first->std).substr(1),
                first->is_observed() ? "" : " (not shown by the survey)");
        } else {
            const auto shown = std::count_if(
                first, last, [](const ParameterEstimate& one) { return one.is_observed(); });
            const auto farthest = std::max_element(first, last, [](const auto& a, const auto& b) {
                return std::abs(a.mean) < std::abs(b.mean);
            });
            say("{}: the survey determines {} of {}; the farthest from the design is {}{} by {}, "
                "std {}\n",
                parameter.to_string(), shown, count,
                farthest->edge >= 0 ? net.edge_id(farthest->edge) : net.node_id(farthest->node),
                farthest->axis >= 0 ? fmt::format(" ({})", "xyz"[farthest->axis]) : "",
                text(farthest->mean), text(farthest->std).substr(1));
        }
        first = last;
    }
}

/// Parameters that the tensions depend on and that are assumed exact.
std::string exact_parameters(const CableNet& net, const Identification& result) {
    const auto is_uncertain = [&](auto... kinds) {
        return std::ranges::any_of(result.uncertain, [&](const ParameterEstimate& one) {
            return ((one.parameter.kind == kinds) || ...);
        });
    };
    using Kind = UncertainParameter::Kind;
    std::vector<std::string_view> given;
    if (!is_uncertain(Kind::stiffness)) {
        given.emplace_back("stiffness");
    }
    const bool has_own_weight_alone = net.data().loads.isZero(0.0);
    if (!net.loads().isZero(0.0) && !is_uncertain(Kind::loads, Kind::loads_each) &&
        !(has_own_weight_alone && is_uncertain(Kind::mass))) {
        given.emplace_back("loads");
    }
    if (!is_uncertain(Kind::supports)) {
        given.emplace_back("supports");
    }
    if (!net.elastic_supports().empty() && !is_uncertain(Kind::support_stiffness)) {
        given.emplace_back("stiffness of supports");
    }
    return given.empty() ? "" : fmt::format("; {} assumed exact", fmt::join(given, ", "));
}

/// The common part of the length deviations: equation (length-trend) of docs/theory.md.
void print_common_deviation(const CommonDeviation& common) {
    if (!(common.mean_std > 0.0)) {
        return;
    }
    say("mean length deviation: {:+.2f} mm, std {:.2f} mm", 1e3 * common.mean,
        1e3 * common.mean_std);
    if (common.runs > 0) {
        say("; {} runs of cable, scales of {:.2g} % with a probability of {:.0f} %", common.runs,
            1e2 * common.run_std, 1e2 * common.run_probability);
    }
    if (common.struts_std > 0.0) {
        say("; struts by {:+.2f} mm more, std {:.2f} mm", 1e3 * common.struts,
            1e3 * common.struts_std);
    }
    if (common.adjustable_std > 0.0) {
        say("; adjustable edges by {:+.2f} mm, std {:.2f} mm", 1e3 * common.adjustable,
            1e3 * common.adjustable_std);
    }
    say("\n");
}

void print_draws(const CableNet& net, const Identification& result) {
    if (!result.draws) {
        say("tensions: not reported, as there are no posterior samples (--draws)\n");
        return;
    }
    const PosteriorDraws& draws = *result.draws;
    if (result.drawn.tensions.empty()) {
        say("tensions: not reported, since {}\n", draws.reason);
        return;
    }
    say("mean tension: {}\n  from {} posterior samples: {}{}\n",
        tension_text(result.drawn.mean_tension), draws.count(), draws.how,
        exact_parameters(net, result));
}

/// One line for each survey, where there are several.
void print_epochs(const CableNet& net, const Identification& result) {
    for (size_t k = 0; k < result.epochs.size(); ++k) {
        const EpochResult& epoch = result.epochs[k];
        say("survey {}: {} free nodes, {} not used", k + 1, epoch.surveyed, epoch.outliers.size());
        if (k > 0) {
            say("; {} edges turned before it{}. Changes of the other lengths are {:.2f} times "
                "those expected by chance (up to {:.2f} is normal)",
                epoch.turned.size(),
                epoch.load > 0.0 ? fmt::format(", under {:.4g} kN hung on it", 1e-3 * epoch.load)
                                 : "",
                epoch.change_ratio, epoch.change_limit);
        }
        say("\n");
        for (const LengthChange& change : epoch.changes) {
            say("  {:<12} changed by {:+.2f} +- {:.2f} mm\n", net.edge_id(change.edge),
                1e3 * change.change, 1e3 * change.std);
        }
    }
}

/// Slack edges are not among these: only a bound of their deviation is known.
void print_largest(const CableNet& net, const Identification& result) {
    std::vector<IdentifiedEdge> edges = result.edges;
    std::erase_if(edges, [](const IdentifiedEdge& e) { return e.status == EdgeStatus::slack; });
    if (edges.empty()) {
        return;
    }
    std::ranges::sort(edges, std::greater{},
                      [](const IdentifiedEdge& e) { return std::abs(e.length_deviation); });
    const bool has_tensions = !result.drawn.tensions.empty();
    say("largest length deviations [mm]{}\n  {:<12}{:>12}{:>10}{:>22}{}  status\n",
        has_tensions ? ", tensions [kN]" : "", "edge", "deviation", "std", "95 % interval",
        has_tensions ? fmt::format("{:>10}{:>18}", "tension", "95 % interval") : "");
    constexpr size_t shown = 8;
    for (size_t i = 0; i < std::min(shown, edges.size()); ++i) {
        const IdentifiedEdge& e = edges[i];
        std::string tension;
        if (has_tensions) {
            const DrawnEstimate& t = result.drawn.tensions[e.edge].tension;
            tension = fmt::format("{:>10.3f}{:>9.3f} {:>8.3f}", 1e-3 * t.mean, 1e-3 * t.lower,
                                  1e-3 * t.upper);
        }
        say("  {:<12}{:>12.3f}{:>10.3f}{:>11.3f} {:>10.3f}{}  {}\n", net.edge_id(e.edge),
            1e3 * e.length_deviation, 1e3 * e.std, 1e3 * e.lower, 1e3 * e.upper, tension,
            status_text(e.status));
    }
}

void print_slack(const CableNet& net, const Identification& result) {
    std::vector<IdentifiedEdge> edges = result.edges;
    std::erase_if(edges, [](const IdentifiedEdge& e) { return e.status != EdgeStatus::slack; });
    if (edges.empty()) {
        return;
    }
    std::ranges::sort(edges, std::greater{}, &IdentifiedEdge::lower);
    say("slack edges: only a bound of the length deviation is known [mm]\n  {:<12}{:>12}\n", "edge",
        "at least");
    constexpr size_t shown = 8;
    for (size_t i = 0; i < std::min(shown, edges.size()); ++i) {
        say("  {:<12}{:>12.3f}\n", net.edge_id(edges[i].edge), 1e3 * edges[i].lower);
    }
    if (edges.size() > shown) {
        say("  and {} more\n", edges.size() - shown);
    }
}

void print_frame(const Identification& result) {
    if (!result.frame_offset) {
        return;
    }
    const FrameOffset& frame = *result.frame_offset;
    const auto text = [](const Eigen::Vector3d& v, const Eigen::Vector3d& std) {
        return fmt::format("({:.2f}, {:.2f}, {:.2f}) +- ({:.2f}, {:.2f}, {:.2f})", v.x(), v.y(),
                           v.z(), std.x(), std.y(), std.z());
    };
    say("coordinate system of the survey: the supports are moved by {} mm and rotated by {} mrad\n",
        text(1e3 * frame.translation, 1e3 * frame.translation_std),
        text(1e3 * frame.rotation, 1e3 * frame.rotation_std));
}

/// "target 3.1 mm, length 8 mm, ..., support none", of those that the checks can find.
std::string detectable_text(const DetectableErrors& errors) {
    const auto text = [](const char* name, double error, double unit, const char* unit_name) {
        if (!std::isfinite(error)) {
            return fmt::format("{} none", name);
        }
        const double value = error / unit;
        const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
        return fmt::format("{} {:.6g} {}", name, std::round(value / digit) * digit, unit_name);
    };
    const std::string forces = std::isfinite(errors.force_scale)
                                   ? text(", all forces", errors.force_scale, 1e-2, "%")
                                   : "";
    return fmt::format("{}, {}, {}, {}, {}, {}, {}{}", text("target", errors.target, 1e-3, "mm"),
                       text("length", errors.length, 1e-3, "mm"),
                       text("turnbuckle", errors.adjustable, 1e-3, "mm"),
                       text("support", errors.support, 1e-3, "mm"),
                       text("scale", errors.scale, 1e-6, "ppm"),
                       text("temperature", errors.temperature, 1.0, "K"),
                       text("load at each node", errors.load, 1.0, "N"), forces);
}

/// The next step with the option of its remedy: "Use this standard deviation (--noise 0.71mm)."
std::string advice(const Trust::Finding& finding) {
    if (!finding.remedy) {
        return finding.next;
    }
    const auto& [parameter, value] = *finding.remedy;
    return fmt::format("{} (--{}{}{}).", finding.next.substr(0, finding.next.size() - 1), parameter,
                       value.empty() ? "" : " ", value);
}

void print_checks(const Trust& trust, const DetectableErrors& detectable) {
    say("Checks: {}.{}", to_string(trust.verdict()), trust.findings.empty() ? " " : "\n");
    constexpr int shown = 6;
    std::map<std::pair<Trust::Finding::Kind, Trust::Verdict>, int> counts;
    const std::vector<Trust::Finding>& all = trust.findings;
    for (size_t i = 0; i < all.size(); ++i) {
        const int count = ++counts[{all[i].kind, all[i].severity}];
        if (count > shown) {
            continue;
        }
        say("  {}: {}\n",
            all[i].severity == Trust::Verdict::passed ? "note" : to_string(all[i].severity),
            all[i].reason);
        const bool is_repeated =
            count < shown && i + 1 < all.size() && advice(all[i + 1]) == advice(all[i]);
        if (!all[i].next.empty() && !is_repeated) {
            say("    {}\n", advice(all[i]));
        }
    }
    for (const auto& [of, count] : counts) {
        if (count > shown) {
            say("  {} more findings of kind {} are in the result\n", count - shown,
                to_string(of.first));
        }
    }
    say("Smallest error this survey would show (with a probability of 80 %):\n  {}\n\n",
        detectable_text(detectable));
}

/// The uncertain parameters, and how to change them.
void print_assumptions(const Identification& result) {
    if (result.assumptions.empty()) {
        say("uncertain besides lengths: nothing. Stiffness, loads, supports and turnbuckles are "
            "taken as exact\n");
        return;
    }
    std::string text;
    bool has_default = false;
    std::vector<std::string> not_shown;
    for (const Assumption& one : result.assumptions) {
        text += fmt::format("{}{}{}", text.empty() ? "" : ", ", one.parameter.to_string(),
                            one.is_default ? " (assumed)" : "");
        has_default = has_default || one.is_default;
        if (!one.is_testable) {
            not_shown.push_back(one.parameter.to_string());
        }
    }
    say("uncertain besides lengths: {}\n  --uncertain NAME:WIDTH changes one, --uncertain none "
        "takes the net as exact{}\n",
        text, has_default ? "; assumed widths are uncertain by a factor of 1.5" : "");
    if (!not_shown.empty()) {
        say("  this survey cannot check {}: intervals depend on {}\n", fmt::join(not_shown, ", "),
            not_shown.size() == 1 ? "this width" : "these widths");
    }
}

void print(const Options& options, const CableNet& net, const Survey& survey,
           const Identification& result) {
    print_checks(result.trust, result.detectable);
    say("{}\n{}", counts_text(net), survey_text(net, options, survey));
    print_assumptions(result);
    say("method {}: {}\n  chosen because: {}\n\n", result.method, result.how, result.method_reason);
    if (result.noise_ratio > 0.0) {
        say("variance factor: {:.2f}\n", result.noise_ratio);
    }
    say("edges: {} determined, {} weakly determined, {} not determined, {} slack\n",
        count(result, EdgeStatus::determined), count(result, EdgeStatus::weakly_determined),
        count(result, EdgeStatus::not_determined), count(result, EdgeStatus::slack));
    const auto slack_adjustable = std::ranges::count_if(
        result.predicted.slack_edges,
        [&](int edge) { return std::ranges::binary_search(net.adjustable_edges(), edge); });
    if (slack_adjustable > 0) {
        say("  in addition {} adjustable edges are slack\n", slack_adjustable);
    }
    say("predicted form: {}\n", equilibrium_text(result.predicted));
    const Eigen::VectorXd residuals = residuals_in_use(result, survey);
    say("  deviation from the surveyed form: {:.3g} mm RMS, {:.3g} mm max\n",
        1e3 * std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size())),
        1e3 * residuals.maxCoeff());
    print_frame(result);
    print_epochs(net, result);
    print_forces(net, result);
    print_common_deviation(result.prior.common);
    print_uncertain(net, result);
    print_draws(net, result);
    say("\n");
    print_largest(net, result);
    print_slack(net, result);
    if (!options.output.empty()) {
        say("\nwritten to {}: all {} edges and the predicted form\n", options.output,
            result.edges.size());
        if (result.draws) {
            say("written to {}: {} posterior samples of lengths, forms and tensions\n",
                options.draws_file(), result.draws->count());
        }
    }
}

EpochFiles parse_epoch_files(const std::string& text) {
    if (std::filesystem::exists(text)) {
        return {.survey = text, .turned = {}, .loads = {}};
    }
    EpochFiles files;
    std::string* const parts[] = {&files.survey, &files.turned, &files.loads};
    size_t part = 0;
    for (const char character : text) {
        if (character != ':') {
            parts[part]->push_back(character);
        } else if (++part == std::size(parts)) {
            break;
        }
    }
    if (part == std::size(parts) || files.survey.empty() || (part > 0 && parts[part]->empty())) {
        throw std::invalid_argument(
            fmt::format("--epoch is '{}', expected a survey, and after colons the list of what was "
                        "turned before it and that of loads hung on the net: second.csv, "
                        "second.csv:turned.csv, second.csv::loads.csv",
                        text));
    }
    return files;
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

/// The first survey and those of --epoch.
std::vector<Epoch> read_epochs(const CableNet& net, const Survey& first, const Options& options) {
    std::vector<Epoch> epochs{{.survey = first, .turned = {}}};
    std::vector<std::vector<EdgeTurned>> steps;
    for (const EpochFiles& files : options.epochs) {
        Epoch epoch;
        if (!files.turned.empty()) {
            epoch.turned = parse_turned(net, read_table(files.turned), files.turned);
        }
        steps.push_back(epoch.turned);
        if (!files.loads.empty()) {
            epoch.loads = parse_loads(net, read_table(files.loads), files.loads);
        }
        Options of_epoch = options;
        of_epoch.survey = files.survey;
        epoch.survey =
            read_survey(turned_net(net, all_turned(steps)), files.survey, options.read_options());
        print_survey_notes(of_epoch, epoch.survey, options.json);
        with_survey_of(files.survey, [&] { check_survey(net, epoch.survey); });
        epochs.push_back(std::move(epoch));
    }
    return epochs;
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
    const std::int64_t draws = options.draws.value_or(default_draws(net));
    check_draws(net, draws);
    settings.draws = static_cast<int>(draws);
    settings.estimate_noise = options.noise == estimated_noise;
    std::vector<Epoch> epochs = read_epochs(net, survey, options);
    check_outputs({options.output, draws > 0 ? options.draws_file() : "", options.names},
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
        Options of_last = options;
        of_last.survey = reported == 0 ? options.survey : options.epochs[reported - 1].survey;
        print(of_last, net, survey, result);
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
    add_each_parsed(command, "--epoch", options->epochs, parse_epoch_files,
                    "A later survey of the same net and the list of what was turned before it: "
                    "second.csv:turned.csv, or second.csv where nothing was; and of loads that "
                    "hung on it then alone: second.csv::loads.csv. All surveys together determine "
                    "the lengths; the result is of the last without such loads. May be repeated")
        ->allow_extra_args(false)
        ->group(heading::input);
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
