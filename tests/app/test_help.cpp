// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a command that nobody can find out how to use.

#include <algorithm>

#include "app/program.hpp"
#include "taut/version.hpp"

namespace {

using namespace taut::test;
using testing::HasSubstr;

const std::vector<std::string> commands{
    "inspect", "identify",  "plan",    "report",  "example",   "import", "export", "frame", "form",
    "survey",  "frequency", "control", "compare", "reproduce", "sample", "train",  "app"};
constexpr size_t everyday_commands = 4;

/// Places of words in a text, each of which must be there.
std::vector<size_t> places(const std::string& text, const std::vector<std::string>& words) {
    std::vector<size_t> found;
    for (const std::string& word : words) {
        found.push_back(text.find(word));
        EXPECT_NE(found.back(), std::string::npos) << word << " is missing in\n" << text;
    }
    return found;
}

class Help : public ProgramTest, public testing::WithParamInterface<std::string> {};

TEST_P(Help, OfACommandShowsItsOptionsAndAnExample) {
    const std::string help = must_run({GetParam(), "--help"});
    const size_t example = help.find("Example:");
    ASSERT_NE(example, std::string::npos) << help;
    EXPECT_THAT(help, HasSubstr("Usage: taut " + GetParam() + " "));
    EXPECT_THAT(help.substr(example), HasSubstr("  taut " + GetParam() + " "));
    EXPECT_TRUE(std::ranges::is_sorted(
        places(help, {"--help", "\nOutput:\n", "--json", "--quiet", "\nAdvanced:\n", "--threads",
                      "--memory", "Example:"})));
    EXPECT_TRUE(files().empty());
}

INSTANTIATE_TEST_SUITE_P(Commands, Help, testing::ValuesIn(commands),
                         [](const auto& command) { return command.param; });

class Program : public ProgramTest {};

TEST_F(Program, ListsTheEverydayCommandsBeforeAllOthers) {
    std::vector<std::string> expected{"\nCommands:\n"};
    for (size_t k = 0; k < commands.size(); ++k) {
        if (k == everyday_commands) {
            expected.emplace_back("\nFurther commands:\n");
        }
        expected.push_back("\n  " + commands[k] + " ");
    }
    EXPECT_TRUE(std::ranges::is_sorted(places(must_run({"--help"}), expected)));
}

TEST_F(Program, GroupsTheOptionsOfLongCommandsAndShowsWhatEverybodyNeedsFirst) {
    EXPECT_TRUE(std::ranges::is_sorted(places(
        must_run({"identify", "--help"}),
        {"\nOptions:\n", "--output", "--noise", "--prior ", "\nInput:\n", "--frame", "--epoch",
         "\nWhat is known:\n", "--offset ", "--prior-exact", "--forces", "--uncertain",
         "\nOutput:\n", "--json", "--names", "--draws", "\nAdvanced:\n", "--method", "--seed"})));
    EXPECT_TRUE(std::ranges::is_sorted(places(
        must_run({"plan", "--help"}),
        {"\nOptions:\n", "--output", "--csv", "--tension", "--turn ", "\nInput:\n", "--target ",
         "--adjustable", "\nWhat is known:\n", "--actuator", "\nLimits:\n", "--confidence",
         "\nOutput:\n", "--suggest-adjustable", "\nAdvanced:\n", "--accept-failed"})));
}

TEST_F(Program, PrintsTheVersionOfTheLibrary) {
    EXPECT_EQ(must_run({"--version"}), "taut " + std::string{taut::version()} + "\n");
}

}  // namespace
