// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/trust.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "identification/net_balance.hpp"
#include "identification/parameter_estimates.hpp"
#include "identification/sag_check.hpp"
#include "net/rounded_length.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/units.hpp"

namespace taut {
namespace {

using Verdict = Trust::Verdict;
using Finding = Trust::Finding;
using FindingKind = Finding::Kind;

/// By which scales a width given too small makes intervals hold less than 90 % instead of 95 %.
constexpr double far_too_small = 1.2;

/// More of the boundary that contradict the survey, and it is not single ones that are wrong.
constexpr int a_few_of_boundary = 3;

/// Of the lengths: so many outliers are named one by one only where the prior is too narrow.
constexpr double many_lengths = 5;
constexpr double many_of_lengths = 0.03;

/// Of the targets: fewer are left out in a sound survey.
constexpr double few_outliers = 0.1;

std::string and_more(std::vector<std::string> names) {
    constexpr size_t shown = 6;
    const size_t count = names.size();
    names.resize(std::min(shown, count));
    return fmt::format("{}{}", fmt::join(names, ", "),
                       count > shown ? fmt::format(" and {} more", count - shown) : "");
}

/// A prior as one would write it, without the rounding errors of its last digit.
std::string prior_text(const LengthPrior& prior) {
    const std::string exact = prior.to_string();
    return exact.substr(0, exact.find(':') + 1) + format_length(prior.scale);
}

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

/// How much likelier so many normal numbers are with a standard deviation this many times as large,
/// logarithm.
double gain_of_scale(double ratio, double count) {
    return count * (0.5 * (ratio * ratio - 1.0) - std::log(ratio));
}

/// Something else than noise or the prior of the lengths that is not as given.
struct OtherCause {
    double gain = 0.0;  ///< by which it makes the survey likelier, logarithm
    std::string name;

    [[nodiscard]] std::string advice() const {
        return fmt::format("Look at {} first: it explains more.", name);
    }
};

/// Whether the survey is of another scale, by more than is lost in its noise at the node furthest
/// out.
bool has_scale(const CableNet& net, const Survey& survey, const FrameCheck& check) {
    const Points arms = net.nodes().colwise() - net.nodes().rowwise().mean();
    const double furthest = std::abs(check.scale) * arms.colwise().norm().maxCoeff();
    return check.is_scaled() && furthest > negligible_scale * survey.rms_noise_std();
}

/// Whether so many lengths are outliers that the prior is too narrow rather than each cable wrong.
bool has_narrow_prior(const Identification& result) {
    const auto outliers = static_cast<double>(result.length_outliers.size());
    return outliers >= many_lengths &&
           outliers > many_of_lengths * static_cast<double>(result.edges.size());
}

/// (other-causes): the one that explains most.
OtherCause other_cause_of(const CableNet& net, const Survey& survey, const Identification& result) {
    const FrameCheck& frame = result.frame_check;
    OtherCause cause;
    const auto take = [&](double gain, std::string name) {
        if (gain > cause.gain) {
            cause = {gain, std::move(name)};
        }
    };
    if (has_scale(net, survey, frame)) {
        take(0.5 * std::pow(frame.scale / frame.scale_std, 2), "the scale of the survey");
    }
    if (frame.is_moved()) {
        take(0.5 * frame.motion_statistic, "the frame of the survey");
    }
    if (const LoadCheck& loads = result.load_check; loads.is_missing()) {
        take(0.5 * std::pow(loads.force / loads.std, 2), "loads and weights of the net");
    }
    if (has_narrow_prior(result)) {
        double gain = 0.0;
        for (const LengthOutlier& outlier : result.length_outliers) {
            gain += 0.5 * outlier.statistic;
        }
        take(gain, "the prior of the lengths");
    }
    for (const ParameterSpread& spread : spreads_of(result.uncertain)) {
        if (spread.is_contradicted()) {
            take(gain_of_scale(spread.ratio, spread.shown), spread.parameter.to_string());
        }
    }
    return cause;
}

/// Along which axis a survey scatters more widely than given and than along both others; -1: none.
int axis_of_noise(const std::array<FoundScale, 3>& axes) {
    constexpr double significant = 3.0;  // standard deviations
    const auto worst = std::ranges::max_element(axes, {}, &FoundScale::ratio);
    const auto k = static_cast<int>(worst - axes.begin());
    double squares = 0.0;
    double redundancy = 0.0;
    for (const FoundScale& other : {axes[(k + 1) % 3], axes[(k + 2) % 3]}) {
        if (other.std > 0.0) {
            const double count = 0.5 / (other.std * other.std);
            redundancy += count;
            squares += other.ratio * other.ratio * count;
        }
    }
    if (!(worst->ratio > 1.0) || !worst->is_contradicted() || !(redundancy > 0.0)) {
        return -1;
    }
    const double std_of_both = std::hypot(worst->std, std::sqrt(0.5 / redundancy));
    return worst->ratio > (1.0 + significant * std_of_both) * std::sqrt(squares / redundancy) ? k
                                                                                              : -1;
}

class Tests {
public:
    Tests(const CableNet& net, const Survey& survey, const Identification& result)
        : m_net(net),
          m_survey(survey),
          m_result(result),
          m_other_cause(other_cause_of(net, survey, result)),
          m_noise_axis(axis_of_noise(result.scales.noise_by_axis)) {}

