// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/nodal_factor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

#include "numerics/packets.hpp"

namespace taut {
namespace {

/// L and D with L D L' = the matrix; reads its lower triangle.
/// @return whether it is positive definite
template <typename Diagonal>
bool factorize_block(const Eigen::Matrix3d& matrix, Diagonal& L,
                     Eigen::Ref<Eigen::Vector3d> pivots) {
    const auto is_positive = [](double pivot) { return pivot > 0.0 && std::isfinite(pivot); };
    pivots(0) = matrix(0, 0);
    L.l10 = matrix(1, 0) / pivots(0);
    L.l20 = matrix(2, 0) / pivots(0);
    pivots(1) = matrix(1, 1) - L.l10 * matrix(1, 0);
    const double m21 = matrix(2, 1) - L.l20 * matrix(1, 0);
    L.l21 = m21 / pivots(1);
    pivots(2) = matrix(2, 2) - L.l20 * matrix(2, 0) - L.l21 * m21;
    L.inverse_pivots = pivots.cwiseInverse();
    return is_positive(pivots(0)) && is_positive(pivots(1)) && is_positive(pivots(2));
}

/// L^-1 of three rows of numbers, in place.
template <typename Diagonal, typename Rows>
void divide_by(const Diagonal& L, Rows& rows) {
    for (Eigen::Index c = 0; c < rows.cols(); ++c) {
        rows(1, c) -= L.l10 * rows(0, c);
        rows(2, c) -= L.l20 * rows(0, c) + L.l21 * rows(1, c);
    }
}

}  // namespace

/// rows[i] -= L_ij S for all blocks L_ij of a column: most of the work.
TAUT_PACKETS void NodalFactor::subtract_products(const Block* begin, const Block* end,
                                                 const Eigen::Matrix3d& S, Padded* rows) {
    const std::array<double, 9> s = {S(0, 0), S(1, 0), S(2, 0), S(0, 1), S(1, 1),
                                     S(2, 1), S(0, 2), S(1, 2), S(2, 2)};
    for (const Block* block = begin; block != end; ++block) {
        const double* const L = block->values.data();
        double* const row = rows[block->row].data();
        Packet first;
        Packet second;
        Packet third;
        std::memcpy(&first, L, sizeof first);
        std::memcpy(&second, L + 4, sizeof second);
        std::memcpy(&third, L + 8, sizeof third);
        for (size_t c = 0; c < 3; ++c) {
            Packet column;
            std::memcpy(&column, row + 4 * c, sizeof column);
            column -= first * s[3 * c] + second * s[3 * c + 1] + third * s[3 * c + 2];
            std::memcpy(row + 4 * c, &column, sizeof column);
        }
    }
}

NodalFactor::NodalFactor(const StiffnessMatrix& matrix)
    : m_parents(matrix.node_count(), -1),
      m_starts(matrix.node_count() + 1, 0),
      m_diagonal(matrix.node_count()),
      m_pivots(3, matrix.node_count()),
      m_row(matrix.node_count(), Padded::Zero()),
      m_pattern(matrix.node_count()),
      m_visited(matrix.node_count(), -1) {
    // Davis, sections 4.1 and 4.5, but without path compression: the whole row is traversed to
    // count its entries.
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
size_t NodalFactor::row_pattern(const StiffnessMatrix& matrix, int row) {
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

bool NodalFactor::factorize(const StiffnessMatrix& matrix) {
    std::ranges::fill(m_visited, -1);
    std::ranges::fill(m_row, Padded::Zero());
    std::copy(m_starts.begin(), m_starts.end() - 1, m_ends.begin());
    for (int row = 0; row < matrix.node_count(); ++row) {
        Eigen::Matrix3d pivot = matrix.diagonal(row);
        const size_t begin = row_pattern(matrix, row);
        for (const auto& block : matrix.column(row)) {
            m_row[block.row].topRows<3>() += block.values;
        }
        for (size_t k = begin; k < m_pattern.size(); ++k) {
            const auto j = static_cast<size_t>(m_pattern[k]);
            // S = D_j L_row,j' = L_jj^-1 (K_j,row - sum of L_ji D_i L_row,i' over i < j)
            Eigen::Matrix3d S = m_row[j].topRows<3>();
            m_row[j].setZero();
            divide_by(m_diagonal[j], S);
            subtract_products(m_blocks.data() + m_starts[j], m_blocks.data() + m_ends[j], S,
                              m_row.data());
            Block& found = m_blocks[m_ends[j]++];
            found.row = row;
            const Eigen::Array3d& inverse = m_diagonal[j].inverse_pivots;
            for (int c = 0; c < 3; ++c) {
                found.values.col(c) << S(c, 0) * inverse(c), S(c, 1) * inverse(c),
                    S(c, 2) * inverse(c), 0.0;
            }
            for (int c = 0; c < 3; ++c) {
                for (int a = c; a < 3; ++a) {
                    pivot(a, c) -= found.values(a, 0) * S(0, c) + found.values(a, 1) * S(1, c) +
                                   found.values(a, 2) * S(2, c);
                }
            }
        }
        if (!factorize_block(pivot, m_diagonal[row], m_pivots.col(row))) {
            return false;
        }
    }
    return true;
}

void NodalFactor::solve(Eigen::Ref<Eigen::VectorXd> x) const {
    const auto node = [&](size_t i) { return x.segment<3>(3 * static_cast<Eigen::Index>(i)); };
    for (size_t j = 0; j < m_diagonal.size(); ++j) {
        Eigen::Vector3d value = node(j);
        divide_by(m_diagonal[j], value);
        node(j) = value;
        for (size_t p = m_starts[j]; p < m_starts[j + 1]; ++p) {
            const Eigen::Vector4d product = m_blocks[p].values * value;
            node(m_blocks[p].row) -= product.head<3>();
        }
    }
    for (size_t j = m_diagonal.size(); j-- > 0;) {
        Eigen::Vector3d value = node(j).cwiseProduct(m_diagonal[j].inverse_pivots.matrix());
        for (size_t p = m_starts[j]; p < m_starts[j + 1]; ++p) {
            value.noalias() -= m_blocks[p].values.topRows<3>().transpose() * node(m_blocks[p].row);
        }
        const Diagonal& L = m_diagonal[j];
        value(1) -= L.l21 * value(2);
        value(0) -= L.l10 * value(1) + L.l20 * value(2);
        node(j) = value;
    }
}

}  // namespace taut
