// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a survey that is misread: columns shifted, a decimal comma taken for a separator,
// a line dropped without a word.

#include "taut/io/survey_csv.hpp"

#include <gmock/gmock.h>

#include "support/bad_input.hpp"
#include "support/errors.hpp"
#include "support/scratch.hpp"

namespace taut {
namespace {

using test::input_error_of;

TEST(SurveyCsv, GivesTheSameTwoPointsHoweverTheyAreWritten) {
    for (const std::string text :
         {"A,1.5,-2.25,3e-3\nB 2,4,5,.125\n", "A 1.5 -2.25 3e-3\n\"B 2\" 4 5 .125\n",
          " A\t1.5   -2.25 \t3e-3 \n\"B 2\"\t4\t5\t.125\t\n",
          "A , 1.5,\t-2.25 , 3e-3 \n \"B 2\" , 4, 5, .125\n",
          "ID;X;Y;Z\nA;1.5;-2.25;3e-3\nB 2;4;5;.125\n",
          "id,x,y,z,sx,sy,sz\nA,1.5,-2.25,3e-3,0,0.001,1\nB 2,4,5,.125,0,0,0\n",
          "# total station, 2026; x,y,z\n\nid,x,y,z\n  # more\nA,1.5,-2.25,3e-3\n \t\nB "
          "2,4,5,.125\n#end\n",
          "\xEF\xBB\xBFid,x,y,z\nA,1.5,-2.25,3e-3\nB 2,4,5,.125\n",
          "\"id\",\"x\",\"y\",\"z\"\n\"A\",\"1.5\",\"-2.25\",\"3e-3\"\n\"B "
          "2\",\"4\",\"5\",\".125\"\n",
          "A,+1.5,-2.25,+3e-3\nB 2,4,5,+.125\n"}) {
        SCOPED_TRACE(text);
        const auto points = parse_survey_points(text, "survey.csv");
        ASSERT_EQ(points.size(), 2U);
        EXPECT_EQ(points[0].id, "A");
        EXPECT_EQ(points[0].position, Eigen::Vector3d(1.5, -2.25, 3e-3));
        EXPECT_EQ(points[1].id, "B 2");
        EXPECT_EQ(points[1].position, Eigen::Vector3d(4, 5, 0.125));
    }
}

TEST(SurveyCsv, UnquotesIdsAndKeepsSeparatorsQuotesAndLineEndsInThem) {
    const auto points = parse_survey_points(
        "\"a,b\",1,2,3\n\"say \"\"x\"\"\",1,2,3\n\"two\nlines\",1,2,3\nP#7,1,2,3\n", "survey.csv");
    ASSERT_EQ(points.size(), 4U);
    EXPECT_EQ(points[0].id, "a,b");
    EXPECT_EQ(points[1].id, "say \"x\"");
    EXPECT_EQ(points[2].id, "two\nlines");
    EXPECT_EQ(points[3].id, "P#7");
}

TEST(SurveyCsv, TellsTheLineThatAPointStandsOn) {
    const auto points = parse_survey_points(
        "# comment\r\nid,x,y,z\r\n\r\n\"two\nlines\",1,2,3\r\nB,1,2,3\r\n", "survey.csv");
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0].line, 4);
    EXPECT_EQ(points[1].line, 6);
}

TEST(SurveyCsv, TakesLinesWithoutIdsAndEmptyIdsForTargetsWithoutNames) {
    for (const char* text :
         {"x,y,z\n1,2,3\n4,5,6\n", "1 2 3\n4 5 6\n", "id,x,y,z\n,1,2,3\n\"\",4,5,6\n"}) {
        const auto points = parse_survey_points(text, "survey.csv");
        ASSERT_EQ(points.size(), 2U) << text;
        EXPECT_EQ(points[0].id, "");
        EXPECT_EQ(points[0].position, Eigen::Vector3d(1, 2, 3));
        EXPECT_EQ(points[1].position, Eigen::Vector3d(4, 5, 6));
    }
}

TEST(SurveyCsv, ReadsStandardDeviationsAndCorrelations) {
    EXPECT_FALSE(parse_survey_points("A,1,2,3\n", "survey.csv")[0].noise_std.has_value());
    const auto points = parse_survey_points("A,1,2,3,0.1,0.2,0.3\n", "survey.csv");
    EXPECT_EQ(points[0].noise_std, Eigen::Vector3d(0.1, 0.2, 0.3));
    for (const char* text : {"A,1,2,3,0.1,0.2,0.3,0.5,-0.25,0\n",
                             "id,x,y,z,sx,sy,sz,rxy,rxz,ryz\nA,1,2,3,0.1,0.2,0.3,0.5,-0.25,0\n",
                             "x;y;z;sx;sy;sz;rxy;rxz;ryz\n1;2;3;0.1;0.2;0.3;0.5;-0.25;0\n"}) {
        const auto points = parse_survey_points(text, "survey.csv");
        ASSERT_EQ(points.size(), 1U) << text;
        EXPECT_EQ(*points[0].noise_std, Eigen::Vector3d(0.1, 0.2, 0.3));
        EXPECT_EQ(points[0].noise_correlations, Eigen::Vector3d(0.5, -0.25, 0.0));
    }
}

