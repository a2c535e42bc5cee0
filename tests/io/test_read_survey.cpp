// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards the one path from any file to a survey: a unit guessed wrong or without a word, names that
// are another's, two points taken for one.

#include "taut/io/read_survey.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <cmath>

#include "support/errors.hpp"
#include "support/scratch.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

using test::input_error_of;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::filesystem::path data_file(const std::string& name) {
    return std::filesystem::path(TAUT_TEST_DATA_DIR) / "surveys" / name;
}

class ReadSurvey : public testing::Test {
protected:
    const CableNet m_net = hypar(4, 5);
    test::ScratchDirectory m_scratch;

    Survey read(const std::string& text, const std::string& name,
                const ReadSurveyOptions& options = {}) const {
        test::put_bytes(m_scratch / name, text);
        return read_survey(m_net, m_scratch / name, options);
    }

    std::string refusal(const std::string& text, const std::string& name,
                        const ReadSurveyOptions& options = {}) const {
        return input_error_of([&] { return read(text, name, options); })
            .substr(m_scratch.path().string().size() + 1);
    }

    /// A table of the nominal nodes.
    /// @param line what stands there for node, x, y, z
    template <class Line>
    std::string table(const std::string& header, const Line& line) const {
        std::string text = header;
        for (int node = 0; node < m_net.node_count(); ++node) {
            const Eigen::Vector3d p = m_net.nodes().col(node);
            text += line(node, p.x(), p.y(), p.z()) + "\n";
        }
        return text;
    }

    /// A table of the nominal nodes.
    /// @param format of node, x, y, z
    std::string formatted(const std::string& header, const char* format) const {
        return table(header, [format](int node, double x, double y, double z) {
            return fmt::format(fmt::runtime(format), node, x, y, z);
        });
    }

    /// Largest distance of a surveyed node from where the net has it [m].
    double distance(const Survey& survey) const {
        return (survey.form - m_net.nodes()).colwise().norm().maxCoeff();
    }
};

TEST_F(ReadSurvey, GivesTheSameFormOutOfEveryFormat) {
    const Survey own = read_survey(m_net, data_file("own.csv"), {.noise_std = 0.0});
    EXPECT_THAT(own.notes, IsEmpty());
    EXPECT_THAT(own.warnings, IsEmpty());
    for (const char* const name :
         {"german.csv", "english.txt", "gsi8.gsi", "gsi16.gsi", "landxml.xml", "jobxml.jxl",
          "gama.xml", "drawing.dxf", "scan.pts", "scan.xyz", "excel.xlsx"}) {
        const Survey survey = read_survey(m_net, data_file(name));
        EXPECT_EQ(survey.surveyed, own.surveyed) << name;
        EXPECT_LT((survey.form - own.form).cwiseAbs().maxCoeff(), 1e-12) << name;
        EXPECT_THAT(survey.notes, Contains(HasSubstr("read as "))) << name;
        EXPECT_THAT(survey.warnings, IsEmpty()) << name;
        EXPECT_EQ(survey.placed.size(), 38U) << name;
    }
    const Survey gama = read_survey(m_net, data_file("gama.xml"), {.noise_std = 0.01});
    EXPECT_NEAR(gama.largest_noise_std(), 0.2e-3, 1e-15);
    const Survey repeated = read_survey(m_net, data_file("english.txt"));
    EXPECT_THAT(repeated.notes, Contains(HasSubstr("8 points were measured several times")));
}

TEST_F(ReadSurvey, GuessesTheUnitByTheNetAndSaysSo) {
    for (const auto& [unit, length] : {std::pair("mm", 1e-3), std::pair("ft", 0.3048)}) {
        const std::string text =
            table("Name;X;Y;Z\n", [size = length](int node, double x, double y, double z) {
                return fmt::format("{};{};{};{}", node, x / size, y / size, z / size);
            });
        const Survey survey = read(text, "a.csv");
        EXPECT_LT(distance(survey), 1e-12);
        EXPECT_THAT(survey.warnings, ElementsAre(HasSubstr(fmt::format("taken as {}:", unit))));
        EXPECT_THAT(read(text, "a.csv", {.unit = length}).warnings, IsEmpty());
    }
    EXPECT_THAT(refusal(table("Name;X;Y;Z\n",
                              [](int node, double x, double y, double z) {
                                  return fmt::format("{};{};{};{}", node, 50 * x, 50 * y, 50 * z);
                              }),
                        "a.csv"),
                HasSubstr("a.csv: gives no unit, and in none of m, mm and ft its points extend"));
    EXPECT_THROW(static_cast<void>(read("0,1,2,3\n", "a.csv", {.unit = 0.0})),
                 std::invalid_argument);
}

