// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against work lost with a process, against processes that wait forever for one that is
// gone, and against a message that each of them prints, or none.

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "app/program.hpp"
#include "taut/io/data_set_h5.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using std::chrono::milliseconds;

const std::string endless = "10000000";

/// Process ids of taut-mpi in a folder, except that of the first process of the group.
std::vector<pid_t> others_at_work(const std::filesystem::path& folder) {
    std::vector<pid_t> found;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        const std::string name = entry.path().filename();
        pid_t id = 0;
        if (std::from_chars(name.data(), name.data() + name.size(), id).ec != std::errc() ||
            !std::filesystem::equivalent(entry.path() / "exe", TAUT_MPI_PROGRAM, ignored) ||
            std::filesystem::read_symlink(entry.path() / "cwd", ignored) != folder) {
            continue;
        }
        std::ifstream stream(entry.path() / "environ", std::ios::binary);
        std::string environment{std::istreambuf_iterator<char>(stream), {}};
        environment.insert(environment.begin(), '\0');
        using namespace std::string_literals;
        if (environment.find("\0OMPI_COMM_WORLD_RANK=0\0"s) == std::string::npos &&
            environment.find("\0PMI_RANK=0\0"s) == std::string::npos) {
            found.push_back(id);
        }
    }
    return found;
}

int count_of(const std::string& words, const std::string& text) {
    int count = 0;
    for (size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
        ++count;
    }
    return count;
}

int errors_printed(const Outcome& outcome) {
    return count_of("taut: error: ", outcome.err);
}

class RanksThatFail : public ProgramTest {
protected:
    RanksThatFail() { must_run({"taut", "example", "hypar:6x6", "-o", "net.json"}); }

    /// The line that taut prints, once, and its exit code.
    void expect_fails_as_taut(const std::vector<std::string>& words) const {
        const auto by = [&](const std::string& who) { return run(joined({who}, words)); };
        const Files before = files();
        const Outcome expected = by("taut");
        expect_error(expected, 2, "");
        const Outcome outcome = by("3");
        EXPECT_EQ(outcome.exit_code, expected.exit_code);
        EXPECT_EQ(outcome.out, "");
        EXPECT_THAT(outcome.err, testing::HasSubstr(expected.err));
        EXPECT_EQ(errors_printed(outcome), 1) << outcome.err;
        EXPECT_EQ(files(), before);
    }

    [[nodiscard]] int partial_size() const {
        return exists("data.h5.partial") ? read_data_set(folder() / "data.h5.partial").data.size()
                                         : 0;
    }

    /// One of so many processes at work, but not the first.
    [[nodiscard]] pid_t another_at_work(size_t processes) const {
        std::vector<pid_t> others;
        for (int k = 0; k < 6000 && others.size() + 1 < processes; ++k) {
            std::this_thread::sleep_for(milliseconds(10));
            others = others_at_work(folder());
        }
        if (others.empty()) {
            throw std::runtime_error("no processes of taut-mpi came to work");
        }
        return others.front();
    }

