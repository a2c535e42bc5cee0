// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/sparse_cholesky.hpp"

#include <utility>

#include "numerics/elimination_order.hpp"

namespace taut {
namespace {

/// From this number of rows on, supernodes gain more than they cost.
constexpr Eigen::Index large = 5000;

MatrixGraph pattern_of(const Eigen::SparseMatrix<double>& matrix) {
    std::vector<std::array<int, 2>> pairs;
    for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, j); entry; ++entry) {
            if (entry.row() > entry.col()) {
                pairs.push_back({static_cast<int>(entry.row()), static_cast<int>(entry.col())});
            }
        }
    }
    return graph_of(static_cast<int>(matrix.rows()), pairs);
}

}  // namespace

SparseCholesky::SparseCholesky(const Eigen::SparseMatrix<double>& matrix) {
    if (matrix.rows() >= large) {
        m_supernodal = by_supernodes(matrix);
    }
    if (!m_supernodal) {
        m_row_by_row.compute(matrix);
    }
}

/// @return none if rounding errors make a pivot negative, which the row-by-row factor tolerates
std::optional<SparseCholesky::Supernodal> SparseCholesky::by_supernodes(
    const Eigen::SparseMatrix<double>& matrix) {
    const auto count = static_cast<size_t>(matrix.rows());
    std::vector<int> order = elimination_order(pattern_of(matrix), Ordering::quick);
    std::vector<int> place(count);
    for (size_t i = 0; i < count; ++i) {
        place[order[i]] = static_cast<int>(i);
    }
    std::vector<std::vector<int>> couplings(count);
    for (size_t i = 0; i < count; ++i) {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, order[i]); entry; ++entry) {
            if (const int other = place[entry.row()]; other > static_cast<int>(i)) {
                couplings[i].push_back(other);
            }
        }
    }
    Supernodal result{.order = std::move(order),
                      .factor = SupernodalFactor(std::vector<int>(count, 1), couplings,
                                                 Definiteness::positive_definite)};
    const bool is_definite = result.factor.factorize(
        [&](int block, const SupernodalFactor::Places& places, FrontMatrix& front) {
            const int own = places.of(block);
            for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, result.order[block]);
                 entry; ++entry) {
                if (const int other = place[entry.row()]; other >= block) {
                    front(places.of(other), own) += entry.value();
                }
            }
        });
    return is_definite ? std::optional(std::move(result)) : std::nullopt;
}

bool SparseCholesky::is_positive_definite() const {
    return m_supernodal ||
           (m_row_by_row.info() == Eigen::Success && (m_row_by_row.vectorD().array() > 0.0).all());
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::Ref<const Eigen::MatrixXd>& b) const {
    if (!m_supernodal) {
        return m_row_by_row.solve(b);
    }
    Eigen::MatrixXd x(b.rows(), b.cols());
    for (Eigen::Index j = 0; j < b.cols(); ++j) {
        const auto column = b.col(j);
        x.col(j)(m_supernodal->order) =
            m_supernodal->factor.solve(Eigen::VectorXd(column(m_supernodal->order)));
    }
    return x;
}

}  // namespace taut
