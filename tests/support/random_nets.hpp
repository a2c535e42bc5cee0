// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <rapidcheck.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "taut/net/cable_net.hpp"

/// Random nets, lengths and forms. The same seed gives the same, so a seed that fails is a bug
/// report.
namespace taut::test {

using Random = std::mt19937_64;

/// A generator for a RapidCheck property, seeded anew in every case. RapidCheck shows the seed if
/// the property fails.
inline Random any_random() {
    return Random(
        *rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>())));
}

inline double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

inline int uniform_int(Random& random, int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
}

inline Points uniform_points(Random& random, Eigen::Index count, double reach) {
    return Points::NullaryExpr(3, count, [&] { return uniform(random, -reach, reach); });
}

inline Eigen::VectorXd uniform_vector(Random& random, Eigen::Index size, double reach) {
    return Eigen::VectorXd::NullaryExpr(size, [&] { return uniform(random, -reach, reach); });
}

/// Ranges from which random_net() draws.
struct RandomNetSettings {
    int most_free_nodes = 10;
    double smallest_strain = -0.03;  ///< of an edge at the nodes' coordinates; below 0 it is slack
    double largest_strain = 0.06;
    double largest_load = 300.0;  ///< at a free node; half of the nets are without loads [N]
};

inline double smallest_eigenvalue(const Eigen::Matrix3d& matrix) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly)
        .eigenvalues()(0);
}

/// Makes half of the supports with edges elastic, with stiffnesses from 10 kN/m to 1 MN/m in
/// directions of their own, unloaded within 0.1 m of their nodes.
inline void put_on_springs(Random& random, CableNetData& data) {
    std::vector<int> rigid;
    for (const int node : data.supports) {
        const bool has_edge = std::ranges::any_of(data.edges, [node](const Edge& edge) {
            return std::ranges::find(edge, node) != edge.end();
        });
        if (!has_edge || uniform_int(random, 0, 1) == 0) {
            rigid.push_back(node);
            continue;
        }
        const Eigen::Matrix3d root = uniform_points(random, 3, 1.0);
        const Eigen::Matrix3d stiffness = std::pow(10.0, uniform(random, 4.0, 6.0)) *
                                          (root * root.transpose() + Eigen::Matrix3d::Identity());
        data.elastic_supports.push_back(
            {.node = node,
             .stiffness = 0.5 * (stiffness + stiffness.transpose()),
             .place = data.nodes.col(node) + uniform_points(random, 1, 0.1)});
    }
    data.supports = rigid;
    // In half of these nets, some of them stand on one frame.
    const auto count = static_cast<int>(data.elastic_supports.size());
    for (int a = 0; count > 0 && uniform_int(random, 0, 1) == 1 && a < count; ++a) {
        for (int b = 0; b < a; ++b) {
            const double least = std::min(smallest_eigenvalue(data.elastic_supports[a].stiffness),
                                          smallest_eigenvalue(data.elastic_supports[b].stiffness));
            data.support_couplings.push_back(
                {.first = b,
                 .second = a,
                 .stiffness = 0.3 * least / count * uniform_points(random, 3, 1.0)});
        }
    }
}

/// A net of any topology, in a ball of some 3 m: every free node joined to an earlier one or to a
/// support, and some further edges. Axial stiffnesses from 10
/// kN to 1 MN. Its coordinates are not in equilibrium; some nodes may hang on a single edge.
inline CableNetData random_net_data(Random& random, const RandomNetSettings& settings = {}) {
    const int free_count = uniform_int(random, 1, settings.most_free_nodes);
    const int support_count = uniform_int(random, 3, 8);
    CableNetData data;
    data.name = "random";
    data.nodes = uniform_points(random, free_count + support_count, 1.0);
    for (int i = free_count; i < free_count + support_count; ++i) {
        data.nodes.col(i) *= 3.0 / data.nodes.col(i).norm();
        data.supports.push_back(i);
    }
    std::set<std::pair<int, int>> joined;
    const auto join = [&](int s, int t) {
        if (s != t && joined.insert(std::minmax(s, t)).second) {
            data.edges.push_back({s, t});
        }
    };
    const auto support = [&] { return free_count + uniform_int(random, 0, support_count - 1); };
    for (int s = 0; s < free_count; ++s) {
        join(s,
             s > 0 && uniform_int(random, 0, 1) == 1 ? uniform_int(random, 0, s - 1) : support());
        for (int extra = uniform_int(random, 0, 3); extra > 0; --extra) {
            join(s, uniform_int(random, 0, 1) == 1 ? uniform_int(random, 0, free_count - 1)
                                                   : support());
        }
    }
    const auto m = static_cast<Eigen::Index>(data.edges.size());
    data.axial_stiffness.resize(m);
    data.unstressed_lengths.resize(m);
    for (Eigen::Index e = 0; e < m; ++e) {
        const auto [s, t] = data.edges[e];
        data.axial_stiffness(e) = std::pow(10.0, uniform(random, 4.0, 6.0));
        data.unstressed_lengths(e) =
            (data.nodes.col(s) - data.nodes.col(t)).norm() /
            (1.0 + uniform(random, settings.smallest_strain, settings.largest_strain));
    }
    if (uniform_int(random, 0, 1) == 1) {
        data.loads = uniform_points(random, data.nodes.cols(), settings.largest_load);
    }
    data.adjustable = edges_at_supports(data.edges, data.supports);
    return data;
}

/// The same; in half of them some supports are elastic.
inline CableNet random_net(Random& random, const RandomNetSettings& settings = {}) {
    CableNetData data = random_net_data(random, settings);
    if (uniform_int(random, 0, 1) == 1) {
        put_on_springs(random, data);
    }
    return CableNet(std::move(data));
}

/// The net with its nodes in a random order.
/// @param from receives the old number of each node
inline CableNetData renumbered(Random& random, CableNetData data, std::vector<int>& from) {
    from.resize(static_cast<size_t>(data.nodes.cols()));
    std::iota(from.begin(), from.end(), 0);
    std::ranges::shuffle(from, random);
    std::vector<int> to(from.size());
    for (size_t i = 0; i < from.size(); ++i) {
        to[from[i]] = static_cast<int>(i);
    }
    data.nodes = Points(data.nodes(Eigen::all, from));
    if (data.loads.cols() > 0) {
        data.loads = Points(data.loads(Eigen::all, from));
    }
    for (int& support : data.supports) {
        support = to[support];
    }
    for (ElasticSupport& support : data.elastic_supports) {
        support.node = to[support.node];
    }
    for (auto& [s, t] : data.edges) {
        s = to[s];
        t = to[t];
    }
    return data;
}

}  // namespace taut::test
