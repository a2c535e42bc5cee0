// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/supernodal_factor.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

#include "numerics/blas.hpp"
#include "numerics/extend_add.hpp"
#include "numerics/parallel.hpp"
#include "numerics/serial_blas.hpp"

namespace taut {
namespace {

/// A panel takes blocks until it has this many pivots. Where pivot blocks are inverted, panels are
/// as narrow as fast products allow.
int panel_width(Definiteness definiteness) {
    return definiteness == Definiteness::positive_definite ? 96 : 48;
}

/// The first pivot of each panel of a supernode, and the number of pivots.
std::vector<int> panels_of(const Supernode& supernode, const std::vector<int>& sizes, int width) {
    std::vector<int> begins{0};
    int end = 0;
    for (const int block : supernode.blocks) {
        end += sizes[block];
        if (end - begins.back() >= width || end == supernode.size) {
            begins.push_back(end);
        }
    }
    return begins;
}

/// Sets the lower triangle and all rows below it to zero.
void set_zero(FrontMatrix& matrix, Parts parts) {
    by_parts(parts, 0, matrix.cols(), [&](Eigen::Index from, Eigen::Index columns) {
        for (Eigen::Index j = from; j < from + columns; ++j) {
            matrix.col(j).tail(matrix.rows() - j).setZero();
        }
    });
}

size_t squared(Eigen::Index size) {
    return static_cast<size_t>(size) * static_cast<size_t>(size);
}

}  // namespace

SupernodalFactor::SupernodalFactor(const std::vector<int>& sizes,
                                   const std::vector<std::vector<int>>& couplings,
                                   Definiteness definiteness)
    : m_definiteness(definiteness) {
    SupernodeTree tree = supernode_tree(sizes, couplings);
    m_number = std::move(tree.number);
    TreeBranches tree_branches = branches_of(tree.supernodes);
    m_trunk = std::move(tree_branches.trunk);
    for (const auto [first, end] : tree_branches.branches) {
        m_branches.emplace_back(end - first);
        std::iota(m_branches.back().begin(), m_branches.back().end(), first);
    }
    m_fronts.reserve(tree.supernodes.size());
    size_t count = 0;
    for (Supernode& supernode : tree.supernodes) {
        std::vector<int> panels = panels_of(supernode, sizes, panel_width(definiteness));
        const Front& front = m_fronts.emplace_back(
            Front{.supernode = std::move(supernode), .panels = std::move(panels), .begin = count});
        count += static_cast<size_t>(front.size()) * static_cast<size_t>(front.supernode.size);
    }
    for (size_t j = m_fronts.size(); j-- > 0;) {
        const int parent = m_fronts[j].supernode.parent;
        m_fronts[j].level = parent < 0 ? 0 : m_fronts[parent].level + 1;
    }
    for (int b = 0; b < static_cast<int>(m_branches.size()); ++b) {
        m_fronts[m_branches[b].back()].branch = b;
        m_branch_needs.cover(needs_of(m_branches[b]));
    }
    m_trunk_needs = needs_of(m_trunk);
    m_branch_updates.resize(m_branches.size());
    m_values = Buffer(count);
}

double SupernodalFactor::entry_count() const {
    double sum = 0.0;
    for (const Front& front : m_fronts) {
        sum += static_cast<double>(front.size()) * front.supernode.size;
    }
    return sum;
}

double SupernodalFactor::operation_count() const {
    double sum = 0.0;
    for (const Front& front : m_fronts) {
        for (int k = 0; k < front.supernode.size; ++k) {
            const auto length = static_cast<double>(front.size() - k);
            sum += length * length;
        }
    }
    return sum;
}

void SupernodalFactor::Needs::cover(const Needs& other) {
    heights[0] = std::max(heights[0], other.heights[0]);
    heights[1] = std::max(heights[1], other.heights[1]);
    scratch = std::max(scratch, other.scratch);
}

void SupernodalFactor::Workspace::prepare(const Needs& needs) {
    stacks.clear(needs.heights);
    if (scratch.size() < needs.scratch) {
        scratch = Buffer(needs.scratch);
    }
}

FrontMatrix SupernodalFactor::factor_of(const Front& front) const {
    return {m_values.data() + front.begin, front.size(), front.supernode.size};
}

SupernodalFactor::Needs SupernodalFactor::needs_of(const std::vector<int>& fronts) const {
    FrontStacks stacks;
    Needs needs;
    for (const int j : fronts) {
        const Front& front = m_fronts[j];
        for (const int child : front.supernode.children) {
            if (m_fronts[child].branch < 0) {
                stacks.pop(front.level + 1, squared(m_fronts[child].row_count()));
            }
        }
        stacks.push(front.level, squared(front.row_count()));
        if (m_definiteness == Definiteness::indefinite) {
            needs.scratch =
                std::max(needs.scratch, static_cast<size_t>(front.size() * front.supernode.size));
        }
    }
    needs.heights = stacks.heights();
    return needs;
}

/// Assembles a front and eliminates its pivots. The updates of the children are added to the
/// columns of the pivots before the elimination, and to the rest of the front after it.
/// @param U becomes the update for the parent
bool SupernodalFactor::eliminate(const Front& front, const Assembly& assemble, FrontMatrix& U,
                                 Workspace& workspace, Parts parts) {
    FrontMatrix L = factor_of(front);
    set_zero(L, parts);
    const Places places(front.supernode, m_number);
    for (const int block : front.supernode.blocks) {
        assemble(block, places, L);
    }
    const auto add_updates = [&](Eigen::Index corner, FrontMatrix& columns) {
        for (size_t c = 0; c < workspace.updates.size(); ++c) {
            const Supernode& child = m_fronts[front.supernode.children[c]].supernode;
            extend_add(workspace.updates[c], child.rows_in_parent, corner, columns, parts);
        }
    };
    add_updates(0, L);
    if (!eliminate_pivots(m_definiteness, front.panels, L, U, workspace.scratch.data(), parts)) {
        return false;
    }
    add_updates(L.cols(), U);
    return true;
}

/// Several fronts, children before parents, with the updates of branches that end at one of them.
bool SupernodalFactor::eliminate(const std::vector<int>& fronts, const Assembly& assemble,
                                 Workspace& workspace, Parts parts) {
    FrontStacks& stacks = workspace.stacks;
    for (const int j : fronts) {
        const Front& front = m_fronts[j];
        const std::vector<int>& children = front.supernode.children;
        workspace.updates.resize(children.size());
        for (size_t c = children.size(); c-- > 0;) {
            const Front& child = m_fronts[children[c]];
            workspace.updates[c] =
                child.branch >= 0
                    ? m_branch_updates[child.branch].data()
                    : stacks.at(child.level, stacks.pop(child.level, squared(child.row_count())));
        }
        const Eigen::Index q = front.row_count();
        FrontMatrix U(stacks.at(front.level, stacks.push(front.level, squared(q))), q, q);
        if (!eliminate(front, assemble, U, workspace, parts)) {
            return false;
        }
    }
    return true;
}

/// Eliminates a branch on one thread, and keeps the update of its root.
bool SupernodalFactor::eliminate_branch(int branch, const Assembly& assemble) {
    const std::vector<int>& fronts = m_branches[branch];
    Workspace& workspace = m_branch_workspaces.local();
    workspace.prepare(m_branch_needs);
    if (!eliminate(fronts, assemble, workspace, Parts::serial)) {
        return false;
    }
    const Front& root = m_fronts[fronts.back()];
    const size_t size = squared(root.row_count());
    if (m_branch_updates[branch].size() < size) {
        m_branch_updates[branch] = Buffer(size);
    }
    std::copy_n(workspace.stacks.at(root.level, 0), size, m_branch_updates[branch].data());
    return true;
}

bool SupernodalFactor::factorize(const Assembly& assemble) {
    const SerialBlas serial;
    std::atomic<bool> is_regular = true;
    // Isolated: a thread that waits here must not start other work that uses the same memory.
    isolate([&] {
        parallel_for(0, static_cast<int>(m_branches.size()), [&](int branch) {
            if (is_regular && !eliminate_branch(branch, assemble)) {
                is_regular = false;
            }
        });
        if (is_regular) {
            m_trunk_workspace.prepare(m_trunk_needs);
            is_regular = eliminate(m_trunk, assemble, m_trunk_workspace, Parts::parallel);
        }
    });
    return is_regular;
}

Eigen::VectorXd SupernodalFactor::solve(const Eigen::Ref<const Eigen::VectorXd>& b) const {
    const SerialBlas serial;
    const bool is_definite = m_definiteness == Definiteness::positive_definite;
    Eigen::VectorXd x(b.size());
    x(m_number) = b;
    Eigen::VectorXd v;  // the unknowns of a front
    for (const Front& front : m_fronts) {
        const Supernode& supernode = front.supernode;
        const std::vector<int>& panels = front.panels;
        const FrontMatrix L = factor_of(front);
        const Eigen::Index size = L.rows();
        v.setZero(size);
        v.head(L.cols()) = x.segment(supernode.begin, L.cols());
        for (size_t k = 0; k + 1 < panels.size(); ++k) {
            const Eigen::Index begin = panels[k];
            const Eigen::Index end = panels[k + 1];
            const Eigen::Index width = end - begin;
            if (is_definite) {
                L.block(begin, begin, width, width)
                    .triangularView<Eigen::Lower>()
                    .solveInPlace(v.segment(begin, width));
            }
            add_product(-1.0, L.block(end, begin, size - end, width), Op::as_it_is,
                        v.segment(begin, width), v.tail(size - end));
        }
        x.segment(supernode.begin, L.cols()) = v.head(L.cols());
        x(supernode.rows) += v.tail(size - L.cols());
    }
    for (size_t i = m_fronts.size(); i-- > 0;) {
        const Supernode& supernode = m_fronts[i].supernode;
        const std::vector<int>& panels = m_fronts[i].panels;
        const FrontMatrix L = factor_of(m_fronts[i]);
        const Eigen::Index size = L.rows();
        v.resize(size);
        v.head(L.cols()) = x.segment(supernode.begin, L.cols());
        v.tail(size - L.cols()) = x(supernode.rows);
        for (size_t k = panels.size() - 1; k-- > 0;) {
            const Eigen::Index begin = panels[k];
            const Eigen::Index end = panels[k + 1];
            const Eigen::Index width = end - begin;
            const auto pivot = L.block(begin, begin, width, width);
            const auto below = L.block(end, begin, size - end, width);
            auto own = v.segment(begin, width);
            if (!is_definite) {
                own = (pivot * own).eval();
            }
            add_product(-1.0, below, Op::transposed, v.tail(size - end), own);
            if (is_definite) {
                pivot.triangularView<Eigen::Lower>().transpose().solveInPlace(own);
            }
        }
        x.segment(supernode.begin, L.cols()) = v.head(L.cols());
    }
    return x(m_number);
}

double SupernodalFactor::log_determinant() const {
    double sum = 0.0;
    for (const Front& front : m_fronts) {
        const FrontMatrix L = factor_of(front);
        if (m_definiteness == Definiteness::positive_definite) {
            sum += 2.0 * L.diagonal().array().log().sum();
            continue;
        }
        for (size_t k = 0; k + 1 < front.panels.size(); ++k) {
            const Eigen::Index begin = front.panels[k];
            const Eigen::Index width = front.panels[k + 1] - begin;
            // The inverse of the pivots is kept.
            const Eigen::PartialPivLU<Eigen::MatrixXd> lu(L.block(begin, begin, width, width));
            sum -= lu.matrixLU().diagonal().array().abs().log().sum();
        }
    }
    return sum;
}

Eigen::VectorXd SupernodalFactor::pivots() const {
    Eigen::VectorXd found(m_number.size());
    for (const Front& front : m_fronts) {
        found.segment(front.supernode.begin, front.supernode.size) =
            factor_of(front).diagonal().cwiseAbs2();
    }
    return found(m_number);
}

}  // namespace taut
