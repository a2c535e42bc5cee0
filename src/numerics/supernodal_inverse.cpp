// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#include <algorithm>

#include "numerics/blas.hpp"
#include "numerics/extend_add.hpp"
#include "numerics/parallel.hpp"
#include "numerics/serial_blas.hpp"
#include "numerics/supernodal_factor.hpp"

namespace taut {
namespace {

template <typename Front>
size_t squared_size(const Front& front) {
    return static_cast<size_t>(front.size()) * static_cast<size_t>(front.size());
}

}  // namespace

/// Completes the inverse at a front, given its part over the front's rows.
void SupernodalFactor::finish_inverse(const Front& front, FrontMatrix& Z, Parts parts) const {
    const FrontMatrix L = factor_of(front);
    const std::vector<int>& panels = front.panels;
    const Eigen::Index size = L.rows();
    for (size_t k = panels.size() - 1; k-- > 0;) {
        const Eigen::Index begin = panels[k];
        const Eigen::Index end = panels[k + 1];
        const Eigen::Index width = end - begin;
        const auto below = L.block(end, begin, size - end, width);
        by_parts(parts, end, size, [&](Eigen::Index from, Eigen::Index rows) {
            const auto part = Z.block(from, begin, rows, width);
            multiply(-1.0, Z.block(from, end, rows, size - end), Op::as_it_is, below, Op::as_it_is,
                     0.0, part);
            Z.block(begin, from, width, rows) = part.transpose();
        });
        Eigen::MatrixXd top = L.block(begin, begin, width, width);
        if (size > end) {
            multiply(-1.0, below, Op::transposed, Z.block(end, begin, size - end, width),
                     Op::as_it_is, 1.0, top);
        }
        Z.block(begin, begin, width, width) = 0.5 * (top + top.transpose());
    }
}

void SupernodalFactor::show(const Front& front, const FrontMatrix& Z, const Reader& read) const {
    const Places places(front.supernode, m_number);
    for (const int block : front.supernode.blocks) {
        read(block, places, Z);
    }
}

SupernodalFactor::Needs SupernodalFactor::needs_of_inverse(const std::vector<int>& fronts) const {
    FrontStacks stacks;
    stacks.push(m_fronts[fronts.back()].level, squared_size(m_fronts[fronts.back()]));
    for (size_t k = fronts.size(); k-- > 0;) {
        const Front& front = m_fronts[fronts[k]];
        stacks.pop(front.level, squared_size(front));
        for (const int child : front.supernode.children) {
            stacks.push(front.level + 1, squared_size(m_fronts[child]));
        }
    }
    return {.heights = stacks.heights(), .scratch = 0};
}

/// Inverts the fronts of a branch on one thread. The inverses of the children go onto the stack of
/// their level.
void SupernodalFactor::invert_branch(const std::vector<int>& fronts, const Reader& read,
                                     std::vector<Buffer>& inverses, FrontStacks& stacks) const {
    const int root = fronts.back();
    double* const first = stacks.at(
        m_fronts[root].level, stacks.push(m_fronts[root].level, squared_size(m_fronts[root])));
    if (!inverses[root].empty()) {
        std::copy_n(inverses[root].data(), squared_size(m_fronts[root]), first);
        inverses[root] = Buffer();
    }
    for (size_t k = fronts.size(); k-- > 0;) {
        const Front& front = m_fronts[fronts[k]];
        const size_t place = stacks.pop(front.level, squared_size(front));
        FrontMatrix Z(stacks.at(front.level, place), front.size(), front.size());
        finish_inverse(front, Z, Parts::serial);
        show(front, Z, read);
        for (const int c : front.supernode.children) {
            const Front& child = m_fronts[c];
            FrontMatrix of_child(
                stacks.at(child.level, stacks.push(child.level, squared_size(child))), child.size(),
                child.size());
            take_rows(Z, child.supernode.rows_in_parent, of_child, Parts::serial);
        }
    }
}

/// Inverts a front of the trunk from the part its parent has left, and leaves parts for its
/// children.
void SupernodalFactor::invert(int front, const Reader& read, std::vector<Buffer>& inverses) const {
    const Front& own = m_fronts[front];
    const auto make = [&](int of) {
        const Eigen::Index size = m_fronts[of].size();
        inverses[of] = Buffer(squared_size(m_fronts[of]));
        return FrontMatrix(inverses[of].data(), size, size);
    };
    FrontMatrix Z = own.supernode.parent < 0
                        ? make(front)
                        : FrontMatrix(inverses[front].data(), own.size(), own.size());
    finish_inverse(own, Z, Parts::parallel);
    show(own, Z, read);
    for (const int child : own.supernode.children) {
        FrontMatrix of_child = make(child);
        take_rows(Z, m_fronts[child].supernode.rows_in_parent, of_child, Parts::parallel);
    }
    inverses[front] = Buffer();
}

void SupernodalFactor::selected_inverse(const Reader& read) const {
    const SerialBlas serial;
    std::vector<Buffer> inverses(m_fronts.size());
    Needs needs;
    for (const std::vector<int>& fronts : m_branches) {
        needs.cover(needs_of_inverse(fronts));
    }
    PerThread<FrontStacks> stacks;
    isolate([&] {
        for (size_t k = m_trunk.size(); k-- > 0;) {
            invert(m_trunk[k], read, inverses);
        }
        parallel_for(size_t{0}, m_branches.size(), [&](size_t b) {
            FrontStacks& own = stacks.local();
            own.clear(needs.heights);
            invert_branch(m_branches[b], read, inverses, own);
        });
    });
}

}  // namespace taut
