// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against functions of the statics that compute with lengths or forms of a wrong size or
// without a number.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/not_finite.hpp"
#include "support/small_nets.hpp"
#include "taut/statics/duality.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/equilibrium_matrix.hpp"
#include "taut/statics/form_sensitivity.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using Lengths = Eigen::VectorXd;
using Function = void (*)(const CableNet&, const Lengths&, const Points&);

class FunctionOfAForm : public ::testing::TestWithParam<Function> {};

TEST_P(FunctionOfAForm, RefusesWrongLengthsAndForms) {
    const CableNet net(test::cross_data(0.02));
    const Lengths& lengths = net.unstressed_lengths();
    const auto refuses = [&](const Lengths& l_0, const Points& form, const std::string& words) {
        EXPECT_THAT([&] { GetParam()(net, l_0, form); },
                    testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr(words)));
    };
    EXPECT_NO_THROW(GetParam()(net, lengths, net.nodes()));
    refuses(lengths.head(3), net.nodes(), "unstressed_lengths has 3 entries, expected 4");
    refuses(lengths, net.nodes().leftCols(4), " has 4 points, expected 5");
    for (const auto& [value, text] : {std::pair{0.0, "is 0"},
                                      {-1.0, "is -1"},
                                      {test::nan, "is nan"},
                                      {test::infinity, "is inf"}}) {
        Lengths bad = lengths;
        bad(2) = value;
        refuses(bad, net.nodes(), "unstressed length 2 " + std::string(text));
    }
    for (const double value : {test::nan, -test::infinity}) {
        Points bad = net.nodes();
        bad(1, 3) = value;
        refuses(lengths, bad, "at node 3, expected finite");
    }
}

INSTANTIATE_TEST_SUITE_P(
    Statics, FunctionOfAForm,
    ::testing::Values(
        [](const CableNet& n, const Lengths& l, const Points& r) {
            (void)potential_energy(n, l, r);
        },
        [](const CableNet& n, const Lengths& l, const Points& r) {
            (void)out_of_balance_forces(n, l, r);
        },
        [](const CableNet& n, const Lengths& l, const Points& r) {
            (void)tangent_stiffness(n, l, r);
        },
        [](const CableNet& n, const Lengths& l, const Points& r) { (void)tensions_of(n, l, r); },
        [](const CableNet& n, const Lengths& l, const Points& r) { (void)slack_edges(n, l, r); },
        [](const CableNet& n, const Lengths& l, const Points& r) {
            (void)energy_certificate(n, l, r);
        },
        [](const CableNet& n, const Lengths& l, const Points& r) { (void)stress_states(n, l, r); },
        [](const CableNet& n, const Lengths& l, const Points& r) {
            (void)FormSensitivity(n, l, r);
        },
        [](const CableNet& n, const Lengths& l, const Points& r) {
            (void)EquilibriumSolver(n).solve(l, r);
        }));

TEST(EdgeLengths, RefuseAWrongForm) {
    const CableNet net(test::cross_data(0.02));
    EXPECT_THROW((void)edge_lengths(net, net.nodes().leftCols(4)), std::invalid_argument);
}

}  // namespace
}  // namespace taut
