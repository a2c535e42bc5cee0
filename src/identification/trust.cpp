// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/trust.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "net/rounded_length.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/units.hpp"

namespace taut {
namespace {

using Verdict = Trust::Verdict;

/// By which scales a width told too small makes intervals hold less than 90 % instead of 95 %.
constexpr double far_too_small = 1.2;

/// More of the boundary that contradict the survey, and it is not single ones that are wrong.
constexpr int a_few_of_boundary = 3;

/// Of the targets: fewer are left out in a sound survey.
constexpr double few_outliers = 0.1;

std::string and_more(std::vector<std::string> names) {
    constexpr size_t shown = 6;
    const size_t count = names.size();
    names.resize(std::min(shown, count));
    return fmt::format("{}{}", fmt::join(names, ", "),
                       count > shown ? fmt::format(" and {} more", count - shown) : "");
}

/// A law as one would tell it, without the rounding errors of its last digit.
std::string law_text(const LengthLaw& law) {
    const std::string exact = law.to_string();
    return exact.substr(0, exact.find(':') + 1) + format_length(law.scale);
}

/// The largest number of targets left out that stand next to each other.
size_t largest_cluster(const CableNet& net, const std::vector<Outlier>& outliers) {
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
    size_t largest = 0;
    for (const Outlier& outlier : outliers) {
        largest = std::max(largest,
                           static_cast<size_t>(std::ranges::count(cluster, cluster[outlier.node])));
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
        return fmt::format("look at {} first: it explains more", name);
    }
};

/// Whether the survey is of another scale, by more than is lost in its noise at the node furthest
/// out.
bool has_scale(const CableNet& net, const Survey& survey, const FrameCheck& check) {
    const Points arms = net.nodes().colwise() - net.nodes().rowwise().mean();
    const double furthest = std::abs(check.scale) * arms.colwise().norm().maxCoeff();
    return check.is_scaled() && furthest > negligible_scale * survey.rms_noise_std();
}

/// (rival-causes): the one that explains most.
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
    for (const UnknownSpread& spread : spreads_of(result.unknowns)) {
        if (spread.is_contradicted()) {
            take(gain_of_scale(spread.ratio, spread.count), spread.unknown.to_string());
        }
    }
    return cause;
}

class Tests {
public:
    Tests(const CableNet& net, const Survey& survey, const Identification& result)
        : m_net(net),
          m_survey(survey),
          m_result(result),
          m_other_cause(other_cause_of(net, survey, result)) {}

    Trust run() {
        test_end();
        test_frame();
        const bool is_noise_first = is_noise_likelier();
        if (!is_noise_first) {
            test_unknowns();
        }
        test_noise();
        test_law();
        test_lengths();
        test_boundary();
        test_targets();
        test_prediction();
        test_names();
        test_places();
        test_forces();
        if (is_noise_first) {
            test_unknowns();
        }
        test_draws();
        std::ranges::stable_sort(m_trust.findings, std::greater{}, &Trust::Finding::verdict);
        return std::move(m_trust);
    }

private:
    void add(Verdict verdict, std::string reason, std::string next = {}) {
        m_trust.findings.push_back({verdict, std::move(reason), std::move(next)});
    }

    void test_end() {
        if (m_result.status != IdentificationStatus::converged) {
            add(Verdict::failed, m_result.message);
        }
    }

    void test_frame() {
        const FrameCheck& check = m_result.frame_check;
        if (has_scale(m_net, m_survey, check)) {
            add(Verdict::failed,
                std::abs(check.scale) < 2e-4
                    ? fmt::format("the survey is {:+.0f} +- {:.0f} ppm larger than the net",
                                  1e6 * check.scale, 1e6 * check.scale_std)
                    : fmt::format("the survey is {:.5f} +- {:.5f} times as large as the net",
                                  1.0 + check.scale, check.scale_std),
                "check the instrument's scale (ppm, prism, unit); lengths cut by another measure, "
                "or a temperature, do the same");
        }
        if (check.is_moved()) {
            add(Verdict::failed,
                fmt::format("the survey lies {:.1f} mm off the frame that was told, and turned by "
                            "{:.2f} mrad",
                            1e3 * check.translation.norm(), 1e3 * check.rotation.norm()),
                "identify again without --frame net");
        }
    }

