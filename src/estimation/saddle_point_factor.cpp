// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/saddle_point_factor.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/LU>
#include <algorithm>
#include <atomic>
#include <numeric>
#include <ranges>

#include "numerics/dense.hpp"

namespace taut {
namespace {

template <typename T>
auto& at(T& values, int i) {
    return values[i];
}

/// A panel takes nodes until it has so many pivots.
constexpr int panel_width = 48;

/// Large products are made by so many rows or columns at once.
constexpr Eigen::Index part_size = 128;

/// A branch of the tree takes at most such a part of the work, unless this is but some milliseconds
/// [multiplications].
constexpr double branch_count = 32.0;
constexpr double least_work = 2e6;

/// Calls in parallel for the parts of first .. end: begin and size of each.
template <typename Function>
void by_parts(Eigen::Index first, Eigen::Index end, const Function& function) {
    if (end - first <= part_size) {
        if (first < end) {
            function(first, end - first);
        }
        return;
    }
    const Eigen::Index parts = (end - first + part_size - 1) / part_size;
    tbb::parallel_for(Eigen::Index{0}, parts, [&](Eigen::Index part) {
        const Eigen::Index from = first + part * part_size;
        function(from, std::min(part_size, end - from));
    });
}

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
        end += at(sizes, block);
        if (end - begins.back() >= panel_width || end == supernode.size) {
            begins.push_back(end);
        }
    }
    return begins;
}

}  // namespace

SaddlePointFactor::SaddlePointFactor(const LocalNet& net, const std::vector<bool>& interior)
    : m_net(net),
      m_edges_of_node(net.free_count),
      m_unknown_of_node(net.free_count),
      m_unknown_of_edge(net.edges.size(), -1) {
    const int n = net.free_count;
    // A length belongs to the later one of its free nodes.
    std::vector<int> sizes(n, 6);
    std::vector<int> place_in_node(net.edges.size(), -1);
    for (int e = 0; e < static_cast<int>(net.edges.size()); ++e) {
        const auto [first, last] = std::minmax(at(net.edges, e)[0], at(net.edges, e)[1]);
        at(m_edges_of_node, first).push_back(e);
        if (last < n) {
            at(m_edges_of_node, last).push_back(e);
        }
        if (interior[e]) {
            at(place_in_node, e) = at(sizes, last < n ? last : first)++;
        }
    }
    std::exclusive_scan(sizes.begin(), sizes.end(), m_unknown_of_node.begin(), 0);
    for (int e = 0; e < static_cast<int>(net.edges.size()); ++e) {
        if (at(place_in_node, e) >= 0) {
            const auto [first, last] = std::minmax(at(net.edges, e)[0], at(net.edges, e)[1]);
            at(m_unknown_of_edge, e) =
                at(m_unknown_of_node, last < n ? last : first) + at(place_in_node, e);
        }
    }
    std::vector<std::vector<int>> couplings(sizes.size());
    for (int j = 0; j < n; ++j) {
        for (const int e : at(m_edges_of_node, j)) {
            const int later = std::ranges::max(at(net.edges, e));
            if (later > j && later < n) {
                for (int k = 0; k < 6; ++k) {
                    at(couplings, j).push_back(at(m_unknown_of_node, later) + k);
                }
                if (is_unknown(e)) {
                    at(couplings, j).push_back(at(m_unknown_of_edge, e));
                }
            }
        }
    }
    SupernodeTree tree = supernode_tree(sizes, std::move(couplings));
    for (Supernode& supernode : tree.supernodes) {
        std::vector<int> panels = panels_of(supernode, sizes);
        m_fronts.push_back(
            {.supernode = std::move(supernode), .panels = std::move(panels), .factor = {}});
    }
    find_branches();
    m_unknowns = static_cast<int>(tree.number.size());
    for (int& unknown : m_unknown_of_node) {
        unknown = at(tree.number, unknown);
    }
    for (int& unknown : m_unknown_of_edge) {
        unknown = unknown < 0 ? -1 : at(tree.number, unknown);
    }

    place_weights.setZero(3, n);
    length_weights.setZero(static_cast<Eigen::Index>(net.edges.size()));
    node_stiffness.assign(n, Eigen::Matrix3d::Zero());
    edge_stiffness.assign(net.edges.size(), Eigen::Matrix3d::Zero());
    length_rates.setZero(3, static_cast<Eigen::Index>(net.edges.size()));
}

