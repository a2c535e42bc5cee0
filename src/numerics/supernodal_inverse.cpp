// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <tbb/parallel_for.h>

#include "numerics/dense.hpp"
#include "numerics/parts.hpp"
#include "numerics/serial_blas.hpp"
#include "numerics/supernodal_factor.hpp"

namespace taut {

/// Finishes the inverse at a front, of which its parent has filled in the rows; fills in those of
/// the children.
void SupernodalFactor::invert(int front, const Reader& read,
                              std::vector<Eigen::MatrixXd>& inverses) const {
    const auto& [supernode, panels, L] = m_fronts[front];
    const Eigen::Index size = L.rows();
    Eigen::MatrixXd& Z = inverses[front];
    if (supernode.parent < 0) {
        Z.setZero(size, size);
    }
    for (size_t k = panels.size() - 1; k-- > 0;) {
        const Eigen::Index begin = panels[k];
        const Eigen::Index end = panels[k + 1];
        const Eigen::Index width = end - begin;
        const auto factor = L.block(end, begin, size - end, width);
        const auto side = Z.block(end, begin, size - end, width);
        by_parts(end, size, [&](Eigen::Index from, Eigen::Index rows) {
            add_product(Z.block(from, begin, rows, width), -1.0,
                        Z.block(from, end, rows, size - end), factor);
        });
        Eigen::MatrixXd top = L.block(begin, begin, width, width);
        add_transposed_product(top, -1.0, factor, side);
        Z.block(begin, end, width, size - end) = side.transpose();
        Z.block(begin, begin, width, width) = 0.5 * (top + top.transpose());
    }
    const Places places(supernode, m_number);
    for (const int block : supernode.blocks) {
        read(block, places, Z);
    }
    for (const int child : supernode.children) {
        const std::vector<int>& rows = m_fronts[child].supernode.rows_in_parent;
        const auto q = static_cast<Eigen::Index>(rows.size());
        const Eigen::Index child_size = m_fronts[child].factor.rows();
        inverses[child].setZero(child_size, child_size);
        inverses[child].bottomRightCorner(q, q) = Z(rows, rows);
    }
    Z.resize(0, 0);
}

void SupernodalFactor::selected_inverse(const Reader& read) const {
    const SerialBlas serial;
    std::vector<Eigen::MatrixXd> inverses(m_fronts.size());
    for (size_t k = m_branches.trunk.size(); k-- > 0;) {
        invert(m_branches.trunk[k], read, inverses);
    }
    tbb::parallel_for(size_t{0}, m_branches.branches.size(), [&](size_t b) {
        const auto [first, end] = m_branches.branches[b];
        for (int j = end; j-- > first;) {
            invert(j, read, inverses);
        }
    });
}

}  // namespace taut