    /// (rival-causes). The ratio of n numbers has the standard deviation 1 / sqrt(2 n).
    [[nodiscard]] bool is_noise_likelier() const {
        const FoundScale& noise = m_result.scales.noise;
        return !noise.is_contradicted() ||
               gain_of_scale(noise.ratio, 0.5 / (noise.std * noise.std)) > m_other_cause.gain;
    }

    void test_noise() {
        const FoundScale& noise = m_result.scales.noise;
        const FoundScale& lengths = m_result.scales.lengths;
        if (m_survey.is_noisy() && !(noise.ratio > 0.0 && lengths.ratio > 0.0)) {
            add(Verdict::passed, "the survey shows too little to test noise and law");
        }
        if (!noise.is_contradicted()) {
            return;
        }
        const double told = m_survey.largest_noise_std();
        const std::string found = rounded_length(told * noise.ratio, 3);
        const std::string again =
            m_survey.tells_noise
                ? "identify again with --noise estimate, by which that of the file is multiplied"
                : fmt::format("identify again with --noise {}", found);
        add(noise.ratio > far_too_small ? Verdict::failed : Verdict::doubtful,
            fmt::format("the noise told, {}, is contradicted: the survey shows {}, {:.2f} times "
                        "that, where chance gives 1 +- {:.2f}",
                        rounded_length(told), found, noise.ratio, noise.std),
            !is_noise_likelier() ? m_other_cause.advice()
            : noise.ratio > 1.0
                ? "if the frame is right, and no target stands off the cables (--offset), " + again
                : again);
    }

    /// (length-trend): scales near the widest that the prior holds are more likely a prior that is
    /// too narrow.
    void test_runs() {
        constexpr double surely = 0.95;
        constexpr double widest = 1.4;  // standard deviations of the law, at an edge of mean length
        const CommonDeviation& common = m_result.prior.common;
        if (common.run_probability <= surely) {
            return;
        }
        const double at_edge =
            common.run_std * m_net.unstressed_lengths()(m_net.interior_edges()).mean();
        if (at_edge > widest * m_result.law.std()) {
            add(Verdict::doubtful,
                fmt::format(
                    "runs of cable differ by scales of {:.2g} %, which is more than the law "
                    "{} lets expect",
                    100.0 * common.run_std, law_text(m_result.law)),
                "the law may be too narrow, or cables were measured by different tapes");
        }
    }

    /// (hyperprior): what the survey finds is cut off where the prior over scales ends.
    void test_scale_of_prior() {
        constexpr double two_standard_deviations = 1.5 * 1.5;
        const PriorEstimate& prior = m_result.prior;
        if (m_result.law_was_told && !prior.exact &&
            prior.std > two_standard_deviations * prior.given.std()) {
            add(Verdict::doubtful,
                fmt::format(
                    "the lengths scatter with a standard deviation of {:.2f} mm or more, the "
                    "prior that was given, {}, allows {:.2f} mm",
                    1e3 * prior.std, law_text(prior.given), 1e3 * prior.given.std()),
                "give a wider prior, or none");
        }
    }

    void test_law() {
        const LawCheck& check = m_result.law_check;
        const std::string told = law_text(m_result.law);
        if (check.has_mean() && std::abs(check.mean) > negligible_mean * m_result.law.std()) {
            add(Verdict::failed,
                fmt::format("the lengths deviate by {:+.2f} mm in common, where the law {} gives 0 "
                            "+- {:.2f} mm",
                            1e3 * check.mean, told, 1e3 * check.mean_std),
                "wrong turnbuckles, stiffness, temperature, scale of the survey or way of cutting "
                "do that: tell what is not known by --uncertain (adjustable, stiffness, "
                "temperature)");
        }
        test_runs();
        if (m_result.contradicted_law && m_result.law_was_told) {
            add(Verdict::doubtful,
                fmt::format("the law told, {}, is contradicted (log likelihood {:.0f} lower): "
                            "lengths and intervals are by {}, which the survey shows",
                            law_text(m_result.contradicted_law->checked),
                            m_result.contradicted_law->gain, told),
                "is that how the edges were cut?");
        } else {
            test_scale_of_prior();
        }
        if (check.gain > 0.0 && LawCheck{.gain = check.gain}.is_contradicted()) {
            const std::string likeliest = law_text(check.likeliest);
            add(check.is_untenable() && !check.is_too_wide() ? Verdict::failed : Verdict::doubtful,
                fmt::format("the law {} is contradicted: {} lengths show {} (log likelihood "
                            "{:.0f} higher)",
                            told, check.lengths, likeliest, check.gain),
                check.gain > m_other_cause.gain
                    ? fmt::format("identify again with --law {}", likeliest)
                    : m_other_cause.advice());
        } else if (check.beyond > 0) {
            add(Verdict::failed,
                fmt::format("{} edges are beyond the law {}: too many to be mis-cut", check.beyond,
                            told),
                "are law, net and frame right?");
        }
    }

