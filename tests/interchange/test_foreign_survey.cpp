// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a survey of another program that is misread: axes exchanged, a unit taken for
// another, a line dropped without a word, a damaged file taken for a whole one.

#include "taut/interchange/foreign_survey.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <array>
#include <random>

#include "support/bad_input.hpp"
#include "support/errors.hpp"
#include "support/scratch.hpp"

namespace taut {
namespace {

using test::input_error_of;
using testing::Contains;
using testing::HasSubstr;

/// Two points, "P1" at (1.5, -2.25, 0.125) m and "7" at (4, 5, 6) m, in a file.
struct ForeignText {
    std::string file;
    std::string text;
    double unit;  ///< of the file; 0: none
};

const std::string landxml_head =
    "<?xml version=\"1.0\"?>\n<LandXML xmlns=\"http://www.landxml.org/schema/LandXML-1.2\">";

TEST(ForeignSurvey, GivesTheSameTwoPointsOutOfEveryFormat) {
    const std::vector<ForeignText> all{
        {"a.csv", "Punkt;X;Y;Z\nP1;1,5;-2,25;0,125\n7;4;5;6\n", 0},
        {"a.txt", "Pkt-Nr;Rechtswert;Hochwert;H\xF6he\nP1;1,5;-2,25;,125\n7;4,0;5,0;6,0\n", 0},
        {"a.asc", "id x y z sx sy sz  remark\nP1 1.5 -2.25 0.125 1 2 3 a b c\n7 4 5 6 0 0 0\n", 0},
        {"a.csv", "Punkt;X [mm];Y [mm];Z [mm]\nP1;1500;-2250;125\n7;4000;5000;6000\n", 1e-3},
        {"a.csv", "Punkt;X;Y;Z\n-;mm;mm;mm\nP1;1500;-2250;125\n7;4000;5000;6000\n", 1e-3},
        {"a.csv", "# Einheit: mm\nPunkt;X;Y;Z\nP1;1500;-2250;125\n7;4000;5000;6000\n", 1e-3},
        {"a.csv",
         "id,x (ft),y (ft),z "
         "(ft)\nP1,4.92125984251968504,-7.38188976377952756,0.41010498687664042\n7,13."
         "1233595800524934,16.4041994750656168,19.6850393700787402\n",
         0.3048},
        {"a.txt", "Punkt\tBemerkung\tX\tY\tZ\nP1\tam Mast\t1,5\t-2,25\t0,125\n7\t\t4\t5\t6\n", 0},
        {"a.txt",
         "Projekt S\xC3\xBC"
         "d\n// second set\nName East North Height\nP1 1.5 -2.25 0.125\n7 4 5 6\n",
         0},
        {"a.txt", "// id y x z\nP1 -2.25 1.5 0.125\n7 5 4 6\n", 0},
        {"a.csv", "Name;X;Y;Z\nP1;1,5;-2,25;0,125\nB;1,5;2;\n7;4;5;6\nEnde\n", 0},
        {"a.txt", "P1;1,5;-2,25;0,125;T\n7;4;5;6;T\n", 0},
        {"a.gsi",
         "110001+000000P1 81...0+00001500 82...0-00002250 83...0+00000125\n110002+00000007 "
         "81...0+00004000 82...0+00005000 83...0+00006000 \n",
         1},
        {"a.txt",
         "*410001+00000000000000A1\n*110002+00000000000000P1 21.322+0000000012345678 "
         "81..46+0000000000015000 82..48-0000000000225000 "
         "83..00+0000000000000125\n*110003+0000000000000007 81..46+0000000000040000 "
         "82..46+0000000000050000 83..46+0000000000060000\n",
         1},
        {"a.xml",
         landxml_head +
             "<Units><Metric linearUnit=\"millimeter\"/></Units><CgPoints><CgPoint "
             "name=\"P1\">-2250 1500 125</CgPoint>\n<CgPoint name=\"flat\">1 2</CgPoint><CgPoint "
             "name=\"7\" code=\"T\"> 5000 4000\n6000 </CgPoint></CgPoints></LandXML>",
         1e-3},
        {"a.jxl",
         "<JOBFile><FieldBook><PointRecord><Name>P1</Name><Grid><North>9</North><East>9</"
         "East><Elevation>9</Elevation></Grid></PointRecord></"
         "FieldBook><Reductions><Point><Name>P1</Name><Grid><North>-2.25</North><East>1.5</"
         "East><Elevation>0.125</Elevation></Grid></Point><Point><Name>7</Name><Grid><North>5</"
         "North><East>4</East><Elevation>6</Elevation></Grid></Point></Reductions></JOBFile>",
         1},
        {"a.jxl",
         "<JOBFile><FieldBook><PointRecord><Name>P1</Name><Grid><North/><East/><Elevation/></"
         "Grid><ComputedGrid><North>-2.25</North><East>1.5</East><Elevation>0.125</Elevation></"
         "ComputedGrid></PointRecord><PointRecord><Name>7</Name><Grid><North>5</North><East>4</"
         "East><Elevation>6</Elevation></Grid></PointRecord><PointRecord><Name>8</"
         "Name><Deleted>true</Deleted><Grid><North>5</North><East>4</East><Elevation>6</"
         "Elevation></Grid></PointRecord></FieldBook></JOBFile>",
         1},
        {"a.dxf",
         "  0\nSECTION\n  2\nHEADER\n  9\n$INSUNITS\n 70\n 4\n  0\nENDSEC\n  0\nSECTION\n  "
         "2\nENTITIES\n  0\nTEXT\n 10\n4010\n 20\n5010\n 30\n6000\n  1\n7\n  0\nPOINT\n 10\n1500\n "
         "20\n-2250\n 30\n125\n  0\nPOINT\n 10\n4000\n 20\n5000\n 30\n6000\n  0\nTEXT\n 10\n1510\n "
         "20\n-2240\n 30\n125\n  1\nP1\n  0\nENDSEC\n  0\nEOF\n",
         1e-3}};
    for (const ForeignText& good : all) {
        SCOPED_TRACE(good.file + ": " + good.text);
        const ForeignSurvey survey = read_foreign_survey(good.text, good.file);
        EXPECT_EQ(survey.unit.value_or(0.0), good.unit);
        ASSERT_EQ(survey.points.size(), 2U);
        const double unit = survey.unit.value_or(1.0);
        EXPECT_EQ(survey.points[0].id, "P1");
        EXPECT_LT((unit * survey.points[0].position - Eigen::Vector3d(1.5, -2.25, 0.125)).norm(),
                  1e-12);
        EXPECT_EQ(survey.points[1].id, "7");
        EXPECT_LT((unit * survey.points[1].position - Eigen::Vector3d(4, 5, 6)).norm(), 1e-12);
        EXPECT_FALSE(survey.notes.empty());
    }
}

TEST(ForeignSurvey, SaysHowATableWasUnderstood) {
    const ForeignSurvey survey = read_foreign_survey(
        "Messung\nPkt-Nr;Rechtswert;Hochwert;H\xF6he;Code\nA;1,5;2;3;T\nB;1;;3;T\nEnde\n", "a.csv");
    EXPECT_EQ(survey.format, "text table");
    EXPECT_THAT(survey.notes, Contains("columns: Pkt-Nr as id, Rechtswert as x, Hochwert as y, "
                                       "H\xC3\xB6he as z, Code as code"));
    EXPECT_THAT(survey.notes, Contains("separator: semicolon; decimal sign: comma"));
    EXPECT_THAT(survey.notes, Contains("encoding: Latin-1"));
    ASSERT_EQ(survey.left_out.size(), 2U);
    EXPECT_EQ(survey.left_out[0].line, 4);
    EXPECT_EQ(survey.left_out[0].reason, "no y");
    EXPECT_EQ(survey.left_out[1].reason, "no coordinates: 'Ende'");
    EXPECT_TRUE(survey.guesses.empty());
}

TEST(ForeignSurvey, SaysThatItGuessesColumns) {
    const ForeignSurvey survey =
        read_foreign_survey("1 1.5 2.5 3.5 9.5\n2 1.5 2.5 3.5 9.5\n", "a.txt");
    EXPECT_EQ(survey.points[0].id, "1");
    ASSERT_EQ(survey.guesses.size(), 1U);
    EXPECT_EQ(survey.guesses[0], "no header was understood: columns taken as id, x, y, z, -");
}

TEST(ForeignSurvey, TakesTheOptionsBeforeWhatItFinds) {
    const SurveyFileOptions options{
        .columns = parse_survey_columns("-,y,x,z,sx,sy,sz"), .separator = ';', .decimal = ','};
    const ForeignSurvey survey =
        read_foreign_survey("Name;X;Y;Z;a;b;c\nA;1,5;2;3;1;2;3\n", "a.csv", options);
    EXPECT_EQ(survey.points[0].id, "");
    EXPECT_EQ(survey.points[0].position, Eigen::Vector3d(2, 1.5, 3));
    EXPECT_EQ(*survey.points[0].noise_std, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(
        read_foreign_survey("A;1.5;2;3\n", "a.gsi", {.format = SurveyFormat::table}).points.size(),
        1U);
    for (const char* const columns : {"id,x,y", "x,y,z,x", "x,y,z,sx", "x,y,z,height", ""}) {
        EXPECT_THROW(static_cast<void>(parse_survey_columns(columns)), std::invalid_argument)
            << columns;
    }
    for (const char* const format :
         {"table", "xyz", "pts", "gsi", "landxml", "jobxml", "gama", "dxf"}) {
        EXPECT_EQ(to_string(parse_survey_format(format)), format);
    }
    EXPECT_THROW(static_cast<void>(parse_survey_format("xlsx")), std::invalid_argument);
}

TEST(ForeignSurvey, ReadsXyzWithoutNamesAndLeavesOutColours) {
    for (const char* const text : {"1.5 2 3 120 12 13 14\n4.5 5 6 90 1 2 3\n",
                                   "//X Y Z R G B\n1.5 2 3 12 13 14\n4.5 5 6 1 2 3\n"}) {
        const ForeignSurvey survey = read_foreign_survey(text, "scan.xyz");
        ASSERT_EQ(survey.points.size(), 2U);
        EXPECT_EQ(survey.points[0].id, "");
        EXPECT_EQ(survey.points[0].position, Eigen::Vector3d(1.5, 2, 3));
        EXPECT_FALSE(survey.points[0].noise_std.has_value());
    }
}

TEST(ForeignSurvey, ReadsAnglesAndDistancesOfGsiFromEveryStation) {
    // Words of a station begin a new one, though no observation was made from the first; heights of
    // the prism hold for their line, or from a line without observations on.
    const std::string text =
        "110001+00000901 84...0+00000000 85...0+00000000 86...0+00000000 88...0+00001600\n"
        "110002+00000902 84...0+00001000 85...0+00002000 86...0+00000500 88...0+00001600\n"
        "110003+00000001 21.322+10000000 22.322+09000000 31...0+00012345\n"
        "110004+00000002 21.322+30000000 22.322+31000000 31...6+00123456 87...0+00000100\n"
        "410005+00000007 42....+00000000\n"
        "110006+00000903 88...0+00001500 87...0+00000200\n"
        "110007+00000001 21.323+09000000 22.323+08100000 31...8+01234500\n"
        "110008+00000003 21.324+09000300 22.325+16000000 31...1+00010000\n"
        "110009+00000004 21.322+10000000 22.322+09000000\n";
    const ForeignSurvey found = read_foreign_survey(text, "a.gsi");
    EXPECT_TRUE(found.points.empty());
    const PolarSurvey& survey = found.polar;
    ASSERT_EQ(survey.stations.size(), 2U);
    EXPECT_EQ(survey.stations[0].name, "902");
    EXPECT_EQ(survey.stations[0].line, 2);
    EXPECT_EQ(survey.stations[1].name, "903");
    ASSERT_EQ(survey.observations.size(), 4U);
    const std::array<int, 4> stations{0, 0, 1, 1};
    // The second face reads 310 gon for 90; minutes and seconds 90 deg 0 min 30.0 s; 1600 mil.
    const std::array<double, 4> directions{100 * gon, 100 * gon, 90 * degree,
                                           (90 + 30.0 / 3600) * degree};
    const std::array<double, 4> zeniths{90 * gon, 90 * gon, 81 * degree, 90 * degree};
    const std::array<double, 4> distances{12.345, 12.3456, 12.345, 3.048};
    const std::array<double, 4> heights{0.0, 0.1, 0.2, 0.2};
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(survey.observations[i].station, stations[i]) << i;
        EXPECT_NEAR(survey.observations[i].direction, directions[i], 1e-12) << i;
        EXPECT_NEAR(survey.observations[i].zenith, zeniths[i], 1e-12) << i;
        EXPECT_NEAR(survey.observations[i].distance, distances[i], 1e-12) << i;
        EXPECT_EQ(survey.observations[i].target_height, heights[i]) << i;
    }
    EXPECT_EQ(survey.observations[3].line, 8);
    ASSERT_EQ(found.left_out.size(), 1U);
    EXPECT_EQ(found.left_out[0].line, 9);
}

TEST(ForeignSurvey, TakesStationsOfGsiThatEveryLineRepeats) {
    const auto line = [](int target, const char* east) {
        return fmt::format(
            "11{:04}+{:08} 21.322+10000000 22.322+09000000 31...0+00012345 "
            "84...0+{} 85...0+00000000 86...0+00000000\n",
            target, target, east);
    };
    const ForeignSurvey found = read_foreign_survey(
        line(1, "00001000") + line(2, "00001000") + line(1, "00002000"), "a.gsi");
    ASSERT_EQ(found.polar.stations.size(), 2U);
    EXPECT_EQ(found.polar.observations[1].station, 0);
    EXPECT_EQ(found.polar.observations[2].station, 1);
}

TEST(ForeignSurvey, TakesObservationsBesideCoordinatesWhereTheyAreAskedFor) {
    const std::string text =
        "110001+00000001 21.322+10000000 22.322+09000000 31...0+00012345 81...0+00001000 "
        "82...0+00002000 83...0+00003000\n";
    EXPECT_EQ(read_foreign_survey(text, "a.gsi").points.size(), 1U);
    const ForeignSurvey observed = read_foreign_survey(text, "a.gsi", {.takes_observations = true});
    EXPECT_TRUE(observed.points.empty());
    EXPECT_EQ(observed.polar.observations.size(), 1U);
    EXPECT_THAT(input_error_of([] {
                    return read_foreign_survey("A;1.5;2;3\n", "a.csv",
                                               {.takes_observations = true});
                }),
                HasSubstr("a.csv: holds no observations of angles and distances"));
}

TEST(ForeignSurvey, TakesTheCovarianceOfEachPointOfGamaFromItsBand) {
    const auto text = [](const std::string& axes, const std::string& matrix) {
        return "<gama-local-adjustment><network-general-parameters " + axes +
               "/><coordinates><adjusted><point><id>A</id><x>1</x><y>2</y><z>3</z></point><point>"
               "<id>h</id><z>1</z></point><point><id>B</id><X>4</X><Y>5</Y><Z>6</Z></point>"
               "</adjusted>" +
               matrix + "</coordinates></gama-local-adjustment>";
    };
    // Rows of the upper band of two: 7 unknowns, the fourth of the point with a height only.
    const std::string matrix =
        "<cov-mat><dim>7</dim><band>1</band><flt>4</flt><flt>6</flt><flt>16</flt><flt>9</flt>"
        "<flt>25</flt><flt>9</flt><flt>9</flt><flt>9</flt><flt>36</flt><flt>9</flt><flt>49</flt>"
        "<flt>9</flt><flt>64</flt></cov-mat>";
    const ForeignSurvey right = read_foreign_survey(text("axes-xy=\"en\"", matrix), "a.xml");
    ASSERT_EQ(right.points.size(), 2U);
    EXPECT_EQ(right.points[0].position, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(*right.points[0].noise_std, Eigen::Vector3d(2, 4, 5));
    EXPECT_EQ(*right.points[1].noise_std, Eigen::Vector3d(6, 7, 8));
    // The band ends before the covariance of x and z.
    EXPECT_TRUE(right.points[0].noise_correlations.isApprox(Eigen::Vector3d(6.0 / 8, 0, 9.0 / 20)));
    EXPECT_TRUE(
        right.points[1].noise_correlations.isApprox(Eigen::Vector3d(9.0 / 42, 0, 9.0 / 56)));
    EXPECT_EQ(right.std_unit, 1e-3);
    EXPECT_EQ(right.left_out.size(), 1U);
    // North first is left-handed: east comes first.
    const ForeignSurvey left = read_foreign_survey(text("", matrix), "a.xml");
    EXPECT_EQ(left.points[1].position, Eigen::Vector3d(5, 4, 6));
    EXPECT_EQ(*left.points[1].noise_std, Eigen::Vector3d(7, 6, 8));
    EXPECT_TRUE(left.points[1].noise_correlations.isApprox(Eigen::Vector3d(9.0 / 42, 9.0 / 56, 0)));
    EXPECT_EQ(input_error_of([&] {
                  return read_foreign_survey(
                      text("",
                           "<cov-mat><dim>7</dim><band>1</band><flt>4</flt><flt>9</flt>"
                           "</cov-mat>"),
                      "a.xml");
              }),
              "a.xml:1: has a cov-mat with 1 whole rows, expected 7 as dim says");
    EXPECT_THAT(input_error_of([&] {
                    return read_foreign_survey(
                        text("", "<cov-mat><dim>1e300</dim><band>1e300</band></cov-mat>"), "a.xml");
                }),
                HasSubstr("expected 1e+300"));
}

TEST(ForeignSurvey, ReadsUtf16OfBothKindsWithMarkAndWithout) {
    const std::string plain = "Name;X;Y;Z\nA;1,5;2;3\n";
    for (const bool is_big : {false, true}) {
        for (const bool has_mark : {false, true}) {
            std::string bytes = has_mark ? (is_big ? "\xFE\xFF" : "\xFF\xFE") : "";
            for (const char c : plain) {
                bytes += is_big ? std::string{'\0', c} : std::string{c, '\0'};
            }
            EXPECT_EQ(read_foreign_survey(bytes, "a.csv").points[0].position,
                      Eigen::Vector3d(1.5, 2, 3));
        }
    }
    EXPECT_EQ(input_error_of([&] {
                  return read_foreign_survey(
                      "\xFF\xFE"
                      "A",
                      "a.csv");
              }),
              "a.csv:1: holds half a character of UTF-16: is the file whole?");
}

TEST(ForeignSurvey, RefusesOtherTextsInOneLine) {
    const std::vector<test::BadText> texts{
        {"", "a.csv: holds no point..."},
        {"Name;X;Y;Z\nA;1;2;3\nB;1;2\n",
         "a.csv:3: has 3 fields, expected id, x, y, z: is the file whole?..."},
        {"Name;X;Y;Z\nA;1;2;nan\n", "a.csv:2: z is 'nan', expected a finite number..."},
        {std::string(4'000'001, '\n'), "a.csv: has more than 4000000 lines..."},
        {"Name;X;Y;Z\nA;1,5;2;3\nB;1.5;2;3\n",
         "a.csv:3: x is '1.5', expected a decimal comma as in line 2..."},
        {"Name,X,Y,Z\nA,1,5,2,5,3,5\n",
         "a.csv:2: has 7 fields, expected 4: id, x, y, z (decimal commas between commas..."},
        {"Name;X [m];Y [m];Z [mm]\nA;1;2;3\n",
         "a.csv:1: gives two units of coordinates, expected one for all..."},
        {"Name;X;Y;Code\nA;1;2;3\n", "a.csv:1: names no column for z..."},
        {"Name;X;East;Y;Z\nA;1;2;3;4\n", "a.csv:1: names a coordinate twice..."},
        {"110001+00000001 21.320+12345678 22.322+12345678 31...0+00012345\n",
         "a.gsi:1: word 21 has the unit '0', expected one of angles: 2, 3, 4, 5..."},
        {"110001+00000001 21.323+36100000 22.323+09000000 31...0+00012345\n",
         "a.gsi:1: word 21 is '36100000', expected no more than a full circle..."},
        {"110001+00000001 81...0+00001500 82...0-00002250 83...0+000",
         "a.gsi:1: ends within the word '83...0+000'..."},
        {"110001+00000001 81...0+00001500 82...1-00002250 83...0+00000125\n",
         "a.gsi:1: has coordinates in feet where others are in metres..."},
        {"110001+00000001 81...2+00001500 82...0+00000001 83...0+00000125\n",
         "a.gsi:1: word 81 has the unit '2'..."},
        {"<JOBFile><PointRecord><Name>1</Name><Circle/></PointRecord></JOBFile>",
         "a.jxl: holds 1 points and no coordinates of any..."},
        {landxml_head + "<CgPoints><CgPoint name=\"A\">1 2 3</CgPo", "a.xml:2: is no XML..."},
        {"<gama-local/>", "a.xml: is the input of GNU Gama..."},
        {"0\nSECTION\n2\nENTITIES\n0\nPOINT\n10\n1\n", "a.dxf:8: ends before the pair 0, EOF..."},
        {"0\nSECTION\nx\nENTITIES\n", "a.dxf:3: is 'x', expected the number..."},
        {"PK\x03\x04xl/worksheets", "a.xlsx: is a ZIP archive..."},
        {"{\"format\": \"taut-net\"}", "a.json: is JSON, expected a survey..."},
        {landxml_head + "</LandXML>",
         "a.gsi: is a LandXML file, expected a Leica GSI file by the end of its name: give the "
         "format landxml..."},
        {std::string("Name;X;Y;Z\nA;1;2;3\0\n", 20), "a.csv:2: holds a zero byte..."}};
    for (const test::BadText& bad : texts) {
        const std::string file = bad.message.substr(0, bad.message.find(':'));
        SCOPED_TRACE(bad.message);
        test::expect_message(input_error_of([&] { return read_foreign_survey(bad.text, file); }),
                             bad.message);
    }
}

TEST(ForeignSurvey, ExpandsNoEntitiesAndStandsDeepElements) {
    std::string deep = "<LandXML>";
    for (int i = 0; i < 100000; ++i) {
        deep += "<a>";
    }
    EXPECT_THAT(input_error_of([&] { return read_foreign_survey(deep, "a.xml"); }),
                HasSubstr("is no XML"));
    for (int i = 0; i < 100000; ++i) {
        deep += "</a>";
    }
    EXPECT_THAT(input_error_of([&] { return read_foreign_survey(deep + "</LandXML>", "a.xml"); }),
                HasSubstr("holds no point"));
    EXPECT_THAT(input_error_of([&] {
                    return read_foreign_survey(
                        "<!DOCTYPE LandXML [<!ENTITY a \"1 2 3\"><!ENTITY b \"&a;&a;\">]><LandXML>"
                        "<CgPoint name=\"A\">&b; 2 3</CgPoint></LandXML>",
                        "a.xml");
                }),
                HasSubstr("northing is '&b;', expected a finite number"));
}

TEST(ForeignSurvey, OfDamagedFilesGivesPointsOrAnErrorAndNothingElse) {
    std::mt19937 random(1);
    for (const char* const name :
         {"german.csv", "english.txt", "gsi8.gsi", "gsi16.gsi", "landxml.xml", "jobxml.jxl",
          "gama.xml", "drawing.dxf", "scan.pts", "scan.xyz"}) {
        const std::string bytes =
            test::bytes_of(std::filesystem::path(TAUT_TEST_DATA_DIR) / "surveys" / name);
        ASSERT_FALSE(bytes.empty());
        const auto whole = read_foreign_survey(bytes, name).points.size();
        for (int i = 0; i < 200; ++i) {
            std::string damaged =
                bytes.substr(0, i % 2 == 0 ? random() % bytes.size() : bytes.size());
            for (int k = 0; k < i % 5 && !damaged.empty(); ++k) {
                damaged[random() % damaged.size()] = static_cast<char>(random());
            }
            test::succeeds_or_refuses([&] {
                const ForeignSurvey survey = read_foreign_survey(damaged, name);
                EXPECT_LE(survey.points.size(), whole + 5);
                for (const SurveyPoint& point : survey.points) {
                    EXPECT_TRUE(point.position.allFinite());
                }
                return 0;
            });
        }
    }
}

}  // namespace
}  // namespace taut
