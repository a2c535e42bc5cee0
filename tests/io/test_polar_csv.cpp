// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against angles in another unit, a face or a column that is taken for another, and a file
// of observations that is not refused in one line.

#include "taut/io/polar_csv.hpp"

#include <gmock/gmock.h>

#include "support/bad_input.hpp"
#include "support/errors.hpp"

namespace taut {
namespace {

using test::input_error_of;

TEST(PolarCsv, ReadsColumnsInAnyOrderAndUnit) {
    const PolarSurvey survey = parse_polar_csv(
        "# two stations\n"
        "target;station;v [deg];hz [gon];distance [mm];angle_std [arcsec];distance_std [mm]\n"
        "A;S1;90;100;2500;1;2\n\"b 2\";S2;45;399.5;1000;2;1\nA;S1;275;300;2500;1;2\n",
        "a.csv");
    ASSERT_EQ(survey.stations.size(), 2U);
    EXPECT_EQ(survey.stations[1].name, "S2");
    EXPECT_EQ(survey.stations[1].line, 4);
    ASSERT_EQ(survey.observations.size(), 3U);
    const PolarObservation& first = survey.observations[0];
    EXPECT_EQ(first.target, "A");
    EXPECT_NEAR(first.direction, std::numbers::pi / 2, 1e-15);
    EXPECT_NEAR(first.zenith, std::numbers::pi / 2, 1e-15);
    EXPECT_EQ(first.distance, 2.5);
    EXPECT_NEAR(first.angle_std, degree / 3600, 1e-20);
    EXPECT_NEAR(first.distance_std, 2e-3, 1e-18);
    EXPECT_EQ(survey.observations[1].station, 1);
    EXPECT_EQ(survey.observations[1].target, "b 2");
    // The second face.
    EXPECT_NEAR(survey.observations[2].direction, 100 * gon, 1e-14);
    EXPECT_NEAR(survey.observations[2].zenith, 85 * degree, 1e-14);
}

TEST(PolarCsv, TakesTheGivenUnitWhereTheHeaderHasNone) {
    const char* const text = "station,target,hz,v,distance\n1,A,180,90,2\n";
    EXPECT_NEAR(parse_polar_csv(text, "a.csv", degree).observations[0].direction, std::numbers::pi,
                1e-15);
    EXPECT_EQ(
        input_error_of([&] { return parse_polar_csv(text, "a.csv"); }),
        "a.csv:1: gives no unit of hz, expected hz [gon], [deg] or [rad], or a standard deviation "
        "of angles with a unit, as 0.3mgon");
}

TEST(PolarCsv, WritesWhatItReadsBack) {
    const PolarSurvey survey{.stations = {{.name = "S, 1"}, {.name = "2"}},
                             .observations = {{.station = 0,
                                               .target = "A",
                                               .direction = 1.0 / 3,
                                               .zenith = 1.2,
                                               .distance = 7.123456789,
                                               .target_height = 0.1,
                                               .angle_std = 5e-6,
                                               .distance_std = 1e-3},
                                              {.station = 1,
                                               .target = "A",
                                               .direction = 6.1,
                                               .zenith = 0.4,
                                               .distance = 3.0,
                                               .angle_std = 6e-6,
                                               .distance_std = 2e-3}}};
    const std::string text = polar_to_csv(survey);
    EXPECT_TRUE(is_polar_csv(text));
    const PolarSurvey again = parse_polar_csv(text, "a.csv");
    ASSERT_EQ(again.observations.size(), 2U);
    EXPECT_EQ(again.stations[0].name, "S, 1");
    for (size_t i = 0; i < 2; ++i) {
        const PolarObservation& a = survey.observations[i];
        const PolarObservation& b = again.observations[i];
        EXPECT_EQ(b.station, a.station);
        using Observation = PolarObservation;
        for (const auto member : {&Observation::direction, &Observation::zenith,
                                  &Observation::distance, &Observation::target_height}) {
            EXPECT_NEAR(b.*member, a.*member, 1e-11);
        }
        EXPECT_NEAR(b.angle_std, a.angle_std, 1e-16);
        EXPECT_NEAR(b.distance_std, a.distance_std, 1e-14);
    }
}

TEST(PolarCsv, IsDistinguishedFromCoordinates) {
    EXPECT_TRUE(is_polar_csv("\nTarget,Station,Hz [gon],V,distance\n"));
    for (const char* text : {"", "id,x,y,z\n", "A,1,2,3\n", "station,target\n", "\"open"}) {
        EXPECT_FALSE(is_polar_csv(text)) << text;
    }
}

constexpr const char* header = "station,target,hz [gon],v [gon],distance [m]\n";

TEST(PolarCsv, RefusesOtherTextsInOneLine) {
    test::expect_refused(
        "a.csv",
        {{header, ": holds no observation behind its header"},
         {"station,target,hz [gon],v [gon],distance,x\n1,A,1,1,1,1\n",
          ":1: has the column 'x', expected some of station, target, hz, v, distance, "
          "target_height, angle_std, distance_std"},
         {"station,target,hz [gon],v [gon],hz [gon],distance\n", ":1: has the column hz twice"},
         {"station,target,hz [gon],v [gon]\n1,A,1,1\n",
          ":1: has no column distance, expected station, target, hz, v, distance"},
         {"station,target,hz [gon],v [grad],distance\n1,A,1,1,1\n",
          ":1: has v in 'grad', expected gon, mgon, deg, arcsec, rad or mrad"},
         {std::string(header) + "1,,1,1,1\n", ":2: has no target, expected a name"},
         {std::string(header) + "1,A,1,1,1\n1,B,401,1,1\n",
          ":3: hz is '401', expected -400 to 400 as its unit says: is the unit right?"},
         {std::string(header) + "1,A,1,1,0\n", ":2: distance is '0', expected more than 0"}},
        [](const std::string& text) { return parse_polar_csv(text, "a.csv"); });
}

TEST(Angle, IsReadWithItsUnit) {
    EXPECT_NEAR(parse_angle("0.3mgon").angle, 0.3e-3 * gon, 1e-20);
    EXPECT_EQ(parse_angle("0.3 mgon").full_unit, gon);
    EXPECT_NEAR(parse_angle("1arcsec").angle, degree / 3600, 1e-20);
    EXPECT_EQ(parse_angle("0.001 deg").full_unit, degree);
    EXPECT_EQ(parse_angle("5mrad").angle, 5e-3);
    EXPECT_EQ(parse_angle("5e-6 rad").full_unit, 1.0);
    for (const char* text : {"", "0.3", "mgon", "0.3mm", "0,3mgon", "nanmgon"}) {
        EXPECT_THROW(static_cast<void>(parse_angle(text)), std::invalid_argument) << text;
    }
}

TEST(DistancePrecision, IsALengthAndAPartOfTheDistance) {
    const DistancePrecision both = parse_distance_precision("1mm+1.5ppm");
    EXPECT_EQ(both.std_dev, 1e-3);
    EXPECT_NEAR(both.part, 1.5e-6, 1e-20);
    EXPECT_NEAR(both.std_at(1000.0), 2.5e-3, 1e-15);
    EXPECT_EQ(parse_distance_precision("2 mm + 2 ppm").std_dev, 2e-3);
    EXPECT_EQ(parse_distance_precision("0.5mm").part, 0.0);
    for (const char* text : {"", "0mm", "1mm+", "1mm+2", "1mm+2mm", "ppm", "1mm+-1ppm", "1.5ppm"}) {
        EXPECT_THROW(static_cast<void>(parse_distance_precision(text)), std::invalid_argument)
            << text;
    }
}

}  // namespace
}  // namespace taut
