// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the way from a result to a list of turns on the command line: keys that others read, a
// list that does what the plan says, and one line for each input that cannot be meant.
#include <cmath>
#include <sstream>

#include "app/program.hpp"
#include "taut/report/report_html.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class PlanCommand : public ProgramTest {
protected:
    PlanCommand() {
        must_run({"example", "hypar:6x6", "-o", "net.json"});
        must_run({"form", "net.json", "--law", "uniform:3mm", "--seed", "7", "-o", "built.csv",
                  "--lengths", "truth.csv"});
        must_run({"survey", "net.json", "built.csv", "--noise", "0.3mm", "-o", "survey.csv"});
        must_run({"identify", "net.json", "survey.csv", "--law", "uniform:3mm", "--draws", "50",
                  "-o", "result.json"});
    }

    [[nodiscard]] Outcome plan(std::vector<std::string> options) const {
        options.insert(options.begin(), {"plan", "net.json", "result.json", "-o", "plan.json"});
        return run(options);
    }

    void expect_refused(const std::vector<std::string>& options, const char* text) const {
        const Outcome outcome = plan(options);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(text));
        EXPECT_FALSE(exists("plan.json"));
    }
};

TEST_F(PlanCommand, WritesTheKeysAndTheListThatOthersRead) {
    const Outcome outcome =
        plan({"--csv", "turns.csv", "--turn", "4mm", "--step", "1/4", "--crews", "2"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("all limits are kept with"));
    const json document = json::parse(read("plan.json"));
    EXPECT_EQ(document["format"].get<std::string>(), "taut-plan");
    EXPECT_EQ(document["version"], 1);
    EXPECT_TRUE(document["feasible"].get<bool>());
    for (const char* form : {"as_built", "planned", "unavoidable"}) {
        for (const char* key : {"mean", "max", "rmse", "normal_mean", "normal_max"}) {
            EXPECT_TRUE(document["form"][form][key].is_number()) << form << ' ' << key;
        }
    }
    EXPECT_LT(document["form"]["planned"]["normal_rmse"],
              document["form"]["as_built"]["normal_rmse"]);
    for (const char* key : {"least", "most", "limit_probability"}) {
        EXPECT_TRUE(document["tension"][key].is_number()) << key;
    }
    double largest = 0.0;
    for (const json& turn : document["turns"]) {
        for (const char* key :
             {"edge", "edge_id", "stroke", "turns", "pass", "crew", "reading_after"}) {
            EXPECT_TRUE(turn.contains(key)) << key;
        }
        const double steps = turn["stroke"].get<double>() / 1e-3;
        EXPECT_NEAR(steps, std::round(steps), 1e-9);
        EXPECT_NEAR(turn["turns"].get<double>(), std::abs(steps) / 4.0, 1e-9);
        largest = std::max(largest, std::abs(turn["stroke"].get<double>()));
    }
    EXPECT_EQ(document["touched"].get<size_t>(), document["turns"].size());  // in one pass
    EXPECT_NEAR(document["largest_stroke"].get<double>(), largest, 1e-12);
    std::istringstream list(read("turns.csv"));
    std::string line;
    size_t lines = 0;
    while (std::getline(list, line)) {
        ++lines;
    }
    EXPECT_EQ(lines, document["turns"].size() + 1);
}

TEST_F(PlanCommand, TellsWhichWayToTurnOnlyWhereTheThreadIsTold) {
    ASSERT_EQ(plan({"--csv", "turns.csv"}).exit_code, 0);
    EXPECT_TRUE(json::parse(read("plan.json"))["options"]["thread"].is_null());
    EXPECT_TRUE(json::parse(read("plan.json"))["turns"][0]["rotation"].is_null());
    EXPECT_THAT(read("turns.csv"), Not(HasSubstr("clockwise")));
    for (const bool is_right : {true, false}) {
        ASSERT_EQ(plan({"--csv", "turns.csv", "--thread", is_right ? "right" : "left"}).exit_code,
                  0);
        const json turns = json::parse(read("plan.json"))["turns"];
        ASSERT_FALSE(turns.empty());
        for (const json& turn : turns) {
            const bool shortens = turn["stroke"].get<double>() < 0.0;
            EXPECT_EQ(turn["rotation"].get<std::string>(),
                      shortens == is_right ? "clockwise" : "counterclockwise");
        }
        EXPECT_THAT(read("turns.csv"), HasSubstr("clockwise"));
    }
}

TEST_F(PlanCommand, HoldsLimitsForTheEstimateAloneWithoutDraws) {
    must_run({"identify", "net.json", "survey.csv", "--law", "uniform:3mm", "--draws", "0", "-o",
              "bare.json"});
    const Outcome outcome = run({"plan", "net.json", "bare.json", "-o", "plan.json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("by the estimate; how surely is not known, since there is "
                                       "no file"));
}

TEST_F(PlanCommand, EndsWithOneWhereLimitsCannotBeKeptAndNamesThem) {
    const Outcome outcome = plan({"--tension", "20kN.."});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("no strokes keep all limits"));
    EXPECT_FALSE(json::parse(read("plan.json"))["feasible"].get<bool>());
    EXPECT_FALSE(json::parse(read("plan.json"))["violations"].empty());
}

