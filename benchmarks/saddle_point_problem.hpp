// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <algorithm>
#include <vector>

#include "estimation/saddle_point_factor.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The saddle-point matrix of a net at its nominal form, for places measured to 0.5 mm and lengths
/// known to 3 mm, in the unit of the latter: for taut, and as a sparse matrix for its peers.
struct SaddlePointProblem {
    explicit SaddlePointProblem(const CableNet& net)
        : local(number_for_elimination(net)),
          interior(interior_flags(net)),
          layout(local, interior),
          factor(local, interior) {
        const double unit =
            1.0 / net.axial_stiffness().cwiseQuotient(net.unstressed_lengths()).mean();
        factor.place_weights.setConstant(36.0);
        factor.length_weights.setOnes();
        for (int e = 0; e < net.edge_count(); ++e) {
            const auto [s, t] = local.edges[e];
            const Eigen::Vector3d vector = local.nodes.col(s) - local.nodes.col(t);
            const Eigen::Vector3d u = vector.normalized();
            const double axial = net.axial_stiffness()(e) / net.unstressed_lengths()(e);
            const double across = axial * (1.0 - net.unstressed_lengths()(e) / vector.norm());
            factor.edge_stiffness[e] = unit * ((axial - across) * u * u.transpose() +
                                               across * Eigen::Matrix3d::Identity());
            factor.length_rates.col(e) = -unit * axial / net.unstressed_lengths()(e) * vector;
            for (const int node : {s, t}) {
                if (node < local.free_count) {
                    factor.node_stiffness[node] += factor.edge_stiffness[e];
                }
            }
        }
        lower = sparse_lower();
    }

    static std::vector<bool> interior_flags(const CableNet& net) {
        std::vector<bool> flags(net.edge_count(), false);
        for (const int edge : net.interior_edges()) {
            flags[edge] = true;
        }
        return flags;
    }

    [[nodiscard]] Eigen::SparseMatrix<double> sparse_lower() const {
        std::vector<Eigen::Triplet<double>> entries;
        const auto add = [&](int i, int j, const auto& values) {
            for (int a = 0; a < values.rows(); ++a) {
                for (int c = 0; c < values.cols(); ++c) {
                    if (i + a >= j + c) {
                        entries.emplace_back(i + a, j + c, values(a, c));
                    } else {
                        entries.emplace_back(j + c, i + a, values(a, c));
                    }
                }
            }
        };
        for (int j = 0; j < local.free_count; ++j) {
            for (int k = 0; k < 3; ++k) {
                entries.emplace_back(layout.place[j] + k, layout.place[j] + k,
                                     factor.place_weights(k, j));
            }
            add(layout.multiplier(j), layout.place[j], factor.node_stiffness[j]);
        }
        for (int e = 0; e < static_cast<int>(local.edges.size()); ++e) {
            const auto [s, t] = local.edges[e];
            if (std::max(s, t) < local.free_count) {
                const Eigen::Matrix3d block = -factor.edge_stiffness[e];
                add(layout.multiplier(s), layout.place[t], block);
                add(layout.multiplier(t), layout.place[s], block);
            }
            if (layout.has_length(e)) {
                entries.emplace_back(layout.length[e], layout.length[e], factor.length_weights(e));
                for (const int node : {s, t}) {
                    if (node < local.free_count) {
                        const double sign = node == s ? 1.0 : -1.0;
                        add(layout.length[e], layout.multiplier(node),
                            Eigen::RowVector3d(sign * factor.length_rates.col(e).transpose()));
                    }
                }
            }
        }
        const int size = layout.parameter_count();
        Eigen::SparseMatrix<double> result(size, size);
        result.setFromTriplets(entries.begin(), entries.end());
        return result;
    }

    /// A vector numbered by the layout, as taut takes it.
    [[nodiscard]] SaddlePointFactor::Vector by_parts(const Eigen::VectorXd& uncertain) const {
        SaddlePointFactor::Vector vector{
            .places = Eigen::Matrix3Xd(3, local.free_count),
            .lengths = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(local.edges.size())),
            .multipliers = Eigen::Matrix3Xd(3, local.free_count)};
        for (int j = 0; j < local.free_count; ++j) {
            vector.places.col(j) = uncertain.segment<3>(layout.place[j]);
            vector.multipliers.col(j) = uncertain.segment<3>(layout.multiplier(j));
        }
        for (int e = 0; e < vector.lengths.size(); ++e) {
            if (layout.has_length(e)) {
                vector.lengths(e) = uncertain(layout.length[e]);
            }
        }
        return vector;
    }

    /// The way back.
    [[nodiscard]] Eigen::VectorXd together(const SaddlePointFactor::Vector& vector) const {
        Eigen::VectorXd uncertain(lower.rows());
        for (int j = 0; j < local.free_count; ++j) {
            uncertain.segment<3>(layout.place[j]) = vector.places.col(j);
            uncertain.segment<3>(layout.multiplier(j)) = vector.multipliers.col(j);
        }
        for (int e = 0; e < vector.lengths.size(); ++e) {
            if (layout.has_length(e)) {
                uncertain(layout.length[e]) = vector.lengths(e);
            }
        }
        return uncertain;
    }

    LocalNet local;
    std::vector<bool> interior;
    SaddlePointLayout layout;
    SaddlePointFactor factor;
    Eigen::SparseMatrix<double> lower;  ///< lower triangle, numbered by the layout
};

}  // namespace taut
