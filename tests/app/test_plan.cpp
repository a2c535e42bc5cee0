// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the way from a result to a list of turns: keys that others read, a list that does what the
// plan says, options that reach the planner, and one line for each wrong input.
#include <fmt/core.h>

#include <cmath>
#include <functional>
#include <map>

#include "app/program.hpp"
#include "taut/report/report_html.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class PlanCommand : public ProgramTest {
protected:
    PlanCommand() {
        must_have_run(
            {{"example", "hypar:6x6", "-o", "net.json"},
             {"form", "net.json", "--prior", "uniform:3mm", "--seed", "7", "-o", "built.csv"},
             {"survey", "net.json", "built.csv", "--noise", "0.3mm", "-o", "survey.csv"},
             {"identify", "net.json", "survey.csv", "--prior", "uniform:3mm", "--draws", "50", "-o",
              "result.json"}});
    }

    void identify(const Words& options) const {
        must_run(joined({"identify", "net.json", "survey.csv", "--prior", "uniform:3mm"}, options));
    }

    [[nodiscard]] Outcome plan(const Words& options) const {
        return run(joined({"plan", "net.json", "result.json", "-o", "plan.json"}, options));
    }

    /// A plan that keeps all limits.
    [[nodiscard]] json planned(const Words& options) const {
        const Outcome outcome = plan(options);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return json::parse(read("plan.json"));
    }
};

TEST_F(PlanCommand, WritesAListOfItsTurnsInWholeSteps) {
    const Outcome outcome =
        plan({"--csv", "turns.csv", "--turn", "4mm", "--step", "1/4", "--crews", "2"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("no limits of tension or reaction were given\n"
                                             "All cables stay taut with a probability of "),
                                   Not(HasSubstr("limits are kept"))));
    const json document = json::parse(read("plan.json"));
    EXPECT_TRUE(document["feasible"].get<bool>());
    EXPECT_LT(document["form"]["planned"]["normal_rmse"],
              document["form"]["as_built"]["normal_rmse"]);
    for (const json& turn : document["turns"]) {
        const double steps = turn["stroke"].get<double>() / 1e-3;
        EXPECT_NEAR(steps, std::round(steps), 1e-9);
        EXPECT_NEAR(turn["turns"].get<double>(), std::abs(steps) / 4.0, 1e-9);
    }
    const Words list = lines("turns.csv");
    EXPECT_THAT(list.at(0), HasSubstr("THE TURNS GAIN LITTLE: "));
    EXPECT_THAT(outcome.out, HasSubstr("THE TURNS GAIN LITTLE: "));
    EXPECT_EQ(list.size(), document["turns"].size() + 2);
}

TEST_F(PlanCommand, HasARotationOnlyWhereTheThreadIsGiven) {
    const auto rotations_are = [&](const Words& options,
                                   const std::function<json(const json&)>& expected) {
        const json document = planned(options);
        Words list = lines("turns.csv");
        std::erase_if(list, [](const std::string& line) { return line.starts_with("#"); });
        EXPECT_FALSE(document["turns"].empty());
        for (size_t k = 0; k < document["turns"].size(); ++k) {
            const json& turn = document["turns"][k];
            const json rotation = expected(turn);
            EXPECT_EQ(turn["rotation"], rotation);
            EXPECT_THAT(list.at(k + 1),
                        HasSubstr("," + turn["action"].get<std::string>() + "," +
                                  (rotation.is_null() ? "" : rotation.get<std::string>()) + ","));
        }
    };
    const auto by = [](const json& turn, bool is_right) {
        return (turn["stroke"].get<double>() < 0.0) == is_right ? "clockwise" : "counterclockwise";
    };
    rotations_are({"--csv", "turns.csv"}, [](const json&) { return json(); });
    json net = json::parse(read("net.json"));
    std::map<int, bool> is_right;
    for (const json& edge : net["adjustable"]) {
        is_right[edge.get<int>()] = is_right.size() % 3 == 0;
        net["thread"].push_back(is_right[edge.get<int>()] ? "right" : "left");
    }
    write("net.json", net.dump());
    rotations_are({"--csv", "turns.csv"},
                  [&](const json& turn) { return by(turn, is_right[turn["edge"].get<int>()]); });
    rotations_are({"--csv", "turns.csv", "--thread", "left"},
                  [&](const json& turn) { return by(turn, false); });
}

