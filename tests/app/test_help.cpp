// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a subcommand that nobody can find out how to use.

#include "app/program.hpp"

namespace {

using namespace taut::test;

const std::vector<std::string> commands{"example", "import", "inspect", "form",     "export",
                                        "sample",  "train",  "survey",  "identify", "reproduce",
                                        "compare", "report"};

class Help : public ProgramTest, public testing::WithParamInterface<std::string> {};

TEST_P(Help, OfASubcommandTellsItsOptionsAndAnExample) {
    const std::string help = must_run({GetParam(), "--help"});
    const size_t example = help.find("Example:");
    ASSERT_NE(example, std::string::npos) << help;
    EXPECT_THAT(help.substr(example), testing::HasSubstr("  taut " + GetParam() + " "));
    for (const std::string option : {"--help", "--threads", "--json", "--quiet"}) {
        EXPECT_THAT(help.substr(0, example), testing::HasSubstr(option));
    }
}

TEST_P(Help, WritesNothing) {
    must_run({GetParam(), "--help"});
    EXPECT_TRUE(files().empty());
}

INSTANTIATE_TEST_SUITE_P(Commands, Help, testing::ValuesIn(commands),
                         [](const auto& command) { return command.param; });

class Program : public ProgramTest {};

TEST_F(Program, ListsItsSubcommands) {
    const std::string help = must_run({"--help"});
    for (const std::string& command : commands) {
        EXPECT_THAT(help, testing::HasSubstr("  " + command + " "));
    }
}

}  // namespace
