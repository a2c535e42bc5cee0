// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards --memory: a limit that is kept, or refused before the work with the need named.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "app/program.hpp"

namespace taut::test {
namespace {

using testing::HasSubstr;

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TAUT_MEMORY_IS_A_SANITIZERS
#endif
#endif
#if !defined(__linux__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TAUT_MEMORY_IS_A_SANITIZERS
#endif

/// On one thread, so that what the program takes by itself is the same on any machine.
class Memory : public ProgramTest {
protected:
    void SetUp() override {
#ifdef TAUT_MEMORY_IS_A_SANITIZERS
        GTEST_SKIP() << "only Linux has such a limit, and a sanitizer takes all memory";
#endif
        must_run({"example", "hypar:3x4", "-o", "net.json"});
    }

    [[nodiscard]] Outcome run_within(const std::string& memory,
                                     std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--threads", "1", "--memory", memory});
        return run(arguments);
    }

    /// The mebibytes that a refusal names behind some words.
    static double named(const Outcome& refusal, const std::string& words) {
        std::smatch found;
        const std::regex pattern(words + " ([0-9.]+) ([MG])iB");
        EXPECT_TRUE(std::regex_search(refusal.err, found, pattern)) << refusal.err;
        return found.empty() ? 0.0 : std::stod(found[1]) * (found[2] == "G" ? 1024.0 : 1.0);
    }
    [[nodiscard]] double of_the_program() const {
        return named(run_within("20MiB", {"form", "net.json"}), "the program takes");
    }
};

std::string mebibytes(double number) {
    return std::to_string(number) + "MiB";
}

TEST_F(Memory, OfWrongTextOrLessThanTheProgramItselfIsRefused) {
    for (const char* text : {"8", "0GiB", "-1GB", "8 apples", "nan GB", "GiB", "1e30GB", "8GiBs"}) {
        expect_error(run({"form", "net.json", "--memory", text}), 2,
                     "--memory is '" + std::string(text) +
                         "', expected a number with MB, MiB, GB, GiB, TB or TiB: 8GiB");
    }
    expect_error(run_within("20 MiB", {"form", "net.json"}), 2,
                 "--memory is 20 MiB, but the program takes ");
    EXPECT_EQ(run_within("1.5 GB", {"form", "net.json"}).exit_code, 0);
}

TEST_F(Memory, IsRefusedBeforehandWhereTheNeedIsKnown) {
    must_run({"sample", "net.json", "-n", "5", "-o", "data.h5"});
    const Files before = files();
    const Outcome outcome =
        run_within("4GiB", {"sample", "net.json", "-n", "10000000", "-o", "more.h5"});
    expect_error(outcome, 2, "--memory is 4GiB, but the command needs ");
    EXPECT_THAT(outcome.err, HasSubstr(" GiB for 10000000 samples"));
    expect_error(run_within("500MB", {"reproduce", "-o", "study", "--samples", "2900"}), 2,
                 "for 2900 samples");
    expect_error(run_within("500MB", {"compare", "net.json", "-o", "out", "--training", "2900"}), 2,
                 "for 2900 training samples");
    EXPECT_EQ(files(), before);
}

TEST_F(Memory, ThatIsNamedSuffices) {
    must_run({"example", "hilo-quarter", "-o", "quarter.json"});
    const double program = of_the_program();
    const std::vector<std::string> sample{"sample", "quarter.json", "-n", "700", "-o", "data.h5"};
    const double to_sample = named(run_within(mebibytes(program + 5.0), sample), "needs");
    EXPECT_EQ(run_within(mebibytes(to_sample + 4.0), sample).err, "");
    const std::vector<std::string> train{"train", "data.h5", "-o", "model.h5"};
    const double to_train = named(run_within(mebibytes(program + 60.0), train), "needs");
    EXPECT_EQ(run_within(mebibytes(to_train + 4.0), train).err, "");
    EXPECT_TRUE(exists("model.h5"));
}

TEST_F(Memory, ThatWorkExceedsEndsItWithALine) {
    must_run({"example", "hypar:200x200", "-o", "large.json"});
    write("form.csv", "old");
    const std::string limit = mebibytes(of_the_program() + 20.0);
    expect_error(run_within(limit, {"form", "large.json", "-o", "form.csv"}), 1,
                 "not enough memory (--memory is " + limit + ")");
    EXPECT_EQ(read("form.csv"), "old");
}

}  // namespace
}  // namespace taut::test
