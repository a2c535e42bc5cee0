// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against trials whose files are incomplete, or that nobody can repeat.

#include <algorithm>

#include "app/program.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;

class Trials : public ProgramTest {
protected:
    Trials() { must_run({"example", "hypar:4x5", "-o", "net.json"}); }
};

TEST_F(Trials, TellEachSurveyOfEachNet) {
    const std::string text = must_run({"trials", "net.json", "-o", "out", "--surveys", "3"});
    EXPECT_THAT(text, testing::HasSubstr("hypar:4x5"));
    EXPECT_THAT(text, testing::HasSubstr("written to out: trials.json, trials.csv"));
    const json document = json::parse(read("out/trials.json"));
    EXPECT_EQ(document["format"], "taut-trials");
    EXPECT_EQ(document["version"], 1);
    ASSERT_EQ(document["nets"].size(), 1U);
    ASSERT_EQ(document["nets"][0]["surveys"].size(), 3U);
    const std::string csv = read("out/trials.csv");
    EXPECT_THAT(csv, testing::StartsWith("net,seed,survey,prior,noise,"));
    EXPECT_EQ(std::ranges::count(csv, '\n'), 4);
    EXPECT_EQ(files().size(), 4U);
}

TEST_F(Trials, RepeatOneSurveyByItsNumber) {
    must_run({"trials", "net.json", "-o", "all", "--surveys", "3", "--seed", "5"});
    must_run({"trials", "net.json", "-o", "one", "--first", "2", "--surveys", "1", "--seed", "5"});
    json expected = json::parse(read("all/trials.json"))["nets"][0]["surveys"][2];
    json repeated = json::parse(read("one/trials.json"))["nets"][0]["surveys"][0];
    expected.erase("seconds");
    repeated.erase("seconds");
    EXPECT_EQ(repeated, expected);
}

TEST_F(Trials, PrintTheResultAsJsonWhenAskedTo) {
    const std::string printed =
        must_run({"trials", "net.json", "-o", "out", "--surveys", "1", "--json"});
    EXPECT_EQ(printed, read("out/trials.json"));
}

TEST_F(Trials, WriteNothingWhereTheyAreRefused) {
    const Files before = files();
    expect_error(run({"trials", "net.json", "-o", "out", "--surveys", "0"}), 2, "0 surveys");
    expect_error(run({"trials", "net.json", "-o", "out", "--first", "-1"}), 2, "-1");
    expect_error(run({"trials", "nothing.json", "-o", "out"}), 2, "nothing.json");
    expect_error(run({"trials", "net.json"}), 2, "--output");
    EXPECT_EQ(files(), before);
}

}  // namespace