TEST_F(ReadSurvey, NamesTheUnitThatItsOwnFormatWouldFit) {
    const std::string text = table("", [](int node, double x, double y, double z) {
        return fmt::format("{},{},{},{}", node, 1e3 * x, 1e3 * y, 1e3 * z);
    });
    EXPECT_THAT(refusal(text, "a.csv"),
                HasSubstr("its coordinates are in millimetres, not in metres: give the unit mm"));
    EXPECT_LT(distance(read(text, "a.csv", {.unit = 1e-3})), 1e-12);
}

TEST_F(ReadSurvey, TakesTheDigitsOfAFileForItsNoiseUnlessItIsTheNominalForm) {
    const auto text = [&](double off) {
        return table("", [&](int node, double x, double y, double z) {
            return fmt::format("{},{:.4f},{:.4f},{:.4f}", node, x + off, y, z);
        });
    };
    const Survey rounded = read(text(0.0012), "a.csv");
    EXPECT_NEAR(rounded.largest_noise_std(), 0.1e-3 / std::sqrt(12.0), 1e-15);
    EXPECT_EQ(rounded.rounding_std, rounded.largest_noise_std());
    EXPECT_THAT(rounded.notes, ElementsAre(HasSubstr("rounded to 0.1mm")));
    EXPECT_TRUE(read(text(0.0012), "a.csv", {.noise_std = 0.0}).is_exact());
    EXPECT_TRUE(read_survey(m_net, m_scratch / "a.csv", {.noise_std = 1e-3}).notes.empty());
    EXPECT_TRUE(read(formatted("", "{},{},{},{}"), "a.csv").is_exact());
    // Steps of 10 mm in edges of 0.1 m are no rounding of an instrument.
    EXPECT_TRUE(read(table("",
                           [](int node, double x, double y, double z) {
                               return fmt::format("{},{:.2f},{:.2f},{:.2f}", node, x + 0.02, y, z);
                           }),
                     "a.csv")
                    .is_exact());
}

TEST_F(ReadSurvey, MatchesNamesThatAreNoNodesByTheirPlace) {
    const std::string text = table("", [](int node, double x, double y, double z) {
        return fmt::format("P{},{},{},{}", 100 - node, x, y, z);
    });
    const Survey survey = read(text + "ST1,20,20,20\n", "a.csv");
    EXPECT_LT(distance(survey), 1e-12);
    EXPECT_TRUE(survey.is_whole());
    EXPECT_THAT(survey.warnings,
                ElementsAre(HasSubstr("39 of its 39 names are no node's of the net")));
    ASSERT_EQ(survey.unmatched.size(), 1U);
    EXPECT_EQ(survey.unmatched[0].point.label, "ST1");
    const std::string names = survey_names_csv(m_net, survey);
    EXPECT_THAT(names, testing::StartsWith("line,name,node,distance,status\n1,P100,0,0,used\n"));
    EXPECT_THAT(names, HasSubstr("\n39,ST1,"));
    EXPECT_THAT(refusal(text, "a.csv", {.matching = PointMatching::name}),
                HasSubstr("a.csv:1: 'P100' is no node of the net"));
}

