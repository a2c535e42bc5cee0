// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <optional>

#include "command.hpp"
#include "net_summary.hpp"
#include "predicted_precision.hpp"
#include "taut/files/file.hpp"
#include "taut/identification/identifiability.hpp"
#include "taut/io/net_json.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/equilibrium_matrix.hpp"
#include "taut/statics/form_sensitivity.hpp"
#include "taut/statics/imbalance.hpp"
#include "taut/statics/plausibility.hpp"
#include "taut/statics/tensions.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

/// Above these sizes the analyses take minutes.
constexpr int most_edges_for_identifiability = 50'000;
constexpr int most_edges_for_sensitivity = 3'000;

constexpr int sensitive_edges = 10;

struct InspectOptions : CommonOptions, SurveyOptions, ForceOptions {
    std::string net;
    std::string prior = "uniform:5mm";
    UncertainOptions uncertain;
    SuggestionOptions suggestions;
};

struct Range {
    double min;
    double mean;
    double max;
};

Range range_of(const Eigen::VectorXd& values) {
    return {values.minCoeff(), values.mean(), values.maxCoeff()};
}

nlohmann::ordered_json to_json(const Range& range) {
    return {{"min", range.min}, {"mean", range.mean}, {"max", range.max}};
}

/// Analyses of the equilibrium form, left out where they take too long or there is no equilibrium.
struct Analysis {
    std::optional<StressStates> stress;
    std::optional<Identifiability> identifiability;
    std::vector<EdgeSensitivity> most_sensitive;
    std::string left_out;  ///< which, and why; empty: none
};

/// Properties of a net as it is given, and in equilibrium.
struct Inspection {
    Eigen::Vector3d lower;  ///< corners of the bounding box [m]
    Eigen::Vector3d upper;
    Range lengths;                 ///< at the given nodes [m]
    Range unstressed_lengths;      ///< [m]
    Range tensions;                ///< at the given nodes [N]
    Range strains;                 ///< likewise
    Imbalance imbalance;           ///< at the given nodes
    std::vector<int> slack_edges;  ///< at the given nodes
    Eigen::Vector3d load;          ///< sum over the free nodes [N]
    Equilibrium equilibrium;
    FormCheck check;    ///< of the equilibrium
    double move;        ///< largest distance from a given node to its equilibrium [m]
    Analysis analysis;  ///< of the equilibrium
    std::vector<std::string> warnings;
};

Analysis analyse(const CableNet& net, const Equilibrium& equilibrium) {
    const Eigen::VectorXd& lengths = equilibrium.unstressed_lengths;
    Analysis result;
    if (!equilibrium.balanced()) {
        result.left_out = "self-stress, identifiability, sensitivities: no equilibrium was found";
        return result;
    }
    result.stress = stress_states(net, lengths, equilibrium.form);
    if (!net.sliding_nodes().empty()) {
        result.left_out = "identifiability: runs of the net slide";
    } else if (net.edge_count() <= most_edges_for_identifiability) {
        result.identifiability = identifiability(net, lengths, equilibrium.form);
    } else {
        result.left_out =
            fmt::format("identifiability: more than {} edges", most_edges_for_identifiability);
    }
    if (net.interior_edge_count() <= most_edges_for_sensitivity) {
        result.most_sensitive = most_sensitive_edges(
            FormSensitivity(net, lengths, equilibrium.form), net.interior_edges(), sensitive_edges);
    } else {
        result.left_out += result.left_out.empty() ? "" : "; ";
        result.left_out +=
            fmt::format("sensitivities: more than {} interior edges", most_edges_for_sensitivity);
    }
    return result;
}

