// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against words of another library, or none, where a command ends by an unexpected
// exception.

#include "run_program.hpp"

#include <gmock/gmock.h>

#include <array>
#include <nlohmann/json.hpp>

namespace {

using namespace taut::app;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string message_of_end;

int keep_message(int code, std::string_view message) noexcept {
    message_of_end = message;
    return code;
}

template <class Action>
void add_broken(CLI::App& program) {
    program.add_subcommand("broken", "Ends by an exception")->callback(Action());
}

struct TakesANumberForAList {
    void operator()() const { static_cast<void>(nlohmann::json(5)[0]); }
};

struct FindsNoSolution {
    void operator()() const { throw std::runtime_error("no solution within 100 iterations"); }
};

int run(void (*add_command)(CLI::App&)) {
    std::array<std::string, 2> words{"taut", "broken"};
    std::array<char*, 2> arguments{words[0].data(), words[1].data()};
    return run_program({.name = "taut", .commands = {add_command}, .end = keep_message},
                       static_cast<int>(arguments.size()), arguments.data());
}

TEST(RunProgram, PrintsAnInternalErrorWithTheCommandAndNotInWordsOfALibrary) {
    EXPECT_EQ(run(add_broken<TakesANumberForAList>), 1);
    EXPECT_THAT(message_of_end, AllOf(HasSubstr("internal error"), HasSubstr(": taut broken"),
                                      Not(HasSubstr("json.exception"))));
}

TEST(RunProgram, PrintsANumericalFailureInItsWords) {
    EXPECT_EQ(run(add_broken<FindsNoSolution>), 1);
    EXPECT_EQ(message_of_end, "no solution within 100 iterations");
}

}  // namespace
