// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/saddle_point_factor.hpp"

#include <algorithm>

namespace taut {

SaddlePointFactor::SaddlePointFactor(const LocalNet& net, const std::vector<bool>& unknown,
                                     Supports supports, Lengths lengths)
    : m_layout(net, unknown, supports, lengths), m_factor(m_layout.sizes, m_layout.couplings()) {
    const auto edge_count = static_cast<Eigen::Index>(net.edges.size());
    place_weights.setZero(3, m_layout.node_count());
    cross_place_weights.setZero(3, m_layout.node_count());
    length_weights.setZero(edge_count);
    load_variances.setZero(3, net.free_count);
    node_stiffness.assign(net.free_count, Eigen::Matrix3d::Zero());
    edge_stiffness.assign(net.edges.size(), Eigen::Matrix3d::Zero());
    length_rates.setZero(3, edge_count);
    reading_weights.setZero(edge_count);
    reading_place_rates.setZero(3, edge_count);
    reading_length_rates.setZero(edge_count);
    if (lengths == Lengths::coupled) {
        length_couplings.setZero(edge_count, edge_count);
        for (int e = 0; e < edge_count; ++e) {
            if (m_layout.is_unknown(e)) {
                m_coupled.push_back(e);
            }
        }
        std::ranges::sort(m_coupled, {}, [this](int edge) { return m_layout.length[edge]; });
    }
}

/// The entries of a node's block with itself and with later ones, lower triangle.
void SaddlePointFactor::assemble(int node, const Places& places, Eigen::MatrixXd& front) const {
    const int own = places.of(m_layout.place[node]);
    front.diagonal().segment<3>(own) = place_weights.col(node);
    front(own + 1, own) = cross_place_weights(0, node);
    front(own + 2, own) = cross_place_weights(1, node);
    front(own + 2, own + 1) = cross_place_weights(2, node);
    if (m_layout.is_free(node)) {
        front.diagonal().segment<3>(own + 3) = -load_variances.col(node);
        front.block<3, 3>(own + 3, own) = node_stiffness[node];
    }
    for (const int e : m_layout.edges_of_node[node]) {
        const int other = m_layout.other_end(e, node);
        const bool is_before = m_layout.is_before(node, other);
        if (is_before) {
            const int row = places.of(m_layout.place[other]);
            front.block<3, 3>(row + 3, own) -= edge_stiffness[e];
            if (m_layout.is_free(node)) {
                front.block<3, 3>(row, own + 3) -= edge_stiffness[e];
            }
        }
        if (m_layout.is_unknown(e)) {
            const int row = places.of(m_layout.length[e]);
            const double sign = m_layout.edges[e][0] == node ? 1.0 : -1.0;
            if (m_layout.is_free(node)) {
                front.block<1, 3>(row, own + 3) += sign * length_rates.col(e).transpose();
            }
            if (!is_before) {
                front(row, row) += length_weights(e);
                assemble_couplings(e, places, front);
            }
        }
        if (reading_weights(e) > 0.0) {
            assemble_reading(e, node, places, front);
        }
    }
}

/// The entries of a coupled length with itself and with later ones.
void SaddlePointFactor::assemble_couplings(int edge, const Places& places,
                                           Eigen::MatrixXd& front) const {
    const int own = m_layout.length[edge];
    const int column = places.of(own);
    for (const int other : m_coupled) {
        if (m_layout.length[other] >= own) {
            front(places.of(m_layout.length[other]), column) += length_couplings(other, edge);
        }
    }
}

/// The entries of w a a' in a node's block.
void SaddlePointFactor::assemble_reading(int edge, int node, const Places& places,
                                         Eigen::MatrixXd& front) const {
    const int own = places.of(m_layout.place[node]);
    const int other = m_layout.other_end(edge, node);
    const double w = reading_weights(edge);
    const Eigen::Vector3d a = reading_place_rates.col(edge);
    const Eigen::Matrix3d product = w * a * a.transpose();
    front.block<3, 3>(own, own).triangularView<Eigen::Lower>() += product;
    if (m_layout.is_before(node, other)) {
        front.block<3, 3>(places.of(m_layout.place[other]), own) -= product;
    }
    if (m_layout.is_unknown(edge)) {
        const int row = places.of(m_layout.length[edge]);
        const double sign = m_layout.edges[edge][0] == node ? 1.0 : -1.0;
        const double rate = reading_length_rates(edge);
        front.block<1, 3>(row, own) += sign * w * rate * a.transpose();
        if (!m_layout.is_before(node, other)) {
            front(row, row) += w * rate * rate;
        }
    }
}

bool SaddlePointFactor::factorize() {
    return m_factor.factorize([this](int block, const Places& places, Eigen::MatrixXd& front) {
        assemble(m_layout.node_of(block), places, front);
    });
}

Eigen::VectorXd SaddlePointFactor::gather(const Vector& vector) const {
    Eigen::VectorXd unknowns(m_factor.unknown_count());
    for (int j = 0; j < m_layout.node_count(); ++j) {
        unknowns.segment<3>(m_layout.place[j]) = vector.places.col(j);
    }
    for (int j = 0; j < m_layout.free_count; ++j) {
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
    Vector vector{.places = Eigen::Matrix3Xd(3, m_layout.node_count()),
                  .lengths = Eigen::VectorXd::Zero(length_weights.size()),
                  .multipliers = Eigen::Matrix3Xd(3, m_layout.free_count)};
    for (int j = 0; j < m_layout.node_count(); ++j) {
        vector.places.col(j) = unknowns.segment<3>(m_layout.place[j]);
    }
    for (int j = 0; j < m_layout.free_count; ++j) {
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

/// Of place_rate (r_s - r_t) + length_rate d, in the front of the earlier end.
double SaddlePointFactor::variance(int edge, const Eigen::Vector3d& place_rate, double length_rate,
                                   const Places& places, const Eigen::MatrixXd& inverse) const {
    std::vector<int> rows;
    Eigen::VectorXd w = Eigen::VectorXd::Zero(7);
    for (const int node : m_layout.edges[edge]) {
        if (m_layout.has_block(node)) {
            const double sign = m_layout.edges[edge][0] == node ? 1.0 : -1.0;
            const int first = places.of(m_layout.place[node]);
            w.segment<3>(std::ssize(rows)) = sign * place_rate;
            rows.insert(rows.end(), {first, first + 1, first + 2});
        }
    }
    if (m_layout.is_unknown(edge)) {
        w(std::ssize(rows)) = length_rate;
        rows.push_back(places.of(m_layout.length[edge]));
    }
    w.conservativeResize(std::ssize(rows));
    return w.dot(inverse(rows, rows) * w);
}

void SaddlePointFactor::read_covariance(int node, const Places& places,
                                        const Eigen::MatrixXd& inverse, Covariance& result) const {
    const int own = places.of(m_layout.place[node]);
    result.places[node] = inverse.block<3, 3>(own, own);
    if (m_layout.is_free(node)) {
        result.multipliers[node] = inverse.block<3, 3>(own + 3, own + 3);
    }
    for (const int e : m_layout.edges_of_node[node]) {
        // With its earlier node the front holds all of an edge: both nodes and the length.
        const int other = m_layout.other_end(e, node);
        if (m_layout.has_block(other) && !m_layout.is_before(node, other)) {
            continue;
        }
        if (m_layout.is_unknown(e)) {
            const int k = places.of(m_layout.length[e]);
            result.lengths(e) = inverse(k, k);
            result.extensions(e) = variance(e, extension_rate(e), -1.0, places, inverse);
        }
        result.readings(e) =
            variance(e, reading_place_rates.col(e), reading_length_rates(e), places, inverse);
    }
}

SaddlePointFactor::Covariance SaddlePointFactor::covariance() const {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(length_weights.size());
    Covariance result{.places = std::vector<Eigen::Matrix3d>(m_layout.node_count()),
                      .multipliers = std::vector<Eigen::Matrix3d>(m_layout.free_count),
                      .lengths = zero,
                      .extensions = zero,
                      .readings = zero};
    m_factor.selected_inverse([&](int block, const Places& places, const Eigen::MatrixXd& inverse) {
        read_covariance(m_layout.node_of(block), places, inverse, result);
    });
    return result;
}

}  // namespace taut