    Trust run() {
        test_end();
        const bool is_noise_first = is_noise_likelier();
        if (!is_noise_first || !noise().is_contradicted()) {
            test_loads();
        }
        test_frame();
        test_elastic_supports();
        if (!is_noise_first) {
            test_uncertain();
        }
        const bool is_prior_first = !is_noise_first && has_narrow_prior(m_result);
        if (is_prior_first) {
            test_prior();
        }
        test_noise();
        if (is_noise_first && noise().is_contradicted()) {
            test_loads();
        }
        if (!is_prior_first) {
            test_prior();
        }
        test_lengths();
        test_boundary();
        test_targets();
        test_prediction();
        test_names();
        test_places();
        test_forces();
        if (is_noise_first) {
            test_uncertain();
        }
        test_draws();
        std::ranges::move(sag_findings(m_net, m_result), std::back_inserter(m_trust.findings));
        if (auto finding = net_balance_finding(m_net, m_result, m_trust.verdict())) {
            // The first to look at: what else contradicts the survey may follow from it.
            m_trust.findings.insert(m_trust.findings.begin(), *std::move(finding));
        }
        std::ranges::stable_sort(m_trust.findings, std::greater{}, &Finding::severity);
        return std::move(m_trust);
    }

private:
    void add(Finding finding) { m_trust.findings.push_back(std::move(finding)); }

    void test_end() {
        if (m_result.status != IdentificationStatus::converged) {
            add({.kind = FindingKind::no_convergence,
                 .severity = Verdict::failed,
                 .reason = m_result.message});
        }
    }

    /// (load-check)
    void test_loads() {
        const LoadCheck& check = m_result.load_check;
        if (check.is_missing()) {
            add({.kind = FindingKind::missing_load,
                 .severity = Verdict::failed,
                 .value = check.force,
                 .std = check.std,
                 .remedy = Trust::Remedy{"uncertain", ""},
                 .reason = fmt::format("The survey fits better with {:.2g} N or more {} at each "
                                       "free node, besides the loads given. Chance allows "
                                       "+-{:.2g} N.",
                                       std::abs(check.force),
                                       check.force > 0.0 ? "downwards" : "upwards", check.std),
                 .next = "Check loads and weights of the net, of its cables, clamps and cladding, "
                         "and whether targets stand off the cables (offset). If loads are not "
                         "known, state how uncertain that of each node is."});
        }
    }

    void test_frame() {
        const FrameCheck& check = m_result.frame_check;
        if (has_scale(m_net, m_survey, check)) {
            add({.kind = FindingKind::survey_scale,
                 .severity = Verdict::failed,
                 .value = check.scale,
                 .std = check.scale_std,
                 .reason = fmt::format("The survey is {:.0f} +- {:.0f} ppm {} than the net.",
                                       1e6 * std::abs(check.scale), 1e6 * check.scale_std,
                                       check.scale > 0.0 ? "larger" : "smaller"),
                 .next = "Check the scale of the instrument (ppm, prism, unit). Cables that were "
                         "measured by another tape or at another temperature look the same."});
        }
        if (check.is_moved()) {
            add({.kind = FindingKind::survey_frame,
                 .severity = Verdict::failed,
                 .value = check.translation.norm(),
                 .remedy = Trust::Remedy{"frame", "auto"},
                 .reason = fmt::format("The survey is shifted by {:.1f} mm and turned by {:.2f} "
                                       "mrad against the frame of the net.",
                                       1e3 * check.translation.norm(), 1e3 * check.rotation.norm()),
                 .next = "Check its control points, or let taut fit the frame."});
        }
    }