Inspection inspect(const CableNet& net) {
    Equilibrium equilibrium = solve_equilibrium(net);
    const Eigen::VectorXd unstressed = equilibrium.unstressed_lengths;
    const Eigen::VectorXd lengths = edge_lengths(net, net.nodes());
    const Eigen::VectorXd edge_tensions = tensions_of(net, unstressed, net.nodes());
    Analysis analysis = analyse(net, equilibrium);
    Eigen::VectorXd strains = lengths.cwiseQuotient(unstressed).array() - 1.0;
    strains = (edge_tensions.array() == 0.0).select(0.0, strains);
    const FormCheck check = check_form(net, equilibrium.unstressed_lengths, equilibrium.form);
    const double move = (equilibrium.form - net.nodes()).colwise().norm().maxCoeff();
    return {.lower = net.nodes().rowwise().minCoeff(),
            .upper = net.nodes().rowwise().maxCoeff(),
            .lengths = range_of(lengths),
            .unstressed_lengths = range_of(unstressed),
            .tensions = {.min = edge_tensions.minCoeff(),
                         .mean = mean_weights(net).dot(edge_tensions),
                         .max = edge_tensions.maxCoeff()},
            .strains = range_of(strains),
            .imbalance = imbalance_of(net, unstressed, net.nodes()),
            .slack_edges = slack_edges(net, unstressed, net.nodes()),
            .load = net.loads()(Eigen::all, net.free_nodes()).rowwise().sum(),
            .equilibrium = std::move(equilibrium),
            .check = check,
            .move = move,
            .analysis = std::move(analysis),
            .warnings = unit_warnings(net)};
}

nlohmann::ordered_json to_json(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

/// Adds the keys "self_stress_states", "mechanisms", "identifiability" and "most_sensitive_edges":
/// null where left out, with the reason in "left_out".
void add_analysis(nlohmann::ordered_json& document, const Analysis& it) {
    document["self_stress_states"] = nullptr;
    document["mechanisms"] = nullptr;
    document["identifiability"] = nullptr;
    document["most_sensitive_edges"] = nullptr;
    if (it.stress) {
        document["self_stress_states"] = it.stress->self_stress;
        document["mechanisms"] = it.stress->mechanisms;
    }
    if (it.identifiability) {
        const Identifiability& i = *it.identifiability;
        document["identifiability"] = {{"determined", i.determined.size()},
                                       {"undetermined", i.undetermined},
                                       {"slack", i.slack},
                                       {"free_self_stress_states", i.free_self_stress},
                                       {"largest_singular_value", i.largest_singular_value},
                                       {"smallest_singular_value", i.smallest_singular_value},
                                       {"condition", i.condition()}};
    }
    for (const EdgeSensitivity& edge : it.most_sensitive) {
        document["most_sensitive_edges"].push_back({{"edge", edge.edge}, {"move", edge.move}});
    }
    if (!it.left_out.empty()) {
        document["left_out"] = it.left_out;
    }
}

nlohmann::ordered_json to_json(const CableNet& net, const Inspection& it) {
    nlohmann::ordered_json equilibrium{{"status", to_string(it.equilibrium.status)},
                                       {"iterations", it.equilibrium.iterations},
                                       {"out_of_balance", it.equilibrium.out_of_balance},
                                       {"mean_tension", it.equilibrium.mean_tension},
                                       {"largest_move", it.move},
                                       {"slack_edges", it.equilibrium.slack_edges}};
    add_check(equilibrium, it.check);
    nlohmann::ordered_json document{
        {"format", "taut-inspection"},
        {"version", 1},
        {"net", counts_json(net)},
        {"bounding_box", {{"lower", to_json(it.lower)}, {"upper", to_json(it.upper)}}},
        {"lengths", to_json(it.lengths)},
        {"unstressed_lengths", to_json(it.unstressed_lengths)},
        {"tensions", to_json(it.tensions)},
        {"strains", to_json(it.strains)},
        {"load", to_json(it.load)},
        {"out_of_balance", it.imbalance.largest},
        {"warnings", it.warnings},
        {"slack_edges", it.slack_edges},
        {"equilibrium", equilibrium}};
    add_analysis(document, it.analysis);
    return document;
}

void print(const CableNet& net, const Analysis& it) {
    if (it.stress) {
        say("states of self-stress: {}; mechanisms: {}\n", it.stress->self_stress,
            it.stress->mechanisms);
    }
    if (it.identifiability) {
        const Identifiability& i = *it.identifiability;
        say("lengths determined by an exact form: {} of {} interior edges, condition {:.3g}\n",
            i.determined.size(), net.interior_edge_count(), i.condition());
        say("  not determined, because of {} free states of self-stress: {}\n", i.free_self_stress,
            edges_text(net, i.undetermined));
        say("  not determined, because slack: {}\n", edges_text(net, i.slack));
    }
    if (!it.most_sensitive.empty()) {
        say("largest change of the form by 1 mm of length: edge");
        for (size_t k = 0; k < std::min<size_t>(5, it.most_sensitive.size()); ++k) {
            say("{} {} ({:.3g} mm)", k > 0 ? "," : "", net.edge_id(it.most_sensitive[k].edge),
                it.most_sensitive[k].move);
        }
        say(" (norm over all coordinates)\n");
    }
    if (!it.left_out.empty()) {
        say("left out: {}\n", it.left_out);
    }
}

void print(const CableNet& net, const Inspection& it) {
    const auto line = [](std::string_view name, std::string_view unit, const Range& r,
                         double scale) {
        say("  {:<28}{:>12.4g}{:>12.4g}{:>12.4g}  {}\n", name, scale * r.min, scale * r.mean,
            scale * r.max, unit);
    };
    const Eigen::Vector3d size = it.upper - it.lower;
    say("{}\nfingerprint {}\n", counts_text(net), net.fingerprint());
    say("bounding box {:.4g} x {:.4g} x {:.4g} m\n", size.x(), size.y(), size.z());
    say("sum of loads {:.4g}, {:.4g}, {:.4g} N\n\n", it.load.x(), it.load.y(), it.load.z());
    say("  {:<28}{:>12}{:>12}{:>12}\n", "as given", "min", "mean", "max");
    line("length", "m", it.lengths, 1.0);
    line("unstressed length", "m", it.unstressed_lengths, 1.0);
    line("tension", "kN", it.tensions, 1e-3);
    line("strain", "%", it.strains, 100.0);
    say("  largest out-of-balance force: {:.4g} N\n", it.imbalance.largest);
    say("  slack edges: {}\n", edges_text(net, it.slack_edges));
    say("\n");
    say("in equilibrium: {}\n", equilibrium_text(it.equilibrium));
    say("  {}\n", check_text(it.check));
    say("  largest distance of a node from its given place: {:.4g} mm\n", 1e3 * it.move);
    say("  slack edges: {}\n\n", edges_text(net, it.equilibrium.slack_edges));
    print(net, it.analysis);
}

void run(const InspectOptions& options) {
    const CableNet net = read_net(options.net).net;
    const LengthPrior prior = options.survey.empty()
                                  ? parse_length_prior(options.prior)  // checked, and not used
                                  : prior_for(net, options.prior, options.net);
    check_outputs({options.names}, {options.net, options.survey, options.control});
    const Inspection inspection = inspect(net);
    warn(options.net, inspection.warnings);
    std::optional<PredictedSurvey> precision;
    if (!options.survey.empty()) {
        precision = precision_of(net, inspection.equilibrium, options, prior,
                                 read_planned_forces(net, options), options.uncertain,
                                 options.suggestions, options, options.net, options.json);
    }
    if (precision && !options.names.empty()) {
        write_file(options.names, survey_names_csv(net, precision->survey));
    }
    if (options.json) {
        nlohmann::ordered_json document = to_json(net, inspection);
        if (precision) {
            document["survey"] = to_json(net, *precision, options.survey);
        }
        say("{}\n", to_text(document));
        return;
    }
    print(net, inspection);
    if (precision) {
        say("\n{}", precision_text(net, *precision, options));
    }
}

}  // namespace

