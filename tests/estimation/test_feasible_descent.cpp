// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a search that says "converged" where no minimum is, or where forces do not
// balance.

#include "estimation/feasible_descent.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/tensions.hpp"

namespace {

using namespace taut;
using namespace taut::test;

constexpr double noise_std = 0.0005;
constexpr double length_std = 0.002;
constexpr double corner = 0.00015;

/// A net of little tension, with every node measured but the first.
struct Weak {
    CableNet net = [] {
        CableNetData data = hypar(4, 4).data();
        const CableNet soft = hypar(4, 4);
        const Eigen::VectorXd lengths = edge_lengths(soft, soft.nodes());
        data.unstressed_lengths += 0.97 * (lengths - data.unstressed_lengths);
        return CableNet(data);
    }();
    Observations observed = nothing_observed(net, length_std);

    explicit Weak(std::uint64_t seed) {
        Random random(seed);
        observed.form += uniform_points(random, net.node_count(), 3.0 * noise_std);
        for (size_t i = 1; i < net.free_nodes().size(); ++i) {
            observed.weights.col(net.free_nodes()[i]).setConstant(1.0 / (noise_std * noise_std));
        }
    }

    /// With rounded tension laws.
    [[nodiscard]] StaticsModel model() const {
        StaticsModel result(net);
        result.corner_width = corner;
        return result;
    }
    [[nodiscard]] double objective(const Iterate& at) const {
        return 0.5 * (observed.weights.cwiseProduct((at.form - observed.form).cwiseAbs2()).sum() +
                      at.deviations.cwiseAbs2().cwiseQuotient(observed.variance).sum());
    }

    /// The form of given lengths under the rounded tension law: Newton's method on the forces
    /// alone.
    [[nodiscard]] Iterate balanced(Iterate at) const {
        Observations known = observed;
        known.weights.setZero();
        known.mean = at.deviations;
        known.variance.setConstant(1e-24);
        for (int k = 0; k < 30; ++k) {
            at.form += linearise(model(), at, known).value().step(at, known).form;
        }
        return at;
    }
};

TEST(FeasibleDescent, EndsAtAFormInEquilibrium) {
    const Weak weak(1);
    const GaussNewtonResult found = feasible_descent(
        weak.model(), weak.observed, nominal_iterate(weak.net), 1e-3, most_descents);
    ASSERT_TRUE(found.converged);
    const Iterate exact = weak.balanced(found.iterate);
    EXPECT_LT((exact.form - found.iterate.form).cwiseAbs().maxCoeff(), 1e-2 * noise_std);
}

// With edges that end up without tension, where the objective bends.
TEST(FeasibleDescent, EndsWhereNoLengthLowersTheObjective) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const Weak weak(seed);
        const GaussNewtonResult found = feasible_descent(
            weak.model(), weak.observed, nominal_iterate(weak.net), 1e-3, most_descents);
        ASSERT_TRUE(found.converged);
        const double lowest = weak.objective(weak.balanced(found.iterate));
        for (int i = 0; i < weak.net.interior_edge_count(); ++i) {
            constexpr double change = 2e-5;
            double sides[2];
            for (const int side : {0, 1}) {
                Iterate moved = found.iterate;
                moved.deviations(i) += side == 0 ? change : -change;
                sides[side] = weak.objective(weak.balanced(moved));
            }
            const double bend = sides[0] + sides[1] - 2.0 * lowest;
            EXPECT_GT(bend, 0.0);
            // The distance to the minimum along this length, in standard deviations.
            EXPECT_LT(std::abs(sides[0] - sides[1]) / (2.0 * std::sqrt(bend)), 0.01)
                << "edge " << weak.net.interior_edges()[i];
        }
    }
}

TEST(FeasibleDescent, ReportsThatItsStepsDidNotSuffice) {
    const Weak weak(1);
    EXPECT_FALSE(feasible_descent(weak.model(), weak.observed, nominal_iterate(weak.net), 1e-3, 1)
                     .converged);
}

}  // namespace
