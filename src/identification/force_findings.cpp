// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/checked_result.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "identification/parameter_estimates.hpp"
#include "identification/parameter_spread.hpp"
#include "net/rounded_length.hpp"
#include "taut/net/units.hpp"

namespace taut {
namespace {

using Verdict = Trust::Verdict;
using Finding = Trust::Finding;
using FindingKind = Finding::Kind;

/// What may be wrong with a measurement that contradicts the survey: of a frequency, the mode that
/// explains it, where one does.
std::string source_hint(const ForceOutlier& outlier) {
    if (outlier.source == ForceSource::load_cell) {
        return {};
    }
    if (outlier.source == ForceSource::sag) {
        return "Check its points, and the mass of the cable.";
    }
    if (!(outlier.expected > 0.0)) {
        return "Check its mode, mass and free length.";
    }
    // T is as 1 / n^2.
    const double fitting = outlier.mode * std::sqrt(outlier.measured / outlier.expected);
    constexpr double closest = 0.15;
    const double mode = std::max(1.0, std::round(fitting));
    return mode != outlier.mode && std::abs(fitting - mode) < closest
               ? fmt::format("It would be that of mode {:.0f}, not {}: check which it is.", mode,
                             outlier.mode)
               : "Check its mode, mass and free length.";
}

/// What taut did with measurements that are named, `out` if all priors contradict them.
std::string use_of(double probability, std::string_view it, std::string_view out) {
    if (probability > all_but_sure) {
        return fmt::format("taut {}.", out);
    }
    if (!(probability > 0.0)) {
        return fmt::format(
            "Chance does so in fewer than one of {:.0f} surveys. taut kept {}: tensions follow {}.",
            1.0 / doubtful_rate, it, it);
    }
    return fmt::format(
        "By {:.0f} % of the priors taut {}, by the others taut kept {}: tensions are a mixture of "
        "both.",
        1e2 * probability, out, it);
}

bool is_estimated(const Identification& result, UncertainParameter::Kind kind) {
    return std::ranges::any_of(result.uncertain, [kind](const ParameterEstimate& one) {
        return one.parameter.kind == kind;
    });
}

}  // namespace

void test_forces(CheckedResult& of) {
    std::vector<std::string> marks;
    for (const auto* edges : {&of.result.contradicted_taut, &of.result.contradicted_slack}) {
        std::ranges::transform(*edges, std::back_inserter(marks),
                               [&](int edge) { return of.net.edge_id(edge); });
    }
    if (!marks.empty()) {
        of.add({.kind = FindingKind::slack_marks,
                .severity = Verdict::doubtful,
                .ids = marks,
                .reason = fmt::format("Edges marked as slack or taut contradict the survey: {}. "
                                      "taut ignored all marks.",
                                      and_more(marks)),
                .advice = "Look at those edges again."});
    }
    if (const std::optional<ForceBias>& bias = of.result.force_bias) {
        of.add({.kind = FindingKind::force_scale,
                .severity = Verdict::doubtful,
                .value = bias->part,
                .std_dev = bias->std_dev,
                .reason = fmt::format(
                    "All force measurements are off by the same part, {:+.0f} %. {}",
                    1e2 * bias->part, use_of(bias->probability, "them", "used none of them")),
                .advice = "Check their unit and calibration."});
        if (bias->is_left_out()) {
            return;
        }
    }
    if (of.result.force_measurements >
            std::ranges::count_if(of.result.force_outliers, &ForceOutlier::is_left_out) &&
        !is_estimated(of.result, UncertainParameter::Kind::test_loads)) {
        add_given_stiffness(of.trust, of.result, false);
    }
    for (const ForceOutlier& outlier : of.result.force_outliers) {
        const bool by_all = outlier.is_left_out();
        const std::string hint = source_hint(outlier);
        of.add({.kind = FindingKind::force_measurement,
                .severity = by_all ? Verdict::passed : Verdict::doubtful,
                .ids = {of.net.edge_id(outlier.edge)},
                .value = outlier.measured - outlier.expected,
                .reason = fmt::format("The force {} edge {} is {:.2f} kN, where {:.2f} kN is "
                                      "expected. {}",
                                      outlier.source == ForceSource::load_cell ? "measured in"
                                      : outlier.source == ForceSource::sag     ? "by the sag of"
                                                                           : "by the frequency of",
                                      of.net.edge_id(outlier.edge), 1e-3 * outlier.measured,
                                      1e-3 * outlier.expected,
                                      use_of(outlier.probability, "it", "left it out")),
                .advice = by_all ? hint : hint + (hint.empty() ? "" : " ") + "Measure it again."});
    }
}

void add_given_stiffness(Trust& trust, const Identification& result, bool by_loads) {
    constexpr double largest = 1.96;
    constexpr double informed = 0.98;  // of the prior standard deviation
    using Kind = UncertainParameter::Kind;
    std::vector<std::string> others;
    for (const Kind kind : {Kind::forces, Kind::mass, Kind::loads, Kind::test_loads}) {
        if (is_estimated(result, kind)) {
            others.emplace_back(to_string(kind));
        }
    }
    for (const ParameterEstimate& one : result.uncertain) {
        if (one.parameter.kind != Kind::stiffness || !(one.std_dev < informed * one.prior_std)) {
            continue;
        }
        // What is shown without the prior of the stiffness.
        const double information = std::pow(one.std_dev, -2) - std::pow(one.prior_std, -2);
        const double shown = one.mean * std::pow(one.std_dev, -2) / information;
        if (std::abs(shown) * std::sqrt(information) < largest) {
            continue;
        }
        const std::string& group = one.parameter.group;
        trust.findings.push_back(
            {.kind = FindingKind::given_stiffness,
             .ids = {std::string(to_string(one.parameter.kind)) +
                     (group.empty() ? "" : "@" + group)},
             .value = shown,
             .std_dev = 1.0 / std::sqrt(information),
             .confounded_with = others,
             .reason = fmt::format(
                 "The {} contradict the given stiffness{}: with the form they show cables {:.1f} "
                 "+- {:.1f} % {}. taut trusts them.",
                 by_loads ? "known loads" : "force measurements",
                 group.empty() ? "" : " of " + group, 1e2 * std::abs(shown),
                 1e2 / std::sqrt(information), shown > 0.0 ? "stiffer" : "softer"),
             .advice = by_loads
                           ? "All of them may be wrong by as much instead. Force measurements "
                             "would tell."
                           : "All of them may be wrong by as much instead (calibration, mass, or "
                             "cable_ends): one survey cannot tell. A second one under a known load "
                             "can."});
    }
}

void test_uncertain(CheckedResult& of) {
    for (const ParameterSpread& spread : spreads_of(of.result.uncertain)) {
        if (spread.is_contradicted()) {
            const double ratio = spread.ratio * spread.widening;
            // parse_uncertain_parameter() takes no more
            const double widest_part =
                spread.parameter.kind == UncertainParameter::Kind::creep ? most_creep : 0.3;
            UncertainParameter wider = spread.parameter;
            wider.std_dev = to_digits(ratio * wider.std_dev, 2);
            const std::string group = wider.group.empty() ? std::string() : "@" + wider.group;
            const bool is_metric = wider.kind == UncertainParameter::Kind::adjustable ||
                                   wider.kind == UncertainParameter::Kind::supports ||
                                   wider.kind == UncertainParameter::Kind::temperature ||
                                   wider.kind == UncertainParameter::Kind::loads_each;
            const bool is_of_known_loads = wider.kind == UncertainParameter::Kind::test_loads;
            of.add(
                {.kind = FindingKind::uncertain_parameter,
                 .severity = Verdict::failed,
                 .ids = {std::string(to_string(wider.kind)) + group},
                 .value = ratio,
                 .remedy = Trust::Remedy{"uncertain", is_metric || wider.std_dev < widest_part
                                                          ? to_string(wider)
                                                          : ""},
                 .reason = fmt::format("The survey shows {:.1f} times the standard deviation "
                                       "assumed of {}.",
                                       ratio, to_string(spread.parameter)),
                 .advice = is_of_known_loads
                               ? "Check the loads that hung on the net: their sign, unit and nodes."
                               : "Check it on site, or assume a larger one."});
        }
    }
}

}  // namespace taut