/// Takes the largest subtrees that are a small part of the work as branches.
void SaddlePointFactor::find_branches() {
    std::vector<double> work;  // of the subtree of each front
    std::vector<int> first;    // front of the subtree
    for (int j = 0; j < static_cast<int>(m_fronts.size()); ++j) {
        const Supernode& supernode = at(m_fronts, j).supernode;
        const auto p = static_cast<double>(supernode.size);
        const double size = p + static_cast<double>(supernode.rows.size());
        work.push_back(p * size * size);
        first.push_back(j);
        for (const int child : supernode.children) {
            work.back() += at(work, child);
            first.back() = std::min(first.back(), at(first, child));
        }
    }
    double total = 0.0;
    for (int j = 0; j < static_cast<int>(m_fronts.size()); ++j) {
        total += at(m_fronts, j).supernode.parent < 0 ? at(work, j) : 0.0;
    }
    const double most = std::max(total / branch_count, least_work);
    for (int j = 0; j < static_cast<int>(m_fronts.size()); ++j) {
        const int parent = at(m_fronts, j).supernode.parent;
        if (at(work, j) > most) {
            m_trunk.push_back(j);
        } else if (parent < 0 || at(work, parent) > most) {
            m_branches.push_back({.first = at(first, j), .end = j + 1});
        }
    }
}

/// The entries of the matrix in the columns of a supernode's pivots, lower triangle.
void SaddlePointFactor::assemble(const Supernode& supernode, Eigen::MatrixXd& matrix) const {
    const auto size = supernode.size + static_cast<Eigen::Index>(supernode.rows.size());
    matrix.setZero(size, size);
    for (const int node : supernode.blocks) {
        const int own = at(m_unknown_of_node, node) - supernode.begin;
        matrix.diagonal().segment<3>(own) = place_weights.col(node);
        matrix.block<3, 3>(own + 3, own) = at(node_stiffness, node);
        for (const int e : at(m_edges_of_node, node)) {
            const auto [s, t] = at(m_net.edges, e);
            const int other = s == node ? t : s;
            if (other > node && other < m_net.free_count) {
                const int row = supernode.place_of(at(m_unknown_of_node, other));
                matrix.block<3, 3>(row + 3, own) -= at(edge_stiffness, e);
                matrix.block<3, 3>(row, own + 3) -= at(edge_stiffness, e);
            }
            if (is_unknown(e)) {
                const int row = supernode.place_of(at(m_unknown_of_edge, e));
                const double sign = s == node ? 1.0 : -1.0;
                matrix.block<1, 3>(row, own + 3) += sign * length_rates.col(e).transpose();
                if (other < node || other >= m_net.free_count) {
                    matrix(row, row) = length_weights(e);
                }
            }
        }
    }
}

