// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a net told in another unit, whose numbers are all in order and all wrong.
#include "taut/statics/plausibility.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/small_nets.hpp"

namespace taut {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> warnings_of(CableNetData data) {
    return unit_warnings(CableNet(std::move(data)));
}

/// The cross as another program tells it: coordinates times `coordinates`, lengths times `lengths`.
CableNetData scaled_cross(double coordinates, double lengths, double strain = 0.01) {
    CableNetData data = test::cross_data(strain);
    data.nodes *= coordinates;
    data.unstressed_lengths *= lengths;
    return data;
}

TEST(UnitWarnings, SayNothingOfASoundNet) {
    for (const double strain : {1e-5, 1e-3, 0.01, 0.049}) {
        EXPECT_THAT(warnings_of(test::cross_data(strain)), IsEmpty()) << strain;
    }
}

TEST(UnitWarnings, SayNothingOfANetThatIsNotYetTensioned) {
    EXPECT_THAT(warnings_of(test::cross_data(0.0)), IsEmpty());
    EXPECT_THAT(warnings_of(test::cross_data(-0.02)), IsEmpty());
}

TEST(UnitWarnings, TellOfCoordinatesInMillimetres) {
    EXPECT_THAT(warnings_of(scaled_cross(29.0, 29.0)), IsEmpty());
    EXPECT_THAT(warnings_of(scaled_cross(1000.0, 1000.0)),
                ElementsAre(HasSubstr("edges of 1000 m in the mean: are its coordinates in mm?")));
}

TEST(UnitWarnings, TellOfForcesInKilonewtonsTakenForNewtons) {
    EXPECT_THAT(warnings_of(test::cross_data(0.5e-6)),
                ElementsAre(AllOf(HasSubstr("strains of 5e-05 % in the mean"),
                                  HasSubstr("--force-unit kN"), HasSubstr("axial_stiffness"))));
}

TEST(UnitWarnings, TakeNoAccountOfSlackEdgesInTheMeanStrain) {
    CableNetData data = test::cross_data(1.2e-5);
    data.unstressed_lengths.tail(2).setConstant(1.5);
    EXPECT_THAT(warnings_of(std::move(data)), IsEmpty());
}

TEST(UnitWarnings, TellOfStrainsThatNoCableBearsWithTheEdge) {
    CableNetData data = test::cross_data(0.01);
    data.unstressed_lengths.tail(2).setConstant(1.0 / 1.08);
    data.edge_ids = {"a", "b", "c", "d"};
    EXPECT_THAT(warnings_of(std::move(data)),
                ElementsAre(AllOf(HasSubstr("edge c has a strain of 8 %"),
                                  HasSubstr("--force-unit N"), HasSubstr("axial_stiffness"))));
}

TEST(UnitWarnings, TellOfNodesThatAreFarFromBalanceAndOfTheOptionsForIt) {
    CableNetData data = test::cross_data(0.01);
    data.loads = Points::Zero(3, 5);
    data.loads(2, 0) = -90.0;
    EXPECT_THAT(warnings_of(data), IsEmpty());
    data.loads(2, 0) = -400.0;
    EXPECT_THAT(warnings_of(std::move(data)),
                ElementsAre(AllOf(HasSubstr("4e+02 N out of balance (0.4 of the mean tension)"),
                                  HasSubstr("--loads balance"), HasSubstr("--force-unit"))));
}

TEST(RefuseImpossibleUnits, RefusesLengthsAThousandTimesTheirEdges) {
    for (const double factor : {1000.0, 101.0, 1e-3, 0.0099}) {
        try {
            refuse_impossible_units(CableNet(scaled_cross(1.0, factor, 0.0)));
            ADD_FAILURE() << factor;
        } catch (const NetError& error) {
            EXPECT_EQ(error.field(), "unstressed_lengths");
            EXPECT_THAT(error.what(), HasSubstr("times the lengths of their edges"));
            EXPECT_THAT(error.what(), HasSubstr("in metres?"));
        }
    }
}

TEST(RefuseImpossibleUnits, LetsASingleEdgeBeOfAnyLength) {
    CableNetData data = test::cross_data(0.01);
    data.unstressed_lengths(0) = 1000.0;
    EXPECT_NO_THROW(refuse_impossible_units(CableNet(data)));
    EXPECT_NO_THROW(refuse_impossible_units(CableNet(scaled_cross(1.0, 90.0))));
    EXPECT_NO_THROW(refuse_impossible_units(CableNet(scaled_cross(1000.0, 1000.0))));
}

}  // namespace
}  // namespace taut
