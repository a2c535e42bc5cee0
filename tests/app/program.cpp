// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#include "app/program.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace taut::test {
namespace {

std::string content_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Makes one of the standard streams of this process a file.
void redirect(int stream, const std::filesystem::path& file, int flags) {
    const int opened = open(file.c_str(), flags, 0600);
    if (opened < 0 || dup2(opened, stream) < 0) {
        _exit(126);
    }
}

}  // namespace

Words joined(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

std::string first_fields(const std::string& line, int count) {
    size_t end = line.find(',');
    for (int k = 1; k < count && end != std::string::npos; ++k) {
        end = line.find(',', end + 1);
    }
    return line.substr(0, end);
}

RunningProgram::RunningProgram(const std::filesystem::path& folder,
                               const std::filesystem::path& records, const Words& arguments)
    : m_records(records) {
    Words words = joined({TAUT_PROGRAM}, arguments);
    std::vector<char*> argv;
    for (std::string& word : words) {
        argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    m_process = fork();
    if (m_process < 0) {
        throw std::runtime_error("cannot start the program");
    }
    if (m_process == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);  // a test that is ended takes it along
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
            std::signal(signal, SIG_DFL);  // ignored where the tests run in the background
        }
        redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
        redirect(STDOUT_FILENO, records / "out", O_WRONLY | O_CREAT | O_TRUNC);
        redirect(STDERR_FILENO, records / "err", O_WRONLY | O_CREAT | O_TRUNC);
        if (chdir(folder.c_str()) == 0) {
            execv(argv[0], argv.data());
        }
        _exit(126);
    }
}

RunningProgram::~RunningProgram() {
    if (m_process > 0) {
        kill(m_process, SIGKILL);
        waitpid(m_process, nullptr, 0);
    }
}

void RunningProgram::send(int signal) const {
    if (m_process > 0) {
        kill(m_process, signal);
    }
}

Outcome RunningProgram::wait() {
    int status = 0;
    waitpid(m_process, &status, 0);
    m_process = -1;
    return {.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            .out = content_of(m_records / "out"),
            .err = content_of(m_records / "err")};
}

ProgramTest::ProgramTest() {
    std::string name = testing::TempDir() + "taut-XXXXXX";
    if (mkdtemp(name.data()) == nullptr) {
        throw std::runtime_error("cannot make a folder " + name);
    }
    m_base = name;
    m_folder = m_base / "work";
    m_records = m_base / "records";
    std::filesystem::create_directory(m_folder);
    std::filesystem::create_directory(m_records);
}

ProgramTest::~ProgramTest() {
    std::error_code ignored;
    std::filesystem::remove_all(m_base, ignored);
}

Outcome ProgramTest::run(const Words& arguments) const {
    return start(arguments).wait();
}

std::string ProgramTest::must_run(const Words& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << testing::PrintToString(arguments);
    EXPECT_EQ(outcome.err, "") << testing::PrintToString(arguments);
    return outcome.out;
}

void ProgramTest::must_have_run(const std::vector<Words>& commands) const {
    static std::map<std::vector<Words>, Files> made;
    if (const auto found = made.find(commands); found != made.end()) {
        for (const auto& [file, content] : found->second) {
            write(file, content);
        }
        return;
    }
    for (const Words& command : commands) {
        must_run(command);
    }
    made.emplace(commands, files());
}

RunningProgram ProgramTest::start(const Words& arguments) const {
    return {m_folder, m_records, arguments};
}

std::string ProgramTest::read(const std::string& file) const {
    EXPECT_TRUE(exists(file)) << file;
    return content_of(m_folder / file);
}

void ProgramTest::write(const std::string& file, const std::string& content) const {
    std::ofstream(m_folder / file, std::ios::binary) << content;
}

Words ProgramTest::lines(const std::string& file) const {
    std::istringstream stream(read(file));
    Words result;
    for (std::string line; std::getline(stream, line);) {
        result.push_back(line);
    }
    return result;
}

void ProgramTest::edit(const std::string& file,
                       const std::function<std::string(const std::string&, int)>& change) const {
    std::string text;
    int number = 0;
    for (const std::string& line : lines(file)) {
        text += change(line, number++) + "\n";
    }
    write(file, text);
}

bool ProgramTest::exists(const std::string& file) const {
    return std::filesystem::exists(m_folder / file);
}

Files ProgramTest::files() const {
    Files files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(m_folder)) {
        const std::string name = entry.path().lexically_relative(m_folder).string();
        if (entry.is_directory()) {
            files[name + "/"] = "";
        } else {
            files[name] = content_of(entry.path());
        }
    }
    return files;
}

std::vector<double> ProgramTest::true_deviations() const {
    std::vector<double> deviations;
    for (const std::string& line : lines("truth.csv")) {
        if (deviations.empty() && line == "edge,nominal,length_deviation") {
            continue;
        }
        deviations.push_back(std::stod(line.substr(line.rfind(',') + 1)));
    }
    return deviations;
}

void expect_error(const Outcome& outcome, int exit_code, const std::string& text) {
    EXPECT_EQ(outcome.exit_code, exit_code);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, testing::StartsWith("taut: error: "));
    EXPECT_THAT(outcome.err, testing::HasSubstr(text));
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_THAT(outcome.err, testing::EndsWith("\n"));
}

}  // namespace taut::test
