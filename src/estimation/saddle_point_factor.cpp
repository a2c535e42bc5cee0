// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/saddle_point_factor.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <limits>

namespace taut {
namespace {

double sign_at(const SaddlePointLayout& layout, int edge, int node) {
    return layout.edges[edge][0] == node ? 1.0 : -1.0;
}

}  // namespace

SaddlePointFactor::SaddlePointFactor(const LocalNet& net, const std::vector<bool>& unknown,
                                     Supports supports, Lengths lengths)
    : m_lengths_last(net, unknown, supports, lengths, LengthsGo::last),
      m_lengths_first(net, unknown, supports, lengths, LengthsGo::first) {
    const auto edge_count = static_cast<Eigen::Index>(net.edges.size());
    place_weights.setZero(3, m_lengths_last.node_count());
    cross_place_weights.setZero(3, m_lengths_last.node_count());
    length_weights.setZero(edge_count);
    load_variances.setZero(3, net.free_count);
    cross_load_variances.setZero(3, net.free_count);
    node_stiffness.assign(net.free_count, Eigen::Matrix3d::Zero());
    edge_stiffness.assign(net.edges.size(), Eigen::Matrix3d::Zero());
    pair_stiffness.assign(net.spring_pairs.size(), Eigen::Matrix3d::Zero());
    length_rates.setZero(3, edge_count);
    force_weights.setZero(edge_count);
    force_place_rates.setZero(3, edge_count);
    force_length_rates.setZero(edge_count);
    if (lengths == Lengths::coupled) {
        length_couplings.setZero(edge_count, edge_count);
        for (int e = 0; e < edge_count; ++e) {
            if (unknown[e]) {
                m_coupled.push_back(e);
            }
        }
        std::ranges::sort(m_coupled, {}, [this](int edge) { return m_lengths_last.length[edge]; });
    }
}

double SaddlePointFactor::precision() const {
    double least_known = std::numeric_limits<double>::infinity();
    double precision = 0.0;
    for (int e = 0; e < length_weights.size(); ++e) {
        if (m_lengths_last.unknown[e]) {
            least_known = std::min(least_known, length_weights(e));
            precision = std::max(precision, length_pivot(e) / length_weights(e) - 1.0);
        }
    }
    for (int node = 0; node < m_lengths_last.node_count(); ++node) {
        double observed = place_weights.col(node).maxCoeff() / least_known;
        if (observed > 0.0 && m_lengths_last.is_free(node)) {
            const Eigen::Vector3d stiffness =
                Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>()
                    .computeDirect(node_stiffness[node], Eigen::EigenvaluesOnly)
                    .eigenvalues();
            const double condition =
                stiffness.cwiseAbs().maxCoeff() / stiffness.cwiseAbs().minCoeff();
            observed *= condition * condition;
        }
        precision = !(observed <= precision) ? observed : precision;
    }
    return precision;
}

/// The entries of a node's block with itself and with later ones, lower triangle.
void SaddlePointFactor::assemble(int node, const Places& places, FrontMatrix& front) const {
    const int own = places.of(layout().place[node]);
    front.diagonal().segment<3>(own) += place_weights.col(node);
    front(own + 1, own) += cross_place_weights(0, node);
    front(own + 2, own) += cross_place_weights(1, node);
    front(own + 2, own + 1) += cross_place_weights(2, node);
    if (layout().is_free(node)) {
        front.diagonal().segment<3>(own + 3) -= load_variances.col(node);
        front(own + 4, own + 3) -= cross_load_variances(0, node);
        front(own + 5, own + 3) -= cross_load_variances(1, node);
        front(own + 5, own + 4) -= cross_load_variances(2, node);
        front.block<3, 3>(own + 3, own) += node_stiffness[node];
    }
    for (const SaddlePointLayout::Pair& pair : layout().pairs_of_node[node]) {
        const int row = places.of(layout().place[pair.other]);
        const Eigen::Matrix3d stiffness = pair_stiffness[pair.index].transpose();
        front.block<3, 3>(row + 3, own) += stiffness;
        front.block<3, 3>(row, own + 3) += stiffness;
    }
    for (const int e : layout().edges_of_node[node]) {
        assemble_edge(e, node, places, front);
        if (force_weights(e) > 0.0) {
            assemble_force(e, node, places, front);
        }
        if (layout().goes_first(e)) {
            assemble_condensed(e, node, places, front);
        }
    }
}

/// The entries of H and B of an edge in a node's block.
void SaddlePointFactor::assemble_edge(int edge, int node, const Places& places,
                                      FrontMatrix& front) const {
    const int own = places.of(layout().place[node]);
    const int other = layout().other_end(edge, node);
    if (layout().is_before(node, other)) {
        const int row = places.of(layout().place[other]);
        front.block<3, 3>(row + 3, own) -= edge_stiffness[edge];
        if (layout().is_free(node)) {
            front.block<3, 3>(row, own + 3) -= edge_stiffness[edge];
        }
    }
    if (layout().has_length(edge) && layout().is_free(node)) {
        const int row = places.of(layout().length[edge]);
        front.block<1, 3>(row, own + 3) +=
            sign_at(layout(), edge, node) * length_rates.col(edge).transpose();
    }
}

/// The entries of a length with itself, and where lengths are coupled with later ones.
void SaddlePointFactor::assemble_length(int edge, const Places& places, FrontMatrix& front) const {
    const int own = layout().length[edge];
    const int column = places.of(own);
    front(column, column) += length_pivot(edge);
    for (const int other : m_coupled) {
        if (layout().length[other] >= own) {
            front(places.of(layout().length[other]), column) += length_couplings(other, edge);
        }
    }
}

/// The entries of w a a' in a node's block.
void SaddlePointFactor::assemble_force(int edge, int node, const Places& places,
                                       FrontMatrix& front) const {
    const int own = places.of(layout().place[node]);
    const int other = layout().other_end(edge, node);
    const double w = force_weights(edge);
    const Eigen::Vector3d a = force_place_rates.col(edge);
    const Eigen::Matrix3d product = w * a * a.transpose();
    front.block<3, 3>(own, own).triangularView<Eigen::Lower>() += product;
    if (layout().is_before(node, other)) {
        front.block<3, 3>(places.of(layout().place[other]), own) -= product;
    }
    if (layout().has_length(edge)) {
        front.block<1, 3>(places.of(layout().length[edge]), own) +=
            sign_at(layout(), edge, node) * w * force_length_rates(edge) * a.transpose();
    }
}

/// (condensed): the entries of -g' g / p in a node's block.
void SaddlePointFactor::assemble_condensed(int edge, int node, const Places& places,
                                           FrontMatrix& front) const {
    const EdgeFunction row = length_row(edge);
    Eigen::Matrix<double, 6, 1> g;
    g << row.place, row.multiplier;
    const Eigen::Matrix<double, 6, 6> product = g * g.transpose() / length_pivot(edge);
    const int own = places.of(layout().place[node]);
    const int other = layout().other_end(edge, node);
    if (!layout().is_free(node)) {
        front.block<3, 3>(own, own).triangularView<Eigen::Lower>() -= product.topLeftCorner<3, 3>();
    } else {
        front.block<6, 6>(own, own).triangularView<Eigen::Lower>() -= product;
    }
    if (layout().is_before(node, other)) {
        const int at_other = places.of(layout().place[other]);
        if (!layout().is_free(node)) {
            front.block<6, 3>(at_other, own) += product.leftCols<3>();
        } else {
            front.block<6, 6>(at_other, own) += product;
        }
    }
}

double SaddlePointFactor::log_determinant() const {
    double sum = m_factor->log_determinant();
    for (int e = 0; m_lengths_go == LengthsGo::first && e < length_weights.size(); ++e) {
        const double pivot = length_pivot(e);  // 0 of a known length
        sum += pivot > 0.0 ? std::log(pivot) : 0.0;
    }
    return sum;
}

/// p.
double SaddlePointFactor::length_pivot(int edge) const {
    return length_weights(edge) +
           force_weights(edge) * force_length_rates(edge) * force_length_rates(edge);
}

/// g, and p.
SaddlePointFactor::EdgeFunction SaddlePointFactor::length_row(int edge) const {
    return {.place = force_weights(edge) * force_length_rates(edge) * force_place_rates.col(edge),
            .multiplier = length_rates.col(edge),
            .length = length_pivot(edge)};
}

bool SaddlePointFactor::factorize() {
    const bool is_condensed =
        m_lengths_last.lengths == Lengths::independent && precision() <= most_precise;
    const LengthsGo lengths_go = is_condensed ? LengthsGo::first : LengthsGo::last;
    if (!m_factor || lengths_go != m_lengths_go) {
        m_lengths_go = lengths_go;
        m_factor.reset();
        m_factor.emplace(layout().sizes, layout().couplings());
    }
    return m_factor->factorize([this](int block, const Places& places, FrontMatrix& front) {
        if (const int node = layout().node_of_block[block]; node >= 0) {
            assemble(node, places, front);
        } else {
            assemble_length(layout().edge_of_block[block], places, front);
        }
    });
}

/// Lengths that go first leave -g' b / p of their right-hand side b.
Eigen::VectorXd SaddlePointFactor::gather(const Vector& vector) const {
    Eigen::VectorXd uncertain(m_factor->unknown_count());
    for (int j = 0; j < layout().node_count(); ++j) {
        uncertain.segment<3>(layout().place[j]) = vector.places.col(j);
    }
    for (int j = 0; j < layout().free_count; ++j) {
        uncertain.segment<3>(layout().multiplier(j)) = vector.multipliers.col(j);
    }
    for (int e = 0; e < vector.lengths.size(); ++e) {
        if (layout().has_length(e)) {
            uncertain(layout().length[e]) = vector.lengths(e);
        } else if (layout().goes_first(e) && vector.lengths(e) != 0.0) {
            const EdgeFunction row = length_row(e);
            for (const int node : layout().edges[e]) {
                const double b = sign_at(layout(), e, node) * vector.lengths(e) / row.length;
                if (layout().has_block(node)) {
                    uncertain.segment<3>(layout().place[node]) -= b * row.place;
                }
                if (layout().is_free(node)) {
                    uncertain.segment<3>(layout().multiplier(node)) -= b * row.multiplier;
                }
            }
        }
    }
    return uncertain;
}

SaddlePointFactor::Vector SaddlePointFactor::scatter(const Eigen::VectorXd& uncertain,
                                                     const Vector& right_side) const {
    Vector vector{.places = Eigen::Matrix3Xd(3, layout().node_count()),
                  .lengths = Eigen::VectorXd::Zero(length_weights.size()),
                  .multipliers = Eigen::Matrix3Xd(3, layout().free_count)};
    for (int j = 0; j < layout().node_count(); ++j) {
        vector.places.col(j) = uncertain.segment<3>(layout().place[j]);
    }
    for (int j = 0; j < layout().free_count; ++j) {
        vector.multipliers.col(j) = uncertain.segment<3>(layout().multiplier(j));
    }
    for (int e = 0; e < vector.lengths.size(); ++e) {
        if (layout().has_length(e)) {
            vector.lengths(e) = uncertain(layout().length[e]);
        } else if (layout().goes_first(e)) {
            const EdgeFunction row = length_row(e);
            double left = right_side.lengths(e);
            for (const int node : layout().edges[e]) {
                double taken = 0.0;
                if (layout().has_block(node)) {
                    taken += row.place.dot(vector.places.col(node));
                }
                if (layout().is_free(node)) {
                    taken += row.multiplier.dot(vector.multipliers.col(node));
                }
                left -= sign_at(layout(), e, node) * taken;
            }
            vector.lengths(e) = left / row.length;
        }
    }
    return vector;
}

SaddlePointFactor::Vector SaddlePointFactor::solve(const Vector& right_side) const {
    return scatter(m_factor->solve(gather(right_side)), right_side);
}

/// The variance f Z f' of a function f of the unknowns at an edge, in the front of its earlier end.
/// Where the length went first it is (f_x - f_d g / p) Z (f_x - f_d g / p)' + f_d^2 / p,
/// (condensed).
double SaddlePointFactor::variance(int edge, const EdgeFunction& function, const Places& places,
                                   const FrontMatrix& inverse) const {
    EdgeFunction f = function;
    double variance = 0.0;
    if (layout().goes_first(edge)) {
        const EdgeFunction row = length_row(edge);
        const double share = f.length / row.length;
        f.place -= share * row.place;
        f.multiplier -= share * row.multiplier;
        variance = f.length * share;
    }
    std::array<int, 13> rows{};
    std::array<double, 13> values{};
    size_t count = 0;
    const auto add = [&](int row, double value) {
        rows[count] = row;
        values[count++] = value;
    };
    for (const int node : layout().edges[edge]) {
        if (layout().has_block(node)) {
            const double sign = sign_at(layout(), edge, node);
            const int first = places.of(layout().place[node]);
            for (int k = 0; k < 3; ++k) {
                add(first + k, sign * f.place(k));
            }
            for (int k = 0; layout().is_free(node) && k < 3; ++k) {
                add(first + 3 + k, sign * f.multiplier(k));
            }
        }
    }
    if (layout().has_length(edge)) {
        add(places.of(layout().length[edge]), f.length);
    }
    for (size_t a = 0; a < count; ++a) {
        for (size_t b = 0; b < count; ++b) {
            variance += values[a] * inverse(rows[a], rows[b]) * values[b];
        }
    }
    return variance;
}

void SaddlePointFactor::read_covariance(int node, const Places& places, const FrontMatrix& inverse,
                                        Covariance& result) const {
    const int own = places.of(layout().place[node]);
    result.places[node] = inverse.block<3, 3>(own, own);
    if (layout().is_free(node)) {
        result.multipliers[node] = inverse.block<3, 3>(own + 3, own + 3);
    }
    for (const int e : layout().edges_of_node[node]) {
        // With its earlier node the front holds all of an edge: both nodes and the length.
        const int other = layout().other_end(e, node);
        if (layout().has_block(other) && !layout().is_before(node, other)) {
            continue;
        }
        if (layout().unknown[e]) {
            result.lengths(e) = variance(e, {.length = 1.0}, places, inverse);
            result.extensions(e) =
                variance(e, {.place = extension_rate(e), .length = -1.0}, places, inverse);
        }
        result.forces(e) =
            variance(e, {.place = force_place_rates.col(e), .length = force_length_rates(e)},
                     places, inverse);
    }
}

SaddlePointFactor::Covariance SaddlePointFactor::covariance() const {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(length_weights.size());
    Covariance result{.places = std::vector<Eigen::Matrix3d>(layout().node_count()),
                      .multipliers = std::vector<Eigen::Matrix3d>(layout().free_count),
                      .lengths = zero,
                      .extensions = zero,
                      .forces = zero};
    m_factor->selected_inverse([&](int block, const Places& places, const FrontMatrix& inverse) {
        if (const int node = layout().node_of_block[block]; node >= 0) {
            read_covariance(node, places, inverse, result);
        }
    });
    return result;
}

}  // namespace taut
