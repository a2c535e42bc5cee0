// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace taut::test {

using Words = std::vector<std::string>;

/// A command with more words.
[[nodiscard]] Words joined(Words words, const Words& more);

/// The first fields of a line of a CSV file.
[[nodiscard]] std::string first_fields(const std::string& line, int count);

/// What a run of the program gave.
struct Outcome {
    int exit_code = -1;  ///< 128 + signal where one ended it
    std::string out;
    std::string err;
};

/// The program at work. Its output goes to files, not to a terminal.
class RunningProgram {
public:
    /// @param folder its working directory, @param records where to keep what it prints
    RunningProgram(const std::filesystem::path& folder, const std::filesystem::path& records,
                   const Words& arguments);
    /// Ends it, if it still works.
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;
    RunningProgram(RunningProgram&&) = delete;
    RunningProgram& operator=(RunningProgram&&) = delete;

    void send(int signal) const;
    Outcome wait();

private:
    std::filesystem::path m_records;
    pid_t m_process = -1;
};

/// Every file under a folder, with its content; directories end in a slash.
using Files = std::map<std::string, std::string>;

/// Runs the program in an empty folder, which is removed afterwards.
class ProgramTest : public testing::Test {
protected:
    ProgramTest();
    ~ProgramTest() override;

    [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }

    /// Runs the program to its end.
    [[nodiscard]] Outcome run(const Words& arguments) const;
    /// The same, which must succeed without a word on standard error. Gives standard output.
    std::string must_run(const Words& arguments) const;
    /// What commands make in the empty folder, each of which must succeed; they run once for all
    /// tests of the program.
    void must_have_run(const std::vector<Words>& commands) const;
    /// A run to be watched or interrupted.
    [[nodiscard]] RunningProgram start(const Words& arguments) const;

    [[nodiscard]] std::string read(const std::string& file) const;
    void write(const std::string& file, const std::string& content) const;
    [[nodiscard]] Words lines(const std::string& file) const;
    /// Writes a file's lines changed.
    /// @param change gives a line from itself and its number, from 0
    void edit(const std::string& file,
              const std::function<std::string(const std::string&, int)>& change) const;
    [[nodiscard]] bool exists(const std::string& file) const;
    [[nodiscard]] Files files() const;
    /// True length deviations in truth.csv, as `form --lengths` wrote them [m].
    [[nodiscard]] std::vector<double> true_deviations() const;

private:
    std::filesystem::path m_base;
    std::filesystem::path m_folder;
    std::filesystem::path m_records;
};

/// One line on standard error that begins as every error does and holds the text; nothing on
/// standard output.
void expect_error(const Outcome& outcome, int exit_code, const std::string& text);

}  // namespace taut::test