TEST_F(PlanCommand, SaysWhichTargetTensionsAreReachedAndWhatIsInTheWay) {
    json net = json::parse(read("net.json"));
    net["groups"]["ridge"] = {net["adjustable"][0], net["adjustable"][7]};
    write("net.json", net.dump());
    const json tensions = planned({})["tension"]["edges"];
    const double target =
        1.1 * tensions[net["adjustable"][0].get<size_t>()]["as_built"].get<double>();
    const std::string force = fmt::format("{:.1f}N", target);
    EXPECT_THAT(plan({"--target-tension", force + ":0.01%@ridge"}).out,
                AllOf(HasSubstr("target tensions are within their tolerance, in the mean of the"),
                      HasSubstr("The survey shows 2 of them no better than their tolerance"),
                      HasSubstr("  weighed: 5mm of form counts")));
    // One force in all cables of a hypar is no equilibrium near its form.
    EXPECT_THAT(plan({"--target-tension", force}).out,
                HasSubstr("are missed: no strokes of these turnbuckles were found that reach all "
                          "targets, not even unlimited ones with any form"));
    identify({"--draws", "0", "-o", "result.json"});
    const Outcome estimate = plan({"--target-tension", force + "@ridge", "--csv", "turns.csv"});
    EXPECT_THAT(estimate.out, StartsWith("TARGET TENSIONS CANNOT BE PROMISED"));
    EXPECT_THAT(read("turns.csv"), StartsWith("# TARGET TENSIONS CANNOT BE PROMISED"));
}

TEST_F(PlanCommand, SuggestsAdjustableEdgesAndTargets) {
    identify({"--draws", "50", "--uncertain", "none", "-o", "result.json"});
    EXPECT_THAT(
        plan({"--suggest-adjustable", "2", "--suggest-targets", "0.2mm"}).out,
        AllOf(HasSubstr("suggested further adjustable edges"), HasSubstr("surveyed to 0.2mm")));
}

