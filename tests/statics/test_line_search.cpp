// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a line search that takes steps which do not lower the energy, or hardly do.
#include "statics/line_search.hpp"

#include <gtest/gtest.h>

#include "support/small_nets.hpp"

namespace taut {
namespace {

/// Along the edge the energy is c u^2 / 2 at a distance u from rest, c = EA/l_0 = 100 kN/m. A step
/// D towards rest changes it by (1 - D / (2 u)) times what the slope predicts.
class HangingNode : public ::testing::Test {
protected:
    static constexpr double stiffness = 100e3;
    static constexpr double away = 0.005;

    HangingNode() {
        m_state.form().col(0).z() = -(1.01 + away);
        m_state.set_unstressed_lengths(m_local, Eigen::VectorXd::Constant(1, 1.0));
        m_state.update(m_local);
        m_trial.set_unstressed_lengths(m_local, Eigen::VectorXd::Constant(1, 1.0));
    }

    /// With a whole step that gives this share of the predicted decrease.
    LineSearchStep search(double part) {
        return search_line(m_local, m_state, Eigen::Vector3d(0.0, 0.0, 2.0 * away * (1.0 - part)),
                           m_trial);
    }

    const LocalNet m_local = number_naturally(CableNet(test::hanging_node_data()));
    NetState m_state{m_local};
    NetState m_trial{m_local};
};

TEST_F(HangingNode, TakesTheWholeStepIfTheEnergyFallsByEnough) {
    for (const double part : {2e-4, 0.1, 0.5, 0.9}) {
        const LineSearchStep step = search(part);
        EXPECT_TRUE(step.accepted);
        EXPECT_EQ(step.length, 1.0) << part;
        const double rest = 2.0 * away * (1.0 - part) - away;
        const double expected = 0.5 * stiffness * (away * away - rest * rest);
        EXPECT_NEAR(step.energy_decrease, expected, 1e-11) << part;
    }
}

TEST_F(HangingNode, ShortensAStepThatRaisesTheEnergySlightly) {
    for (const double part : {-0.5e-4, -1e-6}) {
        const LineSearchStep step = search(part);
        EXPECT_TRUE(step.accepted);
        // The secant of a parabola's slope leads to its bottom.
        EXPECT_NEAR(step.length, 0.5 / (1.0 - part), 1e-9) << part;
        EXPECT_NEAR(step.energy_decrease, 0.5 * stiffness * away * away, 1e-9) << part;
        EXPECT_NEAR(m_trial.form()(2, 0), -1.01, 1e-9);
    }
}

TEST_F(HangingNode, ShortensAStepThatGivesLessThanATenThousandthOfThePredictedDecrease) {
    EXPECT_LT(search(0.5e-4).length, 0.6);
}

}  // namespace
}  // namespace taut