    /// (other-causes). The ratio of n numbers has the standard deviation 1 / sqrt(2 n).
    [[nodiscard]] bool is_noise_likelier() const {
        const auto& [ratio, std] = noise();
        return !noise().is_contradicted() ||
               gain_of_scale(ratio, 0.5 / (std * std)) > m_other_cause.gain;
    }

    /// Along one axis, where that is what is wrong.
    [[nodiscard]] const FoundScale& noise() const {
        return m_noise_axis < 0 ? m_result.scales.noise
                                : m_result.scales.noise_by_axis[m_noise_axis];
    }

    void test_noise_along_axis() {
        const auto& [ratio, std] = noise();
        const double given = m_survey.noise_std.row(m_noise_axis).maxCoeff();
        add({.kind = FindingKind::survey_noise,
             .severity = ratio > far_too_small ? Verdict::failed : Verdict::doubtful,
             .value = ratio,
             .std = std,
             .reason = fmt::format("The survey scatters along {} by {}, {:.2f} times the standard "
                                   "deviation given, {}, and less along the other axes. Chance "
                                   "allows 1 +- {:.2f}.",
                                   "xyz"[m_noise_axis], rounded_length(given * ratio, 3), ratio,
                                   rounded_length(given), std),
             .next = is_noise_likelier()
                         ? "Give a standard deviation for each axis (sx, sy, sz in the survey)."
                         : m_other_cause.advice()});
    }

    void test_noise() {
        if (m_noise_axis >= 0) {
            test_noise_along_axis();
            return;
        }
        constexpr double as_computed = 1e-3;  // no instrument errs so much less than is thought
        const FoundScale& noise = m_result.scales.noise;
        const FoundScale& lengths = m_result.scales.lengths;
        if (!noise.is_contradicted()) {
            if (m_survey.is_noisy() && !(noise.ratio > 0.0 && lengths.ratio > 0.0)) {
                add({.kind = FindingKind::survey_noise,
                     .reason = "The survey shows too little to test its standard deviation and the "
                               "prior of the lengths."});
            }
            return;
        }
        const double given = m_survey.largest_noise_std();
        const std::string found = rounded_length(given * noise.ratio, 3);
        Finding finding{
            .kind = FindingKind::survey_noise,
            .severity = noise.ratio > far_too_small ? Verdict::failed : Verdict::doubtful,
            .value = noise.ratio,
            .std = noise.std,
            .reason = fmt::format("The survey scatters by {}, {:.2f} times the standard deviation "
                                  "given, {}. Chance allows 1 +- {:.2f}.",
                                  found, noise.ratio, rounded_length(given), noise.std),
            .next = m_other_cause.advice()};
        if (noise.ratio < as_computed) {
            finding.next =
                "It looks computed, not measured. If it was, give no noise: taut then takes it as "
                "exact.";
        } else if (is_noise_likelier()) {
            finding.remedy = Trust::Remedy{"noise", m_survey.has_own_noise ? "estimate" : found};
            finding.next = fmt::format(
                "{}{}",
                noise.ratio > 1.0
                    ? "Check the frame, whether targets stand off the cables (offset), and whether "
                      "loads or weights are missing. If all is right: "
                    : "",
                m_survey.has_own_noise ? "let taut scale the standard deviations of the file."
                                       : "use this standard deviation.");
            finding.next[0] = static_cast<char>(std::toupper(finding.next[0]));
        }
        add(std::move(finding));
    }