void add_inspect(CLI::App& program) {
    auto options = std::make_shared<InspectOptions>();
    CLI::App& command = add_command(
        program, "inspect", "Check a net, or predict the precision of a survey before it is made",
        "  taut inspect net.json\n"
        "  taut inspect net.json --survey targets.txt --noise 0.5mm\n"
        "  taut inspect net.json --survey targets.txt --noise 0.5mm --forces cells.txt\n"
        "  taut inspect net.json --survey targets.txt --noise 0.5mm --suggest --cost load:5",
        *options);
    command.add_option("NET", options->net, "Net file")->required();
    CLI::Option* const survey =
        command.add_option("--survey", options->survey,
                           "Predict what a survey determines: a survey file, or a file that names "
                           "the nodes to be targeted, one a line");
    for (CLI::Option* option : add_survey_options(command, *options)) {
        option->needs(survey);
    }
    command.add_option("--prior", options->prior, "Prior of the length deviations")
        ->capture_default_str()
        ->needs(survey)
        ->group(heading::known);
    for (CLI::Option* option : add_force_measurement_options(
             command, *options,
             "Edges with a load cell, one a line, or its measurements: edge,tension[,std]")) {
        option->needs(survey);
    }
    add_uncertain_option(command, options->uncertain, assumes_site)->needs(survey);
    for (CLI::Option* option : add_suggestion_options(command, options->suggestions, *options)) {
        option->needs(survey);
    }
    set_action(command, options, run);
}

}  // namespace taut::app
