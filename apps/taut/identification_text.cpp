// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification_text.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "checks_text.hpp"
#include "net_summary.hpp"
#include "parameter_text.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

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
            std::ranges::count_if(result.force_outliers, &ForceOutlier::is_left_out));
    }
    for (const ForceOutlier& outlier : result.force_outliers) {
        say("  {:<12} measured {:.4g} kN, expected {:.4g} kN from everything else{}\n",
            net.edge_id(outlier.edge), 1e-3 * outlier.measured, 1e-3 * outlier.expected,
            outlier.is_left_out() ? ""
            : outlier.probability > 0.0
                ? fmt::format(": left out by {:.0f} % of the priors", 1e2 * outlier.probability)
                : ": kept, but doubted");
    }
    if (result.force_bias && result.force_bias->is_left_out()) {
        say("  together they contradict the survey, by which tensions are {:.2g} +- {:.2g} times "
            "the measured ones.\n  taut used none of them. Check their unit, their calibration "
            "and the net's stiffness.\n",
            1.0 - result.force_bias->part, result.force_bias->std_dev);
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

/// Cables that slide have one length from clamp to clamp.
void print_stretches(const CableNet& net, const Identification& result) {
    for (const StretchLength& stretch : result.stretches) {
        say("cable that slides, edges {} to {}, friction up to {:.2g}: {:+.2f} mm, std {:.2f} mm, "
            "of {:.4g} m; {:.4g} kN, std {:.2g} kN\n",
            net.edge_id(stretch.edges.front()), net.edge_id(stretch.edges.back()), stretch.friction,
            1e3 * stretch.length_deviation, 1e3 * stretch.std_dev, stretch.nominal,
            1e-3 * stretch.tension, 1e-3 * stretch.tension_std);
    }
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
        tension_text(result.drawn.mean_tension), draws.count(), draws.method,
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
            const bool slides = std::ranges::any_of(result.stretches, [&](const auto& one) {
                return std::ranges::find(one.edges, change.edge) != one.edges.end();
            });
            say("  {:<12} changed by {:+.2f} +- {:.2f} mm\n",
                net.edge_id(change.edge) + (slides ? " or another of its cable" : ""),
                1e3 * change.change, 1e3 * change.std_dev);
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
            1e3 * e.length_deviation, 1e3 * e.std_dev, 1e3 * e.lower, 1e3 * e.upper, tension,
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
    const auto text = [](const Eigen::Vector3d& v, const Eigen::Vector3d& std_dev) {
        return fmt::format("({:.2f}, {:.2f}, {:.2f}) +- ({:.2f}, {:.2f}, {:.2f})", v.x(), v.y(),
                           v.z(), std_dev.x(), std_dev.y(), std_dev.z());
    };
    say("coordinate system of the survey: the supports are moved by {} mm and rotated by {} mrad\n",
        text(1e3 * frame.translation, 1e3 * frame.translation_std),
        text(1e3 * frame.rotation, 1e3 * frame.rotation_std));
}

}  // namespace

void print_identification(const CableNet& net, const SurveyOptions& options, const Survey& survey,
                          const Identification& result) {
    print_checks(result.trust, result.detectable);
    say("{}\n{}", counts_text(net), survey_text(net, options, survey));
    print_assumptions(result);
    say("method {}: {}\n  chosen because: {}\n\n", result.method, result.description,
        result.method_reason);
    if (const auto [ratio, std_dev] = result.scales.noise; ratio > 0.0 && std_dev > 0.0) {
        constexpr double to_95 = 1.96;
        say("variance factor: {:.2f} (expected {:.2f} to {:.2f})\n", ratio,
            std::max(1.0 - to_95 * std_dev, 0.0), 1.0 + to_95 * std_dev);
    } else if (result.noise_ratio > 0.0) {
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
    print_stretches(net, result);
    print_uncertain(net, result);
    print_draws(net, result);
    say("\n");
    print_largest(net, result);
    print_slack(net, result);
}

}  // namespace taut::app
