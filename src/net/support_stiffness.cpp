// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "net/support_stiffness.hpp"

#include <iterator>
#include <set>

namespace taut {

Points support_forces(const CableNet& net, const Points& shifts) {
    const std::vector<ElasticSupport>& supports = net.elastic_supports();
    Points forces = Points::Zero(3, net.node_count());
    for (const ElasticSupport& support : supports) {
        forces.col(support.node) = support.stiffness * shifts.col(support.node);
    }
    for (const auto& [first, second, stiffness] : net.support_couplings()) {
        const int a = supports[first].node;
        const int b = supports[second].node;
        forces.col(a) += stiffness * shifts.col(b);
        forces.col(b) += stiffness.transpose() * shifts.col(a);
    }
    return forces;
}

std::vector<int> coupled_supports(const CableNet& net) {
    std::set<int> nodes;
    for (const SupportCoupling& coupling : net.support_couplings()) {
        nodes.insert(net.elastic_supports()[coupling.first].node);
        nodes.insert(net.elastic_supports()[coupling.second].node);
    }
    return {nodes.begin(), nodes.end()};
}

SupportStiffness::SupportStiffness(const CableNet& net)
    : m_supports(net.elastic_supports()),
      m_factor(support_stiffness_matrix(net.elastic_supports(), net.support_couplings())) {}

Points SupportStiffness::shifts_by(const Points& forces) const {
    const auto count = std::ssize(m_supports);
    Points of_supports(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        of_supports.col(i) = forces.col(m_supports[static_cast<size_t>(i)].node);
    }
    const Eigen::VectorXd found = m_factor.solve(of_supports.reshaped());
    Points shifts = Points::Zero(3, forces.cols());
    for (Eigen::Index i = 0; i < count; ++i) {
        shifts.col(m_supports[static_cast<size_t>(i)].node) = found.segment<3>(3 * i);
    }
    return shifts;
}

Eigen::SparseMatrix<double> support_stiffness_matrix(
    const std::vector<ElasticSupport>& supports, const std::vector<SupportCoupling>& couplings) {
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&entries](int a, int b, const Eigen::Matrix3d& block) {
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                entries.emplace_back(3 * a + i, 3 * b + k, block(i, k));
            }
        }
    };
    for (int i = 0; i < std::ssize(supports); ++i) {
        add(i, i, supports[static_cast<size_t>(i)].stiffness);
    }
    for (const auto& [first, second, stiffness] : couplings) {
        add(first, second, stiffness);
        add(second, first, stiffness.transpose());
    }
    const auto size = static_cast<Eigen::Index>(3 * supports.size());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

}  // namespace taut
