// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the predicted precision of a survey: of a list of targets it must be that of the survey
// itself, and its text must be that of its JSON.

#include <cmath>
#include <set>

#include "app/program.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class InspectSurvey : public ProgramTest {
protected:
    InspectSurvey() { must_have_run({{"example", "hypar:10x10", "-o", "net.json"}}); }

    /// Writes the names of the 100 free nodes, but for those from the `first` to before the `last`.
    void plan(int first, int last) const {
        const std::set<int> supports = json::parse(read("net.json"))["supports"];
        std::string names;
        int place = 0;
        for (int node = 0; node < 140; ++node) {
            if (!supports.contains(node)) {
                names += place >= first && place < last ? "" : std::to_string(node) + "\n";
                ++place;
            }
        }
        write("targets.txt", names);
    }

    json survey(const Words& options) const {
        return json::parse(
            must_run(joined({"inspect", "net.json", "--json", "--survey"}, options)))["survey"];
    }

    static json statuses(const json& document) {
        json result = json::array();
        for (const json& edge : document["edges"]) {
            result.push_back(edge["status"]);
        }
        return result;
    }
};

TEST_F(InspectSurvey, SuggestsWhatToMeasureNext) {
    plan(30, 70);
    const Words what{"targets.txt", "--noise",    "0.5mm",  "--suggest", "form",
                     "--cost",      "target:0.1", "--load", "0.3kN"};
    const json found = survey(what)["suggestions"];
    EXPECT_EQ(found["quantity"], "form");
    ASSERT_EQ(found["steps"].size(), 5U);
    EXPECT_EQ(found["steps"][0]["kind"], "target");
    const std::string text = must_run(joined({"inspect", "net.json", "--survey"}, what));
    EXPECT_THAT(text, AllOf(HasSubstr("form: std "),
                            HasSubstr("node " + found["steps"][0]["id"].get<std::string>()),
                            HasSubstr("not suggested: frequencies and sags: the net has no mass")));
}

TEST_F(InspectSurvey, GivesEachEdgeAndTheCounts) {
    plan(30, 70);
    const json predicted = survey({"targets.txt", "--noise", "0.5mm"});
    EXPECT_EQ(predicted["used"], 60);
    EXPECT_EQ(predicted["missing"], 40);
    ASSERT_EQ(predicted["edges"].size(), 180U);
    std::map<std::string, int> of_status;
    double squares = 0.0;
    for (const json& edge : predicted["edges"]) {
        const double std_dev = edge["std"];
        squares += std_dev * std_dev;
        EXPECT_NEAR(edge["ratio"].get<double>(), std_dev / predicted["prior_std"].get<double>(),
                    1e-12);
        ++of_status[edge["status"]];
    }
    EXPECT_GT(of_status["not_determined"], 0);
    for (const char* status : {"determined", "weakly_determined", "not_determined", "slack"}) {
        EXPECT_EQ(predicted[status], of_status[status]) << status;
    }
    EXPECT_NEAR(predicted["rms_std"].get<double>(), std::sqrt(squares / 180.0), 1e-12);
    EXPECT_THAT(
        must_run({"inspect", "net.json", "--survey", "targets.txt", "--noise", "0.5mm"}),
        AllOf(HasSubstr("survey targets.txt: 60 free nodes, 40 not surveyed"),
              HasSubstr(std::to_string(of_status["not_determined"]) + " not determined"),
              HasSubstr("worst edges"), HasSubstr("with one more force measurement of 2 %")));
}

TEST_F(InspectSurvey, GivesTheSameForAListAndForASurvey) {
    must_run({"form", "net.json", "-o", "form.csv"});
    must_run({"survey", "net.json", "form.csv", "--noise", "0.5mm", "--drop", "30%", "-o",
              "survey.csv"});
    std::string names;
    for (const std::string& line : lines("survey.csv")) {
        names += line.starts_with("id,") ? "" : first_fields(line, 1) + "\n";
    }
    write("targets.txt", names);
    const json list = survey({"targets.txt", "--noise", "0.5mm"});
    const json points = survey({"survey.csv"});
    EXPECT_EQ(list["edges"], points["edges"]);
    EXPECT_EQ(list["missing_nodes"], points["missing_nodes"]);
    // And of the survey in a frame of its own, without names.
    must_run({"survey", "net.json", "form.csv", "--noise", "0.5mm", "--drop", "30%", "--shuffle",
              "--frame", "random", "-o", "survey.csv"});
    EXPECT_EQ(statuses(survey({"survey.csv"})), statuses(list));
}

}  // namespace