    /// (length-trend): scales near the widest that the prior holds are more likely a prior that is
    /// too narrow.
    void test_runs() {
        constexpr double surely = 0.95;
        constexpr double widest = 1.4;  // standard deviations of the prior, at a mean edge
        const CommonDeviation& common = m_result.prior.common;
        if (common.run_probability <= surely) {
            return;
        }
        const double at_edge =
            common.run_std * m_net.unstressed_lengths()(m_net.interior_edges()).mean();
        if (at_edge > widest * m_result.length_prior.std()) {
            add({.kind = FindingKind::run_scales,
                 .severity = Verdict::doubtful,
                 .value = common.run_std,
                 .reason = fmt::format("Runs of cable differ in scale by {:.2g} %, more than the "
                                       "prior {} allows.",
                                       100.0 * common.run_std, prior_text(m_result.length_prior)),
                 .next = "The prior may be too narrow, or cables were measured by different "
                         "tapes."});
        }
    }

    /// (hyperprior): what the survey finds is cut off where the prior over scales ends.
    void test_scale_of_prior() {
        constexpr double two_standard_deviations = 1.5 * 1.5;
        const PriorEstimate& prior = m_result.prior;
        if (m_result.prior_was_given && !prior.exact &&
            prior.std > two_standard_deviations * prior.given.std()) {
            add({.kind = FindingKind::prior,
                 .severity = Verdict::doubtful,
                 .value = prior.std,
                 .reason =
                     fmt::format("The lengths scatter by +-{:.2f} mm or more. The prior "
                                 "given, {}, allows +-{:.2f} mm.",
                                 1e3 * prior.std, prior_text(prior.given), 1e3 * prior.given.std()),
                 .next = "Give a wider prior, or none."});
        }
    }

    void test_prior() {
        const PriorCheck& check = m_result.prior_check;
        const std::string used = prior_text(m_result.length_prior);
        if (check.has_mean() &&
            std::abs(check.mean) > negligible_mean * m_result.length_prior.std()) {
            add({.kind = FindingKind::common_deviation,
                 .severity = Verdict::failed,
                 .value = check.mean,
                 .std = check.mean_std,
                 .remedy = Trust::Remedy{"uncertain", ""},
                 .reason = fmt::format("All lengths deviate by {:+.2f} mm in common. Chance allows "
                                       "+-{:.2f} mm.",
                                       1e3 * check.mean, 1e3 * check.mean_std),
                 .next = "Turnbuckles, stiffness, temperature, the scale of the survey or the way "
                         "of cutting can cause this. State what of it is uncertain."});
        }
        test_runs();
        if (m_result.contradicted_prior && m_result.prior_was_given) {
            add({.kind = FindingKind::prior,
                 .severity = Verdict::doubtful,
                 .value = m_result.length_prior.std(),
                 .reason = fmt::format("The lengths do not scatter as the prior given, {}, but "
                                       "as {} (log likelihood {:.0f} higher). taut used {}.",
                                       prior_text(m_result.contradicted_prior->checked), used,
                                       m_result.contradicted_prior->gain, used),
                 .next = "Check how the cables were cut."});
        } else {
            test_scale_of_prior();
        }
        if (check.gain > 0.0 && PriorCheck{.gain = check.gain}.is_contradicted()) {
            const std::string likeliest = prior_text(check.likeliest);
            const bool is_likeliest = check.gain > m_other_cause.gain || has_narrow_prior(m_result);
            // Of a few dozen lengths it is the likeliest by chance, and too sure where it is not
            // true.
            const bool is_by_chance = check.likeliest.kind == LengthPrior::Kind::bimodal &&
                                      m_result.length_prior.kind != LengthPrior::Kind::bimodal;
            Finding finding{
                .kind = FindingKind::prior,
                .severity = check.is_untenable() && !check.is_too_wide() ? Verdict::failed
                                                                         : Verdict::doubtful,
                .value = check.likeliest.std(),
                .reason = fmt::format("The lengths of {} edges do not scatter as the prior {}, "
                                      "but as {} (log likelihood {:.0f} higher).",
                                      check.lengths, used, likeliest, check.gain),
                .next = !is_likeliest  ? m_other_cause.advice()
                        : is_by_chance ? "Give a wider prior, or none. Use this one only if the "
                                         "cables were cut in two lengths."
                                       : "Use that prior."};
            if (is_likeliest && !is_by_chance) {
                finding.remedy = Trust::Remedy{"prior", likeliest};
            }
            add(std::move(finding));
        } else if (check.outliers > 0) {
            add({.kind = FindingKind::prior,
                 .severity = Verdict::failed,
                 .reason = fmt::format("{} lengths lie outside the prior {}: too many for single "
                                       "errors of cutting.",
                                       check.outliers, used),
                 .next = "Check the prior, the net and the frame."});
        } else if (has_narrow_prior(m_result)) {
            const size_t outliers = m_result.length_outliers.size();
            add({.kind = FindingKind::prior,
                 .severity = Verdict::failed,
                 .value = static_cast<double>(outliers),
                 .reason = fmt::format("{} of {} lengths lie outside the prior {}. Either so many "
                                       "cables are wrong, or the prior is too narrow.",
                                       outliers, m_result.edges.size(), used),
                 .next = "Give a wider prior, or none. What is then still named is wrong."});
        }
    }

