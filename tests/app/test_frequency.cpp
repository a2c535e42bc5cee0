// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a frequency that identify takes from a record that does not show it.

#include <fmt/core.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>

#include "app/program.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class Frequency : public ProgramTest {
protected:
    Frequency() {
        write("plucked.csv", [] {
            std::ifstream file(TAUT_TEST_DATA_DIR "/records/plucked.csv");
            return std::string(std::istreambuf_iterator<char>(file), {});
        }());
    }
};

TEST_F(Frequency, OfARecordIsWrittenForIdentify) {
    must_run({"example", "hypar:2x3", "-o", "net.json"});
    const Words command{"frequency", "plucked.csv", "--edge", "3", "-o", "f.csv"};
    const std::string out = must_run(joined(command, {"--net", "net.json"}));
    EXPECT_THAT(out, AllOf(HasSubstr("3 columns"), HasSubstr("not explained"),
                           HasSubstr("\nfundamental 5.1"), HasSubstr("written to f.csv")));
    ASSERT_EQ(lines("f.csv").size(), 2U);
    EXPECT_EQ(lines("f.csv")[0], "edge,frequency,mode,std");
    EXPECT_THAT(lines("f.csv")[1], testing::MatchesRegex("3,5\\.1[0-9]+,1,0\\.0[0-9]+"));
    const auto document = json::parse(must_run(joined(command, {"--json"})));
    EXPECT_NEAR(document["fundamental"]["frequency"].get<double>(), 5.1268, 0.02);
    EXPECT_EQ(document["peaks"][0]["mode"], 1);
}

TEST_F(Frequency, ThatTheRecordDoesNotShowIsNotWritten) {
    std::mt19937_64 engine(1);
    std::normal_distribution<double> noise(0.0, 0.3);
    std::string text = "t,a\n";
    for (int i = 0; i < 4000; ++i) {
        text += fmt::format("{:.3f},{:.4f}\n", 0.005 * i, std::sin(0.3 * i) + noise(engine));
    }
    write("sine.csv", text);
    write("f.csv", "an earlier outcome\n");
    const Outcome outcome = run({"frequency", "sine.csv", "--edge", "3", "-o", "f.csv"});
    EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr("taut: error: sine.csv: "));
    EXPECT_THAT(outcome.err, HasSubstr("--range"));
    EXPECT_EQ(read("f.csv"), "an earlier outcome\n");
    must_run({"frequency", "sine.csv", "--edge", "3", "--range", "9..10Hz", "-o", "f.csv"});
    EXPECT_THAT(lines("f.csv")[1], testing::StartsWith("3,9.5"));
}

}  // namespace
