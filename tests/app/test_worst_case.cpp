// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards that one command reads a survey with everything that can be wrong with it, names its five
// wrong targets, and gives intervals that hold (tests/data/surveys/make_worst_case.py).

#include <filesystem>
#include <map>
#include <set>

#include "app/built_net.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

using WorstCase = BuiltNetTest;

TEST_F(WorstCase, ComesOutWithAllSuspectsNamed) {
    const std::string file =
        (std::filesystem::path(TAUT_TEST_DATA_DIR) / "surveys" / "worst_case.csv").string();
    const auto [result, err] = identify(file, {"--noise", "0.5mm"});
    EXPECT_THAT(err, AllOf(HasSubstr("decimal sign: comma"), HasSubstr("encoding: Latin-1"),
                           HasSubstr("averaged")));
    std::set<int> wrong;
    std::map<int, std::string> swapped;
    for (const json& outlier : result["survey"]["outliers"]) {
        wrong.insert(outlier["node"].get<int>());
        if (outlier.contains("swapped_with")) {
            swapped[outlier["node"]] = outlier["swapped_with"];
        }
    }
    EXPECT_EQ(wrong, (std::set<int>{30, 41, 97, 150, 233}));
    EXPECT_EQ(swapped, (std::map<int, std::string>{{30, "41"}, {41, "30"}}));
    EXPECT_EQ(result["trust"]["verdict"], "passed") << result["trust"];
    EXPECT_EQ(result["survey"]["used"], 290);
    EXPECT_GE(coverage(result), 0.93);
    EXPECT_THAT(run({"identify", "net.json", file, "--noise", "0.5mm", "--draws", "0"}).out,
                HasSubstr("30 and 41"));
}

TEST_F(WorstCase, NamesSwappedTargetsThatAreFarApart) {
    survey({"--noise", "0.5mm"});
    std::string text = read("survey.csv");
    text.replace(text.find("\n17,"), 4, "\n@,");
    text.replace(text.find("\n203,"), 5, "\n17,");
    text.replace(text.find("\n@,"), 3, "\n203,");
    write("survey.csv", text);
    const json result = identify("survey.csv").result;
    std::map<std::string, std::string> swapped;
    for (const json& point : result["survey"]["unmatched"]) {
        swapped[point["id"]] = point["swapped_with"];
    }
    EXPECT_EQ(swapped, (std::map<std::string, std::string>{{"17", "203"}, {"203", "17"}}));
    EXPECT_THAT(must_run({"identify", "net.json", "survey.csv", "--draws", "0"}),
                AllOf(HasSubstr("swapped with 203"), HasSubstr("17 and 203")));
}

}  // namespace