    void test_lengths() {
        if (m_result.lengths_beyond_law.empty()) {
            return;
        }
        std::vector<std::string> names;
        for (const LengthOutlier& edge : m_result.lengths_beyond_law) {
            if (edge.other < 0) {
                names.push_back(length_text(edge));
            } else if (const auto* other = other_of(edge); other == nullptr || other > &edge) {
                test_two_lengths(edge, other);
            }
        }
        const size_t count = names.size();
        if (count == 0) {
            return;
        }
        add(Verdict::doubtful,
            fmt::format("{} beyond the law of lengths: {}",
                        count == 1 ? "an edge is" : fmt::format("{} edges are", count),
                        and_more(std::move(names))),
            "mis-cut, most likely: look at them. Their intervals are by the survey alone");
    }

    [[nodiscard]] const LengthOutlier* other_of(const LengthOutlier& edge) const {
        const auto found =
            std::ranges::find(m_result.lengths_beyond_law, edge.other, &LengthOutlier::edge);
        return found == m_result.lengths_beyond_law.end() ? nullptr : &*found;
    }

    [[nodiscard]] std::string length_text(const LengthOutlier& edge) const {
        const auto found = std::ranges::find(m_result.edges, edge.edge, &IdentifiedEdge::edge);
        const bool is_slack = found != m_result.edges.end() && found->status == EdgeStatus::slack;
        return fmt::format("{} ({:+.1f} +- {:.1f} mm{})", m_net.edge_id(edge.edge),
                           1e3 * edge.deviation, 1e3 * edge.std,
                           is_slack ? " or longer: it is slack" : "");
    }

    /// (slip), (swap)
    /// @param other null where it is an adjustable edge, which is named by itself
    void test_two_lengths(const LengthOutlier& one, const LengthOutlier* other) {
        const std::string both =
            fmt::format("{} and {}", length_text(one),
                        other == nullptr ? m_net.edge_id(one.other) : length_text(*other));
        if (one.is_swapped) {
            add(Verdict::doubtful, fmt::format("two edges have each other's length: {}", both),
                "swapped, most likely: look at them. Their intervals are by the survey alone");
        } else if (one.is_beside_target) {
            add(Verdict::doubtful,
                fmt::format("the target of {} is wrong, or a clamp slipped there: {} if the target "
                            "is right",
                            m_net.node_id(one.node), both),
                "the survey does not show which: look there. The target is left out, and the "
                "intervals of both edges hold either way");
        } else {
            add(Verdict::doubtful,
                fmt::format("a clamp slipped at {}, one edge there is longer, the other shorter: "
                            "{}",
                            m_net.node_id(one.node), both),
                "look at it. Their intervals are by the survey alone");
        }
    }

    void test_boundary() {
        if (m_result.boundary_beyond > 0) {
            add(m_result.boundary_beyond > a_few_of_boundary ? Verdict::failed : Verdict::doubtful,
                fmt::format("{} adjustable edges and supports contradict the survey, and it does "
                            "not show which is wrong",
                            m_result.boundary_beyond),
                "tell what is not known of them: --uncertain adjustable:3mm, --uncertain "
                "supports:3mm");
        }
        if (m_result.boundary_outliers.empty()) {
            return;
        }
        std::vector<std::string> names;
        names.reserve(m_result.boundary_outliers.size());
        for (const BoundaryOutlier& outlier : m_result.boundary_outliers) {
            names.push_back(boundary_text(outlier));
        }
        const size_t count = names.size();
        add(Verdict::doubtful,
            fmt::format("{} not as told: {}",
                        count == 1 ? "of the boundary one is"
                                   : fmt::format("of the boundary {} are", count),
                        and_more(std::move(names))),
            "look at them: their lengths and places are told by the survey alone");
    }

