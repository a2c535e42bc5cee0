// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards intervals of surveys whose noise nobody told, and of targets that stand off the cables.

#include <fmt/core.h>

#include <sstream>

#include "app/built_net.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class SurveyNoise : public BuiltNetTest {
protected:
    /// The built form, to so many decimals of a unit [m].
    void round_form(int decimals, double unit, const std::string& header) const {
        std::istringstream lines(read("built.csv"));
        std::string text = header;
        std::string line;
        std::getline(lines, line);
        while (std::getline(lines, line)) {
            std::istringstream fields(line);
            std::string field;
            std::getline(fields, field, ',');
            text += field;
            while (std::getline(fields, field, ',')) {
                text += fmt::format(",{:.{}f}", std::stod(field) / unit, decimals);
            }
            text += "\n";
        }
        write("survey.csv", text);
    }
};

TEST_F(SurveyNoise, IsToldByTheDigitsOfTheFile) {
    struct Digits {
        int decimals;
        double unit;
        const char* header;
        double std;
    };
    // 95 % of 536 intervals hold; less than 93 % once in fifty times where each is by itself.
    for (const Digits& digits : {Digits{6, 1.0, "id,x,y,z\n", 0.29e-6}, Digits{4, 1.0, "", 29e-6},
                                 Digits{3, 1e-3, "Punkt,X [mm],Y [mm],Z [mm]\n", 0.29e-6},
                                 Digits{1, 1e-3, "Punkt,X [mm],Y [mm],Z [mm]\n", 29e-6}}) {
        round_form(digits.decimals, digits.unit, digits.header);
        const auto [result, err] = identify("survey.csv");
        EXPECT_NEAR(result["noise"].get<double>(), digits.std, 0.01 * digits.std);
        EXPECT_GE(coverage(result), 0.93) << digits.decimals;
        EXPECT_EQ(result["trust"]["verdict"], "passed") << result["trust"];
        EXPECT_THAT(err, HasSubstr("taken with +- ")) << digits.decimals;
    }
}

TEST_F(SurveyNoise, OfAFormToTheLastDigitIsNone) {
    for (const char* const name : {"built.csv", "survey.csv"}) {
        survey({});
        const auto [result, err] = identify(name);
        EXPECT_EQ(result["method"], "balance");
        EXPECT_EQ(err, "");
        EXPECT_GE(coverage(result), 0.93);
    }
}

TEST_F(SurveyNoise, HasRoundingAddedWhereThatCounts) {
    round_form(3, 1.0, "");
    const auto coarse = identify("survey.csv", {"--noise", "0.2mm"});
    EXPECT_NEAR(coarse.result["noise"].get<double>(), 0.351e-3, 0.001e-3);
    EXPECT_THAT(coarse.err, HasSubstr("adds 0.29 mm to their noise: 0.2mm becomes 0.351 mm"));
    const auto fine = identify("survey.csv", {"--noise", "2mm"});
    EXPECT_NEAR(fine.result["noise"].get<double>(), 2e-3, 1e-15);
    EXPECT_THAT(
        must_run({"identify", "net.json", "survey.csv", "--noise", "0.2mm", "--draws", "0"}),
        AllOf(HasSubstr("becomes 0.351 mm"), Not(HasSubstr("not --noise"))));
}

TEST_F(SurveyNoise, OfTargetsOffTheCablesIsWhatItIsWhereTheOffsetIsTold) {
    int inside = 0;
    int edges = 0;
    for (const int seed : {1, 2, 3, 4}) {
        build(seed);
        survey({"--noise", "0.5mm", "--offset", "3mm:0.2mm", "--seed", std::to_string(seed)});
        // By the prior that is true and no other, which intervals would hold more than 95 % for.
        const auto told = identify("survey.csv", {"--offset", "3mm:0.2mm", "--prior", "uniform:5mm",
                                                  "--prior-exact"})
                              .result;
        EXPECT_EQ(told["trust"]["verdict"], "passed") << told["trust"];
        inside += count_inside(told);
        edges += static_cast<int>(told["edges"].size());
        const auto untold = identify("survey.csv").result;
        EXPECT_NE(untold["trust"]["verdict"], "passed");
        EXPECT_LT(coverage(untold), 0.9);
    }
    const double part = static_cast<double>(inside) / edges;
    EXPECT_GE(part, 0.94);
    EXPECT_LE(part, 0.96);
}

TEST_F(SurveyNoise, TakesOffsetsByTheKindOfTarget) {
    survey({"--noise", "0.5mm", "--offset", "-3mm"});
    std::istringstream lines(read("survey.csv"));
    std::string text = "Name,X,Y,Z,Code\n";
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        for (int k = 0; k < 3; ++k) {
            line.resize(line.rfind(','));
        }
        text += line + ",prism\n";
    }
    write("coded.csv", text);
    write("offsets.csv", "target,offset,std\nprism,-3mm,0.1mm\n17,-0.003\n");
    expect_error(run({"identify", "net.json", "coded.csv", "--offsets", "offsets.csv"}), 2,
                 "offsets.csv:3: has 2 fields, expected 3 as in the lines before");
    write("offsets.csv", "target,offset,std\nprism,-3mm,0.1mm\n17,-0.003,0\n");
    const auto told =
        identify("coded.csv", {"--noise", "0.5mm", "--offsets", "offsets.csv", "--unit", "m"});
    EXPECT_THAT(told.err, AllOf(HasSubstr("299 targets were taken back by -3mm +- 0.1mm"),
                                HasSubstr("1 target was taken back by -3mm along")));
    EXPECT_GE(coverage(told.result), 0.92);
    write("offsets.csv", "sticker,3mm\n");
    expect_error(run({"identify", "net.json", "coded.csv", "--offsets", "offsets.csv"}), 2,
                 "has no target of the name or code 'sticker'");
    expect_error(run({"identify", "net.json", "coded.csv", "--offset", "3mm:x"}), 2, "'x'");
}

}  // namespace
