// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against surroundings that end the program silently or make it print nonsense: streams that
// are closed or full, limits, names that steer a terminal, arguments that are empty. tests/hostile
// does the same at random.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "app/program.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/io/net_json.hpp"

namespace taut::test {
namespace {

using testing::HasSubstr;
using testing::Not;

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TAUT_HAS_SANITIZER
#endif
#endif
#ifdef TAUT_HAS_SANITIZER
constexpr bool has_sanitizer = true;
#else
constexpr bool has_sanitizer = false;
#endif

class Surroundings : public ProgramTest {
protected:
    Surroundings() { must_have_run({{"example", "hypar:3x4", "-o", "net.json"}}); }

    /// The exit code of a line of the shell, in which "taut" is the program.
    [[nodiscard]] int shell(const std::string& line) const {
        const std::string command =
            "cd '" + folder().string() + "' && taut() { '" TAUT_PROGRAM "' \"$@\"; } && " + line;
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
};

TEST_F(Surroundings, AFullOrClosedOutputIsAnErrorAndNothingIsLost) {
    EXPECT_EQ(shell("taut form net.json -o form.csv > /dev/full 2> err"), 2);
    EXPECT_THAT(read("err"), HasSubstr("files are written, but standard output cannot be"));
    EXPECT_THAT(read("form.csv"), testing::StartsWith("id,x,y,z"));
    EXPECT_EQ(shell("taut form net.json -o closed.csv >&- 2> err"), 2);
    EXPECT_EQ(read("closed.csv"), read("form.csv"));
    EXPECT_EQ(shell("taut --help > /dev/full 2> err"), 2);
    EXPECT_THAT(read("err"), HasSubstr("standard output cannot be written"));
}

TEST_F(Surroundings, AClosedOrFullStandardErrorEndsNothing) {
    EXPECT_EQ(shell("taut form missing.json 2>&-"), 2);
    EXPECT_EQ(shell("taut form missing.json 2> /dev/full"), 2);
    EXPECT_EQ(shell("taut form net.json -o form.csv 0<&- > /dev/null 2>&-"), 0);
    EXPECT_EQ(shell("taut form net.json -o all.csv 0<&- >&- 2>&-"), 2);
    EXPECT_EQ(read("all.csv"), read("form.csv"));
}

TEST_F(Surroundings, ALimitOfFileSizeIsAnError) {
    write("form.csv", "old");
    EXPECT_EQ(shell("(ulimit -f 0; taut form net.json -o form.csv > /dev/null 2> /dev/null)"), 2);
    EXPECT_EQ(read("form.csv"), "old");
}

TEST_F(Surroundings, ALimitOfMemoryIsAnErrorAndEndsAtOnce) {
    if (has_sanitizer) {
        GTEST_SKIP() << "a sanitizer has allocators and threads of its own";
    }
    must_run({"form", "net.json", "-o", "form.csv"});
    const Files before = files();
    for (const std::string kilobytes : {"150000", "200000", "250000"}) {
        const int code = shell("(ulimit -v " + kilobytes +
                               "; timeout 20 '" TAUT_PROGRAM
                               "' identify net.json form.csv --noise 1mm -o out.json "
                               "> /dev/null 2> err)");
        const std::string err = read("err");
        std::filesystem::remove(folder() / "err");
        EXPECT_THAT(code, testing::AnyOf(0, 1)) << kilobytes;
        if (code == 1) {
            EXPECT_EQ(files(), before) << kilobytes;
            // Threads that find none at the same time print one line.
            EXPECT_EQ(err.find("taut: error:"), err.rfind("taut: error:")) << err;
            EXPECT_THAT(err, HasSubstr("taut: error: not enough memory\n"));
        }
    }
}

// Memory of one allocator that goes to the free() of another ends the program.
TEST_F(Surroundings, APreloadedAllocatorChangesNothing) {
    if (has_sanitizer) {
        GTEST_SKIP() << "a sanitizer has allocators and threads of its own";
    }
    must_run({"form", "net.json", "-o", "form.csv"});
    EXPECT_EQ(shell("LD_PRELOAD='" TAUT_OTHER_ALLOCATOR "' '" TAUT_PROGRAM
                    "' form net.json -o other.csv > /dev/null"),
              0);
    EXPECT_EQ(read("other.csv"), read("form.csv"));
}

// OpenBLAS would print lines of its own and raise SIGINT before main(), and control would count
// each job as one that was not identified.
TEST_F(Surroundings, AWantOfThreadsIsAnErrorAndNoOutcomeOfASimulatedJob) {
    if (has_sanitizer) {
        GTEST_SKIP() << "a sanitizer has allocators and threads of its own";
    }
    const std::string taut = "LD_PRELOAD='" TAUT_NO_THREADS "' '" TAUT_PROGRAM "' ";
    EXPECT_EQ(shell(taut + "form net.json -o form.csv --quiet > /dev/null 2> err"), 0);
    EXPECT_EQ(read("err"), "");
    EXPECT_EQ(shell(taut + "control net.json --trials 2 --rounds 1 -o out --prior uniform:5mm "
                           "--noise 1mm --stroke 20mm --quiet > /dev/null 2> err"),
              1);
    EXPECT_EQ(read("err"),
              "taut: error: pthread_create has failed: Resource temporarily unavailable\n");
    EXPECT_FALSE(exists("out"));
}

TEST_F(Surroundings, NamesDoNotSteerTheTerminal) {
    CableNetData content = hypar(3, 4).data();
    content.name = "red \x1b[31m";
    content.node_ids.assign(content.nodes.cols(), "");
    for (size_t i = 0; i < content.node_ids.size(); ++i) {
        content.node_ids[i] = "\x1b]0;title\x07\xc2\x9b" + std::to_string(i);
    }
    write("net.json", net_to_json(CableNet(content)));
    for (const Words& words : {Words{"inspect", "net.json"},
                               {"form", "net.json", "--json"},
                               {"form", "net.json", "-o", "form.csv"}}) {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 0);
        EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("\x1b")));
        EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("\xc2\x9b")));
    }
    EXPECT_THAT(run({"inspect", "net.json"}).out, HasSubstr("red \\u001b[31m"));
}

TEST_F(Surroundings, SeedsThatDifferInTheirUpperHalfHaveOtherNoise) {
    must_run({"form", "net.json", "-o", "form.csv"});
    for (const std::string seed : {"1", "4294967297"}) {
        must_run({"survey", "net.json", "form.csv", "--noise", "1mm", "--seed", seed, "-o",
                  seed + ".csv"});
    }
    EXPECT_NE(read("1.csv"), read("4294967297.csv"));
}

TEST_F(Surroundings, EmptyArgumentsAreRefused) {
    expect_error(run({"form", "net.json", "-o", ""}), 2, "argument 4 is empty");
    expect_error(run({"form", "net.json", "--prior", "uniform:1mm", "--lengths="}), 2,
                 "argument 5 is empty");
    must_run({"form", "net.json", "--output=a="});
    EXPECT_THAT(read("a="), testing::StartsWith("id,x,y,z"));
}

}  // namespace
}  // namespace taut::test
