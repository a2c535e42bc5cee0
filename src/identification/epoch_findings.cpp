// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/epoch_findings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "identification/stretch_lengths.hpp"
#include "net/rounded_length.hpp"
#include "net/sliding_nodes.hpp"
#include "taut/estimation/diagnostics.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {
namespace {

using Verdict = Trust::Verdict;
using FindingKind = Trust::Finding::Kind;

/// A survey whose changes exceed the expected ones by this factor contradicts the others.
constexpr double far_too_much = 1.5;

constexpr const char* what_to_check =
    "Check the turns given, and the loads that hung on the net (signs, units, which nodes and "
    "file), and that both surveys are of this net.";

std::string contradiction_text(size_t before, double ratio) {
    return fmt::format(
        "Between surveys {} and {} the lengths changed {:.2g} times as much as chance allows.",
        before, before + 1, ratio);
}

std::string strokes_text(size_t before, double factor, double std_dev) {
    return fmt::format(
        "Between surveys {} and {} all edges were turned {:.3f} +- {:.3f} times as far as given.",
        before, before + 1, factor, std_dev);
}

std::string change_text(const LengthChange& change) {
    return fmt::format("{:+.2f} +- {:.2f} mm", 1e3 * change.change, 1e3 * change.std_dev);
}

/// Reports adjustable edges that at the first survey are not as long as in the net.
void add_start(Trust& trust, const CableNet& net, const EpochResult& first) {
    for (const LengthChange& change : first.changes) {
        trust.findings.push_back(
            {.kind = FindingKind::adjustable_edge,
             .severity = Verdict::doubtful,
             .ids = {net.edge_id(change.edge)},
             .value = change.change,
             .std_dev = change.std_dev,
             .reason = fmt::format("At the first survey adjustable edge {} differs by {} from the "
                                   "length given. taut used the length that the surveys show.",
                                   edge_or_cable(net, change.edge), change_text(change)),
             .advice = "Read the turnbuckle there."});
    }
}

/// An edge that did not change as it was turned: that nothing was turned is the first thing to ask.
Trust::Finding change_finding(const CableNet& net, const EpochResult& epoch,
                              const LengthChange& change, const std::string& between) {
    Trust::Finding finding{
        .kind = FindingKind::length_change,
        .severity = Verdict::doubtful,
        .value = change.change,
        .std_dev = change.std_dev,
        .reason = fmt::format("{} the length of edge {} changed by {}. taut gave each survey a "
                              "length of its own for it.",
                              between, edge_or_cable(net, change.edge), change_text(change)),
        .advice =
            "If it was turned, add it to the turns. Else check whether it slipped, was slack "
            "at one survey, or a support at it moved."};
    const std::vector<int> stretch = stretch_of(net, change.edge);
    std::vector<EdgeTurned> turned = epoch.turned;
    std::erase_if(turned, [&](const EdgeTurned& one) {
        return std::ranges::find(stretch, one.edge) == stretch.end();
    });
    const int named = turned.empty() ? change.edge : turned.front().edge;
    finding.ids = {net.edge_id(named)};
    for (const int edge : stretch) {
        if (edge != named) {
            finding.confounded_with.push_back(net.edge_id(edge));
        }
    }
    if (!turned.empty()) {
        double stroke = 0.0;
        for (const EdgeTurned& one : turned) {
            stroke += one.stroke;
        }
        finding.reason = fmt::format(
            "{} edge {} is given as turned by {:+.2f} mm, but its length changed by {:+.2f} +- "
            "{:.2f} mm. taut gave each survey a length of its own for it.",
            between, edge_or_cable(net, turned.front().edge), 1e3 * stroke,
            1e3 * (stroke + change.change), 1e3 * change.std_dev);
        finding.advice = "Check whether it was turned as given, and which way.";
    }
    return finding;
}

/// (epoch-slip)
Trust::Finding slip_finding(const CableNet& net, const SlipOrTarget& either,
                            const std::string& between) {
    const LengthChange& one = either.lengths[0];
    const LengthChange& other = either.lengths[1];
    return {.kind = FindingKind::slip,
            .severity = Verdict::doubtful,
            .ids = {net.edge_id(one.edge), net.edge_id(other.edge)},
            .value = one.change,
            .std_dev = one.std_dev,
            .confounded_with = {net.node_id(either.node)},
            .reason = fmt::format(
                "{} either the target of node {} went wrong, or a clamp slipped there: edge {} "
                "changed by {}, edge {} by {}. taut left out the target; the intervals of both "
                "edges hold either way.",
                between, net.node_id(either.node), edge_or_cable(net, one.edge), change_text(one),
                net.edge_id(other.edge), change_text(other)),
            .advice = "Check the clamp and the target."};
}

/// (creep) that was not given.
/// @param widest that may be given for so many surveys
Trust::Finding creep_finding(const EpochChanges::CommonStrain& strain, double widest,
                             const std::string& between) {
    const UncertainParameter creep{.kind = UncertainParameter::Kind::creep,
                                   .std_dev = to_digits(std::abs(strain.strain), 2),
                                   .group = strain.group};
    return {.kind = FindingKind::uncertain_parameter,
            .severity = Verdict::doubtful,
            .ids = {std::string(to_string(creep.kind)) +
                    (creep.group.empty() ? "" : "@" + creep.group)},
            .value = strain.strain,
            .std_dev = strain.std_dev,
            .remedy = Trust::Remedy{"uncertain", creep.std_dev < widest ? to_string(creep) : ""},
            .reason = fmt::format(
                "{} the lengths of {} changed by {:+.2f} +- {:.2f} % in common.", between,
                strain.group.empty() ? "all interior edges"
                                     : fmt::format("the edges of group {}", strain.group),
                1e2 * strain.strain, 1e2 * strain.std_dev),
            .advice =
                "Check the temperature of both surveys, and that they have one scale. If the "
                "cables creep or bed in, state it."};
}

/// Reports how lengths changed before a survey, besides the turns given.
void add_changes(Trust& trust, const CableNet& net, const EpochResult& epoch,
                 const EpochChanges& changes, double widest_creep, size_t k) {
    const std::string between = fmt::format("Between surveys {} and {}", k, k + 1);
    const bool is_significant = epoch.change_ratio > epoch.change_limit;
    const Trust::Finding contradiction{.kind = FindingKind::epoch,
                                       .severity = Verdict::doubtful,
                                       .value = epoch.change_ratio,
                                       .reason = contradiction_text(k, epoch.change_ratio),
                                       .advice = what_to_check};
    const bool are_strokes_off =
        std::abs(epoch.stroke_factor - 1.0) > significant_std * epoch.stroke_factor_std;
    if (is_significant && epoch.change_ratio > far_too_much && !are_strokes_off) {
        trust.findings.push_back(contradiction);
        trust.findings.back().severity = Verdict::failed;
        if (changes.common_strain) {
            trust.findings.push_back(creep_finding(*changes.common_strain, widest_creep, between));
        }
        return;
    }
    if (are_strokes_off) {
        trust.findings.push_back(
            {.kind = FindingKind::turns,
             .severity = Verdict::failed,
             .value = epoch.stroke_factor,
             .std_dev = epoch.stroke_factor_std,
             .reason = strokes_text(k, epoch.stroke_factor, epoch.stroke_factor_std),
             .advice = "Check the sign and unit of what was turned, and the length of a turn."});
    }
    for (const LengthChange& change : epoch.changes) {
        trust.findings.push_back(change_finding(net, epoch, change, between));
    }
    for (const SlipOrTarget& either : changes.slips_or_targets) {
        trust.findings.push_back(slip_finding(net, either, between));
    }
    if (changes.common_strain) {
        trust.findings.push_back(creep_finding(*changes.common_strain, widest_creep, between));
    } else if (epoch.excess_actuator_std > 0.0) {
        trust.findings.push_back(
            {.kind = FindingKind::actuator_std,
             .severity = Verdict::doubtful,
             .value = epoch.excess_actuator_std,
             .reason = fmt::format("{} turns differ from those given by {:.2f} mm (root mean "
                                   "square), more than the standard deviation given. taut took it "
                                   "into account.",
                                   between, 1e3 * epoch.excess_actuator_std),
             .advice = "Give it as the standard deviation of what was turned."});
    } else if (is_significant) {
        trust.findings.push_back(contradiction);
    }
}

}  // namespace

