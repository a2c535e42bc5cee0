// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards that a survey tells the same lengths in whatever format it comes, and that the program
// says what it understood.

#include <cmath>
#include <filesystem>

#include "app/program.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class SurveyFormats : public ProgramTest {
protected:
    SurveyFormats() { must_run({"example", "hypar:4x5", "-o", "net.json"}); }

    static std::string data_file(const std::string& name) {
        return (std::filesystem::path(TAUT_TEST_DATA_DIR) / "surveys" / name).string();
    }

    json identify(const std::string& name, std::vector<std::string> options = {}) const {
        options.insert(options.begin(),
                       {"identify", "net.json", data_file(name), "--noise", "0.2mm", "--prior",
                        "uniform:2mm", "--draws", "0", "--json"});
        const Outcome outcome = run(options);
        EXPECT_EQ(outcome.exit_code, 0) << name << ": " << outcome.err;
        return json::parse(outcome.out, nullptr, false);
    }
};

TEST_F(SurveyFormats, GiveTheSameLengths) {
    const json own = identify("own.csv");
    ASSERT_EQ(own["edges"].size(), 31U);
    for (const char* const name :
         {"german.csv", "english.txt", "gsi8.gsi", "gsi16.gsi", "landxml.xml", "jobxml.jxl",
          "gama.xml", "drawing.dxf", "scan.pts", "scan.xyz"}) {
        const json other = identify(name);
        ASSERT_EQ(other["edges"].size(), 31U) << name;
        for (size_t i = 0; i < 31; ++i) {
            for (const char* const key : {"length_deviation", "std", "lower", "upper"}) {
                EXPECT_NEAR(other["edges"][i][key], own["edges"][i][key], 1e-9)
                    << name << ", edge " << i << ", " << key;
            }
        }
    }
}

TEST_F(SurveyFormats, AreToldInTheOutputAndOnStandardErrorWithJson) {
    const std::vector<std::string> command{
        "identify", "net.json", data_file("german.csv"), "--noise", "0.2mm", "--draws", "0"};
    const auto said = AllOf(HasSubstr("read as text table, in mm as the file tells"),
                            HasSubstr("columns: Pkt-Nr as id, Rechtswert [mm] as x"),
                            HasSubstr("separator: semicolon; decimal sign: comma"),
                            HasSubstr("encoding: Latin-1"));
    EXPECT_THAT(must_run(command), said);
    std::vector<std::string> with_json = command;
    with_json.push_back("--json");
    EXPECT_THAT(run(with_json).err, said);
    EXPECT_THAT(
        must_run({"inspect", "net.json", "--survey", data_file("gsi16.gsi"), "--noise", "0.2mm"}),
        AllOf(HasSubstr("read as Leica GSI-16"), HasSubstr("line 2: a station")));
}

TEST_F(SurveyFormats, WriteTheTableOfNames) {
    const Outcome outcome = run({"identify", "net.json", data_file("scan.pts"), "--noise", "0.2mm",
                                 "--draws", "0", "--names", "names.csv"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(read("names.csv"), HasSubstr("line,name,node,distance,status\n2,,"));
    must_run({"inspect", "net.json", "--survey", data_file("own.csv"), "--names", "own_names.csv"});
    EXPECT_THAT(read("own_names.csv"), HasSubstr("\n2,0,0,"));
}

TEST_F(SurveyFormats, FollowWhatIsToldOfThem) {
    write("a.txt", "Punkt;a;b;c\n");
    expect_error(run({"identify", "net.json", data_file("own.csv"), "--format", "gsi"}), 2,
                 "own.csv:1: holds 'id,x,y,z', expected a word of GSI");
    expect_error(run({"identify", "net.json", data_file("own.csv"), "--columns", "id,x"}), 2,
                 "lack a coordinate");
    expect_error(run({"identify", "net.json", data_file("own.csv"), "--unit", "furlong"}), 2,
                 "--unit");
    expect_error(run({"identify", "net.json", "a.txt"}), 2, "a.txt");
    // Exchanged axes are another survey.
    const Outcome exchanged = run({"identify", "net.json", data_file("own.csv"), "--columns",
                                   "id,y,x,z", "--match", "name", "--frame", "net"});
    EXPECT_EQ(exchanged.exit_code, 2);
    EXPECT_THAT(exchanged.err, HasSubstr("from its nominal place"));
}

}  // namespace
