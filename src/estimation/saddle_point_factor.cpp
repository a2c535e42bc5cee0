// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/saddle_point_factor.hpp"

namespace taut {

SaddlePointFactor::SaddlePointFactor(const LocalNet& net, const std::vector<bool>& interior)
    : m_layout(net, interior), m_factor(m_layout.sizes, m_layout.couplings()) {
    const auto edge_count = static_cast<Eigen::Index>(net.edges.size());
    place_weights.setZero(3, net.free_count);
    length_weights.setZero(edge_count);
    node_stiffness.assign(net.free_count, Eigen::Matrix3d::Zero());
    edge_stiffness.assign(net.edges.size(), Eigen::Matrix3d::Zero());
    length_rates.setZero(3, edge_count);
}

/// The entries of a node's block with itself and with later ones, lower triangle.
void SaddlePointFactor::assemble(int node, const Places& places, Eigen::MatrixXd& front) const {
    const int own = places.of(m_layout.place[node]);
    front.diagonal().segment<3>(own) = place_weights.col(node);
    front.block<3, 3>(own + 3, own) = node_stiffness[node];
    for (const int e : m_layout.edges_of_node[node]) {
        const int other = m_layout.other_end(e, node);
        if (other > node && other < m_layout.free_count()) {
            const int row = places.of(m_layout.place[other]);
            front.block<3, 3>(row + 3, own) -= edge_stiffness[e];
            front.block<3, 3>(row, own + 3) -= edge_stiffness[e];
        }
        if (m_layout.is_unknown(e)) {
            const int row = places.of(m_layout.length[e]);
            const double sign = m_layout.edges[e][0] == node ? 1.0 : -1.0;
            front.block<1, 3>(row, own + 3) += sign * length_rates.col(e).transpose();
            if (other < node || other >= m_layout.free_count()) {
                front(row, row) = length_weights(e);
            }
        }
    }
}

bool SaddlePointFactor::factorize() {
    return m_factor.factorize([this](int node, const Places& places, Eigen::MatrixXd& front) {
        assemble(node, places, front);
    });
}

Eigen::VectorXd SaddlePointFactor::gather(const Vector& vector) const {
    Eigen::VectorXd unknowns(m_factor.unknown_count());
    for (int j = 0; j < m_layout.free_count(); ++j) {
        unknowns.segment<3>(m_layout.place[j]) = vector.places.col(j);
        unknowns.segment<3>(m_layout.multiplier(j)) = vector.multipliers.col(j);
    }
    for (int e = 0; e < vector.lengths.size(); ++e) {
        if (m_layout.is_unknown(e)) {
            unknowns(m_layout.length[e]) = vector.lengths(e);
        }
    }
    return unknowns;
}

SaddlePointFactor::Vector SaddlePointFactor::scatter(const Eigen::VectorXd& unknowns) const {
    Vector vector{.places = Eigen::Matrix3Xd(3, m_layout.free_count()),
                  .lengths = Eigen::VectorXd::Zero(length_weights.size()),
                  .multipliers = Eigen::Matrix3Xd(3, m_layout.free_count())};
    for (int j = 0; j < m_layout.free_count(); ++j) {
        vector.places.col(j) = unknowns.segment<3>(m_layout.place[j]);
        vector.multipliers.col(j) = unknowns.segment<3>(m_layout.multiplier(j));
    }
    for (int e = 0; e < vector.lengths.size(); ++e) {
        if (m_layout.is_unknown(e)) {
            vector.lengths(e) = unknowns(m_layout.length[e]);
        }
    }
    return vector;
}

SaddlePointFactor::Vector SaddlePointFactor::solve(const Vector& right_side) const {
    return scatter(m_factor.solve(gather(right_side)));
}

double SaddlePointFactor::extension_variance(int edge, int node, const Places& places,
                                             const Eigen::MatrixXd& inverse) const {
    const int other = m_layout.other_end(edge, node);
    const Eigen::Vector3d u = length_rates.col(edge).normalized();
    const double sign = m_layout.edges[edge][0] == node ? -1.0 : 1.0;
    const int own = places.of(m_layout.place[node]);
    std::vector<int> rows{own, own + 1, own + 2, places.of(m_layout.length[edge])};
    Eigen::VectorXd w(4);
    w << sign * u, -1.0;
    if (other < m_layout.free_count()) {
        const int first = places.of(m_layout.place[other]);
        rows.insert(rows.end(), {first, first + 1, first + 2});
        w.conservativeResize(7);
        w.tail<3>() = -sign * u;
    }
    return w.dot(inverse(rows, rows) * w);
}

void SaddlePointFactor::read_covariance(int node, const Places& places,
                                        const Eigen::MatrixXd& inverse, Covariance& result) const {
    const int own = places.of(m_layout.place[node]);
    result.places[node] = inverse.block<3, 3>(own, own);
    for (const int e : m_layout.edges_of_node[node]) {
        // With its earlier node the front holds all of an edge: both nodes and the length.
        if (m_layout.is_unknown(e) && m_layout.other_end(e, node) > node) {
            const int k = places.of(m_layout.length[e]);
            result.lengths(e) = inverse(k, k);
            result.extensions(e) = extension_variance(e, node, places, inverse);
        }
    }
}

SaddlePointFactor::Covariance SaddlePointFactor::covariance() const {
    Covariance result{.places = std::vector<Eigen::Matrix3d>(node_stiffness.size()),
                      .lengths = Eigen::VectorXd::Zero(length_weights.size()),
                      .extensions = Eigen::VectorXd::Zero(length_weights.size())};
    m_factor.selected_inverse([&](int node, const Places& places, const Eigen::MatrixXd& inverse) {
        read_covariance(node, places, inverse, result);
    });
    return result;
}

}  // namespace taut
