// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a noise of half a metre where half a millimetre was meant.

#include "taut/survey/noise_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "survey/planned_survey.hpp"

namespace {

using namespace taut;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A free node between two supports: two edges of so many metres.
CableNet net_of(double length) {
    CableNetData data;
    data.nodes = Points::Zero(3, 3);
    data.nodes.row(0) << 0.0, length, 2.0 * length;
    data.supports = {0, 2};
    data.edges = {{0, 1}, {1, 2}};
    data.axial_stiffness.setConstant(2, 1e5);
    data.unstressed_lengths.setConstant(2, 0.99 * length);
    return CableNet(std::move(data));
}

TEST(NoiseWarnings, NameTheUnitThatWasMeant) {
    EXPECT_THAT(noise_warnings(net_of(2.0), 0.5),
                ElementsAre(AllOf(HasSubstr("noise of 500mm on edges of 2000 mm"),
                                  HasSubstr("is 0.5mm meant?"))));
    EXPECT_THAT(noise_warnings(net_of(0.13), 0.005),
                ElementsAre(AllOf(HasSubstr("noise of 5mm on edges of 130 mm"),
                                  HasSubstr("is that meant?"))));
}

TEST(NoiseWarnings, BeginAtAFiftiethOfTheMeanEdgeOrFiftyMillimetres) {
    EXPECT_THAT(noise_warnings(net_of(1.0), 0.0199), IsEmpty());
    EXPECT_THAT(noise_warnings(net_of(1.0), 0.0201), ElementsAre(HasSubstr("20.1mm")));
    EXPECT_THAT(noise_warnings(net_of(10.0), 0.049), IsEmpty());
    EXPECT_THAT(noise_warnings(net_of(10.0), 0.051), ElementsAre(HasSubstr("51mm")));
    EXPECT_THAT(noise_warnings(net_of(1.0), 0.0), IsEmpty());
}

TEST(NoiseWarnings, ReachTheSurvey) {
    const std::vector<PlannedTarget> target{{.id = "1"}};
    EXPECT_THAT(planned_survey(net_of(2.0), target, 0.5).warnings,
                ElementsAre(HasSubstr("is 0.5mm meant?")));
}

TEST(RefuseAbsurdNoise, RefusesNoiseBeyondTheMeanEdge) {
    EXPECT_NO_THROW(refuse_absurd_noise(net_of(0.4), 0.39));
    EXPECT_THAT([] { refuse_absurd_noise(net_of(0.4), 0.5); },
                testing::ThrowsMessage<SurveyError>(
                    AllOf(HasSubstr("noise of 500mm, expected less than the mean edge length, 400 "
                                    "mm"),
                          HasSubstr("is 0.5mm meant?"))));
}

}  // namespace
