// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards scripts that use the option names of version 0.2: each still works, with one warning.

#include "app/program.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;

class RenamedOptions : public ProgramTest {
protected:
    RenamedOptions() {
        must_have_run({{"example", "hypar:4x5", "-o", "net.json"},
                       {"form", "net.json", "--prior", "uniform:3mm", "-o", "form.csv"},
                       {"survey", "net.json", "form.csv", "--noise", "0.3mm", "-o", "survey.csv"}});
    }

    /// The result under the old names must be that under the new ones.
    /// @param warning without "taut: warning: "
    void expect_same(const Words& command, const Words& before, const Words& now,
                     const std::string& warning) const {
        const auto result = [&](const Words& options, const std::string& expected_error) {
            const Outcome outcome = run(joined(joined(command, options), {"--json"}));
            EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
            EXPECT_EQ(outcome.err, expected_error);
            json document = json::parse(outcome.out, nullptr, false);
            document.erase("command");
            document.erase("date");
            return document;
        };
        EXPECT_EQ(result(before, "taut: warning: " + warning + "\n"), result(now, ""));
    }
};

TEST_F(RenamedOptions, WorkUnderTheirOldNamesWithOneWarningThatHasTheNewName) {
    const Words form{"form", "net.json"};
    expect_same(form, {"--law", "normal:1mm"}, {"--prior", "normal:1mm"}, "--law is now --prior");
    expect_same(form, {"--law=normal:1mm"}, {"--prior=normal:1mm"}, "--law is now --prior");
    must_run({"identify", "net.json", "survey.csv", "--draws", "50", "-o", "result.json"});
    const Words plan{"plan", "net.json", "result.json", "-o", "plan.json"};
    expect_same(plan, {"--further", "1"}, {"--suggest-adjustable", "1"},
                "--further is now --suggest-adjustable");
    expect_same(plan, {"--survey-first", "0.5mm"}, {"--suggest-targets", "0.5mm"},
                "--survey-first is now --suggest-targets");
}

// Before, everything that was not given was exact.
TEST_F(RenamedOptions, UnknownIsUncertainAndNothingElse) {
    expect_same(
        {"identify", "net.json", "survey.csv", "--draws", "0"},
        {"--unknown", "stiffness:5%", "--unknown", "supports:1mm"},
        {"--uncertain", "none", "--uncertain", "stiffness:5%", "--uncertain", "supports:1mm"},
        "--unknown is now --uncertain none --uncertain");
}

}  // namespace
