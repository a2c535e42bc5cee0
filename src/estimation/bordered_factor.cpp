// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/bordered_factor.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <iterator>

namespace taut {

double dot(const SaddlePointFactor::Vector& a, const SaddlePointFactor::Vector& b) {
    return a.places.cwiseProduct(b.places).sum() + a.lengths.dot(b.lengths) +
           a.multipliers.cwiseProduct(b.multipliers).sum();
}

BorderedFactor::BorderedFactor(const LocalNet& net, const std::vector<bool>& unknown,
                               Supports supports, Lengths lengths)
    : inner(net, unknown, supports, lengths), m_edges(net.edges), m_unknown(unknown) {}

void BorderedFactor::set_border_count(int count) {
    border.assign(count, {});
    corner.setIdentity(count, count);
    extension_rates.setZero(std::ssize(m_edges), count);
    force_rates.setZero(std::ssize(m_edges), count);
    force_biases.setZero(std::ssize(m_edges), count);
}

bool BorderedFactor::factorize() {
    if (!inner.factorize()) {
        return false;
    }
    const auto count = static_cast<Eigen::Index>(border.size());
    m_columns.clear();
    Eigen::MatrixXd schur = corner;
    for (Eigen::Index k = 0; k < count; ++k) {
        m_columns.push_back(inner.solve(border[k]));
        for (Eigen::Index i = 0; i < count; ++i) {
            schur(i, k) -= dot(border[i], m_columns.back());
        }
    }
    m_schur_inverse = Eigen::MatrixXd::Identity(count, count);
    if (count > 0) {
        const Eigen::LDLT<Eigen::MatrixXd> factor(0.5 * (schur + schur.transpose()));
        m_schur_inverse = factor.solve(m_schur_inverse).eval();
    }
    return m_schur_inverse.allFinite();
}

double BorderedFactor::log_determinant() const {
    double sum = inner.log_determinant();
    if (!border.empty()) {
        const Eigen::PartialPivLU<Eigen::MatrixXd> lu(m_schur_inverse);
        sum -= lu.matrixLU().diagonal().array().abs().log().sum();
    }
    return sum;
}

BorderedFactor::Vector BorderedFactor::solve(const Vector& right_side) const {
    Vector result{.inner = inner.solve(right_side.inner), .border = right_side.border};
    for (size_t k = 0; k < border.size(); ++k) {
        result.border(static_cast<Eigen::Index>(k)) -= dot(border[k], result.inner);
    }
    result.border = (m_schur_inverse * result.border).eval();
    for (size_t k = 0; k < border.size(); ++k) {
        const double value = result.border(static_cast<Eigen::Index>(k));
        result.inner.places -= value * m_columns[k].places;
        result.inner.lengths -= value * m_columns[k].lengths;
        result.inner.multipliers -= value * m_columns[k].multipliers;
    }
    return result;
}

Eigen::MatrixXd BorderedFactor::inverse_at(Eigen::Index node, const Eigen::Matrix3d& inverse,
                                           const Eigen::Matrix3Xd& at_node,
                                           const Eigen::MatrixXd& in_border) const {
    Eigen::MatrixXd rows(3, std::ssize(border));
    for (Eigen::Index k = 0; k < rows.cols(); ++k) {
        rows.col(k) = m_columns[static_cast<size_t>(k)].multipliers.col(node);
    }
    const Eigen::MatrixXd of_border = m_schur_inverse * in_border;
    const Eigen::MatrixXd across = at_node.transpose() * rows * of_border;
    return at_node.transpose() * inverse * at_node + in_border.transpose() * of_border - across -
           across.transpose();
}

/// Of a number that is linear in all unknowns, with rates a in those of K and c in those of the
/// border: the variance is a' Z a + (a' Y - c') C^-1 (Y' a - c).
void BorderedFactor::add_border(Covariance& covariance) const {
    const auto count = static_cast<Eigen::Index>(border.size());
    const auto squared = [&](const Eigen::MatrixXd& rows) -> Eigen::MatrixXd {
        return rows * m_schur_inverse * rows.transpose();
    };
    Eigen::MatrixXd rows(3, count);
    for (size_t node = 0; node < covariance.places.size(); ++node) {
        for (Eigen::Index k = 0; k < count; ++k) {
            rows.col(k) = m_columns[k].places.col(static_cast<Eigen::Index>(node));
        }
        covariance.places[node] += squared(rows);
    }
    for (size_t node = 0; node < covariance.multipliers.size(); ++node) {
        for (Eigen::Index k = 0; k < count; ++k) {
            rows.col(k) = m_columns[k].multipliers.col(static_cast<Eigen::Index>(node));
        }
        covariance.multipliers[node] += squared(rows);
    }
    Eigen::RowVectorXd length(count);
    Eigen::RowVectorXd extension(count);
    Eigen::RowVectorXd force(count);
    for (int e = 0; e < static_cast<int>(m_edges.size()); ++e) {
        for (Eigen::Index k = 0; k < count; ++k) {
            const Inner& y = m_columns[k];
            Eigen::Vector3d difference = Eigen::Vector3d::Zero();
            for (const int end : {0, 1}) {
                if (m_edges[e][end] < y.places.cols()) {
                    difference += (end == 0 ? 1.0 : -1.0) * y.places.col(m_edges[e][end]);
                }
            }
            length(k) = y.lengths(e);
            extension(k) = inner.extension_rate(e).dot(difference) - y.lengths(e);
            force(k) = inner.force_place_rates.col(e).dot(difference) +
                       inner.force_length_rates(e) * y.lengths(e);
        }
        if (m_unknown[e]) {
            covariance.lengths(e) += squared(length)(0, 0);
            covariance.extensions(e) += squared(extension - extension_rates.row(e))(0, 0);
        }
        const Eigen::RowVectorXd of_force = force - force_rates.row(e);
        covariance.measured_forces(e) += squared(of_force - force_biases.row(e))(0, 0);
        covariance.forces(e) += squared(of_force)(0, 0);
    }
}

BorderedFactor::Covariance BorderedFactor::covariance() const {
    Covariance result{inner.covariance(), m_schur_inverse, {}};
    result.measured_forces = result.forces;
    if (!border.empty()) {
        add_border(result);
    }
    return result;
}

}  // namespace taut
