// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "taut/net/cable_net.hpp"

namespace taut {

/// K times the shifts of elastic supports: the force on each, that which others of its frame pass
/// on to it among it; 0 at other nodes (3 x n) [N].
/// @param shifts of all nodes, of which those at elastic supports count (3 x n) [m]
[[nodiscard]] Points support_forces(const CableNet& net, const Points& shifts);

/// Nodes of the elastic supports that stand on one frame with others, ascending.
[[nodiscard]] std::vector<int> coupled_supports(const CableNet& net);

/// The stiffness of all elastic supports and its factor, three rows each, in their order.
class SupportStiffness {
public:
    explicit SupportStiffness(const CableNet& net);

    /// The shifts under forces on elastic supports; 0 at other nodes (3 x n) [m].
    [[nodiscard]] Points shifts_by(const Points& forces) const;

private:
    const std::vector<ElasticSupport>& m_supports;
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> m_factor;
};

/// The matrix of SupportStiffness [N/m].
[[nodiscard]] Eigen::SparseMatrix<double> support_stiffness_matrix(
    const std::vector<ElasticSupport>& supports, const std::vector<SupportCoupling>& couplings);

}  // namespace taut
