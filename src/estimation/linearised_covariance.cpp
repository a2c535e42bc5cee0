// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <utility>
#include <vector>

#include "estimation/linearisation.hpp"
#include "numerics/memory_budget.hpp"
#include "numerics/parallel.hpp"

namespace taut {
namespace {

/// Of a covariance of so many numbers, and of its transpose.
MemoryCharge charge_covariance(Eigen::Index count) {
    return charge_numbers(2.0 * static_cast<double>(count * count));
}

}  // namespace

Covariance Linearisation::covariance() const {
    const StaticsNumbering& numbers = m_model->numbering();
    const CommonParameters& common = m_model->common;
    const CableNet& net = m_model->net();
    BorderedFactor::Covariance found = m_matrix->covariance();
    const double squared_unit = m_length_unit * m_length_unit;
    const double force_unit = m_multiplier_unit * m_multiplier_unit;
    Covariance result{
        .places = std::vector<Eigen::Matrix3d>(net.node_count()),
        .lengths = squared_unit * found.lengths(net.interior_edges()),
        .extensions = squared_unit * found.extensions(net.interior_edges()),
        .tensions = found.forces / force_unit,
        .measured = found.measured_forces / force_unit,
        .loads = std::vector<Eigen::Matrix3d>(net.node_count(), Eigen::Matrix3d::Zero()),
        .common = found.border,
        .multipliers = {}};
    for (int node = 0; node < net.node_count(); ++node) {
        const int local = numbers.local_of[node];
        if (numbers.has_place(node)) {
            result.places[node] = squared_unit * found.places[local];
        } else {  // (frame)
            Eigen::Matrix3Xd rates(3, common.count());
            for (int k = 0; k < common.count(); ++k) {
                rates.col(k) = common.support_rate(k, node);
            }
            result.places[node] = rates * found.border * rates.transpose();
        }
        if (local < numbers.local.free_count) {  // V + V Z V, Z the inverse over the multipliers
            const SaddlePointFactor& matrix = m_matrix->inner;
            const Eigen::Matrix3d V =
                symmetric_block(matrix.load_variances, matrix.cross_load_variances, local);
            result.loads[node] = (V + V * found.multipliers[local] * V) /
                                 (force_unit * m_load_factors(local) * m_load_factors(local));
        }
    }
    result.multipliers = std::move(found.multipliers);
    return result;
}

/// |det M| = det(H)^2 det(precision), M the matrix and H the derivative of the forces by the places
/// of the free nodes.
double Linearisation::half_log_determinant(const Observations& observations) const {
    const StaticsNumbering& numbers = m_model->numbering();
    const SaddlePointFactor& matrix = m_matrix->inner;
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int row, int column, const Eigen::Matrix3d& block) {
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                entries.emplace_back(3 * row + i, 3 * column + k, block(i, k));
            }
        }
    };
    const int free_count = numbers.local.free_count;
    for (int node = 0; node < free_count; ++node) {
        add(node, node, matrix.node_stiffness[node]);
    }
    for (size_t e = 0; e < matrix.edge_stiffness.size(); ++e) {
        const auto [s, t] = numbers.local.edges[e];
        if (std::max(s, t) < free_count) {
            add(std::max(s, t), std::min(s, t), -matrix.edge_stiffness[e]);
        }
    }
    for (size_t k = 0; k < matrix.pair_stiffness.size(); ++k) {
        const SpringPair& pair = numbers.local.spring_pairs[k];
        add(pair.second, pair.first, matrix.pair_stiffness[k].transpose());
    }
    Eigen::SparseMatrix<double> stiffness(3 * free_count, 3 * free_count);
    stiffness.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(stiffness);
    // The precision is of lengths and supports in a unit that follows the observations.
    const auto in_unit = static_cast<double>(3 * (std::ssize(numbers.nodes) - free_count) +
                                             m_model->net().interior_edge_count());
    double result = 0.5 * m_matrix->log_determinant() - factor.vectorD().array().abs().log().sum() -
                    in_unit * std::log(m_length_unit);
    const Eigen::MatrixXd& root = observations.mean_root;
    if (root.size() > 0) {  // the numbers behind it, eliminated last
        const Eigen::MatrixXd pulls =
            m_model->prior_variances(observations).cwiseInverse().asDiagonal() * root;
        const Eigen::MatrixXd left = Eigen::MatrixXd::Identity(root.cols(), root.cols()) +
                                     root.transpose() * pulls -
                                     pulls.transpose() * response_to_lengths(pulls).lengths;
        result += 0.5 * left.llt().matrixLLT().diagonal().array().square().log().sum();
    }
    return result;
}

