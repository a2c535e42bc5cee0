// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/target_offsets.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <queue>
#include <set>
#include <tuple>
#include <vector>

#include "numerics/dense.hpp"
#include "taut/net/units.hpp"

namespace taut {
namespace {

using NodeNeighbours = std::vector<std::vector<int>>;

NodeNeighbours neighbours_in(const CableNet& net) {
    NodeNeighbours neighbours(net.node_count());
    for (const auto& [s, t] : net.edges()) {
        neighbours[s].push_back(t);
        neighbours[t].push_back(s);
    }
    return neighbours;
}

/// Of the neighbours of a node, of any sign; 0 where they make no polygon: less than three, or in
/// one line.
Eigen::Vector3d polygon_normal(const Points& form, int node, const std::vector<int>& neighbours) {
    constexpr double least_area = 1e-3;  // over the squared lengths of the edges
    Eigen::Matrix3Xd edges = form(Eigen::all, neighbours).colwise() - form.col(node);
    // The directions that the edges spread least in, and a plane across it to go round in.
    const Eigen::Matrix3Xd directions = edges.colwise().normalized();
    const SymmetricEigen spread = symmetric_eigen(directions * directions.transpose());
    const Eigen::Vector3d u = spread.vectors.col(1);
    const Eigen::Vector3d v = spread.vectors.col(2);
    std::vector<Eigen::Index> round(neighbours.size());
    for (size_t i = 0; i < round.size(); ++i) {
        round[i] = static_cast<Eigen::Index>(i);
    }
    std::ranges::sort(round, {}, [&](Eigen::Index i) {
        return std::atan2(v.dot(edges.col(i)), u.dot(edges.col(i)));
    });
    // (normal-of-node)
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (size_t i = 0; i < round.size(); ++i) {
        const Eigen::Vector3d edge = edges.col(round[i]);
        const Eigen::Vector3d next = edges.col(round[(i + 1) % round.size()]);
        area += 0.5 * edge.cross(next);
    }
    return area.norm() > least_area * edges.squaredNorm() ? area.normalized().eval()
                                                          : Eigen::Vector3d::Zero().eval();
}

/// The nodes that hang together with one by edges at nodes with a normal, all normals turned to the
/// side of its own: along those edges first where normals differ least (H. Hoppe et al. 1992).
std::vector<int> turned_to_one_side(const NodeNeighbours& neighbours, int start, Points& normals,
                                    std::vector<bool>& seen) {
    std::vector<int> nodes;
    std::priority_queue<std::tuple<double, int, int>> next;  // |cosine|, to, from
    next.emplace(1.0, start, start);
    while (!next.empty()) {
        const auto [cosine, node, from] = next.top();
        next.pop();
        if (seen[node]) {
            continue;
        }
        seen[node] = true;
        nodes.push_back(node);
        if (normals.col(node).dot(normals.col(from)) < 0.0) {
            normals.col(node) *= -1.0;
        }
        for (const int neighbour : neighbours[node]) {
            if (!seen[neighbour] && !normals.col(neighbour).isZero()) {
                next.emplace(std::abs(normals.col(node).dot(normals.col(neighbour))), neighbour,
                             node);
            }
        }
    }
    return nodes;
}

/// Whether a normal points up; in an upright net along y, or else along x.
bool is_on_positive_side(const Eigen::Vector3d& mean) {
    constexpr double least_slope = 0.1;
    for (const int axis : {2, 1}) {
        if (std::abs(mean(axis)) > least_slope * mean.norm()) {
            return mean(axis) > 0.0;
        }
    }
    return mean.x() >= 0.0;
}

std::string offset_text(const TargetOffset& offset) {
    return fmt::format("{}{}", format_length(offset.offset),
                       offset.std_dev > 0.0 ? " +- " + format_length(offset.std_dev) : "");
}

/// The offset of a point by its name, by its code, or that of all.
std::optional<TargetOffset> offset_of(const TargetOffsets& offsets, const PlacedPoint& point) {
    for (const std::string& key : {point.name, point.code}) {
        if (const auto found = offsets.of.find(key); found != offsets.of.end()) {
            return found->second;
        }
    }
    return offsets.all;
}

void check_names(const TargetOffsets& offsets, Survey& survey) {
    std::set<std::string> known;
    for (const PlacedPoint& point : survey.placed) {
        known.insert({point.name, point.code});
    }
    for (const UnmatchedPoint& point : survey.unmatched) {
        known.insert({point.point.id, point.point.label, point.point.code});
    }
    std::vector<std::string> unused;
    for (const auto& [name, offset] : offsets.of) {
        if (!known.contains(name)) {
            unused.push_back(name);
        }
    }
    if (unused.empty()) {
        return;
    }
    if (unused.size() == offsets.of.size()) {
        throw SurveyError(0, fmt::format("has no target of the name or code '{}', for which an "
                                         "offset is given",
                                         unused.front()));
    }
    survey.notes.push_back(
        fmt::format("no target has the name or code {}, for which an offset is given",
                    fmt::join(unused, ", ")));
}

}  // namespace

void check_target_offset(const TargetOffset& offset) {
    constexpr double largest = 0.5;  // no target stands further off [m]
    if (!(std::abs(offset.offset) <= largest) || !(offset.std_dev >= 0.0) ||
        !(offset.std_dev <= largest)) {
        throw std::invalid_argument(fmt::format(
            "the offset is {:g} +- {:g} m, expected at most {:g} m, and a standard deviation "
            "from 0 to {:g} m: a number without unit is in metres",
            offset.offset, offset.std_dev, largest, largest));
    }
}

TargetOffset parse_target_offset(std::string_view text) {
    const size_t colon = text.find(':');
    TargetOffset offset{.offset = parse_length(text.substr(0, colon))};
    if (colon != std::string_view::npos) {
        offset.std_dev = parse_length(text.substr(colon + 1));
    }
    check_target_offset(offset);
    return offset;
}

Points node_normals(const CableNet& net, const Points& form) {
    const NodeNeighbours neighbours = neighbours_in(net);
    Points normals = Points::Zero(3, net.node_count());
    for (const int node : net.free_nodes()) {
        normals.col(node) = polygon_normal(form, node, neighbours[node]);
    }
    std::vector<bool> seen(net.node_count(), false);
    for (const int node : net.free_nodes()) {
        if (seen[node] || normals.col(node).isZero()) {
            continue;
        }
        const std::vector<int> nodes = turned_to_one_side(neighbours, node, normals, seen);
        if (!is_on_positive_side(normals(Eigen::all, nodes).rowwise().sum())) {
            normals(Eigen::all, nodes) *= -1.0;
        }
    }
    return normals;
}

void take_off_offsets(const CableNet& net, const TargetOffsets& offsets, Survey& survey) {
    if (offsets.empty()) {
        return;
    }
    check_names(offsets, survey);
    const Points normals = node_normals(net, net.nodes());
    std::map<std::string, int> taken;
    std::vector<std::string> without;
    for (const PlacedPoint& point : survey.placed) {
        const auto offset = offset_of(offsets, point);
        if (!offset || net.is_support(point.node)) {
            continue;
        }
        const Eigen::Vector3d normal = normals.col(point.node);
        auto noise = survey.noise_std.col(point.node);
        if (normal.isZero()) {
            without.push_back(net.node_id(point.node));
            noise = (noise.array().square() + std::pow(offset->offset, 2) +
                     std::pow(offset->std_dev, 2))
                        .sqrt();
            continue;
        }
        ++taken[offset_text(*offset)];
        // (offset)
        survey.form.col(point.node) -= offset->offset * normal;
        noise = (noise.cwiseAbs2() + offset->std_dev * offset->std_dev * normal.cwiseAbs2())
                    .cwiseSqrt();
    }
    for (const auto& [text, count] : taken) {
        survey.notes.push_back(
            fmt::format("{} {} taken back by {} along the net's normal to the cable's axis", count,
                        count == 1 ? "target was" : "targets were", text));
    }
    if (!without.empty()) {
        constexpr size_t shown = 6;
        const size_t count = without.size();
        without.resize(std::min(shown, count));
        survey.warnings.push_back(fmt::format(
            "the net has no normal at {} {} with offsets, which have two edges or all in one line "
            "({}{}): their targets stay where they were measured, and the offset counts as noise",
            count, count == 1 ? "node" : "nodes", fmt::join(without, ", "),
            count > shown ? ", ..." : ""));
    }
}

}  // namespace taut
