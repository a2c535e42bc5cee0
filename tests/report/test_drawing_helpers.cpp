// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against drawings in which a small helper puts things where they are not.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/axes.hpp"
#include "report/colour_bar.hpp"
#include "report/colour_map.hpp"
#include "report/path_data.hpp"
#include "report/projection.hpp"
#include "report/thinning.hpp"
#include "support/small_nets.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut::report {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::SizeIs;

TEST(PathData, WritesRelativeStepsInTenths) {
    PathData path;
    path.move_to({10.0, 20.5});
    path.line_to({10.26, 20.0});
    path.line_to({9.0, 20.0});
    path.dot({9.0, 23.4});
    EXPECT_EQ(path.text(), "m10 20.5l.3-.5l-1.3 0m0 3.4h0");
}

TEST(PathData, WritesASquareAroundItsMiddle) {
    PathData path;
    path.square({10.0, 10.0}, 4.2);
    EXPECT_EQ(path.text(), "m7.9 7.9h4.2v4.2h-4.2z");
    path.dot({7.9, 7.9});  // where "z" went back to
    EXPECT_EQ(path.text(), "m7.9 7.9h4.2v4.2h-4.2zm0 0h0");
}

TEST(PathData, DoesNotAddUpRoundingErrors) {
    PathData path;
    path.move_to({0.0, 0.0});
    for (int i = 1; i <= 100; ++i) {
        path.line_to({0.04 * i, 0.0});
    }
    path.line_to({4.0, 1.0});
    EXPECT_TRUE(path.text().ends_with("l0 1")) << path.text();
}

TEST(Viridis, GoesFromDarkVioletToYellow) {
    EXPECT_EQ(viridis(0.0), "#440154");
    EXPECT_EQ(viridis(0.5), "#21918c");
    EXPECT_EQ(viridis(1.0), "#fde725");
    EXPECT_EQ(viridis(0.0625), "#461768");
}

TEST(Viridis, TakesTheNearerEndOutsideOfItsRange) {
    EXPECT_EQ(viridis(-3.0), viridis(0.0));
    EXPECT_EQ(viridis(2.0), viridis(1.0));
    EXPECT_EQ(viridis(std::numeric_limits<double>::quiet_NaN()), viridis(0.0));
}

TEST(ColourBar, GivesEachValueALevelOfItsRange) {
    const ColourBar bar(8.0);
    EXPECT_EQ(bar.level_of(0.0), 0);
    EXPECT_EQ(bar.level_of(4.0), ColourBar::levels / 2);
    EXPECT_EQ(bar.level_of(8.0), ColourBar::levels - 1);
}

TEST(ColourBar, ShowsARangeWhereAllValuesAreZero) {
    const ColourBar bar(0.0);
    EXPECT_EQ(bar.level_of(0.0), 0);
    EXPECT_EQ(bar.ticks.labels.back(), "1.0");
}

TEST(Scale, MapsItsEndsAndWhatIsBetween) {
    const Scale scale{.low = -1.0, .high = 3.0, .from = 200.0, .to = 100.0};
    EXPECT_DOUBLE_EQ(scale(-1.0), 200.0);
    EXPECT_DOUBLE_EQ(scale(3.0), 100.0);
    EXPECT_DOUBLE_EQ(scale(0.0), 175.0);
}

TEST(TextWidth, CountsCharactersNotBytes) {
    EXPECT_EQ(text_width("±⁻µ"), text_width("abc"));
}

TEST(Thinned, KeepsAllWhereTheyAreFew) {
    EXPECT_THAT(thinned(4, 4), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(thinned(0, 4), SizeIs(0));
    EXPECT_EQ(thinning_words(4, 4, "edge"), "");
}

TEST(Thinned, KeepsAboutTheLimitEvenlySpread) {
    const std::vector<int> kept = thinned(100000, 1000);
    EXPECT_NEAR(static_cast<double>(kept.size()), 1000.0, 10.0);
    EXPECT_EQ(kept.front(), 0);
    for (std::size_t i = 1; i < kept.size(); ++i) {
        EXPECT_GT(kept[i], kept[i - 1]);
        EXPECT_LT(kept[i] - kept[i - 1], 300);
    }
}

TEST(Thinned, KeepsBothOfTwoKindsThatTakeTurns) {
    int odd = 0;
    const std::vector<int> kept = thinned(20000, 5000);
    for (const int i : kept) {
        odd += i % 2;
    }
    EXPECT_NEAR(odd, static_cast<double>(kept.size()) / 2.0, 20.0);
}

TEST(Thinned, TellsHowManyItKeeps) {
    EXPECT_EQ(thinning_words(20000, 5000, "edge"),
              std::to_string(thinned(20000, 5000).size()) + " of 20000 edges");
}

TEST(SlantingView, KeepsLengthsAndShowsHeightUpright) {
    const Projection view = slanting_view();
    EXPECT_TRUE((view * view.transpose()).isIdentity(1e-14));
    EXPECT_NEAR(view(0, 2), 0.0, 1e-15);
    EXPECT_GT(view(1, 2), 0.5);
}

TEST(Plan, IsSeenFromAboveForARoof) {
    const Plan plan = plan_of(hilo_quarter().nodes());
    EXPECT_EQ(plan.seen, "from above");
    EXPECT_EQ(plan.right + plan.up, "xy");
    EXPECT_TRUE((plan.projection * Eigen::Vector3d(1, 2, 3)).isApprox(Eigen::Vector2d(1, 2)));
}

TEST(Plan, IsSeenFromTheSideForANetThatStandsUpright) {
    const Points roof = CableNet(test::cross_data(0.01)).nodes();
    Points facade(3, roof.cols());
    facade << roof.row(0), roof.row(2), roof.row(1);
    EXPECT_EQ(plan_of(facade).seen, "along y");
    EXPECT_TRUE(
        (plan_of(facade).projection * Eigen::Vector3d(1, 2, 3)).isApprox(Eigen::Vector2d(1, 3)));
    facade << roof.row(2), roof.row(0), roof.row(1);
    EXPECT_EQ(plan_of(facade).seen, "along x");
    EXPECT_TRUE(
        (plan_of(facade).projection * Eigen::Vector3d(1, 2, 3)).isApprox(Eigen::Vector2d(2, 3)));
}

}  // namespace
}  // namespace taut::report
