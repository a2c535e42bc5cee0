// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against hours of work lost to a signal, and against half-written files that the next
// command takes for whole. No test depends on timing: each run has far more to do than it is given
// time for, and is tried with more time until the signal met it at work.

#include <chrono>
#include <csignal>
#include <thread>

#include "app/program.hpp"
#include "taut/io/data_set_h5.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using std::chrono::milliseconds;

const std::string endless = "10000000";

class Interruption : public ProgramTest {
protected:
    Interruption() { must_have_run({{"example", "hypar:6x6", "-o", "net.json"}}); }

    /// Sends a signal to a run until `met` says that it met the run at work.
    template <typename Condition>
    Outcome signalled(int signal, const std::vector<std::string>& arguments, Condition met,
                      milliseconds delay = milliseconds(50)) const {
        for (; delay < milliseconds(60'000); delay *= 2) {
            RunningProgram run = start(arguments);
            std::this_thread::sleep_for(delay);
            run.send(signal);
            Outcome outcome = run.wait();
            if (met(outcome)) {
                return outcome;
            }
        }
        ADD_FAILURE() << "the signal never met the run at work";
        return {};
    }

    /// Draws into data.h5 until the signal, so late that something was kept.
    Outcome interrupted_sample(int signal, const std::string& extra = "--quiet") const {
        const int before = exists("data.h5.partial") ? partial_size() : 0;
        return signalled(
            signal, {"sample", "net.json", "-n", endless, "-o", "data.h5", extra},
            [&](const Outcome&) { return exists("data.h5.partial") && partial_size() > before; });
    }

    [[nodiscard]] int partial_size() const {
        return read_data_set(folder() / "data.h5.partial").data.size();
    }

    void expect_resumes_to_the_same_bytes() const {
        const std::string count = std::to_string(partial_size() + 37);
        must_run({"sample", "net.json", "-n", count, "-o", "data.h5", "--resume"});
        must_run({"sample", "net.json", "-n", count, "-o", "straight.h5"});
        EXPECT_EQ(read("data.h5") == read("straight.h5"), true) << "of " << count << " samples";
        EXPECT_FALSE(exists("data.h5.partial"));
    }
};

class SampleOnSignal : public Interruption, public testing::WithParamInterface<int> {};

TEST_P(SampleOnSignal, KeepsItsSamplesAndGoesOnToTheSameBytes) {
    must_run({"sample", "net.json", "-n", "5", "-o", "data.h5"});
    const std::string before = read("data.h5");
    const Outcome outcome = interrupted_sample(GetParam());
    expect_error(outcome, 130, "data.h5.partial");
    EXPECT_THAT(outcome.err, testing::HasSubstr("--resume"));
    EXPECT_THAT(outcome.err, testing::HasSubstr(std::to_string(partial_size()) + " of " + endless));
    EXPECT_EQ(files().size(), 3U) << "the net, the earlier data set and the samples kept";
    EXPECT_EQ(read("data.h5"), before);
    if (GetParam() == SIGINT) {
        interrupted_sample(SIGINT, "--resume");
    }
    expect_resumes_to_the_same_bytes();
}

INSTANTIATE_TEST_SUITE_P(Signals, SampleOnSignal, testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& signal) {
                             return signal.param == SIGINT    ? "interrupt"
                                    : signal.param == SIGTERM ? "terminate"
                                                              : "hang_up";
                         });

TEST_F(Interruption, ByAKillLeavesTheEarlierDataSetAsItWas) {
    must_run({"sample", "net.json", "-n", "5", "-o", "data.h5"});
    const std::string before = read("data.h5");
    RunningProgram run = start({"sample", "net.json", "-n", endless, "-o", "data.h5"});
    std::this_thread::sleep_for(milliseconds(300));
    run.send(SIGKILL);
    EXPECT_EQ(run.wait().exit_code, 128 + SIGKILL);
    EXPECT_EQ(read("data.h5"), before);
    must_run({"sample", "net.json", "-n", "9", "-o", "data.h5", "--resume"});
    must_run({"sample", "net.json", "-n", "9", "-o", "straight.h5"});
    EXPECT_EQ(read("data.h5"), read("straight.h5"));
}

TEST_F(Interruption, OfACommandThatKeepsNothingWritesNothingAndIsOneLine) {
    must_run({"reproduce", "--net", "net.json", "--samples", "20", "--validation", "4", "-o",
              "study", "--keep"});
    const Files before = files();
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"reproduce", "--net", "net.json", "--samples", "1000000", "-o",
                                   "study", "--keep"},
          {"compare", "net.json", "-o", "new", "--training", "20", "--surveys", "100000"},
          {"example", "hypar:300x300", "-o", "large.json"}}) {
        const auto at_work = [](const Outcome& outcome) { return !outcome.err.empty(); };
        expect_error(
            signalled(SIGINT, words, at_work, milliseconds(words.front() == "example" ? 5 : 200)),
            130, "interrupted");
        EXPECT_EQ(files(), before);
    }
}

}  // namespace
