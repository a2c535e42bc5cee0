// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/stiffness_factor.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace taut {
namespace {

/// L and D with L D L' = the matrix, of which the lower triangle is read.
/// @return whether it is positive definite
bool factorize_block(Eigen::Matrix3d matrix, Eigen::Matrix3d& lower,
                     Eigen::Ref<Eigen::Vector3d> pivots) {
    for (int j = 0; j < 3; ++j) {
        pivots(j) = matrix(j, j);
        if (!(pivots(j) > 0.0) || !std::isfinite(pivots(j))) {
            return false;
        }
        for (int i = j + 1; i < 3; ++i) {
            lower(i, j) = matrix(i, j) / pivots(j);
            for (int k = j + 1; k <= i; ++k) {
                matrix(i, k) -= lower(i, j) * matrix(k, j);
            }
        }
    }
    return true;
}

}  // namespace

StiffnessFactor::StiffnessFactor(const StiffnessMatrix& matrix)
    : m_parents(matrix.node_count(), -1),
      m_starts(matrix.node_count() + 1, 0),
      m_diagonal(matrix.node_count(), Eigen::Matrix3d::Zero()),
      m_pivots(3, matrix.node_count()),
      m_row(matrix.node_count(), Eigen::Matrix3d::Zero()),
      m_pattern(matrix.node_count()),
      m_visited(matrix.node_count(), -1) {
    // Davis, sections 4.1 and 4.5, but without path compression: every row is walked whole, since
    // its length counts.
    for (int row = 0; row < matrix.node_count(); ++row) {
        m_visited[row] = row;
        for (const auto& block : matrix.column(row)) {
            for (int j = block.row; m_visited[j] != row;) {
                m_visited[j] = row;
                ++m_starts[j + 1];
                int& parent = m_parents[j];
                if (parent < 0) {
                    parent = row;
                }
                j = parent;
            }
        }
    }
    std::partial_sum(m_starts.begin(), m_starts.end(), m_starts.begin());
    m_blocks.resize(m_starts.back());
    m_ends.assign(m_starts.begin(), m_starts.end() - 1);
}

/// The columns j < row with L_row,j != 0, each after those that it depends on, at the end of
/// m_pattern.
/// @return where they begin
size_t StiffnessFactor::row_pattern(const StiffnessMatrix& matrix, int row) {
    size_t begin = m_pattern.size();
    m_visited[row] = row;
    for (const auto& block : matrix.column(row)) {
        size_t length = 0;
        for (int j = block.row; m_visited[j] != row; j = m_parents[j]) {
            m_visited[j] = row;
            m_pattern[length++] = j;
        }
        while (length > 0) {
            m_pattern[--begin] = m_pattern[--length];
        }
    }
    return begin;
}

bool StiffnessFactor::factorize(const StiffnessMatrix& matrix) {
    m_positive_definite = false;
    std::ranges::fill(m_visited, -1);
    std::ranges::fill(m_row, Eigen::Matrix3d::Zero());
    std::copy(m_starts.begin(), m_starts.end() - 1, m_ends.begin());
    for (int row = 0; row < matrix.node_count(); ++row) {
        Eigen::Matrix3d pivot = matrix.diagonal(row);
        const size_t begin = row_pattern(matrix, row);
        for (const auto& block : matrix.column(row)) {
            m_row[block.row] += block.values;
        }
        for (size_t k = begin; k < m_pattern.size(); ++k) {
            const auto j = static_cast<size_t>(m_pattern[k]);
            // D_j L_row,j' = L_jj^-1 (K_j,row - sum of L_ji D_i L_row,i' over i < j)
            Eigen::Matrix3d scaled = m_row[j];
            m_row[j].setZero();
            m_diagonal[j].triangularView<Eigen::UnitLower>().solveInPlace(scaled);
            for (size_t p = m_starts[j]; p < m_ends[j]; ++p) {
                const Block& below = m_blocks[p];
                m_row[below.row].noalias() -= below.values * scaled;
            }
            Block& found = m_blocks[m_ends[j]++];
            found.row = row;
            found.values =
                (m_pivots.col(static_cast<Eigen::Index>(j)).asDiagonal().inverse() * scaled)
                    .transpose();
            pivot.noalias() -= found.values * scaled;
        }
        if (!factorize_block(pivot, m_diagonal[row], m_pivots.col(row))) {
            return false;
        }
    }
    m_positive_definite = true;
    return true;
}

void StiffnessFactor::solve(Eigen::Ref<Eigen::VectorXd> x) const {
    const auto node = [&](size_t i) { return x.segment<3>(3 * static_cast<Eigen::Index>(i)); };
    for (size_t j = 0; j < m_diagonal.size(); ++j) {
        Eigen::Vector3d value = node(j);
        m_diagonal[j].triangularView<Eigen::UnitLower>().solveInPlace(value);
        node(j) = value;
        for (size_t p = m_starts[j]; p < m_starts[j + 1]; ++p) {
            node(m_blocks[p].row).noalias() -= m_blocks[p].values * value;
        }
    }
    for (size_t j = m_diagonal.size(); j-- > 0;) {
        Eigen::Vector3d value = node(j).cwiseQuotient(m_pivots.col(static_cast<Eigen::Index>(j)));
        for (size_t p = m_starts[j]; p < m_starts[j + 1]; ++p) {
            value.noalias() -= m_blocks[p].values.transpose() * node(m_blocks[p].row);
        }
        m_diagonal[j].triangularView<Eigen::UnitLower>().transpose().solveInPlace(value);
        node(j) = value;
    }
}

bool Stiffness::has_loose_nodes() const {
    return !factor.positive_definite() ||
           (factor.pivots().colwise().minCoeff().transpose().array() <=
            smallest_relative_stiffness * matrix.axial_at_nodes().array())
               .any();
}

}  // namespace taut
