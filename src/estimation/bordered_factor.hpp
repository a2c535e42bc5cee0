// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimation/saddle_point_factor.hpp"

namespace taut {

/// Sum of the products of all entries.
[[nodiscard]] double dot(const SaddlePointFactor::Vector& a, const SaddlePointFactor::Vector& b);

/// The saddle-point matrix K of SaddlePointFactor with a few more unknowns, each of which may have
/// entries E with all others:
///
///   [ K   E ]
///   [ E'  F ],   inverse by the Schur complement C = F - E' K^-1 E:
///
///   Z + Y C^-1 Y', -Y C^-1, C^-1,   Z = K^-1, Y = K^-1 E
///
/// docs/theory.md, (bordered).
class BorderedFactor {
public:
    BorderedFactor(const LocalNet& net, const std::vector<bool>& unknown, Supports supports,
                   Lengths lengths);

    using Inner = SaddlePointFactor::Vector;

    /// Clears the border and sets its number of unknowns.
    void set_border_count(int count);

    // The matrix, to be filled before factorize().
    SaddlePointFactor inner;    ///< K
    std::vector<Inner> border;  ///< E, one a column
    Eigen::MatrixXd corner;     ///< F
    /// Change of extensions and forces by each unknown of the border, in addition to that by those
    /// of K (edges x columns).
    Eigen::MatrixXd extension_rates;
    Eigen::MatrixXd force_rates;
    /// Change of force measurements beyond that of the forces (edges x columns).
    Eigen::MatrixXd force_biases;

    /// @return false where a pivot is singular
    [[nodiscard]] bool factorize();

    struct Vector {
        Inner inner;
        Eigen::VectorXd border;
    };
    /// After factorize().
    [[nodiscard]] Vector solve(const Vector& right_side) const;

    /// a' M^-1 a, M the whole matrix, of vectors a with entries at the multipliers of one node
    /// only, and in the border. After factorize().
    /// @param inverse over the node's multipliers, of covariance()
    /// @param at_node 3 x count
    /// @param in_border unknowns of the border x count
    [[nodiscard]] Eigen::MatrixXd inverse_at(Eigen::Index node, const Eigen::Matrix3d& inverse,
                                             const Eigen::Matrix3Xd& at_node,
                                             const Eigen::MatrixXd& in_border) const;

    /// log of the determinant's absolute value, after factorize().
    [[nodiscard]] double log_determinant() const;

    struct Covariance : SaddlePointFactor::Covariance {
        Eigen::MatrixXd border;           ///< C^-1
        Eigen::VectorXd measured_forces;  ///< variances of force measurements, one an edge
    };
    /// After factorize().
    [[nodiscard]] Covariance covariance() const;

private:
    void add_border(Covariance& covariance) const;

    std::vector<Edge> m_edges;
    std::vector<bool> m_unknown;
    std::vector<Inner> m_columns;  ///< Y
    Eigen::MatrixXd m_schur_inverse;
};

}  // namespace taut
