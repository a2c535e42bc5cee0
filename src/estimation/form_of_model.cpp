// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/form_of_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace taut {

bool FormOfModel::factorize(const Iterate& iterate) {
    constexpr double smallest_relative_stiffness = 1e-10;  // holds loose nodes
    const int free_count = m_numbers.local.free_count;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<size_t>(27 * m_model.net().edge_count()));
    const auto add = [&](int row, int column, const Eigen::Matrix3d& block) {
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                entries.emplace_back(3 * row + i, 3 * column + k, block(i, k));
            }
        }
    };
    for (int e = 0; e < m_model.net().edge_count(); ++e) {
        const auto [s, t] = m_numbers.local.edges[e];
        Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
        if (!m_model.slack[e]) {
            stiffness = m_model.rates(e, iterate).stiffness();
        }
        const Eigen::Matrix3d held = stiffness + smallest_relative_stiffness * stiffness.trace() *
                                                     Eigen::Matrix3d::Identity();
        for (const int node : {s, t}) {
            if (node < free_count) {
                add(node, node, held);
            }
        }
        if (std::max(s, t) < free_count) {
            add(std::max(s, t), std::min(s, t), -stiffness);
        }
    }
    const double factor = m_model.common.support_factor(iterate.common);
    for (const ElasticSupport& support : m_model.net().elastic_supports()) {
        const int node = m_numbers.local_of[support.node];
        add(node, node, factor * support.stiffness);
    }
    for (const SpringPair& pair : m_numbers.local.spring_pairs) {
        add(pair.second, pair.first, factor * pair.stiffness.transpose());
    }
    Eigen::SparseMatrix<double> stiffness(3 * free_count, 3 * free_count);
    stiffness.setFromTriplets(entries.begin(), entries.end());
    if (!std::exchange(m_is_analysed, true)) {
        m_factor.analyzePattern(stiffness);
    }
    m_factor.factorize(stiffness);
    return m_factor.info() == Eigen::Success && m_factor.vectorD().minCoeff() > 0.0;
}

Points FormOfModel::solve(const Points& right) const {
    const Points of_free = right(Eigen::all, m_numbers.free_nodes);
    const Eigen::VectorXd solution = m_factor.solve(of_free.reshaped());
    Points result = Points::Zero(3, right.cols());
    result(Eigen::all, m_numbers.free_nodes) =
        solution.reshaped(3, m_numbers.local.free_count).eval();
    return result;
}

bool FormOfModel::converge(Iterate& iterate, double tolerance) {
    constexpr int most_iterations = 60;
    constexpr double least_part = 1e-4;
    const auto imbalance = [&](const Iterate& at) -> Points {
        return m_model.imbalance(at)(Eigen::all, m_numbers.free_nodes);
    };
    Points forces = m_model.imbalance(iterate);
    double size = imbalance(iterate).norm();
    for (int k = 0; k < most_iterations; ++k) {
        if (!std::isfinite(size) || !factorize(iterate)) {
            return false;
        }
        const Points step = -solve(forces);
        const double length = step.cwiseAbs().maxCoeff();
        double part = 1.0;
        Iterate next = iterate;
        for (;; part *= 0.5) {
            next.form = iterate.form + part * step;
            forces = m_model.imbalance(next);
            const double now = forces(Eigen::all, m_numbers.free_nodes).norm();
            if (now < (1.0 - 1e-4 * part) * size ||
                (part == 1.0 && length < tolerance && std::isfinite(now))) {
                size = now;
                break;
            }
            if (part < least_part) {
                return false;
            }
        }
        iterate.form = std::move(next.form);
        if (part == 1.0 && length < tolerance) {
            return true;
        }
    }
    return false;
}

}  // namespace taut
