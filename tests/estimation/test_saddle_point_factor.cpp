// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a sparse solution or covariance that is not that of the dense matrix.

#include "estimation/saddle_point_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <utility>
#include <vector>

#include "taut/design/builtin_nets.hpp"
#include "taut/threads.hpp"

namespace {

using namespace taut;

class OnANet : public testing::Test {
protected:
    explicit OnANet(CableNet net) : m_net(std::move(net)) {
        srand(1);
        m_factor.place_weights = Eigen::Matrix3Xd::Random(3, n).cwiseAbs();
        m_factor.cross_place_weights = 0.3 * Eigen::Matrix3Xd::Random(3, n);
        m_factor.place_weights.array() += 0.7;    // positive definite with these
        m_factor.place_weights.col(3).setZero();  // a hidden node
        m_factor.cross_place_weights.col(3).setZero();
        m_factor.length_weights.setConstant(0.5);
        m_factor.length_rates.setRandom();
        for (int e = 0; e < m_net.edge_count(); ++e) {
            const Eigen::Vector3d v = Eigen::Vector3d::Random();
            const Eigen::Matrix3d k = v * v.transpose() + 0.1 * Eigen::Matrix3d::Identity();
            m_factor.edge_stiffness[e] = k;
            for (const int node : m_local.edges[e]) {
                if (node < n) {
                    m_factor.node_stiffness[node] += k;
                }
            }
        }
    }

    /// The matrix in the order places, multipliers, lengths of all edges.
    [[nodiscard]] Eigen::MatrixXd dense() const {
        const int m = m_net.edge_count();
        Eigen::MatrixXd K = Eigen::MatrixXd::Zero(6 * n + m, 6 * n + m);
        for (int i = 0; i < n; ++i) {
            K.block<3, 3>(3 * i, 3 * i) = m_factor.place_weights.col(i).asDiagonal();
            K(3 * i + 1, 3 * i) = m_factor.cross_place_weights(0, i);
            K(3 * i + 2, 3 * i) = m_factor.cross_place_weights(1, i);
            K(3 * i + 2, 3 * i + 1) = m_factor.cross_place_weights(2, i);
            K.block<3, 3>(3 * (n + i), 3 * i) = m_factor.node_stiffness[i];
        }
        for (int e = 0; e < m; ++e) {
            const auto [s, t] = m_local.edges[e];
            if (std::max(s, t) < n) {
                const auto& k = m_factor.edge_stiffness[e];
                K.block<3, 3>(3 * (n + s), 3 * t) -= k;
                K.block<3, 3>(3 * (n + t), 3 * s) -= k;
            }
            const int row = 6 * n + e;
            K(row, row) = 1.0;
            if (m_interior[e]) {
                K(row, row) = m_factor.length_weights(e);
                if (s < n) {
                    K.block<1, 3>(row, 3 * (n + s)) = m_factor.length_rates.col(e).transpose();
                }
                if (t < n) {
                    K.block<1, 3>(row, 3 * (n + t)) = -m_factor.length_rates.col(e).transpose();
                }
            }
        }
        return K.selfadjointView<Eigen::Lower>();
    }

    void expect_the_solution_of_the_dense_matrix() {
        ASSERT_TRUE(m_factor.factorize());
        const int m = m_net.edge_count();
        Eigen::VectorXd b = Eigen::VectorXd::Random(6 * n + m);
        for (int e = 0; e < m; ++e) {
            b(6 * n + e) *= m_interior[e] ? 1.0 : 0.0;
        }
        const Eigen::VectorXd x = dense().partialPivLu().solve(b);
        const auto found = m_factor.solve({.places = b.head(3 * n).reshaped(3, n),
                                           .lengths = b.tail(m),
                                           .multipliers = b.segment(3 * n, 3 * n).reshaped(3, n)});
        EXPECT_LT((found.places.reshaped() - x.head(3 * n)).norm(), 1e-9 * x.norm());
        EXPECT_LT((found.multipliers.reshaped() - x.segment(3 * n, 3 * n)).norm(), 1e-9 * x.norm());
        EXPECT_LT((found.lengths - x.tail(m)).norm(), 1e-9 * x.norm());
    }