std::string contradiction_of(const CableNet& net, const std::vector<EpochChanges>& changes) {
    for (size_t k = 0; k < changes.size(); ++k) {
        const EpochChanges& epoch = changes[k];
        if (epoch.is_of_all_turns) {
            return fmt::format("{} {}",
                               strokes_text(k, epoch.stroke_factor, epoch.stroke_factor_std),
                               what_to_check);
        }
        if (!are_too_many_changes(net, epoch.lengths.size())) {
            continue;
        }
        if (k > 0) {
            return fmt::format("{} More than a tenth of all changed. {}",
                               contradiction_text(k, epoch.agreement.ratio()), what_to_check);
        }
        return fmt::format(
            "At the first survey {} or more adjustable edges are not as long as given. Check that "
            "this is the net's file, and what was turned since it was written.",
            epoch.lengths.size());
    }
    return {};
}

Trust trust_of_epochs(const CableNet& net, const std::vector<EpochResult>& epochs,
                      const std::vector<EpochChanges>& changes) {
    Trust trust;
    for (size_t k = 0; k < epochs.size(); ++k) {
        for (const Trust::Finding& finding : epochs[k].trust.findings) {
            trust.findings.push_back(finding);
            trust.findings.back().reason = fmt::format("Survey {}: {}", k + 1, finding.reason);
        }
    }
    add_start(trust, net, epochs.front());
    const double widest_creep = most_creep / std::sqrt(static_cast<double>(epochs.size()) - 1.0);
    for (size_t k = 1; k < epochs.size(); ++k) {
        add_changes(trust, net, epochs[k], changes[k], widest_creep, k);
    }
    return trust;
}

}  // namespace taut