    [[nodiscard]] std::string boundary_text(const BoundaryOutlier& outlier) const {
        if (outlier.kind == BoundaryOutlier::Kind::support) {
            return fmt::format(
                "support {} ({:.1f} mm off{})", m_net.node_id(outlier.index),
                1e3 * outlier.deviation.norm(),
                outlier.rival < 0 ? "" : fmt::format(", or edge {}", m_net.edge_id(outlier.rival)));
        }
        return fmt::format(
            "edge {} ({:+.1f} +- {:.1f} mm{})", m_net.edge_id(outlier.index),
            1e3 * outlier.deviation.x(), 1e3 * outlier.std.x(),
            outlier.rival < 0 ? "" : fmt::format(", or support {}", m_net.node_id(outlier.rival)));
    }

    void test_targets() {
        // Those beside a clamp are named with it.
        const auto is_beside_clamp = [this](const Outlier& outlier) {
            return std::ranges::any_of(m_result.lengths_beyond_law, [&](const LengthOutlier& edge) {
                return edge.is_beside_target && edge.node == outlier.node;
            });
        };
        std::vector<Outlier> outliers;
        std::ranges::remove_copy_if(m_result.outliers, std::back_inserter(outliers),
                                    is_beside_clamp);
        if (outliers.empty()) {
            return;
        }
        std::vector<std::string> names;
        names.reserve(outliers.size());
        for (const Outlier& outlier : outliers) {
            names.push_back(fmt::format(
                "{} ({:.1f} mm{})", m_net.node_id(outlier.node), 1e3 * outlier.distance,
                outlier.swapped_with < 0
                    ? ""
                    : fmt::format(", swapped with {}", m_net.node_id(outlier.swapped_with))));
        }
        const size_t count = names.size();
        constexpr double far = 10.0;  // standard deviations of the survey
        const bool is_far = std::ranges::any_of(outliers, [&](const Outlier& outlier) {
            return outlier.swapped_with < 0 &&
                   outlier.distance > far * m_survey.noise_std.col(outlier.node).maxCoeff();
        });
        const bool is_few = static_cast<double>(count) <=
                            few_outliers * static_cast<double>(m_survey.surveyed.size());
        add(is_few ? Verdict::passed : Verdict::doubtful,
            fmt::format(
                "{} all others and {} left out: {}",
                count == 1 ? "a target contradicts" : fmt::format("{} targets contradict", count),
                count == 1 ? "is" : "are", and_more(std::move(names))),
            !is_few  ? "are frame, supports and noise right?"
            : is_far ? "taut cannot tell a wrong target from a cable, turnbuckle or support at it "
                       "that is "
                       "not as given: look there"
                     : "");
        constexpr size_t by_chance = 3;
        if (const size_t cluster = largest_cluster(m_net, outliers);
            is_few && cluster > by_chance) {
            add(Verdict::doubtful,
                fmt::format("{} of the targets that are left out stand next to each other",
                            cluster),
                "rather than these, something near them is not as told: turnbuckles, supports or "
                "cables there");
        }
    }

    /// Where cables stretch by less than their lengths are known to, the form of the mean lengths
    /// may be off by the law's width; not by far more.
    void test_prediction() {
        constexpr double far = 10.0;        // in standard deviations of the noise
        constexpr double beyond_law = 3.0;  // in those of the law
        if (!m_survey.is_noisy() || m_result.residuals.size() != std::ssize(m_survey.surveyed)) {
            return;
        }
        int worst = -1;
        double largest = beyond_law * m_result.law.std();
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
            add(Verdict::doubtful,
                fmt::format("the form that follows from the lengths is {:.1f} mm from target {}, "
                            "{:.0f} times its noise",
                            1e3 * largest, m_net.node_id(worst),
                            largest / m_survey.noise_std.col(worst).maxCoeff()),
                "that target is wrong, or a cable, turnbuckle or support near it");
        }
    }

