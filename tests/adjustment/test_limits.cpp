// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against limits that contradict each other.
#include "taut/adjustment/limits.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "support/refusals.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

class LimitsOfAHypar : public ::testing::Test {
protected:
    void expect_refused(const std::function<void(Limits&)>& change, const char* text) const {
        Limits limits = stroke_limits(net, net.adjustable_edges(), 10e-3);
        change(limits);
        test::expect_refused([&] { check_limits(net, net.adjustable_edges(), limits); }, text);
    }
    CableNet net = hypar(3, 3);
    double nan = std::numeric_limits<double>::quiet_NaN();
};

TEST_F(LimitsOfAHypar, AreRefusedWhereTheyContradictEachOther) {
    expect_refused([](Limits& l) { l.tension.lower(2) = -1.0; }, "are -1 and inf N");
    expect_refused(
        [](Limits& l) {
            l.tension.lower(2) = 5.0;
            l.tension.upper(2) = 4.0;
        },
        "are 5 and 4 N");
    expect_refused([&](Limits& l) { l.tension.upper(2) = nan; }, "nan N");
    expect_refused([](Limits& l) { l.tension.lower.conservativeResize(3); }, "of 3 and");
    expect_refused([](Limits& l) { l.shortest_stroke(0) = 1e-3; }, "a range that contains 0");
    expect_refused([&](Limits& l) { l.longest_stroke(0) = nan; }, "a range that contains 0");
    expect_refused([](Limits& l) { l.shortest_stroke(0) = -10.0; },
                   "expected to leave more than a tenth");
    expect_refused([](Limits& l) { l.longest_stroke.conservativeResize(2); }, "stroke limits of");
    expect_refused(
        [&](Limits& l) {
            l.reactions = {{.name = "here", .supports = {net.free_nodes()[0]}, .upper = 1.0}};
        },
        "which is no support");
    expect_refused(
        [&](Limits& l) {
            l.reactions = {{.name = "here", .supports = net.supports(), .upper = 0.0}};
        },
        "expected more than 0");
    expect_refused(
        [&](Limits& l) {
            l.load_cases = {{.name = "wet", .loads = Points::Zero(3, 2), .tension = l.tension}};
        },
        "wet");
}

}  // namespace
}  // namespace taut