    void expect_the_covariance_of_the_dense_inverse() {
        ASSERT_TRUE(m_factor.factorize());
        const Eigen::MatrixXd Z = dense().inverse();
        const auto covariance = m_factor.covariance();
        for (int i = 0; i < n; ++i) {
            const Eigen::Matrix3d expected = Z.block<3, 3>(3 * i, 3 * i);
            EXPECT_LT((covariance.places[i] - expected).norm(), 1e-8 * (1.0 + expected.norm()));
        }
        for (const int e : m_net.interior_edges()) {
            const int row = 6 * n + e;
            EXPECT_NEAR(covariance.lengths(e), Z(row, row), 1e-8);
            // Extension: the ends' distance along -B, less the length.
            Eigen::VectorXd w = Eigen::VectorXd::Zero(Z.rows());
            const Eigen::Vector3d u = -m_factor.length_rates.col(e).normalized();
            const auto [s, t] = m_local.edges[e];
            if (s < n) {
                w.segment<3>(3 * s) = u;
            }
            if (t < n) {
                w.segment<3>(3 * t) = -u;
            }
            w(row) = -1.0;
            EXPECT_NEAR(covariance.extensions(e), w.dot(Z * w), 1e-8);
        }
    }

    [[nodiscard]] std::vector<Supernode> supernodes() const {
        const SaddlePointLayout layout(m_local, m_interior);
        return supernode_tree(layout.sizes, layout.couplings()).supernodes;
    }

