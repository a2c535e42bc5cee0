// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/supernodal_factor.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/LU>
#include <algorithm>
#include <atomic>
#include <utility>

#include "numerics/dense.hpp"
#include "numerics/parts.hpp"
#include "numerics/serial_blas.hpp"

namespace taut {
namespace {

/// A panel takes blocks until it has so many pivots.
constexpr int panel_width = 48;

/// Adds the lower triangle of a child's update where its rows stand in the parent's matrix.
void add_update(const Eigen::MatrixXd& update, const std::vector<int>& place,
                Eigen::MatrixXd& matrix) {
    for (Eigen::Index b = 0; b < update.cols(); ++b) {
        double* const column = matrix.col(place[b]).data();
        for (Eigen::Index a = b; a < update.rows(); ++a) {
            column[place[a]] += update(a, b);
        }
    }
}

/// Where the panels of a supernode begin among its pivots, and the end.
std::vector<int> panels_of(const Supernode& supernode, const std::vector<int>& sizes) {
    std::vector<int> begins{0};
    int end = 0;
    for (const int block : supernode.blocks) {
        end += sizes[block];
        if (end - begins.back() >= panel_width || end == supernode.size) {
            begins.push_back(end);
        }
    }
    return begins;
}

}  // namespace

SupernodalFactor::SupernodalFactor(const std::vector<int>& sizes,
                                   std::vector<std::vector<int>> couplings) {
    SupernodeTree tree = supernode_tree(sizes, std::move(couplings));
    m_number = std::move(tree.number);
    m_branches = branches_of(tree.supernodes);
    for (Supernode& supernode : tree.supernodes) {
        std::vector<int> panels = panels_of(supernode, sizes);
        m_fronts.push_back(
            {.supernode = std::move(supernode), .panels = std::move(panels), .factor = {}});
    }
}

/// Assembles a front with the updates of its children, eliminates the pivots and leaves the update
/// for the parent; lower triangles.
/// @return false where a pivot is singular
bool SupernodalFactor::eliminate(int front, const Assembly& assemble,
                                 std::vector<Eigen::MatrixXd>& matrices) {
    const auto& supernode = m_fronts[front].supernode;
    const auto& panels = m_fronts[front].panels;
    Eigen::MatrixXd& L = m_fronts[front].factor;
    Eigen::MatrixXd& matrix = matrices[front];
    const auto p = static_cast<Eigen::Index>(supernode.size);
    const Eigen::Index size = p + static_cast<Eigen::Index>(supernode.rows.size());
    matrix.setZero(size, size);
    const Places places(supernode, m_number);
    for (const int block : supernode.blocks) {
        assemble(block, places, matrix);
    }
    for (const int child : supernode.children) {
        add_update(matrices[child], m_fronts[child].supernode.rows_in_parent, matrix);
        matrices[child].resize(0, 0);
    }
    L.setZero(size, p);
    for (size_t k = 0; k + 1 < panels.size(); ++k) {
        const Eigen::Index begin = panels[k];
        const Eigen::Index end = panels[k + 1];
        const Eigen::Index width = end - begin;
        const Eigen::MatrixXd pivot =
            matrix.block(begin, begin, width, width).selfadjointView<Eigen::Lower>();
        auto inverse = L.block(begin, begin, width, width);
        inverse = pivot.partialPivLu().inverse();
        if (!inverse.allFinite()) {
            return false;
        }
        by_parts(end, size, [&](Eigen::Index from, Eigen::Index rows) {
            add_product(L.block(from, begin, rows, width), 1.0,
                        matrix.block(from, begin, rows, width), inverse);
        });
        // The other panels now, the rows once all panels are eliminated.
        by_parts(end, p, [&](Eigen::Index from, Eigen::Index columns) {
            add_product_transposed(matrix.block(from, from, size - from, columns), -1.0,
                                   L.block(from, begin, size - from, width),
                                   matrix.block(from, begin, columns, width));
        });
    }
    by_parts(p, size, [&](Eigen::Index from, Eigen::Index columns) {
        add_product_transposed(matrix.block(from, from, size - from, columns), -1.0,
                               L.bottomRows(size - from), matrix.block(from, 0, columns, p));
    });
    matrix = matrix.bottomRightCorner(size - p, size - p).eval();
    return true;
}

bool SupernodalFactor::factorize(const Assembly& assemble) {
    const SerialBlas serial;
    std::vector<Eigen::MatrixXd> matrices(m_fronts.size());
    std::atomic<bool> is_regular = true;
    tbb::parallel_for(size_t{0}, m_branches.branches.size(), [&](size_t b) {
        const auto [first, end] = m_branches.branches[b];
        for (int j = first; j < end && is_regular; ++j) {
            if (!eliminate(j, assemble, matrices)) {
                is_regular = false;
            }
        }
    });
    return is_regular && std::ranges::all_of(m_branches.trunk, [&](int front) {
               return eliminate(front, assemble, matrices);
           });
}

Eigen::VectorXd SupernodalFactor::solve(const Eigen::Ref<const Eigen::VectorXd>& b) const {
    Eigen::VectorXd x(b.size());
    x(m_number) = b;
    Eigen::VectorXd v;  // the unknowns of a front
    for (const auto& [supernode, panels, L] : m_fronts) {
        const Eigen::Index size = L.rows();
        v.setZero(size);
        v.head(L.cols()) = x.segment(supernode.begin, L.cols());
        for (size_t k = 0; k + 1 < panels.size(); ++k) {
            const Eigen::Index begin = panels[k];
            const Eigen::Index end = panels[k + 1];
            v.tail(size - end).noalias() -=
                L.block(end, begin, size - end, end - begin) * v.segment(begin, end - begin);
        }
        x.segment(supernode.begin, L.cols()) = v.head(L.cols());
        x(supernode.rows) += v.tail(size - L.cols());
    }
    for (size_t i = m_fronts.size(); i-- > 0;) {
        const auto& [supernode, panels, L] = m_fronts[i];
        const Eigen::Index size = L.rows();
        v.resize(size);
        v.head(L.cols()) = x.segment(supernode.begin, L.cols());
        v.tail(size - L.cols()) = x(supernode.rows);
        for (size_t k = panels.size() - 1; k-- > 0;) {
            const Eigen::Index begin = panels[k];
            const Eigen::Index end = panels[k + 1];
            const Eigen::Index width = end - begin;
            v.segment(begin, width) =
                L.block(begin, begin, width, width) * v.segment(begin, width) -
                L.block(end, begin, size - end, width).transpose() * v.tail(size - end);
        }
        x.segment(supernode.begin, L.cols()) = v.head(L.cols());
    }
    return x(m_number);
}

}  // namespace taut
