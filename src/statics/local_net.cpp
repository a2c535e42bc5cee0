// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/local_net.hpp"

#include <algorithm>
#include <map>

namespace taut {
namespace {

/// Largest distance of a node from the middle of the supports: that of the farthest support plus
/// ten times the net's total length of cable. No cable can be stretched further.
double reach_of(const CableNet& net, const Points& places, const Eigen::Vector3d& middle) {
    constexpr double stretched = 10.0;
    const double supports = (places.colwise() - middle).colwise().norm().maxCoeff();
    return supports + stretched * net.unstressed_lengths().sum();
}

/// The point itself, or the point in its direction at the distance `reach`.
Eigen::Vector3d within_reach(const Eigen::Vector3d& from_middle, double reach) {
    // Not by norm(): the square of a coordinate could overflow.
    const double largest = from_middle.cwiseAbs().maxCoeff();
    if (largest <= reach) {
        return from_middle;
    }
    return reach * (from_middle / largest).normalized();
}

/// @param extent of the net about that middle
Eigen::Vector3d origin_of(const Eigen::Vector3d& middle, double extent) {
    constexpr double far = 10.0;  // extents of the net
    return middle.cwiseAbs().maxCoeff() > far * extent ? middle : Eigen::Vector3d::Zero();
}

/// Edges from one elastic support to another, by their nodes, the lower one first.
std::map<Edge, int> edges_between_springs(const CableNet& net) {
    std::map<Edge, int> result;
    for (int e = 0; !net.support_couplings().empty() && e < net.edge_count(); ++e) {
        const auto [s, t] = std::minmax(net.edges()[e][0], net.edges()[e][1]);
        if (net.free_index(s) >= 0 && net.free_index(t) >= 0 && net.is_support(s) &&
            net.is_support(t)) {
            result[{s, t}] = e;
        }
    }
    return result;
}

void add_spring_pairs(const CableNet& net, const std::vector<int>& local_of, LocalNet& local) {
    const std::map<Edge, int> joined = edges_between_springs(net);
    for (const auto& [first, second, stiffness] : net.support_couplings()) {
        const int a = net.elastic_supports()[first].node;
        const int b = net.elastic_supports()[second].node;
        const auto edge = joined.find({std::min(a, b), std::max(a, b)});
        SpringPair pair{.first = local_of[a],
                        .second = local_of[b],
                        .stiffness = stiffness,
                        .edge = edge == joined.end() ? -1 : edge->second};
        if (pair.first > pair.second) {
            std::swap(pair.first, pair.second);
            pair.stiffness.transposeInPlace();
        }
        local.spring_pairs.push_back(pair);
    }
}

LocalNet number(const CableNet& net, const std::vector<int>& free_order) {
    LocalNet local;
    local.free_count = net.free_node_count();
    local.node_of = free_order;
    local.node_of.insert(local.node_of.end(), net.supports().begin(), net.supports().end());

    std::vector<int> local_of(local.node_of.size());
    for (size_t i = 0; i < local.node_of.size(); ++i) {
        local_of[local.node_of[i]] = static_cast<int>(i);
    }
    local.edges.reserve(net.edges().size());
    for (const auto& [s, t] : net.edges()) {
        local.edges.push_back({local_of[s], local_of[t]});
    }
    local.axial_stiffness = net.axial_stiffness();
    local.laws = net.data().tension_laws;
    local.law_of_edge = net.data().tension_law;
    local.sags = net.sags();
    for (int e = 0; local.sags && e < net.edge_count(); ++e) {
        local.law_of_edge.resize(net.edges().size(), -1);
        if (const TensionLaw* law = net.tension_law(e); law != nullptr && law->sags()) {
            local.law_of_edge[e] = static_cast<int>(local.laws.size());
            local.laws.push_back(*law);
        }
    }
    for (const EdgeKind kind : net.data().kind) {
        local.struts.push_back(kind == EdgeKind::strut);
    }
    local.supports = net.nodes()(Eigen::all, net.supports());
    const Points places = net.support_places();
    const Eigen::Vector3d middle = places.rowwise().mean();
    local.reach = reach_of(net, places, middle);
    Eigen::Matrix3Xd from_middle = net.nodes().colwise() - middle;
    for (const int node : net.free_nodes()) {
        from_middle.col(node) = within_reach(from_middle.col(node), local.reach);
    }
    local.origin = origin_of(middle, from_middle.cwiseAbs().maxCoeff());
    local.middle = middle - local.origin;
    local.nodes.resize(3, net.node_count());
    local.loads.resize(Eigen::Index{3} * local.free_count);
    for (int i = 0; i < net.node_count(); ++i) {
        const int node = local.node_of[i];
        const bool is_near = (net.nodes().col(node) - middle).cwiseAbs().maxCoeff() <= local.reach;
        local.nodes.col(i) = is_near || i >= local.free_count
                                 ? Eigen::Vector3d(net.nodes().col(node) - local.origin)
                                 : Eigen::Vector3d(from_middle.col(node) + local.middle);
        if (i < local.free_count) {
            local.loads.segment<3>(Eigen::Index{3} * i) = net.loads().col(node);
        }
    }
    for (const auto& [node, stiffness, place] : net.elastic_supports()) {
        local.springs.push_back(
            {.node = local_of[node], .stiffness = stiffness, .place = place - local.origin});
    }
    add_spring_pairs(net, local_of, local);
    return local;
}

/// The graph of the free nodes.
MatrixGraph free_node_graph(const CableNet& net) {
    std::vector<std::array<int, 2>> pairs;
    pairs.reserve(net.edges().size());
    for (const auto& [s, t] : net.edges()) {
        const int i = net.free_index(s);
        const int j = net.free_index(t);
        if (i >= 0 && j >= 0) {
            pairs.push_back({i, j});
        }
    }
    const std::map<Edge, int> joined = edges_between_springs(net);
    for (const SupportCoupling& coupling : net.support_couplings()) {
        const auto [a, b] = std::minmax(net.elastic_supports()[coupling.first].node,
                                        net.elastic_supports()[coupling.second].node);
        if (!joined.contains({a, b})) {
            pairs.push_back({net.free_index(a), net.free_index(b)});
        }
    }
    return graph_of(net.free_node_count(), pairs);
}

}  // namespace

void LocalNet::gather(const Eigen::Ref<const Points>& form, Eigen::Matrix3Xd& local) const {
    local = nodes;
    for (int i = 0; i < free_count; ++i) {
        local.col(i) = form.col(node_of[i]) - origin;
        const Eigen::Vector3d from_middle = local.col(i) - middle;
        if (from_middle.cwiseAbs().maxCoeff() > reach) {
            local.col(i) = middle + within_reach(from_middle, reach);
        }
    }
}

Points LocalNet::scatter(const Eigen::Matrix3Xd& local) const {
    Points form(3, local.cols());
    for (Eigen::Index i = 0; i < local.cols(); ++i) {
        const int node = node_of[i];
        if (i < free_count) {
            form.col(node) = local.col(i) + origin;
        } else {
            form.col(node) = supports.col(i - free_count);
        }
    }
    return form;
}

LocalNet number_naturally(const CableNet& net) {
    return number(net, net.free_nodes());
}

LocalNet number_for_elimination(const CableNet& net, Ordering ordering) {
    // Nodes, not coordinates, are ordered: the three rows of a node share their pattern.
    std::vector<int> free_order = elimination_order(free_node_graph(net), ordering);
    for (int& node : free_order) {
        node = net.free_nodes()[node];
    }
    return number(net, free_order);
}

}  // namespace taut