TEST(SurveyCsv, WritesWhatItReadsBackToTheLastBit) {
    const std::vector<SurveyPoint> points{
        {.id = "a, \"b\"", .position = {1.0 / 3.0, -2e-17, 1e6 + 0.1}},
        {.id = "", .position = {1, 2, 3}, .noise_std = Eigen::Vector3d(0.1, 1.0 / 3.0, 0)},
        {.id = "C",
         .position = {4, 5, 6},
         .noise_std = Eigen::Vector3d(0.1, 0.2, 0.3),
         .noise_correlations = {1.0 / 7.0, -0.1, 0.3}}};
    const auto read = parse_survey_points(survey_to_csv(points), "survey.csv");
    ASSERT_EQ(read.size(), points.size());
    for (size_t i = 0; i < read.size(); ++i) {
        EXPECT_EQ(read[i].noise_correlations, points[i].noise_correlations);
        EXPECT_EQ(read[i].id, points[i].id);
        EXPECT_EQ(read[i].position, points[i].position);
        EXPECT_EQ(read[i].noise_std, points[i].noise_std.value_or(Eigen::Vector3d::Zero()));
    }
}

TEST(SurveyCsv, ReadsPtsWithIntensityAndColour) {
    const test::ScratchDirectory scratch;
    test::put_bytes(scratch / "scan.PTS", "2\r\n1.5 2 3 -1200 12 13 14\r\n4 5 6\r\n");
    const auto points = read_survey_points(scratch / "scan.PTS");
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0].id, "");
    EXPECT_EQ(points[0].position, Eigen::Vector3d(1.5, 2, 3));
}

TEST(SurveyCsv, RefusesAPtsFileThatIsNotWhole) {
    const auto message = [](const std::string& text) {
        return input_error_of([&] { return parse_pts_points(text, "scan.pts"); });
    };
    EXPECT_EQ(message("3\n1 2 3\n"), "scan.pts: holds 1 points, expected 3 as its first line says");
    EXPECT_EQ(message("1 2 3\n"),
              "scan.pts:1: is not the number of points that a PTS file starts with");
    EXPECT_EQ(message("1\n1 2\n"),
              "scan.pts:2: has 2 fields, expected x y z, with or without intensity and colour "
              "behind");
    EXPECT_EQ(message("1\n1 2 nan\n"), "scan.pts:2: z is 'nan', expected a finite number");
}

TEST(SurveyCsv, RefusesWhatIsNoFiniteNumber) {
    for (const std::string number : {"two", "1m", "", "0x10", "+-1", "nan", "-inf", "1e999"}) {
        EXPECT_EQ(input_error_of(
                      [&] { return parse_survey_points("A,1," + number + ",3\n", "survey.csv"); }),
                  "survey.csv:1: y is '" + number + "', expected a finite number");
    }
}

constexpr const char* no_point = ": holds no point, expected lines id,x,y,z";
constexpr const char* no_header =
    ":1: is neither a point nor the header [id,]x,y,z[,sx,sy,sz[,rxy,rxz,ryz]]";
constexpr const char* wrong_count =
    " fields, expected [id,]x,y,z[,sx,sy,sz[,rxy,rxz,ryz]]: 3, 4, 6, 7, 9 or 10";

TEST(SurveyCsv, RefusesOtherTextsWithTheirLine) {
    test::expect_refused(
        "survey.csv",
        {{"id,x,y,z\n", no_point},
         {"id,x,z,y\nA,1,2,3\n", no_header},
         {"id,x,y,z\nid,x,y,z\n", ":2: x is 'x', expected a finite number"},
         {"A,1,2,3,\n", std::string(":1: has 5") + wrong_count},
         {"A,1,2,3\nB,1,2\n", ":2: has 3 fields, expected 4 as in the lines before"},
         {"A,1,2,3,0,-0.1,0\n", ":1: sy is '-0.1', expected a standard deviation of at least 0"},
         {"A,1,2,3,1,1,1,0,0,0\nB,1,2,3,1,1,1,.9,.9,-.9\n",
          ":2: rxy, rxz, ryz are .9, .9, -.9, expected correlations that three coordinates can "
          "have: their matrix is not positive definite"},
         {"A;1,5;2,5;3,5\n", ":1: x is '1,5', expected a number with a decimal point, not a comma"},
         {"A 1,5 2 3\n", ":1: x is '1,5', expected a number with a decimal point, not a comma"},
         {"id,x,y,z\nA,1,5,2,5,3,5\n",
          ":2: has 7 fields, expected 4 as in the lines before (with a decimal point, not a "
          "comma)"},
         {"A,1,2,3\n\"B,1,2,3\nC,1,2,3\n", ":2: opens a quote that is never closed"},
         {"\"A\"b,1,2,3\n", ":1: has text behind a closing quote, expected a separator"},
         {std::string("A,1,2,3\nB,1,2,\0", 15), ":2: holds a zero byte, expected text"}},
        [](const std::string& text) { return parse_survey_points(text, "survey.csv"); });
}

}  // namespace
}  // namespace taut
