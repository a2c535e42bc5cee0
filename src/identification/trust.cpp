// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/trust.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "identification/checked_result.hpp"
#include "identification/net_balance.hpp"
#include "identification/sag_check.hpp"
#include "taut/identification/result.hpp"

namespace taut {
namespace {

using Verdict = Trust::Verdict;
using Finding = Trust::Finding;
using FindingKind = Finding::Kind;

void test_end(CheckedResult& of) {
    if (of.result.status != IdentificationStatus::converged) {
        of.add({.kind = FindingKind::no_convergence,
                .severity = Verdict::failed,
                .reason = of.result.message});
    }
}

void test_draws(CheckedResult& of) {
    if (of.result.draws && of.result.drawn.tensions.empty()) {
        of.add({.kind = FindingKind::tensions,
                .severity = Verdict::doubtful,
                .reason = fmt::format("Tensions are not reported: {}.", of.result.draws->reason),
                .advice = "Lengths may be used, tensions not."});
    }
}

constexpr std::pair<FindingKind, std::string_view> kind_names[] = {
    {FindingKind::no_convergence, "no_convergence"},
    {FindingKind::survey_scale, "survey_scale"},
    {FindingKind::survey_frame, "survey_frame"},
    {FindingKind::survey_noise, "survey_noise"},
    {FindingKind::missing_load, "missing_load"},
    {FindingKind::prior, "prior"},
    {FindingKind::common_deviation, "common_deviation"},
    {FindingKind::run_scales, "run_scales"},
    {FindingKind::length, "length"},
    {FindingKind::slip, "slip"},
    {FindingKind::swapped_cables, "swapped_cables"},
    {FindingKind::adjustable_edge, "adjustable_edge"},
    {FindingKind::support, "support"},
    {FindingKind::boundary, "boundary"},
    {FindingKind::target, "target"},
    {FindingKind::adjacent_targets, "adjacent_targets"},
    {FindingKind::swapped_targets, "swapped_targets"},
    {FindingKind::target_far_from_node, "target_far_from_node"},
    {FindingKind::misplaced_names, "misplaced_names"},
    {FindingKind::predicted_form, "predicted_form"},
    {FindingKind::slack_marks, "slack_marks"},
    {FindingKind::force_scale, "force_scale"},
    {FindingKind::given_stiffness, "given_stiffness"},
    {FindingKind::force_measurement, "force_measurement"},
    {FindingKind::uncertain_parameter, "uncertain_parameter"},
    {FindingKind::tensions, "tensions"},
    {FindingKind::length_change, "length_change"},
    {FindingKind::turns, "turns"},
    {FindingKind::actuator_std, "actuator_std"},
    {FindingKind::epoch, "epoch"},
    {FindingKind::repeated_survey, "repeated_survey"},
    {FindingKind::net_balance, "net_balance"},
    {FindingKind::sag, "sag"},
    {FindingKind::other, "other"},
};

}  // namespace

Trust::Verdict Trust::verdict() const {
    Verdict worst = Verdict::passed;
    for (const Finding& finding : findings) {
        worst = std::max(worst, finding.severity);
    }
    return worst;
}

std::string_view to_string(Trust::Verdict verdict) {
    switch (verdict) {
        case Trust::Verdict::passed:
            return "passed";
        case Trust::Verdict::doubtful:
            return "doubtful";
        case Trust::Verdict::failed:
            return "failed";
    }
    return "unknown";
}

std::string Trust::Finding::text() const {
    return advice.empty() ? reason : reason + " " + advice;
}

std::string_view to_string(FindingKind kind) {
    const auto* const found =
        std::ranges::find(kind_names, kind, [](const auto& one) { return one.first; });
    return found->second;
}

std::optional<FindingKind> finding_kind(std::string_view name) {
    const auto* const found =
        std::ranges::find(kind_names, name, [](const auto& one) { return one.second; });
    return found == std::end(kind_names) ? std::nullopt : std::optional(found->first);
}

Trust trust_of(const CableNet& net, const Survey& survey, const Identification& result) {
    CheckedResult of(net, survey, result);
    test_end(of);
    const bool is_noise_first = of.is_noise_likelier();
    if (of.other_cause.is_load_likeliest) {
        test_loads(of);
    }
    test_frame(of);
    test_elastic_supports(of);
    if (!is_noise_first) {
        test_uncertain(of);
    }
    const bool is_prior_first = !is_noise_first && of.has_narrow_prior();
    if (is_prior_first) {
        test_prior(of);
    }
    test_noise(of);
    if (!is_prior_first) {
        test_prior(of);
    }
    if (!of.other_cause.is_load_likeliest) {
        test_loads(of);
    }
    test_lengths(of);
    test_boundary(of);
    test_targets(of);
    test_prediction(of);
    test_names(of);
    test_places(of);
    test_forces(of);
    if (is_noise_first) {
        test_uncertain(of);
    }
    test_draws(of);
    std::ranges::move(sag_findings(net, result), std::back_inserter(of.trust.findings));
    if (auto finding = net_balance_finding(net, result, of.trust.verdict())) {
        // The first to look at: what else contradicts the survey may follow from it.
        of.trust.findings.insert(of.trust.findings.begin(), *std::move(finding));
    }
    std::ranges::stable_sort(of.trust.findings, std::greater{}, &Finding::severity);
    return std::move(of.trust);
}

}  // namespace taut