/// Assembles a front with the updates of its children, eliminates the pivots and leaves the update
/// for the parent; lower triangles.
/// @return false where a pivot is singular
bool SaddlePointFactor::eliminate(int front, std::vector<Eigen::MatrixXd>& matrices) {
    auto& [supernode, panels, L] = at(m_fronts, front);
    Eigen::MatrixXd& matrix = at(matrices, front);
    assemble(supernode, matrix);
    for (const int child : supernode.children) {
        add_update(at(matrices, child), at(m_fronts, child).supernode.rows_in_parent, matrix);
        at(matrices, child).resize(0, 0);
    }
    const Eigen::Index size = matrix.rows();
    const auto p = static_cast<Eigen::Index>(supernode.size);
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

bool SaddlePointFactor::factorize() {
    const SerialBlas serial;
    std::vector<Eigen::MatrixXd> matrices(m_fronts.size());
    std::atomic<bool> is_regular = true;
    tbb::parallel_for(size_t{0}, m_branches.size(), [&](size_t b) {
        for (int j = m_branches[b].first; j < m_branches[b].end && is_regular; ++j) {
            if (!eliminate(j, matrices)) {
                is_regular = false;
            }
        }
    });
    return is_regular &&
           std::ranges::all_of(m_trunk, [&](int front) { return eliminate(front, matrices); });
}

Eigen::VectorXd SaddlePointFactor::gather(const Vector& vector) const {
    Eigen::VectorXd unknowns(m_unknowns);
    for (int j = 0; j < m_net.free_count; ++j) {
        unknowns.segment<3>(at(m_unknown_of_node, j)) = vector.places.col(j);
        unknowns.segment<3>(at(m_unknown_of_node, j) + 3) = vector.multipliers.col(j);
    }
    for (int e = 0; e < vector.lengths.size(); ++e) {
        if (is_unknown(e)) {
            unknowns(at(m_unknown_of_edge, e)) = vector.lengths(e);
        }
    }
    return unknowns;
}

SaddlePointFactor::Vector SaddlePointFactor::scatter(const Eigen::VectorXd& unknowns) const {
    Vector vector{.places = Eigen::Matrix3Xd(3, m_net.free_count),
                  .lengths = Eigen::VectorXd::Zero(length_weights.size()),
                  .multipliers = Eigen::Matrix3Xd(3, m_net.free_count)};
    for (int j = 0; j < m_net.free_count; ++j) {
        vector.places.col(j) = unknowns.segment<3>(at(m_unknown_of_node, j));
        vector.multipliers.col(j) = unknowns.segment<3>(at(m_unknown_of_node, j) + 3);
    }
    for (int e = 0; e < vector.lengths.size(); ++e) {
        if (is_unknown(e)) {
            vector.lengths(e) = unknowns(at(m_unknown_of_edge, e));
        }
    }
    return vector;
}

SaddlePointFactor::Vector SaddlePointFactor::solve(const Vector& right_side) const {
    Eigen::VectorXd x = gather(right_side);
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
    for (const auto& [supernode, panels, L] : m_fronts | std::views::reverse) {
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
    return scatter(x);
}

double SaddlePointFactor::extension_variance(int edge, int node, const Supernode& supernode,
                                             const Eigen::MatrixXd& inverse) const {
    const int other = at(m_net.edges, edge)[0] + at(m_net.edges, edge)[1] - node;
    const Eigen::Vector3d u = length_rates.col(edge).normalized();
    // Extension: u of one node, -u of the other (their order is all the same to the sign of the
    // square but for the length's), and the length.
    const double sign = at(m_net.edges, edge)[0] == node ? -1.0 : 1.0;
    const int own = supernode.place_of(at(m_unknown_of_node, node));
    std::vector<int> rows{own, own + 1, own + 2, supernode.place_of(at(m_unknown_of_edge, edge))};
    Eigen::VectorXd w(4);
    w << sign * u, -1.0;
    if (other < m_net.free_count) {
        const int first = supernode.place_of(at(m_unknown_of_node, other));
        rows.insert(rows.end(), {first, first + 1, first + 2});
        w.conservativeResize(7);
        w.tail<3>() = -sign * u;
    }
    return w.dot(inverse(rows, rows) * w);
}

void SaddlePointFactor::read_covariance(const Supernode& supernode, const Eigen::MatrixXd& inverse,
                                        Covariance& result) const {
    for (const int node : supernode.blocks) {
        const int own = supernode.place_of(at(m_unknown_of_node, node));
        at(result.places, node) = inverse.block<3, 3>(own, own);
        for (const int e : at(m_edges_of_node, node)) {
            // With its earlier node the supernode holds all of an edge: both nodes and the length.
            const int other = at(m_net.edges, e)[0] + at(m_net.edges, e)[1] - node;
            if (is_unknown(e) && other > node) {
                const int k = supernode.place_of(at(m_unknown_of_edge, e));
                result.lengths(e) = inverse(k, k);
                result.extensions(e) = extension_variance(e, node, supernode, inverse);
            }
        }
    }
}

/// The inverse at a front, of which its parent has filled in the rows; fills in those of the
/// children. With Z = A^-1, pivots p of a panel and all later unknowns q of the front:
///
///   Z_qp = -Z_qq L,   Z_pp = pivot^-1 - L' Z_qp
void SaddlePointFactor::invert(int front, std::vector<Eigen::MatrixXd>& inverses,
                               Covariance& result) const {
    const auto& [supernode, panels, L] = at(m_fronts, front);
    const Eigen::Index size = L.rows();
    Eigen::MatrixXd& Z = at(inverses, front);
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
    read_covariance(supernode, Z, result);
    for (const int child : supernode.children) {
        const std::vector<int>& rows = at(m_fronts, child).supernode.rows_in_parent;
        const auto q = static_cast<Eigen::Index>(rows.size());
        const Eigen::Index child_size = at(m_fronts, child).factor.rows();
        at(inverses, child).setZero(child_size, child_size);
        at(inverses, child).bottomRightCorner(q, q) = Z(rows, rows);
    }
    Z.resize(0, 0);
}

SaddlePointFactor::Covariance SaddlePointFactor::covariance() const {
    Covariance result{.places = std::vector<Eigen::Matrix3d>(m_edges_of_node.size()),
                      .lengths = Eigen::VectorXd::Zero(length_weights.size()),
                      .extensions = Eigen::VectorXd::Zero(length_weights.size())};
    const SerialBlas serial;
    std::vector<Eigen::MatrixXd> inverses(m_fronts.size());
    for (const int front : m_trunk | std::views::reverse) {
        invert(front, inverses, result);
    }
    tbb::parallel_for(size_t{0}, m_branches.size(), [&](size_t b) {
        for (int j = m_branches[b].end; j-- > m_branches[b].first;) {
            invert(j, inverses, result);
        }
    });
    return result;
}

}  // namespace taut
