// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/checked_result.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

#include "net/rounded_length.hpp"
#include "taut/net/units.hpp"

namespace taut {
namespace {

using Verdict = Trust::Verdict;
using Finding = Trust::Finding;
using FindingKind = Finding::Kind;

/// Of the targets: fewer are left out in a sound survey.
constexpr double few_outliers = 0.1;

/// The targets left out that stand next to each other, where they are most.
std::vector<std::string> largest_cluster(const CableNet& net,
                                         const std::vector<Outlier>& outliers) {
    std::vector<int> cluster(net.node_count(), -1);
    for (const Outlier& outlier : outliers) {
        cluster[outlier.node] = outlier.node;
    }
    // Each takes the least number among its neighbours, until none changes.
    for (bool has_changed = true; has_changed;) {
        has_changed = false;
        for (const auto& [s, t] : net.edges()) {
            if (cluster[s] >= 0 && cluster[t] >= 0 && cluster[s] != cluster[t]) {
                cluster[s] = cluster[t] = std::min(cluster[s], cluster[t]);
                has_changed = true;
            }
        }
    }
    const auto size_of = [&](const Outlier& outlier) {
        return std::ranges::count(cluster, cluster[outlier.node]);
    };
    const auto most = std::ranges::max_element(outliers, {}, size_of);
    std::vector<std::string> largest;
    for (int node = 0; most != outliers.end() && node < net.node_count(); ++node) {
        if (cluster[node] == cluster[most->node]) {
            largest.push_back(net.node_id(node));
        }
    }
    return largest;
}

/// Without it no standard deviation is the remedy.
constexpr std::string_view load_first =
    "Look for the missing load first: targets scatter by it, too.";

/// "along z by 0.9mm, 1.51 times the standard deviation given, 0.6mm"
std::string axis_text(const CheckedResult& of, int axis) {
    const double ratio = of.result.scales.noise_by_axis[axis].ratio;
    const double given = of.survey.noise_std(axis, of.survey.surveyed).maxCoeff();
    return fmt::format("along {} by {}, {:.2f} times the standard deviation given, {}", "xyz"[axis],
                       rounded_length(given * ratio, 3), ratio, rounded_length(given));
}

/// The remedy where the noise is not the same along all axes.
std::string each_axis(const CheckedResult& of) {
    if (of.survey.has_own_noise) {
        return "Correct these standard deviations in the survey (sx, sy, sz).";
    }
    std::vector<std::string> stds;
    for (int axis = 0; axis < 3; ++axis) {
        const double given = of.survey.noise_std(axis, of.survey.surveyed).maxCoeff();
        const double ratio = of.result.scales.noise_by_axis[axis].ratio;
        stds.push_back(ratio > 0.0 ? rounded_length(given * ratio, 3) : "not shown");
    }
    return fmt::format(
        "Give a standard deviation for each axis in the survey (sx, sy, sz); in the net's frame it "
        "shows {}.",
        fmt::join(stds, ", "));
}

void test_noise_along_axes(CheckedResult& of) {
    std::vector<std::string> texts;
    std::ranges::transform(of.noise_axes, std::back_inserter(texts),
                           [&](int axis) { return axis_text(of, axis); });
    const auto& [ratio, std_dev] = of.noise();
    of.add({.kind = FindingKind::survey_noise,
            .severity = ratio > far_too_small ? Verdict::failed : Verdict::doubtful,
            .value = ratio,
            .std_dev = std_dev,
            .reason = fmt::format("In the net's frame the survey scatters {}, and less along the "
                                  "rest. Chance allows 1 +- {:.2f}.",
                                  fmt::join(texts, ", and "), std_dev),
            .advice = of.other_cause.is_load_likeliest ? std::string(load_first)
                      : !of.is_noise_likelier()        ? of.other_cause.advice()
                                                       : each_axis(of)});
}

}  // namespace

void test_loads(CheckedResult& of) {
    const LoadCheck& check = of.result.load_check;
    if (!check.is_missing()) {
        return;
    }
    const auto newton = [](double force) {
        return fmt::format("{:.6g} N", to_digits(std::abs(force), 2));
    };
    of.add(
        {.kind = FindingKind::missing_load,
         .severity = Verdict::failed,
         .value = check.force,
         .std_dev = check.std_dev,
         .remedy = Trust::Remedy{"uncertain", ""},
         .reason = fmt::format("The survey fits better with about {} {} at each free node, besides "
                               "the loads given. Chance allows +-{}.",
                               newton(check.force), check.force > 0.0 ? "downwards" : "upwards",
                               newton(check.std_dev)),
         .advice =
             of.other_cause.is_load_likeliest
                 ? "Check loads and weights of the net, of its cables, clamps and cladding, and "
                   "the heights of supports and targets. If loads are not known, state how "
                   "uncertain that of each node is."
                 : of.other_cause.advice()});
}

void test_frame(CheckedResult& of) {
    const FrameCheck& check = of.result.frame_check;
    if (of.has_scale()) {
        of.add({.kind = FindingKind::survey_scale,
                .severity = Verdict::failed,
                .value = check.scale,
                .std_dev = check.scale_std,
                .reason = fmt::format("The survey is {:.0f} +- {:.0f} ppm {} than the net.",
                                      1e6 * std::abs(check.scale), 1e6 * check.scale_std,
                                      check.scale > 0.0 ? "larger" : "smaller"),
                .advice = "Check the scale of the instrument (ppm, prism, unit). Cables that were "
                          "measured by another tape or at another temperature look the same."});
    }
    if (check.is_moved()) {
        of.add({.kind = FindingKind::survey_frame,
                .severity = Verdict::failed,
                .value = check.translation.norm(),
                .remedy = Trust::Remedy{"frame", "auto"},
                .reason = fmt::format("The survey is shifted by {:.1f} mm and turned by {:.2f} "
                                      "mrad against the frame of the net.",
                                      1e3 * check.translation.norm(), 1e3 * check.rotation.norm()),
                .advice = "Check its control points, or let taut fit the frame."});
    }
}

void test_noise(CheckedResult& of) {
    if (!of.noise_axes.empty()) {
        test_noise_along_axes(of);
        return;
    }
    constexpr double as_computed = 1e-3;  // no instrument errs so much less than is thought
    const FoundScale& noise = of.result.scales.noise;
    const FoundScale& lengths = of.result.scales.lengths;
    if (!noise.is_contradicted()) {
        if (of.survey.is_noisy() && !(noise.ratio > 0.0 && lengths.ratio > 0.0)) {
            of.add({.kind = FindingKind::survey_noise,
                    .reason = "The survey shows too little to test its standard deviation and the "
                              "prior of the lengths."});
        }
        return;
    }
    const double given = of.survey.largest_noise_std();
    const std::string found = rounded_length(given * noise.ratio, 3);
    Finding finding{
        .kind = FindingKind::survey_noise,
        .severity = noise.ratio > far_too_small ? Verdict::failed : Verdict::doubtful,
        .value = noise.ratio,
        .std_dev = noise.std_dev,
        .reason = fmt::format("The survey scatters by {}, {:.2f} times the standard deviation "
                              "given, {}. Chance allows 1 +- {:.2f}.",
                              found, noise.ratio, rounded_length(given), noise.std_dev),
        .advice = of.other_cause.advice()};
    if (noise.ratio < as_computed) {
        finding.advice =
            "It looks computed, not measured. If it was, give no noise: taut then takes it as "
            "exact.";
    } else if (of.other_cause.is_load_likeliest) {
        finding.advice = load_first;
    } else if (of.is_noise_likelier() && noise.ratio < 1.0 && of.has_uneven_noise()) {
        finding.advice = each_axis(of);  // in common it would be too small along the others
    } else if (of.is_noise_likelier()) {
        finding.remedy = Trust::Remedy{"noise", of.survey.has_own_noise ? "estimate" : found};
        finding.advice = fmt::format(
            "{}{}",
            noise.ratio > 1.0
                ? "Check the frame, whether targets stand off the cables (offset), and whether "
                  "loads or weights are missing. If all is right: "
                : "",
            of.survey.has_own_noise ? "let taut scale the standard deviations of the file."
                                    : "use this standard deviation.");
        finding.advice[0] = static_cast<char>(std::toupper(finding.advice[0]));
    }
    of.add(std::move(finding));
}

void test_targets(CheckedResult& of) {
    // Those beside a clamp are named with it.
    const auto is_beside_clamp = [&](const Outlier& outlier) {
        return std::ranges::any_of(of.result.length_outliers, [&](const LengthOutlier& edge) {
            return edge.is_beside_target && edge.node == outlier.node;
        });
    };
    std::vector<Outlier> outliers;
    std::ranges::remove_copy_if(of.result.outliers, std::back_inserter(outliers), is_beside_clamp);
    const bool are_few = static_cast<double>(outliers.size()) <=
                         few_outliers * static_cast<double>(of.survey.surveyed.size());
    for (const Outlier& outlier : outliers) {
        constexpr double far = 10.0;  // standard deviations of the survey
        const bool is_far =
            outlier.swapped_with < 0 &&
            outlier.distance > far * of.survey.noise_std.col(outlier.node).maxCoeff();
        const bool is_at_support = of.net.is_support(outlier.node);  // an elastic one
        of.add({.kind = FindingKind::target,
                .severity = are_few && !is_at_support ? Verdict::passed : Verdict::doubtful,
                .ids = {of.net.node_id(outlier.node)},
                .value = outlier.distance,
                .reason = fmt::format("Target {} is {:.1f} mm from where all other measurements "
                                      "put it. taut left it out.",
                                      of.net.node_id(outlier.node), 1e3 * outlier.distance),
                .advice = !are_few ? "More than a tenth of the targets is left out: check frame, "
                                     "supports and standard deviation."
                          : is_at_support
                              ? "It is at an elastic support. If that stands elsewhere without "
                                "load, or its stiffness is not as given, it would look the same: "
                                "check both."
                          : is_far ? "A cable, turnbuckle, support or load at it that is not as "
                                     "designed would look the same: check them."
                                   : ""});
    }
    constexpr size_t by_chance = 3;
    std::vector<std::string> adjacent = largest_cluster(of.net, outliers);
    if (are_few && adjacent.size() > by_chance) {
        of.add({.kind = FindingKind::adjacent_targets,
                .severity = Verdict::doubtful,
                .ids = adjacent,
                .value = static_cast<double>(adjacent.size()),
                .reason = fmt::format("{} of the targets left out are next to each other: {}.",
                                      adjacent.size(), and_more(adjacent)),
                .advice = "More likely than these targets, something near them is not as designed: "
                          "check turnbuckles, supports, cables and loads there."});
    }
}

void test_prediction(CheckedResult& of) {
    constexpr double far = 10.0;          // in standard deviations of the survey
    constexpr double beyond_prior = 3.0;  // in those of the prior
    if (!of.survey.is_noisy() || of.result.residuals.size() != std::ssize(of.survey.surveyed)) {
        return;
    }
    int worst = -1;
    double largest = beyond_prior * of.result.length_prior.std_dev();
    for (size_t i = 0; i < of.survey.surveyed.size(); ++i) {
        const int node = of.survey.surveyed[i];
        const double residual = of.result.residuals(static_cast<Eigen::Index>(i));
        if (residual > largest && residual > far * of.survey.noise_std.col(node).maxCoeff() &&
            std::ranges::find(of.result.outliers, node, &Outlier::node) ==
                of.result.outliers.end()) {
            worst = node;
            largest = residual;
        }
    }
    if (worst >= 0) {
        of.add({.kind = FindingKind::predicted_form,
                .severity = Verdict::doubtful,
                .ids = {of.net.node_id(worst)},
                .value = largest,
                .reason = fmt::format("The form that follows from the lengths misses target {} by "
                                      "{:.1f} mm, {:.0f} times its standard deviation.",
                                      of.net.node_id(worst), 1e3 * largest,
                                      largest / of.survey.noise_std.col(worst).maxCoeff()),
                .advice = "Check that target, and the cables, turnbuckles and supports near it."});
    }
}

void test_places(CheckedResult& of) {
    if (of.survey.contradicted_names == 0) {
        return;
    }
    std::vector<std::string> ids;
    std::vector<std::string> names;
    for (const PlacedPoint& point : of.survey.placed) {
        const std::string& id = of.net.node_id(point.node);
        if (!point.name.empty() && point.name != id) {
            ids.push_back(id);
            names.push_back(fmt::format("{} on node {}", point.name, id));
        }
    }
    const size_t count = names.size();
    of.add({.kind = FindingKind::misplaced_names,
            .severity = Verdict::doubtful,
            .ids = std::move(ids),
            .value = static_cast<double>(count),
            .remedy = Trust::Remedy{"match", "place"},
            .reason = fmt::format("{} points lie on other nodes than their names say: {}. taut "
                                  "used the positions.",
                                  count, and_more(std::move(names))),
            .advice = "If the names are those of the net, check frame, axes and the order of the "
                      "points. If they are the surveyor's own, match by place."});
}

void test_names(CheckedResult& of) {
    for (const UnmatchedPoint& point : of.survey.unmatched) {
        if (point.reason == UnmatchedReason::far_from_its_node && point.swapped_with < 0) {
            of.add({.kind = FindingKind::target_far_from_node,
                    .severity = Verdict::doubtful,
                    .ids = {of.net.node_id(point.nearest)},
                    .value = point.distance,
                    .reason = fmt::format("Target {} is {:.3g} m from the node of its name. taut "
                                          "left it out.",
                                          of.net.node_id(point.nearest), point.distance),
                    .advice = "Check its name, and those of the others."});
        }
    }
    const auto add_pair = [&](int node, int other) {
        if (node < other) {
            of.add({.kind = FindingKind::swapped_targets,
                    .ids = {of.net.node_id(node), of.net.node_id(other)},
                    .reason = fmt::format("Targets {} and {} lie at each other's place. taut "
                                          "left out both.",
                                          of.net.node_id(node), of.net.node_id(other)),
                    .advice = "Swap their names in the survey."});
        }
    };
    for (const Outlier& outlier : of.result.outliers) {
        add_pair(outlier.node, outlier.swapped_with);
    }
    for (const UnmatchedPoint& point : of.survey.unmatched) {
        add_pair(point.nearest, point.swapped_with);
    }
}

}  // namespace taut