    const CableNet m_net;
    const LocalNet m_local = number_for_elimination(m_net);
    const int n = m_local.free_count;
    std::vector<bool> m_interior = interior_flags();
    SaddlePointFactor m_factor{m_local, m_interior};

private:
    [[nodiscard]] std::vector<bool> interior_flags() const {
        std::vector<bool> flags(m_net.edge_count(), false);
        for (const int e : m_net.interior_edges()) {
            flags[e] = true;
        }
        return flags;
    }
};

/// Large enough for supernodes of several panels and for branches.
class OnALargerHypar : public OnANet {
protected:
    OnALargerHypar() : OnANet(hypar(14, 14)) {
        EXPECT_GE(std::ranges::max(supernodes(), {}, &Supernode::size).size, 64);
        EXPECT_GE(branches_of(supernodes()).branches.size(), 2U);
    }
};

class OnAHyparOfManyBranches : public OnANet {
protected:
    OnAHyparOfManyBranches() : OnANet(hypar(30, 30)) {
        EXPECT_GE(branches_of(supernodes()).branches.size(), 8U);
    }
};

TEST_F(OnALargerHypar, ASingularPivotIsReported) {
    m_factor.place_weights.setZero();
    std::ranges::fill(m_factor.node_stiffness, Eigen::Matrix3d::Zero());
    std::ranges::fill(m_factor.edge_stiffness, Eigen::Matrix3d::Zero());
    EXPECT_FALSE(m_factor.factorize());
}

TEST_F(OnALargerHypar, TheSolutionIsThatOfTheDenseMatrix) {
    expect_the_solution_of_the_dense_matrix();
}

TEST_F(OnALargerHypar, TheCovarianceIsThatOfTheDenseInverse) {
    expect_the_covariance_of_the_dense_inverse();
}

// Lengths that are eliminated first are to give what those that go last do, of all that is asked of
// the factor: a weight of a place that is too large for the first way by a little makes the
// difference.
TEST_F(OnALargerHypar, LengthsThatGoFirstLeaveWhatThoseThatGoLastDo) {
    m_factor.load_variances.setConstant(0.3);
    m_factor.force_weights.setConstant(0.4);
    m_factor.force_place_rates.setRandom();
    m_factor.force_length_rates.setRandom();
    const SaddlePointFactor::Vector right_side{
        .places = Eigen::Matrix3Xd::Random(3, n),
        .lengths = Eigen::VectorXd::Random(m_net.edge_count()),
        .multipliers = Eigen::Matrix3Xd::Random(3, n)};
    const auto found = [&](double weight) {
        m_factor.place_weights.setConstant(weight);
        EXPECT_TRUE(m_factor.factorize());
        return std::pair(m_factor.solve(right_side), m_factor.covariance());
    };
    m_factor.place_weights.setOnes();
    const double largest = SaddlePointFactor::most_precise / m_factor.precision();
    const auto [first, first_covariance] = found((1.0 - 1e-10) * largest);
    const auto [last, last_covariance] = found((1.0 + 1e-10) * largest);
    EXPECT_LT((first.places - last.places).norm(), 1e-7 * last.places.norm());
    EXPECT_LT((first.lengths - last.lengths).norm(), 1e-7 * last.lengths.norm());
    EXPECT_LT((first.multipliers - last.multipliers).norm(), 1e-7 * last.multipliers.norm());
    for (const int e : m_net.interior_edges()) {
        for (const auto member :
             {&SaddlePointFactor::Covariance::lengths, &SaddlePointFactor::Covariance::extensions,
              &SaddlePointFactor::Covariance::forces}) {
            const double expected = (last_covariance.*member)(e);
            EXPECT_NEAR((first_covariance.*member)(e), expected, 1e-7 * expected);
        }
    }
    for (int i = 0; i < n; ++i) {
        EXPECT_LT((first_covariance.places[i] - last_covariance.places[i]).norm(),
                  1e-7 * last_covariance.places[i].norm());
        EXPECT_LT((first_covariance.multipliers[i] - last_covariance.multipliers[i]).norm(),
                  1e-7 * last_covariance.multipliers[i].norm());
    }
}

// A far more precise survey than the lengths' prior: variances fall by ten orders of magnitude.
TEST_F(OnALargerHypar, PreciseSurveysKeepTheDigits) {
    m_factor.place_weights.setConstant(1e10);
    ASSERT_TRUE(m_factor.factorize());
    const Eigen::MatrixXd Z = dense().inverse();
    const auto covariance = m_factor.covariance();
    for (int i = 0; i < n; ++i) {
        const Eigen::Matrix3d expected = Z.block<3, 3>(3 * i, 3 * i);
        EXPECT_LT((covariance.places[i] - expected).norm(), 1e-6 * expected.norm());
    }
}

TEST_F(OnAHyparOfManyBranches, TheResultsAreTheSameForAnyNumberOfThreads) {
    const SaddlePointFactor::Vector right_side{
        .places = Eigen::Matrix3Xd::Random(3, n),
        .lengths = Eigen::VectorXd::Random(m_net.edge_count()),
        .multipliers = Eigen::Matrix3Xd::Random(3, n)};
    const auto found = [&](int threads) {
        return with_threads(threads, [&] {
            EXPECT_TRUE(m_factor.factorize());
            return std::pair(m_factor.solve(right_side), m_factor.covariance());
        });
    };
    const auto [solution, covariance] = found(1);
    for (const int threads : {2, 4}) {
        const auto [other_solution, other_covariance] = found(threads);
        EXPECT_EQ(other_solution.places, solution.places);
        EXPECT_EQ(other_solution.lengths, solution.lengths);
        EXPECT_EQ(other_solution.multipliers, solution.multipliers);
        EXPECT_EQ(other_covariance.places, covariance.places);
        EXPECT_EQ(other_covariance.lengths, covariance.lengths);
        EXPECT_EQ(other_covariance.extensions, covariance.extensions);
    }
}

}  // namespace
