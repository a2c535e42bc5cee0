// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against solutions or entries of the inverse that are not those of the dense matrix: fill
// that the supernodes miss, an update lost between fronts, a panel or a branch left out.
#include "numerics/supernodal_factor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "support/random_nets.hpp"
#include "taut/threads.hpp"

namespace taut {
namespace {

using test::Random;
using test::uniform;
using test::uniform_int;

/// A matrix of blocks that can be eliminated in any order: in each row the diagonal entry, of
/// either sign where the matrix is indefinite, is greater than the sum of the others.
struct BlockMatrix {
    Definiteness definiteness = Definiteness::indefinite;
    std::vector<int> sizes;
    std::vector<int> first;                   ///< unknown of each block
    std::vector<std::vector<int>> couplings;  ///< of each block, later blocks
    std::vector<std::vector<int>> entries;    ///< of each block, unknowns of these
    Eigen::MatrixXd dense;

    void add_block(int size) {
        first.push_back(std::accumulate(sizes.begin(), sizes.end(), 0));
        sizes.push_back(size);
        couplings.emplace_back();
        entries.emplace_back();
    }
    /// Couples a block with some or all unknowns of a later one.
    void couple(Random& random, int block, int later, double share) {
        couplings[block].push_back(later);
        for (int k = 0; k < sizes[later]; ++k) {
            if (uniform(random, 0.0, 1.0) < share) {
                entries[block].push_back(first[later] + k);
            }
        }
    }
    void fill(Random& random) {
        const int n = first.back() + sizes.back();
        dense.setZero(n, n);
        for (int j = 0; j < static_cast<int>(sizes.size()); ++j) {
            for (int b = first[j]; b < first[j] + sizes[j]; ++b) {
                for (int a = b + 1; a < first[j] + sizes[j]; ++a) {
                    dense(a, b) = dense(b, a) = uniform(random, -1.0, 1.0);
                }
                for (const int a : entries[j]) {
                    dense(a, b) = dense(b, a) = uniform(random, -1.0, 1.0);
                }
            }
        }
        for (int i = 0; i < n; ++i) {
            const double sum = dense.col(i).cwiseAbs().sum();
            const bool is_negative =
                definiteness == Definiteness::indefinite && uniform_int(random, 0, 1) == 1;
            dense(i, i) = (is_negative ? -1.0 : 1.0) * (1.0 + sum);
        }
    }

    /// Of a block's front, its own unknowns and those that it is coupled with.
    [[nodiscard]] std::vector<int> unknowns_at(int block) const {
        std::vector<int> unknowns(sizes[block]);
        std::iota(unknowns.begin(), unknowns.end(), first[block]);
        unknowns.insert(unknowns.end(), entries[block].begin(), entries[block].end());
        return unknowns;
    }

    [[nodiscard]] bool factorize(SupernodalFactor& factor) const {
        return factor.factorize(
            [this](int block, const SupernodalFactor::Places& places, FrontMatrix& front) {
                for (int b = first[block]; b < first[block] + sizes[block]; ++b) {
                    for (const int a : unknowns_at(block)) {
                        if (a >= b) {
                            front(places.of(a), places.of(b)) += dense(a, b);
                        }
                    }
                }
            });
    }

    /// The largest difference of the selected entries from those of the dense inverse; infinite
    /// where a block was not shown, or shown twice.
    [[nodiscard]] double error_of_inverse(const SupernodalFactor& factor) const {
        const Eigen::MatrixXd inverse = dense.inverse();
        std::vector<double> errors(sizes.size(), 0.0);
        std::vector<int> shown(sizes.size(), 0);
        factor.selected_inverse(
            [&](int block, const SupernodalFactor::Places& places, const FrontMatrix& Z) {
                ++shown[block];
                const std::vector<int> unknowns = unknowns_at(block);
                for (const int a : unknowns) {
                    for (const int b : unknowns) {
                        errors[block] = std::max(
                            errors[block], std::abs(Z(places.of(a), places.of(b)) - inverse(a, b)));
                    }
                }
            });
        return std::ranges::all_of(shown, [](int times) { return times == 1; })
                   ? std::ranges::max(errors)
                   : std::numeric_limits<double>::infinity();
    }