TEST_F(ReadSurvey, DoesNotTakeTheNumbersOfASurveyorForThoseOfTheNet) {
    const std::string text = table("", [](int node, double x, double y, double z) {
        return fmt::format("{},{},{},{}", node + 1, x, y, z);
    });
    const Survey survey = read(text, "a.csv");
    EXPECT_LT(distance(survey), 1e-12);
    EXPECT_THAT(survey.warnings, ElementsAre(HasSubstr("lie on other nodes than those of their")));
    EXPECT_EQ(survey.contradicted_names, 38);
    EXPECT_THAT(
        refusal(text, "a.csv", {.matching = PointMatching::name}),
        testing::AllOf(HasSubstr("match them by place"), testing::Not(HasSubstr("mirrored"))));
    const Survey by_place = read(text, "a.csv", {.matching = PointMatching::place});
    EXPECT_LT(distance(by_place), 1e-12);
    EXPECT_EQ(by_place.contradicted_names, 0);  // they were not to be used
}

TEST_F(ReadSurvey, AveragesPointsAndRefusesTwoOfOneName) {
    const std::string text = table("Name,X,Y,Z\n", [](int i, double x, double y, double z) {
        return fmt::format("{0},{1},{2},{3}\n{0},{1},{2},{4}", i, x, y, z, z + 2e-3);
    });
    const Survey survey = read(text, "a.csv");
    EXPECT_NEAR(distance(survey), 1e-3, 1e-12);
    EXPECT_THAT(survey.notes, Contains(HasSubstr("38 points were measured several times")));
    const Eigen::Vector3d p = m_net.nodes().col(5);
    EXPECT_THAT(refusal(text + fmt::format("5,{},{},{}\n", p.x(), p.y(), p.z() + 0.1), "a.csv"),
                HasSubstr("surveys '5' a second time"));
}

TEST_F(ReadSurvey, ReportsErrorsOfItsOwnFormatInItsOwnWords) {
    EXPECT_EQ(refusal("id,x,y,z\nA,1,2,3\nB,1,2\n", "a.csv"),
              "a.csv:3: has 3 fields, expected 4 as in the lines before");
    EXPECT_EQ(refusal("Name,X,Y,Z\nA,1,2,3\nB,1,2\n", "a.csv"),
              "a.csv:3: has 3 fields, expected id, x, y, z: is the file whole?");
}

TEST_F(ReadSurvey, LeavesNothingThatItsOwnReaderRefusedToThatOfForeignTables) {
    const std::string header = "id,x,y,z\n";
    for (const char* const row : {"no coordinates here\n", "7,1,,\n", "7,,,\n", "7\n"}) {
        EXPECT_THAT(refusal(formatted(header, "{},{},{},{}") + row, "a.csv"),
                    HasSubstr(fmt::format("a.csv:{}: ", 2 + m_net.node_count())))
            << row;
    }
    // A name of two words, which would be read as one and a coordinate.
    EXPECT_THAT(refusal(table("id x y z\n",
                              [](int node, double x, double y, double z) {
                                  return fmt::format("{}{} {} {} {}", node == 3 ? "A " : "", node,
                                                     x, y, z);
                              }),
                        "a.csv"),
                HasSubstr("a.csv:5: has 5 fields, expected 4"));
}

TEST_F(ReadSurvey, ShowsANoiseThatWasComputedToAFewDigits) {
    const std::string text = table("", [](int node, double x, double y, double z) {
        constexpr const char* std_dev = ",0.000512345678901,0.000512345678901,0.000512345678901";
        return fmt::format("{},{:.3f},{:.3f},{:.3f}{}", node, x, y, z + 0.00123, std_dev);
    });
    EXPECT_THAT(read(text, "a.csv").notes, Contains(HasSubstr(": 0.5123mm becomes ")));
}

class IncompleteStd : public ReadSurvey {
protected:
    /// A table with standard deviations, but for what stands behind the coordinates of node 7.
    std::string text(const std::string& header, char separator, const std::string& of_seventh,
                     const std::string& of_eighth) const {
        std::string all = table(header, [&](int node, double x, double y, double z) {
            const std::string std_dev = node == 7   ? of_seventh
                                        : node == 8 ? of_eighth
                                                    : ",0.0005,0.0005,0.0006";
            return fmt::format("{},{:.4f},{:.4f},{:.4f}{}", node, x, y, z + 0.00123 * (node % 3),
                               std_dev);
        });
        std::ranges::replace(all, ',', separator);
        return all;
    }
};