    void test_lengths() {
        for (const LengthOutlier& edge : m_result.length_outliers) {
            if (edge.other < 0) {
                add({.kind = FindingKind::length,
                     .severity = Verdict::doubtful,
                     .ids = {m_net.edge_id(edge.edge)},
                     .value = edge.deviation,
                     .std = edge.std,
                     .reason = fmt::format("Edge {} than designed, which the prior does not allow. "
                                           "taut used the survey alone for it.",
                                           length_text(edge)),
                     .next = "Check how this cable was cut."});
            } else if (const auto* other = other_of(edge); other == nullptr || other > &edge) {
                test_two_lengths(edge, other);
            }
        }
    }

    [[nodiscard]] const LengthOutlier* other_of(const LengthOutlier& edge) const {
        const auto found =
            std::ranges::find(m_result.length_outliers, edge.other, &LengthOutlier::edge);
        return found == m_result.length_outliers.end() ? nullptr : &*found;
    }

    /// "12 is 5.1 +- 0.4 mm longer"
    [[nodiscard]] std::string length_text(const LengthOutlier& edge) const {
        const auto found = std::ranges::find(m_result.edges, edge.edge, &IdentifiedEdge::edge);
        const bool is_slack = found != m_result.edges.end() && found->status == EdgeStatus::slack;
        return fmt::format("{} is {}{}", m_net.edge_id(edge.edge), is_slack ? "slack and " : "",
                           longer_text(edge.deviation, edge.std, is_slack ? "at least " : ""));
    }

    static std::string longer_text(double deviation, double std, std::string_view bound = "") {
        return fmt::format("{}{:.1f} +- {:.1f} mm {}", bound, 1e3 * std::abs(deviation), 1e3 * std,
                           deviation < 0.0 ? "shorter" : "longer");
    }

    /// (slip), (swap)
    /// @param other null where it is an adjustable edge, which is named by itself
    void test_two_lengths(const LengthOutlier& one, const LengthOutlier* other) {
        const std::string both =
            fmt::format("edge {}, edge {}", length_text(one),
                        other == nullptr ? m_net.edge_id(one.other) : length_text(*other));
        Finding finding{.kind = one.is_swapped ? FindingKind::swapped_cables : FindingKind::slip,
                        .severity = Verdict::doubtful,
                        .ids = {m_net.edge_id(one.edge), m_net.edge_id(one.other)},
                        .value = one.deviation,
                        .std = one.std};
        const std::string& node = one.node < 0 ? std::string() : m_net.node_id(one.node);
        if (one.is_swapped) {
            finding.reason = fmt::format(
                "Two cables have each other's length: {}. taut used the "
                "survey alone for both.",
                both);
            finding.next = "Check whether they were swapped.";
        } else if (one.is_beside_target) {
            finding.confounded_with = {node};
            finding.reason = fmt::format(
                "Either the target of node {} is wrong, or a clamp "
                "slipped there: {}. taut left out the target; the "
                "intervals of both edges hold either way.",
                node, both);
            finding.next = "Check the clamp and the target.";
        } else {
            finding.reason = fmt::format(
                "A clamp slipped at node {}: {}. taut used the survey "
                "alone for both.",
                node, both);
            finding.next = "Check the clamp.";
        }
        add(std::move(finding));
    }

