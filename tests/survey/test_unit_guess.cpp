// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a unit guessed from points that are no targets, and one guessed where none fits.

#include "survey/unit_guess.hpp"

#include <gmock/gmock.h>

#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

std::vector<SurveyPoint> points_of(const CableNet& net, double factor, bool has_names = true) {
    std::vector<SurveyPoint> points;
    for (int node = 0; node < net.node_count(); ++node) {
        points.push_back(
            {.id = has_names ? net.node_id(node) : "", .position = factor * net.nodes().col(node)});
    }
    return points;
}

TEST(UnitGuess, IsTheUnitInWhichThePointsExtendAsTheNet) {
    const CableNet net = hypar(4, 5);
    for (const bool has_names : {true, false}) {
        EXPECT_STREQ(guess_unit(net, points_of(net, 1.0, has_names))->name, "m");
        EXPECT_STREQ(guess_unit(net, points_of(net, 1e3, has_names))->name, "mm");
        EXPECT_STREQ(guess_unit(net, points_of(net, 1.0 / 0.3048, has_names))->name, "ft");
    }
    EXPECT_FALSE(guess_unit(net, points_of(net, 50.0)));
    EXPECT_FALSE(guess_unit(net, {}));
    EXPECT_THAT(extents_text(net, points_of(net, 50.0)),
                testing::HasSubstr("the median distance from their middle is "));
}

TEST(UnitGuess, HangsOnTheNamedPointsAloneWhereMostAre) {
    const CableNet net = hypar(4, 5);
    std::vector<SurveyPoint> points = points_of(net, 1e3);
    points.resize(net.node_count() / 2);  // a part of the net, which extends less
    for (int i = 0; i < net.node_count() / 4; ++i) {
        points.push_back({.id = "station", .position = {1e9, 1e9, i * 1e9}});
    }
    EXPECT_STREQ(guess_unit(net, points)->name, "mm");
}

}  // namespace
}  // namespace taut