TEST_F(PlanCommand, KeepsLimitsByTheEstimateAloneWithoutSamples) {
    // The samples of the earlier result stay there, and are not taken for its own.
    identify({"--draws", "0", "-o", "result.json"});
    ASSERT_TRUE(exists("result_draws.h5"));
    EXPECT_THAT(plan({}).out, HasSubstr("no cable goes slack by the estimate; its probability is "
                                        "not known, since "));
    const Outcome outcome = plan({"--tension", "0.1kN..", "--csv", "turns.csv"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("LIMITS CANNOT BE PROMISED"));
    const json document = json::parse(read("plan.json"));
    EXPECT_EQ(document["draws"], 0);
    EXPECT_TRUE(document["tension"]["limit_probability"].is_null());
    EXPECT_THAT(read("turns.csv"), StartsWith("# LIMITS CANNOT BE PROMISED"));
    EXPECT_TRUE(lines("turns.csv").back().ends_with(",")) << "no tension after the turn";
}

TEST_F(PlanCommand, RefusesSamplesOfAnotherResult) {
    identify({"--draws", "50", "--seed", "2", "-o", "other.json"});
    write("result_draws.h5", read("other_draws.h5"));
    expect_error(plan({}), 2, "result_draws.h5:");
    EXPECT_FALSE(exists("plan.json"));
}

TEST_F(PlanCommand, SaysWithWhichProbabilityLimitsAreKept) {
    EXPECT_THAT(plan({"--tension", "0.1kN..60kN"}).out,
                AllOf(HasSubstr("All limits are kept with a probability of "),
                      HasSubstr("probability that no step breaks a limit: ")));
}

// Cables that are slack and are turned taut: posterior samples of their lengths can lie off the
// estimate, and keep limits that it breaks.
TEST_F(PlanCommand, IsNotFeasibleWhereItsOwnEstimateBreaksALimit) {
    must_run({"example", "hypar:7x7", "-o", "net.json"});
    json net = json::parse(read("net.json"));
    for (const size_t edge : {9, 10, 24, 25, 40, 41}) {
        net["unstressed_lengths"][edge] = 1.06 * net["unstressed_lengths"][edge].get<double>();
    }
    write("net.json", net.dump());
    // With a warning: the nodes of the file are not the form of such lengths.
    ASSERT_EQ(run({"form", "net.json", "--prior", "uniform:5mm", "--seed", "3", "-o", "built.csv"})
                  .exit_code,
              0);
    must_run(
        {"survey", "net.json", "built.csv", "--noise", "0.5mm", "--seed", "3", "-o", "survey.csv"});
    must_run({"identify", "net.json", "survey.csv", "--uncertain", "none", "-o", "result.json"});
    EXPECT_EQ(plan({"--tension", "1kN.."}).exit_code, 1);
    const json document = json::parse(read("plan.json"));
    ASSERT_LT(document["tension"]["least"].get<double>(), 1e3);
    EXPECT_FALSE(document["feasible"].get<bool>());
    EXPECT_LT(document["violations"][0]["value"].get<double>(), 1e3);
}

TEST_F(PlanCommand, EndsWithOneWhereLimitsCannotBeKeptAndMarksItsList) {
    const Outcome outcome = plan({"--tension", "20kN..", "--csv", "turns.csv"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("no strokes were found that keep all limits"));
    EXPECT_THAT(read("turns.csv"), StartsWith("# DO NOT TURN BY THIS LIST"));
    const json document = json::parse(read("plan.json"));
    EXPECT_FALSE(document["feasible"].get<bool>());
    EXPECT_FALSE(document["violations"].empty());
    EXPECT_FALSE(document["order"]["safe"].get<bool>());
}

TEST_F(PlanCommand, RefusesAFailedIdentificationUnlessThatIsAccepted) {
    // 0.3 mm of noise, taken for 0.1 mm.
    edit("survey.csv", [](const std::string& line, int) { return first_fields(line, 4); });
    ASSERT_EQ(run({"identify", "net.json", "survey.csv", "--noise", "0.1mm", "--prior",
                   "uniform:3mm", "--draws", "50", "-o", "result.json"})
                  .exit_code,
              0);
    const json result = json::parse(read("result.json"));
    ASSERT_EQ(result["trust"]["verdict"], "failed");
    const std::string reason = result["findings"][0]["reason"];
    const Outcome refused = plan({"--csv", "turns.csv"});
    expect_error(refused, 2, reason);
    EXPECT_THAT(refused.err, HasSubstr("--accept-failed"));
    EXPECT_FALSE(exists("plan.json"));
    EXPECT_FALSE(exists("turns.csv"));
    const Outcome accepted = plan({"--csv", "turns.csv", "--accept-failed"});
    ASSERT_EQ(accepted.exit_code, 0) << accepted.err;
    const std::string first = "DO NOT TURN BY THIS LIST: ";
    EXPECT_THAT(accepted.out, AllOf(StartsWith(first), HasSubstr(reason)));
    EXPECT_THAT(read("turns.csv"), AllOf(StartsWith("# " + first), HasSubstr(reason)));
    EXPECT_THAT(json::parse(read("plan.json"))["warnings"][0].get<std::string>(),
                StartsWith(first));
}

TEST_F(PlanCommand, IsSimulatedOverWholeJobsByControl) {
    const std::string text =
        must_run({"control", "net.json", "-o", "jobs", "--prior", "uniform:2mm", "--noise", "0.2mm",
                  "--draws", "50", "--rounds", "1", "--trials", "2"});
    EXPECT_THAT(text, HasSubstr("identified"));
    const json document = json::parse(read("jobs/control.json"));
    EXPECT_EQ(document["format"].get<std::string>(), "taut-control");
    EXPECT_EQ(document["settings"]["uncertain"],
              json({"stiffness:5%", "stiffness-each:2%", "adjustable:0.5mm", "supports:1mm"}));
    EXPECT_EQ(document["strategies"].size(), 4U);
    EXPECT_EQ(document["strategies"][1]["states"].size(), 4U);
    EXPECT_THAT(read("jobs/control.csv"), StartsWith("strategy,trial,round,mean"));
    if (taut::has_report_viewer()) {
        must_run({"report", "jobs/control.json", "-o", "again.html"});
        EXPECT_EQ(read("again.html"), read("jobs/report.html"));
    }
}

}  // namespace