    void test_boundary() {
        if (m_result.boundary_not_released > 0) {
            add({.kind = FindingKind::boundary,
                 .severity = m_result.boundary_not_released > a_few_of_boundary ? Verdict::failed
                                                                                : Verdict::doubtful,
                 .value = m_result.boundary_not_released,
                 .remedy = Trust::Remedy{"uncertain", "adjustable:3mm supports:3mm"},
                 .reason = fmt::format("{} adjustable edges and supports contradict the survey, "
                                       "which does not show which of them are wrong.",
                                       m_result.boundary_not_released),
                 .next = "Check them, or state how uncertain they are."});
        }
        for (const BoundaryOutlier& outlier : m_result.boundary_outliers) {
            test_one_of_boundary(outlier);
        }
    }

    void test_one_of_boundary(const BoundaryOutlier& outlier) {
        const bool is_support = outlier.kind == BoundaryOutlier::Kind::support;
        Finding finding{.kind = is_support ? FindingKind::support : FindingKind::adjustable_edge,
                        .severity = Verdict::doubtful};
        if (is_support) {
            const double distance = outlier.deviation.norm();
            const double std = outlier.deviation.normalized().cwiseProduct(outlier.std).norm();
            finding.ids = {m_net.node_id(outlier.index)};
            finding.value = distance;
            finding.std = std;
            finding.reason = fmt::format(
                "Support {} is {:.1f} +- {:.1f} mm from its design "
                "position. taut used the surveyed position.",
                finding.ids[0], 1e3 * distance, 1e3 * std);
            finding.next = fmt::format("Check the coordinates of support {}", finding.ids[0]);
        } else {
            finding.ids = {m_net.edge_id(outlier.index)};
            finding.value = outlier.deviation.x();
            finding.std = outlier.std.x();
            finding.reason = fmt::format(
                "Adjustable edge {} is {} than given. taut used the "
                "length that the survey shows.",
                finding.ids[0], longer_text(outlier.deviation.x(), outlier.std.x()));
            finding.next = fmt::format("Check the turnbuckle of edge {}", finding.ids[0]);
        }
        if (outlier.confounded_with >= 0) {
            finding.confounded_with = {is_support ? m_net.edge_id(outlier.confounded_with)
                                                  : m_net.node_id(outlier.confounded_with)};
            finding.next +=
                fmt::format(", and {} {}: it would explain nearly as much",
                            is_support ? "edge" : "support", finding.confounded_with[0]);
        }
        finding.next += '.';
        add(std::move(finding));
    }