TEST_F(PlanCommand, RefusesWhatCannotBeMeant) {
    expect_refused({"--tension", "3kN..1kN"}, "an upper one above it");
    expect_refused({"--tension", "5kN"}, "expected a range");
    expect_refused({"--tension", "1kN..@ridge"}, "the group 'ridge'");
    expect_refused({"--turn", "0mm", "--step", "1/4"}, "a turn is 0 m");
    expect_refused({"--turn", "5mm", "--step", "5/4"}, "no more than a whole turn");
    expect_refused({"--turn", "5mm", "--step", "1/0"}, "expected a part of a turn");
    expect_refused({"--step", "1/4"}, "--turn");
    expect_refused({"--stroke=-5mm"}, "expected more than 0");
    expect_refused({"--weights", "up:1"}, "expected weights");
    expect_refused({"--weights", "normal:0,tangential:0"}, "all weights are 0");
    expect_refused({"--tolerance", "0mm"}, "tolerance is 0");
    expect_refused({"--confidence", "100%"}, "confidence is 1");
    expect_refused({"--crews", "0"}, "0 crews");
    expect_refused({"--target", "net.json"}, "net.json");
    write("edges.csv", "edge\n3\n3\n");
    expect_refused({"--adjustable", "edges.csv"}, "a second time");
    write("strokes.csv", "edge,shortest,longest\n0,0.001,0.002\n");
    expect_refused({"--stroke", "strokes.csv"}, "strokes.csv:2");
    write("wet.csv", "id,x,y,z\nnowhere,0,0,-1\n");
    expect_refused({"--check", "wet.csv"}, "wet.csv:2");
}

TEST_F(PlanCommand, IsTriedOverWholeJobsByControl) {
    const std::string told =
        must_run({"control", "net.json", "-o", "jobs", "--law", "uniform:2mm", "--noise", "0.2mm",
                  "--draws", "50", "--rounds", "1", "--trials", "2"});
    EXPECT_THAT(told, HasSubstr("identified"));
    const json document = json::parse(read("jobs/control.json"));
    EXPECT_EQ(document["format"].get<std::string>(), "taut-control");
    EXPECT_EQ(document["strategies"].size(), 4U);
    EXPECT_EQ(document["strategies"][1]["states"].size(), 4U);
    EXPECT_THAT(read("jobs/control.csv"), testing::StartsWith("strategy,trial,round,mean"));
    if (taut::has_report_viewer()) {
        const std::string page = read("jobs/report.html");
        must_run({"report", "jobs/control.json", "-o", "again.html", "--svg", "svg"});
        EXPECT_EQ(read("again.html"), page);
        EXPECT_THAT(read("svg/control_form.svg"), HasSubstr("<svg"));
    }
    expect_error(run({"control", "net.json", "-o", "jobs", "--trials", "0"}), 2, "trials");
    expect_error(run({"control", "net.json", "-o", "jobs", "--tension", "9kN..1kN"}), 2,
                 "an upper one above it");
}

TEST_F(PlanCommand, RefusesAResultOfAnotherNet) {
    must_run({"example", "hypar:6x5", "-o", "other.json"});
    const Outcome outcome = run({"plan", "other.json", "result.json", "-o", "plan.json"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("it is of another net"));
    EXPECT_EQ(run({"plan", "net.json", "net.json", "-o", "plan.json"}).exit_code, 2);
}

}  // namespace