    [[nodiscard]] double error_of_solution(Random& random, const SupernodalFactor& factor) const {
        const Eigen::VectorXd x = test::uniform_vector(random, dense.rows(), 1.0);
        return (factor.solve(dense * x) - x).cwiseAbs().maxCoeff();
    }
};

/// Blocks of 1 to 7 unknowns, coupled at random; some matrices fall into parts.
BlockMatrix random_matrix(Random& random, Definiteness definiteness) {
    BlockMatrix matrix;
    matrix.definiteness = definiteness;
    for (int count = uniform_int(random, 1, 40); count > 0; --count) {
        matrix.add_block(uniform_int(random, 1, 7));
    }
    const int count = static_cast<int>(matrix.sizes.size());
    const double density = uniform(random, 0.0, 0.3);
    for (int j = 0; j < count; ++j) {
        for (int later = j + 1; later < count; ++later) {
            if (uniform(random, 0.0, 1.0) < density) {
                matrix.couple(random, j, later, uniform(random, 0.0, 1.0) < 0.5 ? 1.0 : 0.6);
            }
        }
    }
    matrix.fill(random);
    return matrix;
}

/// Parts of some 100 unknowns that are coupled with one last part alone, of some 150: branches.
BlockMatrix matrix_of_branches(Random& random, Definiteness definiteness) {
    constexpr int parts = 8;
    BlockMatrix matrix;
    matrix.definiteness = definiteness;
    std::vector<int> part_of;
    for (int part = 0; part <= parts; ++part) {
        for (int size = 0; size < (part < parts ? 100 : 150);) {
            matrix.add_block(uniform_int(random, 1, 7));
            part_of.push_back(part);
            size += matrix.sizes.back();
        }
    }
    for (int j = 0; j < static_cast<int>(part_of.size()); ++j) {
        for (int later = j + 1; later < static_cast<int>(part_of.size()); ++later) {
            const bool next = part_of[later] == part_of[j] && later == j + 1;
            const bool joined = part_of[later] == part_of[j] || part_of[later] == parts;
            if (next || (joined && uniform_int(random, 0, 9) == 0)) {
                matrix.couple(random, j, later, 1.0);
            }
        }
    }
    matrix.fill(random);
    return matrix;
}

RC_GTEST_PROP(SupernodalFactorOfARandomMatrix, SolvesAndInvertsAsTheDenseMatrix, ()) {
    Random random = test::any_random();
    const BlockMatrix matrix = random_matrix(random, Definiteness::indefinite);
    SupernodalFactor factor(matrix.sizes, matrix.couplings);
    RC_ASSERT(factor.unknown_count() == matrix.dense.rows());
    RC_ASSERT(matrix.factorize(factor));
    RC_ASSERT(matrix.error_of_solution(random, factor) < 1e-10);
    RC_ASSERT(matrix.error_of_inverse(factor) < 1e-11);
}

RC_GTEST_PROP(SupernodalFactorOfARandomMatrix, OfADefiniteOneHasItsSolutionsAndItsDeterminant, ()) {
    Random random = test::any_random();
    const BlockMatrix matrix = random_matrix(random, Definiteness::positive_definite);
    SupernodalFactor factor(matrix.sizes, matrix.couplings, Definiteness::positive_definite);
    RC_ASSERT(matrix.factorize(factor));
    RC_ASSERT(matrix.error_of_solution(random, factor) < 1e-10);
    const Eigen::VectorXd diagonal = matrix.dense.llt().matrixLLT().diagonal();
    RC_ASSERT(std::abs(factor.pivots().array().log().sum() - 2.0 * diagonal.array().log().sum()) <
              1e-10);
}

TEST(SupernodalFactor, CountsTheWorkOfADenseMatrix) {
    const SupernodalFactor factor({2, 3, 1}, {{1, 2}, {2}, {}});
    EXPECT_EQ(factor.entry_count(), 36.0);
    EXPECT_EQ(factor.operation_count(), 91.0);  // 6^2 + 5^2 + ... + 1
}

class OnBranches : public testing::TestWithParam<Definiteness> {
protected:
    OnBranches() {
        const auto supernodes = supernode_tree(m_matrix.sizes, m_matrix.couplings).supernodes;
        const TreeBranches branches = branches_of(supernodes);
        EXPECT_GE(branches.branches.size(), 4U);
        EXPECT_GE(branches.trunk.size(), 1U);
    }

    Random m_random{1};
    BlockMatrix m_matrix = matrix_of_branches(m_random, GetParam());
    SupernodalFactor m_factor{m_matrix.sizes, m_matrix.couplings, GetParam()};
};

INSTANTIATE_TEST_SUITE_P(SupernodalFactor, OnBranches,
                         testing::Values(Definiteness::positive_definite, Definiteness::indefinite),
                         [](const auto& with) {
                             return with.param == Definiteness::indefinite ? "Indefinite"
                                                                           : "Definite";
                         });

TEST_P(OnBranches, SolvesAndInvertsAsTheDenseMatrixOneAfterTheOther) {
    for (int round = 0; round < 2; ++round) {
        ASSERT_TRUE(m_matrix.factorize(m_factor));
        EXPECT_LT(m_matrix.error_of_solution(m_random, m_factor), 1e-10);
        if (GetParam() == Definiteness::indefinite) {
            EXPECT_LT(m_matrix.error_of_inverse(m_factor), 1e-11);
        }
        m_matrix.fill(m_random);
    }
}

TEST_P(OnBranches, SolutionsDoNotDependOnTheNumberOfThreads) {
    const Eigen::VectorXd b = test::uniform_vector(m_random, m_matrix.dense.rows(), 1.0);
    const auto found = [&](int threads) {
        return with_threads(threads, [&] {
            EXPECT_TRUE(m_matrix.factorize(m_factor));
            return m_factor.solve(b);
        });
    };
    const Eigen::VectorXd expected = found(1);
    EXPECT_EQ(found(2), expected);
    EXPECT_EQ(found(4), expected);
}

TEST_P(OnBranches, ASingularPivotIsReportedInABranchAndInTheTrunk) {
    for (const int unknown : {0, static_cast<int>(m_matrix.dense.rows()) - 1}) {
        BlockMatrix matrix = m_matrix;
        matrix.dense.row(unknown).setZero();
        matrix.dense.col(unknown).setZero();
        EXPECT_FALSE(matrix.factorize(m_factor)) << "unknown " << unknown;
    }
}

}  // namespace
}  // namespace taut
