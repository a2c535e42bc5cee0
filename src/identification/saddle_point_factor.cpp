// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/saddle_point_factor.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>
#include <ranges>

namespace taut {
namespace {

template <typename T>
auto& at(T& values, int i) {
    return values[static_cast<size_t>(i)];
}

}  // namespace

SaddlePointFactor::SaddlePointFactor(const LocalNet& net, const std::vector<bool>& interior)
    : m_net(net),
      m_fronts(static_cast<size_t>(net.free_count)),
      m_unknown_of_edge(net.edges.size(), -1) {
    const int n = net.free_count;
    // A length belongs to the later one of its free nodes.
    std::vector<std::vector<int>> own_lengths(m_fronts.size());
    for (int e = 0; e < static_cast<int>(net.edges.size()); ++e) {
        const auto [first, last] =
            std::minmax(net.edges[static_cast<size_t>(e)][0], net.edges[static_cast<size_t>(e)][1]);
        at(m_fronts, first).edges.push_back(e);
        if (last < n) {
            at(m_fronts, last).edges.push_back(e);
        }
        if (interior[static_cast<size_t>(e)]) {
            at(own_lengths, last < n ? last : first).push_back(e);
        }
    }
    std::vector<int> node_of_unknown;
    for (int j = 0; j < n; ++j) {
        Front& front = at(m_fronts, j);
        front.begin = m_unknowns;
        front.size = 6 + static_cast<int>(at(own_lengths, j).size());
        for (int k = 6; k < front.size; ++k) {
            at(m_unknown_of_edge, at(own_lengths, j)[static_cast<size_t>(k - 6)]) = m_unknowns + k;
        }
        m_unknowns += front.size;
        node_of_unknown.resize(static_cast<size_t>(m_unknowns), j);
    }
    std::vector<std::vector<int>> children(m_fronts.size());
    for (int j = 0; j < n; ++j) {
        Front& front = at(m_fronts, j);
        for (const int e : front.edges) {
            const int later = std::ranges::max(at(net.edges, e));
            if (later > j && later < n) {
                for (int k = 0; k < 6; ++k) {
                    front.rows.push_back(at(m_fronts, later).begin + k);
                }
                if (is_unknown(e)) {
                    front.rows.push_back(at(m_unknown_of_edge, e));
                }
            }
        }
        for (const int child : at(children, j)) {
            std::ranges::copy_if(at(m_fronts, child).rows, std::back_inserter(front.rows),
                                 [&](int row) { return row >= front.begin + front.size; });
        }
        std::ranges::sort(front.rows);
        const auto doubled = std::ranges::unique(front.rows);
        front.rows.erase(doubled.begin(), doubled.end());
        if (!front.rows.empty()) {
            front.parent = at(node_of_unknown, front.rows.front());
            at(children, front.parent).push_back(j);
            ++at(m_fronts, front.parent).children;
        }
    }
    // Depth first from the roots, reversed: few updates wait at any time.
    std::vector<int> stack;
    for (int j = n - 1; j >= 0; --j) {
        if (at(m_fronts, j).parent < 0) {
            stack.push_back(j);
        }
    }
    while (!stack.empty()) {
        const int j = stack.back();
        stack.pop_back();
        m_sequence.push_back(j);
        stack.insert(stack.end(), at(children, j).begin(), at(children, j).end());
    }
    std::ranges::reverse(m_sequence);

    place_weights.setZero(3, n);
    length_weights.setZero(static_cast<Eigen::Index>(net.edges.size()));
    node_stiffness.assign(m_fronts.size(), Eigen::Matrix3d::Zero());
    edge_stiffness.assign(net.edges.size(), Eigen::Matrix3d::Zero());
    length_rates.setZero(3, static_cast<Eigen::Index>(net.edges.size()));
}

void SaddlePointFactor::set_places(const Front& front, std::vector<int>& place) const {
    for (int k = 0; k < front.size; ++k) {
        at(place, front.begin + k) = k;
    }
    for (size_t k = 0; k < front.rows.size(); ++k) {
        at(place, front.rows[k]) = front.size + static_cast<int>(k);
    }
}

/// The entries of the matrix in the columns of a front, lower triangle.
void SaddlePointFactor::assemble(int node, Eigen::MatrixXd& matrix, std::vector<int>& place) const {
    const Front& front = at(m_fronts, node);
    set_places(front, place);
    const auto size = front.size + static_cast<Eigen::Index>(front.rows.size());
    matrix.setZero(size, size);
    matrix.diagonal().head<3>() = place_weights.col(node);
    matrix.block<3, 3>(3, 0) = at(node_stiffness, node);
    for (const int e : front.edges) {
        const auto [s, t] = at(m_net.edges, e);
        const int other = s == node ? t : s;
        if (other > node && other < m_net.free_count) {
            const int row = at(place, at(m_fronts, other).begin);
            matrix.block<3, 3>(row + 3, 0) -= at(edge_stiffness, e);
            matrix.block<3, 3>(row, 3) -= at(edge_stiffness, e);
        }
        if (is_unknown(e)) {
            const int row = at(place, at(m_unknown_of_edge, e));
            const double sign = s == node ? 1.0 : -1.0;
            matrix.block<1, 3>(row, 3) += sign * length_rates.col(e).transpose();
            if (row < front.size) {
                matrix(row, row) = length_weights(e);
            }
        }
    }
}

bool SaddlePointFactor::factorize() {
    std::vector<Eigen::MatrixXd> updates(m_fronts.size());
    std::vector<std::vector<int>> children(m_fronts.size());
    std::vector<int> place(static_cast<size_t>(m_unknowns));
    Eigen::MatrixXd matrix;
    for (const int j : m_sequence) {
        Front& front = at(m_fronts, j);
        assemble(j, matrix, place);
        for (const int child : at(children, j)) {
            const std::vector<int>& rows = at(m_fronts, child).rows;
            Eigen::MatrixXd& update = at(updates, child);
            for (Eigen::Index b = 0; b < update.cols(); ++b) {
                double* const column = matrix.col(at(place, rows[static_cast<size_t>(b)])).data();
                for (Eigen::Index a = b; a < update.rows(); ++a) {
                    column[at(place, rows[static_cast<size_t>(a)])] += update(a, b);
                }
            }
            update.resize(0, 0);
        }
        const auto p = static_cast<Eigen::Index>(front.size);
        const auto q = static_cast<Eigen::Index>(front.rows.size());
        const Eigen::MatrixXd pivot = matrix.topLeftCorner(p, p).selfadjointView<Eigen::Lower>();
        front.pivot_inverse = pivot.partialPivLu().inverse();
        if (!front.pivot_inverse.allFinite()) {
            return false;
        }
        front.L.noalias() = matrix.bottomLeftCorner(q, p) * front.pivot_inverse;
        if (q > 0) {
            Eigen::MatrixXd& update = at(updates, j);
            update = matrix.bottomRightCorner(q, q);
            update.triangularView<Eigen::Lower>() -=
                front.L * matrix.bottomLeftCorner(q, p).transpose();
            at(children, front.parent).push_back(j);
        }
    }
    return true;
}

Eigen::VectorXd SaddlePointFactor::gather(const Vector& vector) const {
    Eigen::VectorXd unknowns(m_unknowns);
    for (int j = 0; j < m_net.free_count; ++j) {
        unknowns.segment<3>(at(m_fronts, j).begin) = vector.places.col(j);
        unknowns.segment<3>(at(m_fronts, j).begin + 3) = vector.multipliers.col(j);
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
        vector.places.col(j) = unknowns.segment<3>(at(m_fronts, j).begin);
        vector.multipliers.col(j) = unknowns.segment<3>(at(m_fronts, j).begin + 3);
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
    for (const int j : m_sequence) {
        const Front& front = at(m_fronts, j);
        x(front.rows) -= front.L * x.segment(front.begin, front.size);
    }
    for (const int j : m_sequence | std::views::reverse) {
        const Front& front = at(m_fronts, j);
        x.segment(front.begin, front.size) =
            front.pivot_inverse * x.segment(front.begin, front.size) -
            front.L.transpose() * x(front.rows);
    }
    return scatter(x);
}

double SaddlePointFactor::extension_variance(int edge, int node, const Eigen::MatrixXd& inverse,
                                             const std::vector<int>& place) const {
    const int other = at(m_net.edges, edge)[0] + at(m_net.edges, edge)[1] - node;
    const Eigen::Vector3d u = length_rates.col(edge).normalized();
    // Extension: u of one node, -u of the other (their order is all the same to the sign of the
    // square but for the length's), and the length.
    const double sign = at(m_net.edges, edge)[0] == node ? -1.0 : 1.0;
    std::vector<int> rows{0, 1, 2, at(place, at(m_unknown_of_edge, edge))};
    Eigen::VectorXd w(4);
    w << sign * u, -1.0;
    if (other < m_net.free_count) {
        const int first = at(place, at(m_fronts, other).begin);
        rows.insert(rows.end(), {first, first + 1, first + 2});
        w.conservativeResize(7);
        w.tail<3>() = -sign * u;
    }
    return w.dot(inverse(rows, rows) * w);
}

SaddlePointFactor::Covariance SaddlePointFactor::covariance() const {
    Covariance result{.places = std::vector<Eigen::Matrix3d>(m_fronts.size()),
                      .lengths = Eigen::VectorXd::Zero(length_weights.size()),
                      .extensions = Eigen::VectorXd::Zero(length_weights.size())};
    // With Z = A^-1, pivots p and rows q of a front, from the roots on:
    //   Z_qp = -Z_qq L,   Z_pp = pivot^-1 - L' Z_qp,
    // where Z_qq is part of what the parent has found.
    std::vector<Eigen::MatrixXd> inverses(m_fronts.size());
    std::vector<int> waiting(m_fronts.size());
    std::vector<int> place(static_cast<size_t>(m_unknowns));
    for (const int j : m_sequence | std::views::reverse) {
        const Front& front = at(m_fronts, j);
        const auto p = static_cast<Eigen::Index>(front.size);
        const auto q = static_cast<Eigen::Index>(front.rows.size());
        Eigen::MatrixXd& Z = at(inverses, j);
        Z.resize(p + q, p + q);
        if (q > 0) {
            set_places(at(m_fronts, front.parent), place);
            std::vector<int> from(front.rows.size());
            std::ranges::transform(front.rows, from.begin(),
                                   [&](int row) { return at(place, row); });
            Z.bottomRightCorner(q, q) = at(inverses, front.parent)(from, from);
            if (--at(waiting, front.parent) == 0) {
                at(inverses, front.parent).resize(0, 0);
            }
        }
        Z.bottomLeftCorner(q, p).noalias() = -Z.bottomRightCorner(q, q) * front.L;
        Z.topRightCorner(p, q) = Z.bottomLeftCorner(q, p).transpose();
        Z.topLeftCorner(p, p) =
            front.pivot_inverse - front.L.transpose() * Z.bottomLeftCorner(q, p);
        at(result.places, j) =
            0.5 * (Z.topLeftCorner<3, 3>() + Z.topLeftCorner<3, 3>().transpose());
        set_places(front, place);
        for (const int e : front.edges) {
            // At its earlier node the front holds all of an edge: both nodes and the length.
            const int other = at(m_net.edges, e)[0] + at(m_net.edges, e)[1] - j;
            if (is_unknown(e) && other > j) {
                const int k = at(place, at(m_unknown_of_edge, e));
                result.lengths(e) = Z(k, k);
                result.extensions(e) = extension_variance(e, j, Z, place);
            }
        }
        at(waiting, j) = front.children;
        if (front.children == 0) {
            Z.resize(0, 0);
        }
    }
    return result;
}

}  // namespace taut
