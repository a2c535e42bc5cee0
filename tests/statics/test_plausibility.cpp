// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against nets given in a wrong unit: their numbers are consistent and wrong.
#include "taut/statics/plausibility.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/small_nets.hpp"

namespace taut {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> warnings_of(CableNetData data) {
    return unit_warnings(CableNet(std::move(data)));
}

/// The cross in other units: coordinates times `coordinates`, unstressed lengths times `lengths`.
CableNetData scaled_cross(double coordinates, double lengths, double strain = 0.01) {
    CableNetData data = test::cross_data(strain);
    data.nodes *= coordinates;
    data.unstressed_lengths *= lengths;
    return data;
}

TEST(UnitWarnings, AreNoneForASoundNetAndForOneThatIsNotYetTensioned) {
    for (const double strain : {1e-5, 1e-3, 0.01, 0.049, 0.0, -0.02}) {
        EXPECT_THAT(warnings_of(test::cross_data(strain)), IsEmpty()) << strain;
    }
}

TEST(UnitWarnings, NameCoordinatesInMillimetres) {
    EXPECT_THAT(warnings_of(scaled_cross(29.0, 29.0)), IsEmpty());
    EXPECT_THAT(warnings_of(scaled_cross(1000.0, 1000.0)),
                ElementsAre(HasSubstr("edges of 1000 m on average: are its coordinates in mm?")));
}

TEST(UnitWarnings, NameForcesInKilonewtonsTakenForNewtons) {
    EXPECT_THAT(warnings_of(test::cross_data(0.5e-6)),
                ElementsAre(AllOf(HasSubstr("strains of 5e-05 % on average"),
                                  HasSubstr("forces in kN"), HasSubstr("axial_stiffness"))));
    CableNetData data = test::cross_data(1.2e-5);  // slack edges do not count in the mean
    data.unstressed_lengths.tail(2).setConstant(1.5);
    EXPECT_THAT(warnings_of(std::move(data)), IsEmpty());
}

TEST(UnitWarnings, NameAnEdgeWithAStrainThatNoCableBears) {
    CableNetData data = test::cross_data(0.01);
    data.unstressed_lengths.tail(2).setConstant(1.0 / 1.08);
    data.edge_ids = {"a", "b", "c", "d"};
    EXPECT_THAT(
        warnings_of(std::move(data)),
        ElementsAre(AllOf(HasSubstr("edge c has a strain of 8 %"), HasSubstr("axial_stiffness"))));
}

TEST(UnitWarnings, NameNodesThatAreFarFromBalance) {
    CableNetData data = test::cross_data(0.01);
    data.loads = Points::Zero(3, 5);
    data.loads(2, 0) = -90.0;
    EXPECT_THAT(warnings_of(data), IsEmpty());
    data.loads(2, 0) = -400.0;
    EXPECT_THAT(warnings_of(std::move(data)),
                ElementsAre(AllOf(HasSubstr("4e+02 N out of balance (0.4 of the mean tension)"),
                                  HasSubstr("loads missing"))));
}

TEST(RefuseImpossibleUnits, RefusesLengthsAThousandTimesTheirEdges) {
    for (const double factor : {1000.0, 101.0, 1e-3, 0.0099}) {
        EXPECT_THAT(
            [&] { refuse_impossible_units(CableNet(scaled_cross(1.0, factor, 0.0))); },
            testing::ThrowsMessage<NetError>(AllOf(testing::StartsWith("unstressed_lengths: "),
                                                   HasSubstr("times the lengths of their edges"))))
            << factor;
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
