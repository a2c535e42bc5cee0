// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/balance_equations.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "taut/statics/energy.hpp"

namespace taut {
namespace {

/// T / l of an edge with its nominal unstressed length [N/m].
double nominal_force_density(const CableNet& net, int edge, double length) {
    const double nominal = net.unstressed_lengths()(edge);
    if (const TensionLaw* law = net.tension_law(edge); law != nullptr) {
        return law->at(length / nominal - 1.0).tension / length;
    }
    return net.axial_stiffness()(edge) / nominal * (1.0 - nominal / length);
}

}  // namespace

BalanceEquations::BalanceEquations(const CableNet& net, const Points& form,
                                   const std::vector<bool>& slack)
    : m_forces(Eigen::VectorXd::Zero(Eigen::Index{3} * net.free_node_count())),
      m_matrix(m_forces.size(), net.interior_edge_count()) {
    Eigen::VectorXd node_stiffness = m_forces;
    Points forces = elastic_forces(net, form) - net.loads();
    std::vector<Eigen::Triplet<double>> entries;
    int interior = 0;
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto [s, t] = net.edges()[e];
        const bool is_interior =
            interior < net.interior_edge_count() && net.interior_edges()[interior] == e;
        const int column = is_interior ? interior++ : -1;
        if (slack[e]) {
            continue;
        }
        const Eigen::Vector3d vector = form.col(s) - form.col(t);
        const double axial = net.axial_stiffness()(e) / net.unstressed_lengths()(e);
        const Eigen::Vector3d force = nominal_force_density(net, e, vector.norm()) * vector;
        forces.col(s) += force;
        forces.col(t) -= force;
        for (const auto& [node, sign] : {std::pair{s, 1.0}, std::pair{t, -1.0}}) {
            const int row = 3 * net.free_index(node);
            if (row >= 0) {
                node_stiffness.segment<3>(row).array() += axial;
                for (int k = 0; is_interior && k < 3; ++k) {
                    entries.emplace_back(row + k, column, sign * axial * vector(k));
                }
            }
        }
    }
    m_matrix.setFromTriplets(entries.begin(), entries.end());
    // Forces in terms of the move of their node, so that soft parts count as much as stiff
    // ones.
    const Eigen::VectorXd scale = node_stiffness.cwiseMax(1e-300).cwiseInverse();
    m_forces = scale.cwiseProduct(free_coordinates(net, forces));
    m_matrix = scale.asDiagonal() * m_matrix;
    Eigen::SparseMatrix<double> normal = m_matrix.transpose() * m_matrix;
    // Lengths that the forces do not show stay nominal.
    constexpr double smallest_part = 1e-13;
    m_shift = smallest_part * normal.diagonal().maxCoeff();
    for (Eigen::Index i = 0; i < normal.cols(); ++i) {
        normal.coeffRef(i, i) += m_shift;
    }
    m_factor.emplace(normal);
}

Eigen::VectorXd BalanceEquations::solve() const {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(m_matrix.cols());
    constexpr int passes = 3;
    for (int pass = 0; pass < passes; ++pass) {
        y -= m_factor->solve(m_matrix.transpose() * (m_forces + m_matrix * y));
    }
    return y;
}

std::pair<double, double> unstressed_lengths_from(const CableNet& net, int edge, double length,
                                                  double y) {
    const double nominal = net.unstressed_lengths()(edge);
    const TensionLaw* law = net.tension_law(edge);
    if (law == nullptr) {
        return {nominal / (1.0 + y), nominal / (1.0 + y)};
    }
    const double density =
        nominal_force_density(net, edge, length) + net.axial_stiffness()(edge) / nominal * y;
    constexpr double loosest = -0.5;  // without tension a cable that sags has no length
    const auto [least, greatest] = law->strains_at(density * length);
    return {length / (1.0 + std::max(loosest, greatest)),
            length / (1.0 + std::max(loosest, least))};
}

std::vector<bool> BalanceEquations::undetermined() const {
    constexpr int passes = 4;
    constexpr double smallest_share = 1e-6;
    std::mt19937 random(1);
    Eigen::VectorXd share = Eigen::VectorXd::NullaryExpr(m_matrix.cols(), [&] {
        return std::uniform_real_distribution<double>(0.5, 1.0)(random) *
               (random() % 2 == 0 ? 1.0 : -1.0);
    });
    for (int pass = 0; pass < passes; ++pass) {
        share = m_shift * m_factor->solve(share);
    }
    std::vector<bool> result;
    for (const double s : share) {
        result.push_back(std::abs(s) > smallest_share);
    }
    return result;
}

}  // namespace taut
