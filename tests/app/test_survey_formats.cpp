// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards that the program says how it understood a survey, and that its options reach the reader.

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
};

TEST_F(SurveyFormats, AreDescribedInTheOutputAndOnStandardErrorWithJson) {
    const std::vector<std::string> command{
        "identify", "net.json", data_file("german.csv"), "--noise", "0.2mm", "--draws", "0"};
    const auto said = AllOf(
        HasSubstr("read as text table"), HasSubstr("columns: Pkt-Nr as id, Rechtswert [mm] as x"),
        HasSubstr("separator: semicolon; decimal sign: comma"), HasSubstr("encoding: Latin-1"));
    EXPECT_THAT(must_run(command), said);
    std::vector<std::string> with_json = command;
    with_json.push_back("--json");
    EXPECT_THAT(run(with_json).err, said);
    EXPECT_THAT(
        must_run({"inspect", "net.json", "--survey", data_file("gsi16.gsi"), "--noise", "0.2mm"}),
        HasSubstr("read as Leica GSI-16"));
}

TEST_F(SurveyFormats, IncludeASheetOfExcel) {
    const std::vector<std::string> command{
        "inspect", "net.json", "--survey", data_file("excel.xlsx"), "--noise", "0.2mm"};
    const std::string said = must_run(command);
    EXPECT_THAT(said, AllOf(HasSubstr("read as Excel sheet 'Aufmaß & Lage', in mm by the file"),
                            HasSubstr("columns: Pkt-Nr as id, Rechtswert [mm] as x"),
                            testing::Not(HasSubstr("separator"))));
    std::vector<std::string> with_separator = command;
    with_separator.insert(with_separator.end(), {"--separator", "comma"});
    expect_error(run(with_separator), 2, "excel.xlsx: is an Excel file, which has no separator");
    write("cut.xlsx", read(data_file("excel.xlsx")).substr(0, 5000));
    expect_error(run({"identify", "net.json", "cut.xlsx", "-o", "result.json"}), 2,
                 "cut.xlsx: is a ZIP archive, as xlsx files are, that is damaged");
    EXPECT_FALSE(exists("result.json"));
}

TEST_F(SurveyFormats, WriteTheTableOfNames) {
    const Outcome outcome = run({"identify", "net.json", data_file("scan.pts"), "--noise", "0.2mm",
                                 "--draws", "0", "--names", "names.csv"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(read("names.csv"), HasSubstr("line,name,node,distance,status\n2,,"));
    must_run({"inspect", "net.json", "--survey", data_file("own.csv"), "--names", "own_names.csv"});
    EXPECT_THAT(read("own_names.csv"), HasSubstr("\n2,0,0,"));
}

TEST_F(SurveyFormats, FollowTheirOptions) {
    // Exchanged axes are another survey.
    const Outcome exchanged = run({"identify", "net.json", data_file("own.csv"), "--columns",
                                   "id,y,x,z", "--match", "name", "--frame", "net"});
    EXPECT_EQ(exchanged.exit_code, 2);
    EXPECT_THAT(exchanged.err, HasSubstr("from its nominal place"));
}

}  // namespace
