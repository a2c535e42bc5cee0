// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against an error that energy, forces, stiffness and solver share: the forms were found by
// SciPy from formulas written independently (tests/data/make_statics_reference.py).
#include <gtest/gtest.h>

#include "statics/reference_net.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using test::Json;
using test::points_of;
using test::reference_net;
using test::vector_of;

class ReferenceNet : public ::testing::TestWithParam<const char*> {};

TEST_P(ReferenceNet, HasTheFormThatScipyFinds) {
    const Json json = reference_net("statics_reference.json", GetParam());
    const CableNet net = test::net_of(json);
    const Equilibrium e = solve_equilibrium(net);
    EXPECT_EQ(e.status, EquilibriumStatus::converged);
    EXPECT_LT((e.form - points_of(json.at("form"))).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_EQ(e.slack_edges, json.at("slack_edges").get<std::vector<int>>());
    const Eigen::VectorXd expected = vector_of(json.at("tensions"));
    const Eigen::VectorXd tension = tensions_of(net, net.unstressed_lengths(), e.form);
    EXPECT_LT((tension - expected).cwiseAbs().maxCoeff(), 1e-10 * expected.maxCoeff());
    const double lowest = json.at("energy").get<double>();
    EXPECT_NEAR(potential_energy(net, net.unstressed_lengths(), e.form), lowest,
                1e-12 * std::abs(lowest));
}

INSTANTIATE_TEST_SUITE_P(Scipy, ReferenceNet,
                         ::testing::Values("grid", "chain", "tripod", "springs", "simplex", "mast",
                                           "sagging", "frame"),
                         [](const auto& param) { return std::string(param.param); });

}  // namespace
}  // namespace taut