    /// Points whose names are other nodes' than those that they lie on.
    void test_places() {
        if (m_survey.contradicted_names == 0) {
            return;
        }
        std::vector<std::string> names;
        for (const PlacedPoint& point : m_survey.placed) {
            if (!point.name.empty() && point.name != m_net.node_id(point.node)) {
                names.push_back(
                    fmt::format("{} on node {}", point.name, m_net.node_id(point.node)));
            }
        }
        const size_t count = names.size();
        add(Verdict::doubtful,
            fmt::format("{} points lie on other nodes than those that they name: {}", count,
                        and_more(std::move(names))),
            "taut used the places. If names are those of the surveyor, identify again with --match "
            "place. If they are the net's, check frame, axes and the order of the points");
    }

    void test_names() {
        std::vector<std::string> pairs;
        const auto add_pair = [&](int node, int other) {
            if (node < other) {
                pairs.push_back(
                    fmt::format("{} and {}", m_net.node_id(node), m_net.node_id(other)));
            }
        };
        for (const Outlier& outlier : m_result.outliers) {
            add_pair(outlier.node, outlier.swapped_with);
        }
        for (const UnmatchedPoint& point : m_survey.unmatched) {
            add_pair(point.nearest, point.swapped_with);
        }
        std::vector<std::string> far;
        for (const UnmatchedPoint& point : m_survey.unmatched) {
            if (point.reason == UnmatchedReason::far_from_its_node && point.swapped_with < 0) {
                far.push_back(
                    fmt::format("{} ({:.3g} m)", m_net.node_id(point.nearest), point.distance));
            }
        }
        if (const size_t count = far.size(); count > 0) {
            add(Verdict::doubtful,
                fmt::format("{} far from the {} named, and left out: {}",
                            count == 1 ? "a target lies" : fmt::format("{} targets lie", count),
                            count == 1 ? "node that is" : "nodes that are",
                            and_more(std::move(far))),
                "are their names right, and those of the others?");
        }
        if (!pairs.empty()) {
            add(Verdict::passed,
                fmt::format(
                    "names of targets are swapped, which lie at each other's places and are "
                    "left out: {}",
                    and_more(std::move(pairs))),
                "exchange their names in the survey, and identify again");
        }
    }

    void test_forces() {
        if (!m_result.contradicted_taut.empty() || !m_result.contradicted_slack.empty()) {
            add(Verdict::doubtful,
                "the survey contradicts what was seen taut or slack: none of that is used",
                "look at those edges again");
        }
        if (m_result.reading_bias) {
            add(Verdict::doubtful,
                fmt::format("all readings of force are off by the same part, {:+.0f} %: none is "
                            "used",
                            1e2 * m_result.reading_bias->part),
                "is their unit right, and their calibration?");
        } else if (!m_result.reading_outliers.empty()) {
            add(Verdict::passed,
                fmt::format("{} of {} readings of force contradict all else and are left out",
                            m_result.reading_outliers.size(), m_result.readings));
        }
    }

    void test_unknowns() {
        for (const UnknownSpread& spread : spreads_of(m_result.unknowns)) {
            if (spread.is_contradicted()) {
                add(Verdict::failed,
                    fmt::format("{} is too narrow: the survey shows {:.1f} times as much",
                                spread.unknown.to_string(), spread.ratio * spread.widening),
                    fmt::format(
                        "check it on site, or identify again with --uncertain {} and a width "
                        "{:.1f} times as large",
                        spread.unknown.name(), spread.ratio * spread.widening));
            }
        }
    }

    void test_draws() {
        if (m_result.draws && m_result.drawn.tensions.empty()) {
            add(Verdict::doubtful, fmt::format("no tension is told: {}", m_result.draws->doubt),
                "lengths may be used, tensions not");
        }
    }

    const CableNet& m_net;
    const Survey& m_survey;
    const Identification& m_result;
    OtherCause m_other_cause;
    Trust m_trust;
};

}  // namespace

Trust::Verdict Trust::verdict() const {
    Verdict worst = Verdict::passed;
    for (const Finding& finding : findings) {
        worst = std::max(worst, finding.verdict);
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

Trust trust_of(const CableNet& net, const Survey& survey, const Identification& result) {
    return Tests(net, survey, result).run();
}

}  // namespace taut