TEST_F(IncompleteStd, OfOnePointIsRefusedWithItsLine) {
    const std::string whole = ",0.0005,0.0005,0.0006";
    for (const char* const of_one :
         {"", ",0.0005", ",0.0005,0,0.0006", ",-,-,-", ",0.0005,,0.0006"}) {
        for (const char separator : {',', ';', ' '}) {
            if (separator == ' ' && std::string(of_one).find(",,") != std::string::npos) {
                continue;
            }
            for (const char* const header : {"", "id,x,y,z,sx,sy,sz\n", "Name,X,Y,Z,sX,sY,sZ\n"}) {
                SCOPED_TRACE(std::string(header) + of_one + separator);
                const int line = 8 + (*header == '\0' ? 0 : 1);
                EXPECT_THAT(refusal(text(header, separator, of_one, whole), "a.csv"),
                            HasSubstr(fmt::format("a.csv:{}: ", line)));
            }
        }
    }
    EXPECT_THAT(refusal(text("", ',', ",0.0005,0,0.0006", ",0,0,0"), "a.csv"),
                HasSubstr("a.csv:8: gives no standard deviations above 0 (lines 8, 9 in all), as"));
    EXPECT_THAT(read(text("", ',', whole, whole), "a.csv").warnings, IsEmpty());
}

TEST_F(IncompleteStd, TakesTheNoiseThatIsGivenAndSaysWhere) {
    const ReadSurveyOptions options{.noise_std = 1e-3};
    for (const char* const of_one : {",0.0005,0,0.0006", ",0,0,0", ",,,", ",-,-,-"}) {
        const bool is_own = std::string(of_one) != ",-,-,-";
        const Survey survey =
            read(text(is_own ? "id,x,y,z,sx,sy,sz\n" : "Name,X,Y,Z,sX,sY,sZ\n", ',', of_one, ""),
                 "a.csv", options);
        EXPECT_EQ(!survey.notes.empty() && survey.notes.front().starts_with("read as"), !is_own);
        EXPECT_THAT(survey.warnings, Contains(HasSubstr("2 of 38 points give no standard "
                                                        "deviations above 0: the noise of "
                                                        "1mm holds for lines 9, 10")));
        for (const int node : survey.surveyed) {
            EXPECT_NEAR(survey.noise_std(1, node), node == 7 || node == 8 ? 1e-3 : 0.5e-3, 1e-5);
        }
    }
}

TEST_F(IncompleteStd, OfNoPointLeavesTheNoiseUnusedAndSaysSo) {
    const std::string own = formatted("", "{},{:.6f},{:.6f},{:.6f},0.0005,0.0005,0.0005");
    const auto warnings = [&](double noise_std) {
        return read(own, "a.csv", {.noise_std = noise_std}).warnings;
    };
    EXPECT_THAT(warnings(1e-3), ElementsAre(HasSubstr("the noise of 1mm is not used")));
    EXPECT_THAT(warnings(0.5e-3), IsEmpty());
}

// Points of a table, an array or another program's memory.
TEST_F(ReadSurvey, TakesPointsThatComeFromNoFile) {
    std::vector<SurveyPoint> points;
    for (const int node : m_net.free_nodes()) {
        points.push_back({.id = m_net.node_id(node), .position = m_net.nodes().col(node)});
    }
    const Survey survey = read_survey(m_net, points, {.noise_std = 1e-3});
    EXPECT_EQ(survey.surveyed, m_net.free_nodes());
    EXPECT_TRUE((survey.noise_std(Eigen::all, m_net.free_nodes()).array() == 1e-3).all());
    for (SurveyPoint& point : points) {
        point.position *= 1e3;
    }
    EXPECT_TRUE(
        read_survey(m_net, points, {.noise_std = 1e-3, .unit = 1e-3}).form.isApprox(survey.form));
    points[3].position.x() = std::nan("");
    EXPECT_THAT(input_error_of([&] { (void)read_survey(m_net, points); }), HasSubstr("not finite"));
}

}  // namespace
}  // namespace taut
