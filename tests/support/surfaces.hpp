// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "taut/adjustment/target_surface.hpp"
#include "taut/net/cable_net.hpp"

/// Target surfaces.
namespace taut::test {

/// A square at a height [m], twice as large as the net.
inline std::shared_ptr<const TargetSurface> plane_at(double height, const CableNet& net) {
    const Eigen::Vector3d low = net.nodes().rowwise().minCoeff();
    const Eigen::Vector3d size = net.nodes().rowwise().maxCoeff() - low;
    Points corners(3, 4);
    for (int k = 0; k < 4; ++k) {
        corners.col(k) << low.x() + (k == 1 || k == 2 ? 1.5 : -0.5) * size.x(),
            low.y() + (k >= 2 ? 1.5 : -0.5) * size.y(), height;
    }
    return std::make_shared<const TargetSurface>(
        corners, std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}});
}

/// A surface of triangles through a form: each free node with each pair of its neighbours that are
/// consecutive round it, seen from above.
inline std::shared_ptr<const TargetSurface> surface_through(const CableNet& net, const Points& form,
                                                            double scale = 1.0) {
    std::vector<std::array<int, 3>> triangles;
    for (const int node : net.free_nodes()) {
        std::vector<int> round(net.neighbours(node).begin(), net.neighbours(node).end());
        std::ranges::sort(round, {}, [&](int other) {
            const Eigen::Vector3d to = form.col(other) - form.col(node);
            return std::atan2(to.y(), to.x());
        });
        for (size_t k = 0; k < round.size(); ++k) {
            triangles.push_back({node, round[k], round[(k + 1) % round.size()]});
        }
    }
    return std::make_shared<const TargetSurface>(scale * form, triangles);
}

}  // namespace taut::test