    /// Ends a run by a deed, with more time until something was kept.
    template <typename Deed>
    Outcome ended(const std::string& processes, Deed deed) const {
        for (milliseconds delay{250}; delay < milliseconds(60'000); delay *= 2) {
            RunningProgram run =
                start({processes, "sample", "net.json", "-n", endless, "-o", "data.h5", "--quiet"});
            std::this_thread::sleep_for(delay);
            deed(run);
            // Open MPI's mpiexec has been seen to wait for itself when its processes were gone.
            const std::jthread watchdog([&run](const std::stop_token& ended) {
                for (int k = 0; k < 600 && !ended.stop_requested(); ++k) {
                    std::this_thread::sleep_for(milliseconds(100));
                }
                if (!ended.stop_requested()) {
                    run.send(SIGKILL);
                }
            });
            Outcome outcome = run.wait();
            if (partial_size() > 0) {
                return outcome;
            }
        }
        ADD_FAILURE() << "no samples were ever kept";
        return {};
    }

    void expect_resumes_to_the_same_bytes(const std::string& processes) const {
        const std::string count = std::to_string(partial_size() + 37);
        EXPECT_EQ(run({processes, "sample", "net.json", "-n", count, "-o", "data.h5", "--resume"})
                      .exit_code,
                  0);
        must_run({"taut", "sample", "net.json", "-n", count, "-o", "straight.h5"});
        EXPECT_EQ(read("data.h5") == read("straight.h5"), true) << "of " << count << " samples";
        EXPECT_FALSE(exists("data.h5.partial"));
    }
};

TEST_F(RanksThatFail, AllAtOncePrintOneLine) {
    expect_fails_as_taut({"sample", "nothing.json", "-n", "5", "-o", "data.h5"});
    expect_fails_as_taut({"sample", "net.json", "-n", "five", "-o", "data.h5"});
    expect_fails_as_taut({"control", "net.json", "-o", "out", "--trials", "0"});
    expect_fails_as_taut({"compare", "net.json", "-o", "out", "--training", "1"});
}

TEST_F(RanksThatFail, WhereTheFirstAloneFailsAllEnd) {
    expect_fails_as_taut({"sample", "net.json", "-n", "5", "-o", "nowhere/data.h5"});
    write("data.h5", "no data set");
    expect_fails_as_taut({"sample", "net.json", "-n", "5", "-o", "data.h5", "--resume"});
    std::filesystem::create_directories(folder() / "out/control.csv");
    expect_fails_as_taut(
        {"control", "net.json", "-o", "out", "--trials", "2", "--rounds", "1", "--draws", "20"});
}

TEST_F(RanksThatFail, WhereAnotherFailsTheFirstPrintsIt) {
    std::filesystem::create_directories(folder() / "empty");
    std::filesystem::create_directories(folder() / "other");
    must_run({"taut", "example", "hypar:6x7", "-o", "other/net.json"});
    const Files before = files();
    const auto with_second = [this](const std::string& its_folder, const std::string& its_samples) {
        return run({"1", "sample", "net.json", "-n", "50", "-o", "data.h5", ":", "-n", "1", "-wdir",
                    folder() / its_folder, TAUT_MPI_PROGRAM, "sample", "net.json", "-n",
                    its_samples, "-o", "data.h5"});
    };
    const Outcome missing = with_second("empty", "50");
    EXPECT_EQ(missing.exit_code, 2);
    EXPECT_EQ(errors_printed(missing), 1) << missing.err;
    EXPECT_THAT(missing.err, testing::HasSubstr("net.json"));
    const Outcome other_arguments = with_second(".", "5000");
    EXPECT_EQ(other_arguments.exit_code, 2);
    EXPECT_EQ(errors_printed(other_arguments), 1) << other_arguments.err;
    EXPECT_THAT(other_arguments.err, testing::HasSubstr("process 1 of 2 has other arguments"));
    const Outcome another = with_second("other", "50");
    EXPECT_EQ(another.exit_code, 1);
    EXPECT_EQ(errors_printed(another), 1) << another.err;
    EXPECT_THAT(another.err, testing::HasSubstr("process 1 of 2 has another net"));
    EXPECT_EQ(files(), before);
}

TEST_F(RanksThatFail, ByAKillLoseNothingThatWasFinished) {
    const Outcome outcome =
        ended("3", [this](const RunningProgram& /*run*/) { kill(another_at_work(3), SIGKILL); });
    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_FALSE(exists("data.h5"));
    expect_resumes_to_the_same_bytes("2");
}

TEST_F(RanksThatFail, ByASignalToOneOfThemKeepWhatWasFinishedAndPrintWhere) {
    const Outcome outcome =
        ended("2", [this](const RunningProgram& /*run*/) { kill(another_at_work(2), SIGTERM); });
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_EQ(errors_printed(outcome), 1) << outcome.err;
    EXPECT_THAT(outcome.err, testing::HasSubstr("data.h5.partial"));
    EXPECT_FALSE(exists("data.h5"));
    expect_resumes_to_the_same_bytes("4");
}

// The message does not always come through mpiexec, which ends itself.
TEST_F(RanksThatFail, ByASignalToAllKeepWhatWasFinished) {
    const Outcome outcome = ended("2", [](const RunningProgram& run) { run.send(SIGTERM); });
    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_FALSE(exists("data.h5"));
    expect_resumes_to_the_same_bytes("1");
}

TEST_F(RanksThatFail, AreNotStartedByACommandThatHasNoShares) {
    const Outcome outcome = run({"2", "identify", "net.json", "survey.csv"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, testing::HasSubstr("'identify' is not a command; taut-mpi --help"));
    EXPECT_EQ(errors_printed(outcome), 1) << outcome.err;
}

TEST_F(RanksThatFail, PrintHelpAndWarningsOnce) {
    const Outcome help = run({"3", "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(count_of("taut-mpi COMMAND --help", help.out), 1) << help.out;
    const Outcome renamed =
        run({"3", "sample", "net.json", "-n", "5", "--law", "normal:1mm", "-o", "data.h5"});
    EXPECT_EQ(renamed.exit_code, 0);
    EXPECT_EQ(count_of("taut: warning: --law is now --prior", renamed.err), 1) << renamed.err;
}

}  // namespace
