// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/survey.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "survey/match_by_place.hpp"
#include "survey/mean_edge_length.hpp"
#include "survey/node_names.hpp"
#include "taut/survey/noise_check.hpp"

namespace taut {
namespace {

constexpr double largest_far_part = 0.05;   ///< of the named free nodes
constexpr double least_matched_part = 0.5;  ///< of the targets without a name

std::string far_away(const CableNet& net, const SurveyPoint& point, int node, double distance,
                     double limit) {
    return fmt::format(
        "{} '{}' lies {:.4g} m from its nominal place, expected at most {:.4g} m: "
        "is the survey of this net, in its frame and in metres?",
        net.free_index(node) < 0 ? "support" : "node", point.id, distance, limit);
}

/// Puts points on nodes, each once.
class Matching {
public:
    Matching(const CableNet& net, double noise_std)
        : m_net(net), m_default_noise_std(Eigen::Vector3d::Constant(noise_std)) {
        m_survey.form = net.nodes();
        m_survey.noise_std = Points::Zero(3, net.node_count());
        m_seen.assign(net.node_count(), false);
    }

    [[nodiscard]] bool seen(int node) const { return m_seen[node]; }

    void put(const SurveyPoint& point, int node) {
        m_seen[node] = true;
        m_survey.placed.push_back({.name = point.id.empty() ? point.label : point.id,
                                   .line = point.line,
                                   .node = node,
                                   .distance = (point.position - m_net.nodes().col(node)).norm(),
                                   .code = point.code});
        if (m_net.free_index(node) >= 0) {
            m_survey.form.col(node) = point.position;
            m_survey.noise_std.col(node) = point.noise_std.value_or(m_default_noise_std);
            m_survey.set_correlations(node, point.noise_correlations);
        } else {
            m_survey.supports.push_back({.node = node,
                                         .position = point.position,
                                         .noise_std = point.noise_std.value_or(m_default_noise_std),
                                         .noise_correlations = point.noise_correlations});
        }
    }

    void leave_out(UnmatchedPoint point) { m_survey.unmatched.push_back(std::move(point)); }

