// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against evidence that is lost, doubled or carried wrong from one epoch to another: against
// one normal distribution of everything at once.
#include "estimation/epoch_evidence.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>
#include <vector>

#include "support/random_nets.hpp"

namespace taut {
namespace {

constexpr int size = 6;

/// Of a few sums of x, so that much of x is not determined at all.
LengthEvidence random_evidence(test::Random& random, int sums) {
    LengthEvidence evidence;
    evidence.root.resize(size, sums);
    for (Eigen::Index k = 0; k < evidence.root.size(); ++k) {
        evidence.root(k) = test::uniform_vector(random, 1, 3.0)(0);
    }
    evidence.information = evidence.root * evidence.root.transpose();
    evidence.pull = evidence.root * test::uniform_vector(random, sums, 2.0);
    return evidence;
}

/// One entry of each kind: kept, turned with scatter, forgotten.
EpochStep mixed_step() {
    EpochStep step;
    step.prior_from.resize(size);
    step.prior_from << 4.0, 4.0, 1e-6, 1.0, 2.0, 1.0;
    step.factor.resize(size);
    step.factor << 1.0, 1.0, 1.0, 0.0, 1.0, 1.0;
    step.added.resize(size);
    step.added << 0.0, 0.0, 0.3, 1.0, 0.5, 0.0;
    step.prior_to = step.factor.cwiseAbs2().cwiseProduct(step.prior_from) + step.added;
    return step;
}

/// Mean and covariance of x_to by evidence of x_from and of x_to, by the joint distribution.
std::pair<Eigen::VectorXd, Eigen::MatrixXd> jointly(const EpochStep& step,
                                                    const LengthEvidence& of_from,
                                                    const LengthEvidence& of_to) {
    Eigen::MatrixXd prior = Eigen::MatrixXd::Zero(2 * size, 2 * size);
    prior.topLeftCorner(size, size) = step.prior_from.asDiagonal();
    prior.bottomRightCorner(size, size) = step.prior_to.asDiagonal();
    prior.topRightCorner(size, size) =
        step.factor.cwiseProduct(step.prior_from).asDiagonal().toDenseMatrix();
    prior.bottomLeftCorner(size, size) = prior.topRightCorner(size, size).transpose();
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(2 * size, 2 * size);
    information.topLeftCorner(size, size) = of_from.information;
    information.bottomRightCorner(size, size) = of_to.information;
    Eigen::VectorXd pull(2 * size);
    pull << of_from.pull, of_to.pull;
    // (P^-1 + J)^-1 without P^-1: entries that are the same in both make P singular.
    const Eigen::MatrixXd covariance =
        (Eigen::MatrixXd::Identity(2 * size, 2 * size) + prior * information).lu().solve(prior);
    return {(covariance * pull).tail(size), covariance.bottomRightCorner(size, size)};
}

void expect_same(const LengthEvidence& carried_and_own, const EpochStep& step,
                 const std::pair<Eigen::VectorXd, Eigen::MatrixXd>& expected) {
    const Eigen::MatrixXd prior = step.prior_to.asDiagonal();
    const Eigen::MatrixXd covariance =
        (Eigen::MatrixXd::Identity(size, size) + prior * carried_and_own.information)
            .lu()
            .solve(prior);
    EXPECT_LT((covariance - expected.second).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_LT((covariance * carried_and_own.pull - expected.first).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(EpochEvidence, IsCarriedAsInTheJointDistribution) {
    test::Random random(3);
    const EpochStep step = mixed_step();
    for (int trial = 0; trial < 20; ++trial) {
        const LengthEvidence from = random_evidence(random, 3);
        const LengthEvidence to = random_evidence(random, 2);
        expect_same(sum_of(carried(from, step), to), step, jointly(step, from, to));
    }
}

TEST(EpochEvidence, IsCarriedBackTheSameWay) {
    test::Random random(4);
    const EpochStep step = mixed_step();
    const EpochStep back = step.reversed();
    EXPECT_LT((back.prior_to - step.prior_from).norm(), 1e-15);
    for (int trial = 0; trial < 20; ++trial) {
        const LengthEvidence from = random_evidence(random, 3);
        const LengthEvidence to = random_evidence(random, 2);
        expect_same(sum_of(carried(to, back), from), back, jointly(back, to, from));
    }
}

TEST(EpochEvidence, HasARoot) {
    test::Random random(5);
    const LengthEvidence evidence = carried(random_evidence(random, 3), mixed_step());
    EXPECT_LT((evidence.root * evidence.root.transpose() - evidence.information).norm(), 1e-12);
    EXPECT_EQ(carried(no_evidence(size), mixed_step()).information.cwiseAbs().maxCoeff() < 1e-12,
              true);
}

/// Evidence without entries is that of x where their prior is so wide that it has no effect.
TEST(EpochEvidence, IsForgottenAsByAWidePrior) {
    test::Random random(8);
    const LengthEvidence evidence = random_evidence(random, 5);
    const std::vector<Eigen::Index> entries{1, 3};
    const LengthEvidence rest = forgotten(evidence, entries);
    EXPECT_EQ(rest.information.col(1).norm() + rest.information.row(3).norm(), 0.0);
    EXPECT_EQ(rest.pull(1), 0.0);
    Eigen::VectorXd precision = Eigen::VectorXd::Ones(size);
    precision(entries).setConstant(1e-9);
    const auto posterior = [&](const LengthEvidence& of) -> Eigen::MatrixXd {
        return (precision.asDiagonal().toDenseMatrix() + of.information).inverse();
    };
    const std::vector<Eigen::Index> others{0, 2, 4, 5};
    EXPECT_LT((posterior(evidence) - posterior(rest))(others, others).norm(), 1e-7);
    EXPECT_LT((posterior(evidence) * evidence.pull - posterior(rest) * rest.pull)(others).norm(),
              1e-6);
}

/// Over many pairs of surveys of the same x: above the limit as often as stated, and a change of
/// each entry by itself is found as wide as it is.
TEST(EpochEvidence, ComesToItsLimitByChanceAlone) {
    test::Random random(7);
    std::normal_distribution<double> normal;
    const auto normal_vector = [&](Eigen::Index count) {
        return Eigen::VectorXd::NullaryExpr(count, [&] { return normal(random); }).eval();
    };
    constexpr int trials = 4000;
    constexpr double change = 1.5;
    int above = 0;
    double mean_square = 0.0;
    double squares = 0.0;
    const std::vector<Eigen::Index> entries{0, 1, 2, 3, 4, 5};
    const Eigen::VectorXd prior = Eigen::VectorXd::Constant(size, 4.0);
    for (int trial = 0; trial < trials; ++trial) {
        const Eigen::VectorXd x = 2.0 * normal_vector(size);
        const auto survey_of = [&](const Eigen::VectorXd& seen) {
            LengthEvidence survey = random_evidence(random, size);
            survey.pull = survey.root * (survey.root.transpose() * seen + normal_vector(size));
            return survey;
        };
        const LengthEvidence first = survey_of(x);
        const Agreement same = EvidenceTest(prior, first, survey_of(x)).agreement();
        above += same.ratio() > same.limit() ? 1 : 0;
        mean_square += same.squares / same.rank / trials;
        const EvidenceTest moved(prior, first, survey_of(x + change * normal_vector(size)));
        squares += std::pow(moved.spread(entries), 2) / trials;
    }
    EXPECT_NEAR(mean_square, 1.0, 0.05);
    EXPECT_NEAR(above, 1e-3 * trials, 8);
    EXPECT_NEAR(std::sqrt(squares), change, 0.4);
}

/// Where all of x is determined, the change of one entry that explains the difference best is that
/// of least squares, and all together are chi squared; what was let go is left out.
TEST(EpochEvidence, IsTestedAsDifferencesOfLeastSquares) {
    test::Random random(6);
    const Eigen::VectorXd prior = Eigen::VectorXd::Constant(size, 2.0);
    const LengthEvidence others = random_evidence(random, 2);
    const LengthEvidence own = random_evidence(random, size);
    EvidenceTest test(prior, others, own);
    const Eigen::MatrixXd before =
        (prior.cwiseInverse().asDiagonal().toDenseMatrix() + others.information).inverse();
    const Eigen::MatrixXd of_own = own.information.inverse();
    const Eigen::VectorXd difference = of_own * own.pull - before * others.pull;
    Eigen::MatrixXd variance = before + of_own;
    const Agreement all = test.agreement();
    EXPECT_EQ(all.rank, size);
    EXPECT_NEAR(all.squares, difference.dot(variance.inverse() * difference), 1e-6 * all.squares);
    // Of some entries, where the others may be anything else.
    const std::vector<Eigen::Index> some{1, 4};
    const Eigen::MatrixXd of_all = variance.inverse();
    const Eigen::VectorXd gradient = (of_all * difference)(some);
    const Agreement part = test.agreement(some);
    EXPECT_EQ(part.rank, 2);
    EXPECT_NEAR(part.squares,
                gradient.dot(Eigen::MatrixXd(of_all(some, some)).inverse() * gradient),
                1e-6 * part.squares);
    for (const bool is_first_let_go : {false, true}) {
        if (is_first_let_go) {
            test.let_go(0);
            variance(0, 0) += 0.1 * 0.1;
        }
        const Eigen::MatrixXd weights = variance.inverse();
        const EvidenceTest::Changes changes = test.changes();
        for (int i = 0; i < size; ++i) {
            const Eigen::VectorXd only = Eigen::VectorXd::Unit(size, i);
            const double information = only.dot(weights * only);
            EXPECT_NEAR(changes.change(i), only.dot(weights * difference) / information, 1e-7);
            EXPECT_NEAR(changes.std_dev(i), 1.0 / std::sqrt(information), 1e-7);
            const auto [along, along_std] = test.change_along(only);
            EXPECT_NEAR(along, changes.change(i), 1e-9);
            EXPECT_NEAR(along_std, changes.std_dev(i), 1e-9);
            EXPECT_NEAR(changes.statistic(i), std::abs(changes.change(i)) / changes.std_dev(i),
                        1e-6);
        }
    }
}

}  // namespace
}  // namespace taut
