// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/checked_result.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "identification/parameter_estimates.hpp"
#include "identification/stretch_lengths.hpp"
#include "net/rounded_length.hpp"
#include "taut/net/units.hpp"

namespace taut {
namespace {

using Verdict = Trust::Verdict;
using Finding = Trust::Finding;
using FindingKind = Finding::Kind;

/// More of the boundary that contradict the survey, and it is not single ones that are wrong.
constexpr int a_few_of_boundary = 3;

/// A prior as one would write it, without the rounding errors of its last digit.
std::string prior_text(const LengthPrior& prior) {
    const std::string exact = to_string(prior);
    return exact.substr(0, exact.find(':') + 1) + format_length(prior.scale);
}

/// (length-trend): scales near the widest that the prior holds are more likely a prior that is
/// too narrow.
void test_runs(CheckedResult& of) {
    constexpr double surely = 0.95;
    constexpr double widest = 1.4;  // standard deviations of the prior, at a mean edge
    const CommonDeviation& common = of.result.prior.common;
    if (common.run_probability <= surely) {
        return;
    }
    const double at_edge =
        common.run_std * of.net.unstressed_lengths()(of.net.interior_edges()).mean();
    if (at_edge > widest * of.result.length_prior.std_dev()) {
        of.add({.kind = FindingKind::run_scales,
                .severity = Verdict::doubtful,
                .value = common.run_std,
                .reason = fmt::format("Runs of cable differ in scale by {:.2g} %, more than the "
                                      "prior {} allows.",
                                      100.0 * common.run_std, prior_text(of.result.length_prior)),
                .advice = "The prior may be too narrow, or cables were measured by different "
                          "tapes."});
    }
}

/// (hyperprior): what the survey finds is cut off where the prior over scales ends.
void test_scale_of_prior(CheckedResult& of) {
    constexpr double standard_deviation = 1.5;  // of the prior over scales
    const PriorEstimate& prior = of.result.prior;
    if (of.result.prior_was_given && !prior.exact &&
        prior.std_dev - prior.std_std > standard_deviation * prior.given.std_dev()) {
        of.add({.kind = FindingKind::prior,
                .severity = Verdict::doubtful,
                .value = prior.std_dev,
                .reason = fmt::format("The lengths scatter by +-{:.2f} mm or more. The prior "
                                      "given, {}, allows +-{:.2f} mm.",
                                      1e3 * prior.std_dev, prior_text(prior.given),
                                      1e3 * prior.given.std_dev()),
                .advice =
                    "Give a wider prior, or none. Noise in plan that is larger than given can look "
                    "the same."});
    }
}

const LengthOutlier* other_of(const CheckedResult& of, const LengthOutlier& edge) {
    const auto found =
        std::ranges::find(of.result.length_outliers, edge.other, &LengthOutlier::edge);
    return found == of.result.length_outliers.end() ? nullptr : &*found;
}

/// "12 is 5.1 +- 0.4 mm longer"
std::string length_text(const CheckedResult& of, const LengthOutlier& edge) {
    const auto found = std::ranges::find(of.result.edges, edge.edge, &IdentifiedEdge::edge);
    const bool is_slack = found != of.result.edges.end() && found->status == EdgeStatus::slack;
    return fmt::format("{} is {}{}", edge_or_cable(of.net, edge.edge), is_slack ? "slack and " : "",
                       longer_text(edge.deviation, edge.std_dev, is_slack ? "at least " : ""));
}

/// (slip), (swap)
/// @param other null where it is an adjustable edge, which is named by itself
void test_two_lengths(CheckedResult& of, const LengthOutlier& one, const LengthOutlier* other) {
    const std::string both =
        fmt::format("edge {}, edge {}", length_text(of, one),
                    other == nullptr ? of.net.edge_id(one.other) : length_text(of, *other));
    Finding finding{.kind = one.is_swapped ? FindingKind::swapped_cables : FindingKind::slip,
                    .severity = Verdict::doubtful,
                    .ids = {of.net.edge_id(one.edge), of.net.edge_id(one.other)},
                    .value = one.deviation,
                    .std_dev = one.std_dev};
    const std::string& node = one.node < 0 ? std::string() : of.net.node_id(one.node);
    if (one.is_swapped) {
        finding.reason = fmt::format(
            "Two cables have each other's length: {}. taut used the "
            "survey alone for both.",
            both);
        finding.advice = "Check whether they were swapped.";
    } else if (one.is_beside_target) {
        finding.confounded_with = {node};
        finding.reason = fmt::format(
            "Either the target of node {} is wrong, or a clamp "
            "slipped there: {}. taut left out the target; the "
            "intervals of both edges hold either way.",
            node, both);
        finding.advice = "Check the clamp and the target.";
    } else {
        finding.reason = fmt::format(
            "A clamp slipped at node {}: {}. taut used the survey "
            "alone for both.",
            node, both);
        finding.advice = "Check the clamp.";
    }
    of.add(std::move(finding));
}

void test_one_of_boundary(CheckedResult& of, const BoundaryOutlier& outlier) {
    const bool is_support = outlier.kind == BoundaryOutlier::Kind::support;
    Finding finding{.kind = is_support ? FindingKind::support : FindingKind::adjustable_edge,
                    .severity = Verdict::doubtful};
    if (is_support) {
        const double distance = outlier.deviation.norm();
        const double std_dev = outlier.deviation.normalized().cwiseProduct(outlier.std_dev).norm();
        finding.ids = {of.net.node_id(outlier.index)};
        finding.value = distance;
        finding.std_dev = std_dev;
        finding.reason = fmt::format(
            "Support {} is {:.1f} +- {:.1f} mm from its design "
            "position. taut used the surveyed position.",
            finding.ids[0], 1e3 * distance, 1e3 * std_dev);
        finding.advice = fmt::format("Check the coordinates of support {}", finding.ids[0]);
    } else {
        finding.ids = {of.net.edge_id(outlier.index)};
        finding.value = outlier.deviation.x();
        finding.std_dev = outlier.std_dev.x();
        finding.reason = fmt::format(
            "Adjustable edge {} is {} than given. taut used the "
            "length that the survey shows.",
            finding.ids[0], longer_text(outlier.deviation.x(), outlier.std_dev.x()));
        finding.advice = fmt::format("Check the turnbuckle of edge {}", finding.ids[0]);
    }
    if (outlier.confounded_with >= 0) {
        finding.confounded_with = {is_support ? of.net.edge_id(outlier.confounded_with)
                                              : of.net.node_id(outlier.confounded_with)};
        finding.advice += fmt::format(", and {} {}: it would explain nearly as much",
                                      is_support ? "edge" : "support", finding.confounded_with[0]);
    }
    finding.advice += '.';
    of.add(std::move(finding));
}

}  // namespace

void test_prior(CheckedResult& of) {
    const PriorCheck& check = of.result.prior_check;
    const std::string used = prior_text(of.result.length_prior);
    if (of.has_mean()) {
        of.add({.kind = FindingKind::common_deviation,
                .severity = Verdict::failed,
                .value = check.mean,
                .std_dev = check.mean_std,
                .remedy = Trust::Remedy{"uncertain", ""},
                .reason = fmt::format("All lengths deviate by {:+.2f} mm in common. Chance allows "
                                      "+-{:.2f} mm.",
                                      1e3 * check.mean, 1e3 * check.mean_std),
                .advice = "Turnbuckles, stiffness, temperature, the scale of the survey or the way "
                          "of cutting can cause this. State what of it is uncertain."});
    }
    test_runs(of);
    if (of.result.contradicted_prior && of.result.prior_was_given) {
        of.add({.kind = FindingKind::prior,
                .severity = Verdict::doubtful,
                .value = of.result.length_prior.std_dev(),
                .reason = fmt::format("The lengths do not scatter as the prior given, {}, but "
                                      "as {} (log likelihood {:.0f} higher). taut used {}.",
                                      prior_text(of.result.contradicted_prior->checked), used,
                                      of.result.contradicted_prior->gain, used),
                .advice = "Check how the cables were cut."});
    } else {
        test_scale_of_prior(of);
    }
    if (check.gain > 0.0 && PriorCheck{.gain = check.gain}.is_contradicted()) {
        const std::string likeliest = prior_text(check.likeliest);
        const bool is_likeliest = check.gain > of.other_cause.gain || of.has_narrow_prior();
        // Of a few dozen lengths it is the likeliest by chance, and too sure where it is not
        // true.
        const bool is_by_chance = check.likeliest.kind == LengthPrior::Kind::bimodal &&
                                  of.result.length_prior.kind != LengthPrior::Kind::bimodal;
        Finding finding{
            .kind = FindingKind::prior,
            .severity =
                check.is_untenable() && !check.is_too_wide() ? Verdict::failed : Verdict::doubtful,
            .value = check.likeliest.std_dev(),
            .reason = fmt::format("The lengths of {} edges do not scatter as the prior {}, "
                                  "but as {} (log likelihood {:.0f} higher).",
                                  check.lengths, used, likeliest, check.gain),
            .advice = !is_likeliest  ? of.other_cause.advice()
                      : is_by_chance ? "Give a wider prior, or none. Use this one only if the "
                                       "cables were cut in two lengths."
                                     : "Use that prior."};
        if (is_likeliest && !is_by_chance) {
            finding.remedy = Trust::Remedy{"prior", likeliest};
        }
        of.add(std::move(finding));
    } else if (check.outliers > 0) {
        of.add({.kind = FindingKind::prior,
                .severity = Verdict::failed,
                .reason = fmt::format("{} lengths lie outside the prior {}: too many for single "
                                      "errors of cutting.",
                                      check.outliers, used),
                .advice = "Check the prior, the net and the frame."});
    } else if (of.has_narrow_prior()) {
        const size_t outliers = of.result.length_outliers.size();
        of.add({.kind = FindingKind::prior,
                .severity = Verdict::failed,
                .value = static_cast<double>(outliers),
                .reason = fmt::format("{} of {} lengths lie outside the prior {}. Either so many "
                                      "cables are wrong, or the prior is too narrow.",
                                      outliers, of.result.edges.size(), used),
                .advice = "Give a wider prior, or none. What is then still named is wrong."});
    }
}

void test_lengths(CheckedResult& of) {
    for (const LengthOutlier& edge : of.result.length_outliers) {
        if (edge.other < 0) {
            of.add({.kind = FindingKind::length,
                    .severity = Verdict::doubtful,
                    .ids = {of.net.edge_id(edge.edge)},
                    .value = edge.deviation,
                    .std_dev = edge.std_dev,
                    .reason = fmt::format("Edge {} than designed, which the prior does not allow. "
                                          "taut used the survey alone for it.",
                                          length_text(of, edge)),
                    .advice = "Check how this cable was cut."});
        } else if (const auto* other = other_of(of, edge); other == nullptr || other > &edge) {
            test_two_lengths(of, edge, other);
        }
    }
}

void test_boundary(CheckedResult& of) {
    if (of.result.boundary_not_released > 0) {
        of.add({.kind = FindingKind::boundary,
                .severity = of.result.boundary_not_released > a_few_of_boundary ? Verdict::failed
                                                                                : Verdict::doubtful,
                .value = of.result.boundary_not_released,
                .remedy = Trust::Remedy{"uncertain", "adjustable:3mm supports:3mm"},
                .reason = fmt::format("{} adjustable edges and supports contradict the survey, "
                                      "which does not show which of them are wrong.",
                                      of.result.boundary_not_released),
                .advice = "Check them, or state how uncertain they are."});
    }
    for (const BoundaryOutlier& outlier : of.result.boundary_outliers) {
        test_one_of_boundary(of, outlier);
    }
}

void test_elastic_supports(CheckedResult& of) {
    for (const DisplacedSupport& support : displaced_supports(of.net, of.result.uncertain)) {
        const std::string id = of.net.node_id(support.node);
        of.add({.kind = FindingKind::support,
                .severity = Verdict::doubtful,
                .ids = {id},
                .value = support.distance,
                .std_dev = support.std_dev,
                .reason = fmt::format(
                    "Elastic support {} stands {:.1f} +- {:.1f} mm from its place without load, "
                    "or its stiffness is not as given. The prior allows less.",
                    id, 1e3 * support.distance, 1e3 * support.std_dev),
                .advice = "Check where it stands without load, and how stiff it is."});
    }
}

}  // namespace taut
