// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "estimation/saddle_point_layout.hpp"
#include "numerics/supernodal_factor.hpp"
#include "numerics/symmetric_blocks.hpp"
#include "statics/local_net.hpp"

namespace taut {

/// The symmetric matrix of a least squares problem in places r and length deviations d under
/// linearised statics H r + B d = c with multipliers lambda, docs/theory.md (normal), and its
/// factor:
///
///   [ S    H ] r        S: weights of places, a block a node, semidefinite
///   [    P B'] d        P: weights of lengths, one an unknown length, positive
///   [ H  B -V] lambda   H, B: sums over edges, as below; V: variances of loads, 0 or more
///
/// Force measurements, a' (r, d) with a weight w, add w a a' to S and P, over the two places and
/// the length of their edge. Where supports are uncertain, r includes their places.
///
/// It is eliminated node by node, along each branch of the elimination tree in the order of the
/// local net: place and multipliers of a node, then the lengths of the edges to earlier nodes;
/// supports first. Any such order works, since S and P are semidefinite and definite, and so is H.
/// It keeps the digits where a survey is far more precise than the prior of the lengths: both ends
/// of a length are eliminated before it.
///
/// Where the survey is less precise, the lengths are eliminated first, edge by edge: an edge with p
/// = P + w a_d^2 and its row g at the places and multipliers of its ends leaves -g' g / p there,
/// and the matrix has 6 unknowns a node instead of some 8, docs/theory.md (condensed).
///
/// Why taut has a factor of its own (numerics/supernodal_factor.hpp): for the entries of the
/// inverse, which Eigen does not give. Times relative to it, by `bench_factorisation
/// --benchmark_filter='saddle|covariance'` (one core):
///
///                                        built-in net   hypar:30x30   100x100
///   factor and one solution
///     Eigen SimplicialLDLT                    0.8           2.7          11
///     Eigen SparseLU                          2.6           5.0          13
///     MUMPS 5.5                               0.9           1.0         0.6
///   covariances, after the factor
///     MUMPS 5.5, ICNTL(30)                     23            17          16
class SaddlePointFactor {
public:
    /// @param unknown one flag an edge of the net: whether its length is an unknown
    SaddlePointFactor(const LocalNet& net, const std::vector<bool>& unknown,
                      Supports supports = Supports::fixed, Lengths lengths = Lengths::independent);

    /// Precision of a survey relative to the prior of the lengths: the weight of a place over that
    /// of a length, times the square of the condition number of its node's stiffness, the largest
    /// of all nodes; and the weight of a force measurement likewise. Infinite where a node has no
    /// stiffness.
    [[nodiscard]] double precision() const;
    /// Lengths go first up to this precision: five digits of the covariances of a net of 300 x 300
    /// nodes are then left, and more of smaller nets, docs/theory.md (condensed).
    static constexpr double most_precise = 1e5;

    // The matrix, to be filled before factorize(). Nodes: the free ones, in the order of the local
    // net, then the supports where these are uncertain.
    /// S, a block a node: its diagonal (3 x nodes), of a support positive definite; and its entries
    /// xy, xz, yz (3 x nodes).
    Eigen::Matrix3Xd place_weights;
    Eigen::Matrix3Xd cross_place_weights;
    Eigen::VectorXd length_weights;  ///< P, one an edge; unused for known lengths
    /// What coupled lengths add to P, edges x edges; unused for known lengths.
    Eigen::MatrixXd length_couplings;
    Eigen::Matrix3Xd load_variances;              ///< diagonal of V, 3 x free nodes
    Eigen::Matrix3Xd cross_load_variances;        ///< its entries xy, xz, yz, 3 x free nodes
    std::vector<Eigen::Matrix3d> node_stiffness;  ///< diagonal block of H, one a free node
    /// One an edge: -1 times the block of H between its nodes.
    std::vector<Eigen::Matrix3d> edge_stiffness;
    /// One a pair of elastic supports on one frame: the block of H at the first, by the second.
    std::vector<Eigen::Matrix3d> pair_stiffness;
    /// One an edge: the block of B of its first node, and -1 times that of its second (3 x edges).
    Eigen::Matrix3Xd length_rates;
    Eigen::VectorXd force_weights;  ///< w, one an edge; 0: not measured
    /// One an edge: the entries of a at its first node, and -1 times those at its second (3 x
    /// edges); and the entry at its length.
    Eigen::Matrix3Xd force_place_rates;
    Eigen::VectorXd force_length_rates;

