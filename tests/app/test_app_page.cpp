// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards `taut app` where it is installed: a page that is not found, or an output that takes its
// place.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "app/program.hpp"

namespace taut::test {
namespace {

using testing::HasSubstr;

class AppPage : public ProgramTest {
protected:
    AppPage() {
        std::filesystem::create_directory(folder() / "bin");
        std::filesystem::copy_file(TAUT_PROGRAM, folder() / "bin/taut");
    }

    /// Runs the copy of the program in bin/; what it says goes into the file "said".
    [[nodiscard]] int installed(const std::string& arguments) const {
        const std::string command =
            "cd '" + folder().string() + "' && bin/taut app " + arguments + " > said 2>&1";
        return WEXITSTATUS(std::system(command.c_str()));
    }
};

TEST_F(AppPage, IsWrittenFromBesideAnInstalledProgram) {
    std::filesystem::create_directories(folder() / "share/taut");
    const std::string page = "<!DOCTYPE html>\n<title>taut</title>\n";
    write("share/taut/taut.html", page);
    ASSERT_EQ(installed("-o page.html"), 0) << read("said");
    EXPECT_EQ(read("page.html"), page);
    EXPECT_EQ(installed("-o share/taut/taut.html"), 2);
    EXPECT_THAT(read("said"), HasSubstr("is an input of this command"));
    EXPECT_EQ(installed("-o ."), 2);
    EXPECT_EQ(read("share/taut/taut.html"), page);
}

TEST_F(AppPage, IsMissedInOneLineThatSaysHowToGetIt) {
    EXPECT_EQ(installed("-o page.html"), 2);
    EXPECT_EQ(lines("said").size(), 1U);
    EXPECT_THAT(read("said"), HasSubstr("'make app'"));
    EXPECT_FALSE(exists("page.html"));
}

}  // namespace
}  // namespace taut::test