    void test_targets() {
        // Those beside a clamp are named with it.
        const auto is_beside_clamp = [this](const Outlier& outlier) {
            return std::ranges::any_of(m_result.length_outliers, [&](const LengthOutlier& edge) {
                return edge.is_beside_target && edge.node == outlier.node;
            });
        };
        std::vector<Outlier> outliers;
        std::ranges::remove_copy_if(m_result.outliers, std::back_inserter(outliers),
                                    is_beside_clamp);
        const bool are_few = static_cast<double>(outliers.size()) <=
                             few_outliers * static_cast<double>(m_survey.surveyed.size());
        for (const Outlier& outlier : outliers) {
            constexpr double far = 10.0;  // standard deviations of the survey
            const bool is_far =
                outlier.swapped_with < 0 &&
                outlier.distance > far * m_survey.noise_std.col(outlier.node).maxCoeff();
            const bool is_at_support = m_net.is_support(outlier.node);  // an elastic one
            add({.kind = FindingKind::target,
                 .severity = are_few && !is_at_support ? Verdict::passed : Verdict::doubtful,
                 .ids = {m_net.node_id(outlier.node)},
                 .value = outlier.distance,
                 .reason = fmt::format("Target {} is {:.1f} mm from where all other measurements "
                                       "put it. taut left it out.",
                                       m_net.node_id(outlier.node), 1e3 * outlier.distance),
                 .next = !are_few ? "More than a tenth of the targets is left out: check frame, "
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
        std::vector<std::string> adjacent = largest_cluster(m_net, outliers);
        if (are_few && adjacent.size() > by_chance) {
            add({.kind = FindingKind::adjacent_targets,
                 .severity = Verdict::doubtful,
                 .ids = adjacent,
                 .value = static_cast<double>(adjacent.size()),
                 .reason = fmt::format("{} of the targets left out are next to each other: {}.",
                                       adjacent.size(), and_more(adjacent)),
                 .next = "More likely than these targets, something near them is not as designed: "
                         "check turnbuckles, supports, cables and loads there."});
        }
    }

    /// Where cables stretch by less than their lengths are known to, the form of the mean lengths
    /// may be off by the width of the prior; not by far more.
    void test_prediction() {
        constexpr double far = 10.0;          // in standard deviations of the survey
        constexpr double beyond_prior = 3.0;  // in those of the prior
        if (!m_survey.is_noisy() || m_result.residuals.size() != std::ssize(m_survey.surveyed)) {
            return;
        }
        int worst = -1;
        double largest = beyond_prior * m_result.length_prior.std();
        for (size_t i = 0; i < m_survey.surveyed.size(); ++i) {
            const int node = m_survey.surveyed[i];
            const double residual = m_result.residuals(static_cast<Eigen::Index>(i));
            if (residual > largest && residual > far * m_survey.noise_std.col(node).maxCoeff() &&
                std::ranges::find(m_result.outliers, node, &Outlier::node) ==
                    m_result.outliers.end()) {
                worst = node;
                largest = residual;
            }
        }
        if (worst >= 0) {
            add({.kind = FindingKind::predicted_form,
                 .severity = Verdict::doubtful,
                 .ids = {m_net.node_id(worst)},
                 .value = largest,
                 .reason = fmt::format("The form that follows from the lengths misses target {} by "
                                       "{:.1f} mm, {:.0f} times its standard deviation.",
                                       m_net.node_id(worst), 1e3 * largest,
                                       largest / m_survey.noise_std.col(worst).maxCoeff()),
                 .next = "Check that target, and the cables, turnbuckles and supports near it."});
        }
    }

    /// Points whose names are other nodes' than those that they lie on.
    void test_places() {
        if (m_survey.contradicted_names == 0) {
            return;
        }
        std::vector<std::string> ids;
        std::vector<std::string> names;
        for (const PlacedPoint& point : m_survey.placed) {
            const std::string& id = m_net.node_id(point.node);
            if (!point.name.empty() && point.name != id) {
                ids.push_back(id);
                names.push_back(fmt::format("{} on node {}", point.name, id));
            }
        }
        const size_t count = names.size();
        add({.kind = FindingKind::misplaced_names,
             .severity = Verdict::doubtful,
             .ids = std::move(ids),
             .value = static_cast<double>(count),
             .remedy = Trust::Remedy{"match", "place"},
             .reason = fmt::format("{} points lie on other nodes than their names say: {}. taut "
                                   "used the positions.",
                                   count, and_more(std::move(names))),
             .next = "If the names are those of the net, check frame, axes and the order of the "
                     "points. If they are the surveyor's own, match by place."});
    }

    void test_names() {
        for (const UnmatchedPoint& point : m_survey.unmatched) {
            if (point.reason == UnmatchedReason::far_from_its_node && point.swapped_with < 0) {
                add({.kind = FindingKind::target_far_from_node,
                     .severity = Verdict::doubtful,
                     .ids = {m_net.node_id(point.nearest)},
                     .value = point.distance,
                     .reason = fmt::format("Target {} is {:.3g} m from the node of its name. taut "
                                           "left it out.",
                                           m_net.node_id(point.nearest), point.distance),
                     .next = "Check its name, and those of the others."});
            }
        }
        const auto add_pair = [&](int node, int other) {
            if (node < other) {
                add({.kind = FindingKind::swapped_targets,
                     .ids = {m_net.node_id(node), m_net.node_id(other)},
                     .reason = fmt::format("Targets {} and {} lie at each other's place. taut "
                                           "left out both.",
                                           m_net.node_id(node), m_net.node_id(other)),
                     .next = "Swap their names in the survey."});
            }
        };
        for (const Outlier& outlier : m_result.outliers) {
            add_pair(outlier.node, outlier.swapped_with);
        }
        for (const UnmatchedPoint& point : m_survey.unmatched) {
            add_pair(point.nearest, point.swapped_with);
        }
    }

    void test_forces() {
        std::vector<std::string> marks;
        for (const auto* edges : {&m_result.contradicted_taut, &m_result.contradicted_slack}) {
            std::ranges::transform(*edges, std::back_inserter(marks),
                                   [&](int edge) { return m_net.edge_id(edge); });
        }
        if (!marks.empty()) {
            add({.kind = FindingKind::slack_marks,
                 .severity = Verdict::doubtful,
                 .ids = marks,
                 .reason = fmt::format("Edges marked as slack or taut contradict the survey: {}. "
                                       "taut ignored all marks.",
                                       and_more(marks)),
                 .next = "Look at those edges again."});
        }
        if (m_result.force_bias) {
            add({.kind = FindingKind::force_scale,
                 .severity = Verdict::doubtful,
                 .value = m_result.force_bias->part,
                 .std = m_result.force_bias->std,
                 .reason = fmt::format("All force measurements are off by the same part, {:+.0f} "
                                       "%. taut used none of them.",
                                       1e2 * m_result.force_bias->part),
                 .next = "Check their unit and calibration."});
            return;
        }
        for (const ForceOutlier& outlier : m_result.force_outliers) {
            add({.kind = FindingKind::force_measurement,
                 .ids = {m_net.edge_id(outlier.edge)},
                 .value = outlier.measured - outlier.expected,
                 .reason = fmt::format("The force {} edge {} is {:.2f} kN, where {:.2f} kN is "
                                       "expected. taut left it out.",
                                       outlier.source == ForceSource::load_cell ? "measured in"
                                       : outlier.source == ForceSource::sag     ? "by the sag of"
                                                                            : "by the frequency of",
                                       m_net.edge_id(outlier.edge), 1e-3 * outlier.measured,
                                       1e-3 * outlier.expected),
                 .next = source_hint(outlier)});
        }
    }

    void test_elastic_supports() {
        for (const DisplacedSupport& support : displaced_supports(m_net, m_result.uncertain)) {
            const std::string id = m_net.node_id(support.node);
            add({.kind = FindingKind::support,
                 .severity = Verdict::doubtful,
                 .ids = {id},
                 .value = support.distance,
                 .std = support.std,
                 .reason = fmt::format(
                     "Elastic support {} stands {:.1f} +- {:.1f} mm from its place without load, "
                     "or its stiffness is not as given. The prior allows less.",
                     id, 1e3 * support.distance, 1e3 * support.std),
                 .next = "Check where it stands without load, and how stiff it is."});
        }
    }

    void test_uncertain() {
        for (const ParameterSpread& spread : spreads_of(m_result.uncertain)) {
            if (spread.is_contradicted()) {
                const double ratio = spread.ratio * spread.widening;
                // parse_uncertain_parameter() takes no more
                const double widest_part =
                    spread.parameter.kind == UncertainParameter::Kind::creep ? most_creep : 0.3;
                UncertainParameter wider = spread.parameter;
                wider.std = to_digits(ratio * wider.std, 2);
                const std::string group = wider.group.empty() ? std::string() : "@" + wider.group;
                const bool is_metric = wider.kind == UncertainParameter::Kind::adjustable ||
                                       wider.kind == UncertainParameter::Kind::supports ||
                                       wider.kind == UncertainParameter::Kind::temperature ||
                                       wider.kind == UncertainParameter::Kind::loads_each;
                const bool is_of_known_loads = wider.kind == UncertainParameter::Kind::test_loads;
                add({.kind = FindingKind::uncertain_parameter,
                     .severity = Verdict::failed,
                     .ids = {std::string(wider.name()) + group},
                     .value = ratio,
                     .remedy = Trust::Remedy{"uncertain", is_metric || wider.std < widest_part
                                                              ? wider.to_string()
                                                              : ""},
                     .reason = fmt::format("The survey shows {:.1f} times the standard deviation "
                                           "assumed of {}.",
                                           ratio, spread.parameter.to_string()),
                     .next =
                         is_of_known_loads
                             ? "Check the loads that hung on the net: their sign, unit and nodes."
                             : "Check it on site, or assume a larger one."});
            }
        }
    }

    void test_draws() {
        if (m_result.draws && m_result.drawn.tensions.empty()) {
            add({.kind = FindingKind::tensions,
                 .severity = Verdict::doubtful,
                 .reason = fmt::format("Tensions are not reported: {}.", m_result.draws->reason),
                 .next = "Lengths may be used, tensions not."});
        }
    }

    const CableNet& m_net;
    const Survey& m_survey;
    const Identification& m_result;
    OtherCause m_other_cause;
    int m_noise_axis;
    Trust m_trust;
};

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
    return next.empty() ? reason : reason + " " + next;
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
    return Tests(net, survey, result).run();
}

}  // namespace taut