    [[nodiscard]] Survey finished() && {
        for (const int node : m_net.free_nodes()) {
            (seen(node) ? m_survey.surveyed : m_survey.missing).push_back(node);
        }
        std::ranges::sort(m_survey.supports, {}, &SurveyedSupport::node);
        std::ranges::stable_sort(m_survey.unmatched, {},
                                 [](const UnmatchedPoint& p) { return p.point.line; });
        std::ranges::stable_sort(m_survey.placed, {}, &PlacedPoint::line);
        if (!m_survey.surveyed.empty()) {
            m_survey.warnings =
                noise_warnings(m_net, m_survey.noise_std(Eigen::all, m_survey.surveyed).maxCoeff());
        }
        return std::move(m_survey);
    }

private:
    const CableNet& m_net;
    Eigen::Vector3d m_default_noise_std;
    std::vector<bool> m_seen;
    Survey m_survey;
};

/// Marks pairs of named points of which each is at the node of the other's name.
void mark_swapped(const CableNet& net, std::vector<UnmatchedPoint>& far) {
    const double reach = 0.5 * mean_edge_length(net);
    const auto is_at = [&](const UnmatchedPoint& point, int node) {
        return (point.point.position - net.nodes().col(node)).norm() < reach;
    };
    for (UnmatchedPoint& one : far) {
        const auto other = std::ranges::find_if(far, [&](const UnmatchedPoint& point) {
            return is_at(one, point.nearest) && is_at(point, one.nearest);
        });
        one.swapped_with = other == far.end() ? -1 : other->nearest;
    }
}

void put_named(const CableNet& net, const std::vector<SurveyPoint>& points, Matching& matching) {
    const std::map<std::string, int> node_of = nodes_by_name(net);
    const double mean_length = mean_edge_length(net);
    std::map<int, int> line_of;
    std::vector<UnmatchedPoint> far;
    int free_points = 0;
    for (const SurveyPoint& point : points) {
        const auto found = node_of.find(point.id);
        if (found == node_of.end()) {
            throw SurveyError(point.line,
                              fmt::format("'{}' is no node of the net '{}'", point.id, net.name()));
        }
        const int node = found->second;
        if (!line_of.emplace(node, point.line).second) {
            throw SurveyError(point.line, fmt::format("surveys node '{}' a second time", point.id));
        }
        const bool is_support = net.free_index(node) < 0;
        const double distance = (point.position - net.nodes().col(node)).norm();
        if (is_support && distance > 0.1 * mean_length) {
            throw SurveyError(point.line, far_away(net, point, node, distance, 0.1 * mean_length));
        }
        free_points += is_support ? 0 : 1;
        if (distance > mean_length) {
            far.push_back({.point = point,
                           .nearest = node,
                           .distance = distance,
                           .reason = UnmatchedReason::far_from_its_node});
        } else {
            matching.put(point, node);
        }
    }
    if (static_cast<double>(far.size()) > largest_far_part * free_points) {
        const UnmatchedPoint& first = far.front();
        throw SurveyError(first.point.line,
                          far_away(net, first.point, first.nearest, first.distance, mean_length));
    }
    mark_swapped(net, far);
    std::ranges::for_each(far, [&](UnmatchedPoint& p) { matching.leave_out(std::move(p)); });
}

/// @param named how many points have names of nodes. With any, a point with a label may be
///   anything, as the instrument's station; with more than points without a name, these may, too.
void put_unnamed(const CableNet& net, const std::vector<SurveyPoint>& targets, size_t named,
                 Matching& matching) {
    const bool has_named = named > 0;
    const std::vector<PlaceMatch> matches =
        match_by_place(net, targets, [&](int node) { return matching.seen(node); });
    size_t matched = 0;
    size_t expected = 0;
    for (size_t i = 0; i < targets.size(); ++i) {
        const PlaceMatch& match = matches[i];
        const bool counts = !has_named || targets[i].label.empty();
        expected += counts ? 1 : 0;
        if (match.unmatched) {
            matching.leave_out({.point = targets[i],
                                .nearest = match.node,
                                .distance = match.distance,
                                .reason = *match.unmatched});
        } else {
            matching.put(targets[i], match.node);
            matched += counts ? 1 : 0;
        }
    }
    if (expected > named &&
        static_cast<double>(matched) < least_matched_part * static_cast<double>(expected)) {
        throw SurveyError(
            0, fmt::format("{} of {} targets without a name lie clearly on one node, expected "
                           "at least half: is the survey of this net, in its frame and in metres?",
                           matched, expected));
    }
}

}  // namespace

std::string_view to_string(UnmatchedReason reason) {
    switch (reason) {
        case UnmatchedReason::far_from_its_node:
            return "far from its node";
        case UnmatchedReason::far_from_every_node:
            return "far from every node";
        case UnmatchedReason::between_nodes:
            return "between nodes";
        case UnmatchedReason::node_taken:
            return "node taken";
    }
    return "unknown";
}

Survey match_to_nodes(const CableNet& net, const std::vector<SurveyPoint>& points,
                      double noise_std) {
    if (!(noise_std >= 0.0) || !std::isfinite(noise_std)) {
        throw std::invalid_argument(
            fmt::format("the noise is {} m, expected at least 0 and finite", noise_std));
    }
    std::vector<SurveyPoint> named;
    std::vector<SurveyPoint> unnamed;
    for (const SurveyPoint& point : points) {
        constexpr double furthest = 1e9;  // no grid on earth goes further [m]
        if (!point.position.allFinite()) {
            throw SurveyError(
                point.line, fmt::format("node '{}' has a coordinate that is not finite", point.id));
        }
        if (point.position.cwiseAbs().maxCoeff() > furthest) {
            throw SurveyError(
                point.line, fmt::format("node '{}' has a coordinate of {:.3g} m, expected at most "
                                        "{:g} m",
                                        point.id, point.position.cwiseAbs().maxCoeff(), furthest));
        }
        (point.id.empty() ? unnamed : named).push_back(point);
    }
    Matching matching(net, noise_std);
    put_named(net, named, matching);
    put_unnamed(net, unnamed, named.size(), matching);
    return std::move(matching).finished();
}

Survey with_noise_times(Survey survey, double factor) {
    if (!(factor > 0.0) || !std::isfinite(factor)) {
        throw std::invalid_argument(fmt::format(
            "the noise is to be taken {} times, expected more than 0 and finite", factor));
    }
    survey.noise_std *= factor;
    for (SurveyedSupport& support : survey.supports) {
        support.noise_std *= factor;
    }
    return survey;
}

}  // namespace taut
