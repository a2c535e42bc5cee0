// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards intervals of surveys whose noise is not given, and of targets offset from the cables.

#include <fmt/core.h>

#include <sstream>

#include "app/built_net.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class SurveyNoise : public BuiltNetTest {
protected:
    /// The built form, to so many decimals of a unit [m].
    void round_form(int decimals, double unit, const std::string& header) const {
        std::string text = header;
        for (const std::string& line : lines("built.csv")) {
            std::istringstream fields(line);
            std::string field;
            std::getline(fields, field, ',');
            if (field != "id") {
                text += field;
                while (std::getline(fields, field, ',')) {
                    text += fmt::format(",{:.{}f}", std::stod(field) / unit, decimals);
                }
                text += "\n";
            }
        }
        write("survey.csv", text);
    }
};

TEST_F(SurveyNoise, IsThatOfTheDigitsOfTheFile) {
    struct Digits {
        int decimals;
        double unit;
        const char* header;
        double std;
    };
    // 95 % of 536 intervals hold; less than 93 % once in fifty times where each is by itself.
    for (const Digits& digits :
         {Digits{4, 1.0, "", 29e-6}, Digits{3, 1e-3, "Punkt,X [mm],Y [mm],Z [mm]\n", 0.29e-6}}) {
        round_form(digits.decimals, digits.unit, digits.header);
        const auto [result, err] = identify("survey.csv");
        EXPECT_NEAR(result["noise"].get<double>(), digits.std, 0.01 * digits.std);
        EXPECT_GE(coverage(result), 0.93) << digits.decimals;
        EXPECT_EQ(result["trust"]["verdict"], "passed") << result["trust"];
        EXPECT_NE(err, "") << digits.decimals;
    }
}

TEST_F(SurveyNoise, OfAFormToTheLastDigitIsNone) {
    const auto [result, err] = identify("built.csv");
    EXPECT_EQ(result["method"], "balance");
    EXPECT_EQ(err, "");
    EXPECT_GE(coverage(result), 0.93);
}

TEST_F(SurveyNoise, OfOffsetTargetsIsTheirsWhereTheOffsetIsGiven) {
    int inside = 0;
    int edges = 0;
    for (const int seed : {1, 2, 3, 4}) {
        build(seed);
        survey({"--noise", "0.5mm", "--offset", "3mm:0.2mm", "--seed", std::to_string(seed)});
        // By the prior that is true and no other, which intervals would hold more than 95 % for.
        const auto given = identify("survey.csv", {"--offset", "3mm:0.2mm", "--prior",
                                                   "uniform:5mm", "--prior-exact"})
                               .result;
        EXPECT_EQ(given["trust"]["verdict"], "passed") << given["trust"];
        inside += count_inside(given);
        edges += static_cast<int>(given["edges"].size());
        const auto not_given = identify("survey.csv").result;
        EXPECT_NE(not_given["trust"]["verdict"], "passed");
        EXPECT_LT(coverage(not_given), 0.9);
    }
    const double part = static_cast<double>(inside) / edges;
    EXPECT_GE(part, 0.94);
    EXPECT_LE(part, 0.96);
}

TEST_F(SurveyNoise, TakesOffsetsByTheKindOfTarget) {
    survey({"--noise", "0.5mm", "--offset", "-3mm"});
    edit("survey.csv", [](const std::string& line, int number) {
        return number == 0 ? "Name,X,Y,Z,Code" : first_fields(line, 4) + ",prism";
    });
    write("offsets.csv", "target,offset,std\nprism,-3mm,0.1mm\n17,-0.003,0\n");
    const auto [result, err] =
        identify("survey.csv", {"--noise", "0.5mm", "--offsets", "offsets.csv", "--unit", "m"});
    EXPECT_THAT(err, AllOf(HasSubstr("299 targets"), HasSubstr("1 target ")));
    EXPECT_GE(coverage(result), 0.92);
    write("offsets.csv", "sticker,3mm\n");
    expect_error(run({"identify", "net.json", "survey.csv", "--offsets", "offsets.csv"}), 2,
                 "'sticker'");
    expect_error(run({"identify", "net.json", "survey.csv", "--offset", "3mm:x"}), 2, "'x'");
}

}  // namespace