/// a' Z g, with g the weighted sum of all a.
Eigen::VectorXd Linearisation::covariances_with(const Eigen::VectorXd& weights,
                                                const Eigen::MatrixXd& rates) const {
    const SaddlePointFactor& matrix = m_matrix->inner;
    const StaticsNumbering& numbers = m_model->numbering();
    BorderedFactor::Vector sum = empty_vector();
    sum.inner.lengths = weights.cwiseProduct(matrix.force_length_rates);
    sum.border = m_multiplier_unit * rates.transpose() * weights;
    for (int e = 0; e < weights.size(); ++e) {
        add_place_rates(e, weights(e), sum.inner.places);
    }
    const BorderedFactor::Vector varied = m_matrix->solve(sum);
    Eigen::VectorXd result(weights.size());
    for (int e = 0; e < weights.size(); ++e) {
        double of_edge = matrix.force_length_rates(e) * varied.inner.lengths(e) +
                         m_multiplier_unit * rates.row(e).dot(varied.border);
        const auto [s, t] = numbers.local.edges[e];
        for (const auto& [node, sign] : {std::pair(s, 1.0), std::pair(t, -1.0)}) {
            if (node < std::ssize(numbers.nodes)) {
                of_edge +=
                    sign * matrix.force_place_rates.col(e).dot(varied.inner.places.col(node));
            }
        }
        result(e) = of_edge / (m_multiplier_unit * m_multiplier_unit);
    }
    return result;
}

Eigen::MatrixXd Linearisation::evidence_covariance(int common_count) const {
    const std::vector<int>& edges = m_model->net().interior_edges();
    const auto lengths = static_cast<int>(std::ssize(edges));
    const MemoryCharge charge = charge_covariance(lengths + common_count);
    Eigen::MatrixXd result(lengths + common_count, lengths + common_count);
    parallel_for(0, lengths + common_count, [&](int k) {
        BorderedFactor::Vector unit = empty_vector();
        (k < lengths ? unit.inner.lengths(edges[k]) : unit.border(k - lengths)) = 1.0;
        const BorderedFactor::Vector column = m_matrix->solve(unit);
        result.col(k) << m_length_unit * column.inner.lengths(edges),
            column.border.head(common_count);
    });
    result.leftCols(lengths) *= m_length_unit;
    return 0.5 * (result + result.transpose());
}

Eigen::MatrixXd Linearisation::joint_covariance() const {
    const std::vector<int>& nodes = m_model->numbering().nodes;
    const std::vector<int>& edges = m_model->net().interior_edges();
    const Eigen::Index places = Eigen::Index{3} * m_model->net().node_count();
    const Eigen::Index lengths = std::ssize(edges);
    const Eigen::Index count = places + lengths + m_model->common.count();
    const MemoryCharge charge = charge_covariance(count);
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count, count);
    const auto set_column = [&](Eigen::Index column, const BorderedFactor::Vector& unit,
                                double unit_length) {
        const BorderedFactor::Vector varied = m_matrix->solve(unit);
        for (size_t i = 0; i < nodes.size(); ++i) {
            result.col(column).segment<3>(Eigen::Index{3} * nodes[i]) =
                unit_length * m_length_unit * varied.inner.places.col(static_cast<Eigen::Index>(i));
        }
        result.col(column).segment(places, lengths) =
            unit_length * m_length_unit * varied.inner.lengths(edges);
        result.col(column).tail(m_model->common.count()) = unit_length * varied.border;
    };
    parallel_for(Eigen::Index{0}, std::ssize(nodes), [&](Eigen::Index i) {
        for (int axis = 0; axis < 3; ++axis) {
            BorderedFactor::Vector unit = empty_vector();
            unit.inner.places(axis, i) = 1.0;
            set_column(Eigen::Index{3} * nodes[static_cast<size_t>(i)] + axis, unit, m_length_unit);
        }
    });
    parallel_for(Eigen::Index{0}, lengths, [&](Eigen::Index i) {
        BorderedFactor::Vector unit = empty_vector();
        unit.inner.lengths(edges[static_cast<size_t>(i)]) = 1.0;
        set_column(places + i, unit, m_length_unit);
    });
    for (Eigen::Index k = 0; k < m_model->common.count(); ++k) {
        BorderedFactor::Vector unit = empty_vector();
        unit.border(k) = 1.0;
        set_column(places + lengths + k, unit, 1.0);
    }
    return 0.5 * (result + result.transpose());
}

Eigen::MatrixXd Linearisation::length_covariance(const std::vector<int>& edges) const {
    const auto count = std::ssize(edges);
    const MemoryCharge charge = charge_covariance(count);
    Eigen::MatrixXd result(count, count);
    parallel_for(std::ptrdiff_t{0}, count, [&](std::ptrdiff_t k) {
        BorderedFactor::Vector unit = empty_vector();
        unit.inner.lengths(edges[k]) = 1.0;
        result.col(k) = m_length_unit * m_length_unit * m_matrix->solve(unit).inner.lengths(edges);
    });
    return 0.5 * (result + result.transpose());
}

Linearisation::LengthResponse Linearisation::response_to_lengths(
    const Eigen::MatrixXd& weights) const {
    const std::vector<int>& edges = m_model->net().interior_edges();
    const int common_count = m_model->common.count();
    LengthResponse result{.lengths = Eigen::MatrixXd(weights.rows(), weights.cols()),
                          .common = Eigen::MatrixXd(common_count, weights.cols())};
    parallel_for(Eigen::Index{0}, weights.cols(), [&](Eigen::Index k) {
        BorderedFactor::Vector sum = empty_vector();
        sum.inner.lengths(edges) = weights.col(k);
        const BorderedFactor::Vector varied = m_matrix->solve(sum);
        result.lengths.col(k) = m_length_unit * m_length_unit * varied.inner.lengths(edges);
        result.common.col(k) = m_length_unit * varied.border.head(common_count);
    });
    return result;
}

}  // namespace taut