    /// @return false where a pivot is singular
    [[nodiscard]] bool factorize();

    struct Vector {
        Eigen::Matrix3Xd places;       ///< 3 x nodes
        Eigen::VectorXd lengths;       ///< one an edge; 0 for known lengths
        Eigen::Matrix3Xd multipliers;  ///< 3 x free nodes
    };
    /// After factorize().
    [[nodiscard]] Vector solve(const Vector& right_side) const;

    /// log of the determinant's absolute value, after factorize().
    [[nodiscard]] double log_determinant() const;

    /// V times the multipliers (3 x free nodes).
    [[nodiscard]] Eigen::Matrix3Xd loads_by(const Eigen::Matrix3Xd& multipliers) const {
        return symmetric_products(load_variances, cross_load_variances, multipliers);
    }

    struct Covariance {
        std::vector<Eigen::Matrix3d> places;       ///< one a node
        std::vector<Eigen::Matrix3d> multipliers;  ///< negative semidefinite, one a free node
        Eigen::VectorXd lengths;                   ///< variances, one an edge; 0 for known lengths
        /// Variances of the distance of the two nodes, along -B, less the length deviation: one an
        /// edge; 0 for known lengths.
        Eigen::VectorXd extensions;
        Eigen::VectorXd forces;  ///< variances a' Z a, one an edge
    };
    /// Entries of the inverse, after factorize(), docs/theory.md (covariance): S and P being
    /// inverse covariances, the covariances under H r + B d = c. With Z the inverse over the
    /// unknowns of an edge (s, t) and u the direction of its block of B, the variance of its
    /// extension is
    ///
    ///   w' Z w,   w = (-u at place s, u at place t, -1 at the length)
    [[nodiscard]] Covariance covariance() const;

    /// The entries of w above at the first node of an edge.
    [[nodiscard]] Eigen::Vector3d extension_rate(int edge) const {
        return -length_rates.col(edge).normalized();
    }

private:
    using Places = SupernodalFactor::Places;
    /// A linear function of the unknowns at an edge: its entries at the first node, with the
    /// opposite sign at the second, and at the length.
    struct EdgeFunction {
        Eigen::Vector3d place = Eigen::Vector3d::Zero();
        Eigen::Vector3d multiplier = Eigen::Vector3d::Zero();
        double length = 0.0;
    };

    [[nodiscard]] const SaddlePointLayout& layout() const {
        return m_lengths_go == LengthsGo::last ? m_lengths_last : m_lengths_first;
    }
    void assemble(int node, const Places& places, FrontMatrix& front) const;
    void assemble_edge(int edge, int node, const Places& places, FrontMatrix& front) const;
    void assemble_length(int edge, const Places& places, FrontMatrix& front) const;
    void assemble_force(int edge, int node, const Places& places, FrontMatrix& front) const;
    void assemble_condensed(int edge, int node, const Places& places, FrontMatrix& front) const;
    [[nodiscard]] double length_pivot(int edge) const;
    [[nodiscard]] EdgeFunction length_row(int edge) const;
    void read_covariance(int node, const Places& places, const FrontMatrix& inverse,
                         Covariance& result) const;
    [[nodiscard]] double variance(int edge, const EdgeFunction& function, const Places& places,
                                  const FrontMatrix& inverse) const;
    [[nodiscard]] Eigen::VectorXd gather(const Vector& vector) const;
    [[nodiscard]] Vector scatter(const Eigen::VectorXd& uncertain, const Vector& right_side) const;

    SaddlePointLayout m_lengths_last;
    SaddlePointLayout m_lengths_first;
    LengthsGo m_lengths_go = LengthsGo::last;  ///< in the factor
    std::optional<SupernodalFactor> m_factor;
    std::vector<int> m_coupled;  ///< edges of unknown length in the order of elimination; or none
};

}  // namespace taut
