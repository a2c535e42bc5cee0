// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/stiffness_factor.hpp"

#include <utility>

namespace taut {

StiffnessFactor::StiffnessFactor(const StiffnessMatrix& matrix)
    : m_factor(matrix.node_count() < large
                   ? std::variant<NodalFactor, Large>(NodalFactor(matrix))
                   : std::variant<NodalFactor, Large>(large_factor(matrix))) {}

StiffnessFactor::Large StiffnessFactor::large_factor(const StiffnessMatrix& matrix) {
    const auto count = static_cast<size_t>(matrix.node_count());
    std::vector<std::vector<Large::Entry>> entries(count);
    std::vector<std::vector<int>> couplings(count);
    int block = 0;
    for (int j = 0; j < matrix.node_count(); ++j) {
        for (const StiffnessMatrix::Block& at : matrix.column(j)) {
            entries[at.row].push_back({.later = j, .block = block++});
            couplings[at.row].push_back(j);
        }
    }
    return {.factor = SupernodalFactor(std::vector<int>(count, 3), couplings,
                                       Definiteness::positive_definite),
            .entries = std::move(entries),
            .pivots = Eigen::Matrix3Xd(3, matrix.node_count())};
}

bool StiffnessFactor::Large::factorize(const StiffnessMatrix& matrix) {
    const auto assemble = [&](int node, const SupernodalFactor::Places& places,
                              FrontMatrix& front) {
        const int own = places.of(3 * node);
        front.block<3, 3>(own, own) += matrix.diagonal(node);
        for (const auto [later, block] : entries[node]) {
            front.block<3, 3>(places.of(3 * later), own) +=
                matrix.blocks()[block].values.transpose();
        }
    };
    if (!factor.factorize(assemble)) {
        return false;
    }
    pivots.reshaped() = factor.pivots();
    return pivots.allFinite();
}

bool StiffnessFactor::factorize(const StiffnessMatrix& matrix) {
    m_positive_definite =
        std::visit([&](auto& factor) { return factor.factorize(matrix); }, m_factor);
    return m_positive_definite;
}

void StiffnessFactor::solve(Eigen::Ref<Eigen::VectorXd> x) const {
    if (const auto* nodal = std::get_if<NodalFactor>(&m_factor)) {
        nodal->solve(x);
    } else {
        x = std::get<Large>(m_factor).factor.solve(x);
    }
}

const Eigen::Matrix3Xd& StiffnessFactor::pivots() const {
    const auto* nodal = std::get_if<NodalFactor>(&m_factor);
    return nodal != nullptr ? nodal->pivots() : std::get<Large>(m_factor).pivots;
}

bool Stiffness::has_loose_nodes() const {
    return !factor.positive_definite() ||
           (factor.pivots().colwise().minCoeff().transpose().array() <=
            smallest_relative_stiffness * matrix.axial_at_nodes().array())
               .any();
}

}  // namespace taut
