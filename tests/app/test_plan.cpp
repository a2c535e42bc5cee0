// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the way from a result to a list of turns: keys that others read, a list that does what the
// plan says, options that reach the planner, and one line for each wrong input.
#include <fmt/core.h>

#include <algorithm>
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

    void expect_refused(const Words& options, const std::string& text) const {
        std::filesystem::remove(folder() / "plan.json");
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
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("no limits of tension or reaction were given\n"
                                             "All cables stay taut with a probability of "),
                                   Not(HasSubstr("limits are kept"))));
    const json document = json::parse(read("plan.json"));
    EXPECT_EQ(document["format"].get<std::string>(), "taut-plan");
    EXPECT_TRUE(document["feasible"].get<bool>());
    for (const char* form : {"as_built", "planned", "unconstrained"}) {
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
             {"edge", "edge_id", "stroke", "turns", "pass", "crew", "step", "reading_after"}) {
            EXPECT_TRUE(turn.contains(key)) << key;
        }
        const double steps = turn["stroke"].get<double>() / 1e-3;
        EXPECT_NEAR(steps, std::round(steps), 1e-9);
        EXPECT_NEAR(turn["turns"].get<double>(), std::abs(steps) / 4.0, 1e-9);
        largest = std::max(largest, std::abs(turn["stroke"].get<double>()));
    }
    EXPECT_EQ(document["touched"].get<size_t>(), document["turns"].size());  // in one pass
    EXPECT_NEAR(document["largest_stroke"].get<double>(), largest, 1e-12);
    EXPECT_EQ(lines("turns.csv").size(), document["turns"].size() + 1);
}

TEST_F(PlanCommand, HasARotationOnlyWhereTheThreadIsGiven) {
    const auto rotations_are = [&](const Words& options,
                                   const std::function<json(const json&)>& expected) {
        const json document = planned(options);
        const Words list = lines("turns.csv");
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
    EXPECT_EQ(plan({"--thread", "up"}).exit_code, 2);
}

/// The surface of hypar:6x6 as OBJ, in a unit [m] and moved up [m].
std::string roof_obj(double unit, double up) {
    constexpr int cells = 14;
    constexpr double side = 0.924;
    constexpr double rise = 0.231;
    std::string text;
    for (int i = 0; i <= cells; ++i) {
        for (int j = 0; j <= cells; ++j) {
            const double u = static_cast<double>(i) / cells;
            const double v = static_cast<double>(j) / cells;
            text += fmt::format("v {} {} {}\n", side * u / unit, side * v / unit,
                                (rise * ((1.0 - u) * (1.0 - v) + u * v) + up) / unit);
            if (i > 0 && j > 0) {
                const int at = i * (cells + 1) + j + 1;
                text += fmt::format("f {} {} {} {}\n", at - cells - 2, at - 1, at, at - cells - 1);
            }
        }
    }
    return text;
}

TEST_F(PlanCommand, TakesASurfaceAsTargetAndRefusesOneInAnotherUnit) {
    write("roof.obj", roof_obj(1e-3, 0.0));
    expect_refused({"--target", "roof.obj"}, "in mm it would fit");
    expect_refused({"--target", "built.csv", "--target-unit", "mm"}, "--target-unit");
    write("far.obj", roof_obj(1.0, 5.0));
    expect_refused({"--target", "far.obj"}, "far.obj: node '");
    write("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
    expect_refused({"--target", "cut.ply"}, "cut.ply:3: ");
    const json document = planned({"--target", "roof.obj", "--target-unit", "mm"});
    EXPECT_EQ(document["options"]["target"].get<std::string>(), "surface");
    EXPECT_LT(document["form"]["planned"]["normal_rmse"],
              document["form"]["as_built"]["normal_rmse"]);
}

TEST_F(PlanCommand, WeighsSingleNodesAndRefusesWrongWeights) {
    const json net = json::parse(read("net.json"));
    size_t free = 0;
    while (std::ranges::find(net["supports"], json(free)) != net["supports"].end()) {
        ++free;
    }
    const std::string id = std::to_string(free);
    const auto refused = [&](const std::string& line, const char* text) {
        write("weights.csv", "id,normal,tangential\n" + line + "\n");
        expect_refused({"--node-weights", "weights.csv"}, text);
    };
    refused("nowhere,1,1", "weights.csv:2: 'nowhere'");
    refused(id + ",1,1\n" + id + ",2,1", "weights.csv:3: ");
    refused(std::to_string(net["supports"][0].get<int>()) + ",1,1", "is a support");
    refused(id + ",-1,1", "-1 and 1");
    refused(id + ",1", "2 fields");
    const auto deviation = [&](const json& plan) {  // the largest of a coordinate
        double largest = 0.0;
        for (size_t k = 0; k < 3; ++k) {
            largest = std::max(largest, std::abs(plan["planned_form"][free][k].get<double>() -
                                                 plan["target_form"][free][k].get<double>()));
        }
        return largest;
    };
    const double before = deviation(planned({}));
    write("weights.csv", id + ",1000,1000\n");
    const json weighed = planned({"--node-weights", "weights.csv"});
    EXPECT_LT(deviation(weighed), 0.5 * before);
    EXPECT_EQ(weighed["options"]["node_weights"]["normal"][0], 1000.0);
    EXPECT_EQ(weighed["options"]["node_weights"]["tangential"][1], 0.1);
}

class PlanToTensions : public PlanCommand {
protected:
    /// The net gets the group "ridge" of two adjustable edges, and the file targets.csv.
    PlanToTensions() {
        json net = json::parse(read("net.json"));
        edges = {net["adjustable"][0], net["adjustable"][7]};
        std::ranges::sort(edges);
        net["groups"]["ridge"] = edges;
        write("net.json", net.dump());
        const json tensions = planned({})["tension"]["edges"];
        std::string text = "edge,tension,tolerance\n";
        for (const size_t edge : edges) {
            targets.push_back(1.1 * tensions[edge]["as_built"].get<double>());
            text += fmt::format("{},{},{}\n", tensions[edge]["edge"].get<int>(), targets.back(),
                                0.1 * targets.back());
        }
        write("targets.csv", text);
    }

    std::vector<size_t> edges;
    std::vector<double> targets;
};

TEST_F(PlanToTensions, ReachesThoseOfAFileAndReportsThemOverTheSamples) {
    const Outcome outcome =
        plan({"--target-tension", "targets.csv", "--turn", "2mm", "--step", "1/8"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("2 of 2 target tensions are within their tolerance, "
                                             "in the mean of the samples\n"),
                                   HasSubstr("  weighed: 5mm of form counts")));
    const json document = json::parse(read("plan.json"));
    ASSERT_EQ(document["target_tensions"].size(), 2U);
    for (size_t i = 0; i < 2; ++i) {
        const json& one = document["target_tensions"][i];
        EXPECT_EQ(one["edge"], edges[i]);
        EXPECT_NEAR(one["target"].get<double>(), targets[i], 1e-6);
        EXPECT_NEAR(one["mean"].get<double>(), targets[i], 0.1 * targets[i]);
        EXPECT_EQ(one["planned"], document["tension"]["edges"][edges[i]]["planned"]);
        EXPECT_EQ(one["as_built"], document["tension"]["edges"][edges[i]]["as_built"]);
        EXPECT_GT(one["std"].get<double>(), 0.0);
        EXPECT_GT(one["probability"].get<double>(), 0.1);
        EXPECT_EQ(one["obstacle"], "none");
    }
    EXPECT_EQ(document["options"]["form_tolerance"], 5e-3);
    EXPECT_TRUE(planned({})["options"]["form_tolerance"].is_null());
}

TEST_F(PlanToTensions, TakesForcesOfGroupsAndSaysWhatCannotBeReachedOrIsNotKnown) {
    const std::string force = fmt::format("{:.1f}N", targets[0]);
    const json ridge = planned({"--target-tension", force + ":0.01%@ridge", "--form-tolerance",
                                "100mm"})["target_tensions"];
    ASSERT_EQ(ridge.size(), 2U);
    EXPECT_NEAR(ridge[0]["tolerance"].get<double>(), 1e-4 * targets[0], 1e-2);
    EXPECT_THAT(plan({"--target-tension", force + ":0.01%@ridge"}).out,
                HasSubstr("The survey shows 2 of them no better than their tolerance"));
    // One force in all cables of a hypar is no equilibrium near its form.
    const Outcome all = plan({"--target-tension", force});
    EXPECT_EQ(all.exit_code, 0);
    EXPECT_THAT(all.out,
                HasSubstr("are missed: no strokes of these turnbuckles were found that reach all "
                          "targets, not even unlimited ones with any form"));
    identify({"--draws", "0", "-o", "result.json"});
    const Outcome estimate = plan({"--target-tension", force + "@ridge", "--csv", "turns.csv"});
    EXPECT_THAT(estimate.out, StartsWith("TARGET TENSIONS CANNOT BE PROMISED"));
    EXPECT_THAT(read("turns.csv"), StartsWith("# TARGET TENSIONS CANNOT BE PROMISED"));
    EXPECT_TRUE(json::parse(read("plan.json"))["target_tensions"][0]["mean"].is_null());
}

TEST_F(PlanToTensions, RefusesThoseThatContradictLimitsOrAreNone) {
    const std::string force = fmt::format("{:.1f}N", targets[0]);
    expect_refused({"--target-tension", force, "--tension", "..1N"},
                   "--target-tension of edge '0' is");
    expect_refused({"--target-tension", "0kN@ridge"}, "no edge may go slack");
    expect_refused({"--target-tension", "12kN@roof"}, "--target-tension names the group 'roof'");
    expect_refused({"--target-tension", "12mm"}, "'12mm' is no force");
    expect_refused({"--target-tension", "12kN:5mm"}, "'5mm' is no force");
    expect_refused({"--target-tension", "12kN:0%"}, "has the tolerance 0 N");
    expect_refused({"--target-tension", "missing.csv"}, "'missing.csv' is no force");
    expect_refused({"--form-tolerance", "2mm"}, "--form-tolerance weighs the form against");
    expect_refused({"--form-tolerance", "0mm", "--target-tension", force},
                   "--form-tolerance is 0mm, expected more than 0");
    expect_refused({"--weights", "normal:0,tangential:0"}, "all weights are 0");
    write("targets.csv", "edge,tension\n0,100\n0,200\n");
    expect_refused({"--target-tension", "targets.csv"}, "targets.csv:3: ");
    write("targets.csv", "edge,tension\n0,-100\n");
    expect_refused({"--target-tension", "targets.csv"}, "targets.csv:2: tension is '-100'");
    write("targets.csv", "edge,tension,tolerance\n0,100,0\n");
    expect_refused({"--target-tension", "targets.csv"}, "targets.csv:2: tolerance is '0'");
}

TEST_F(PlanCommand, TakesLimitsAsPartsOfBreakingLoads) {
    expect_refused({"--tension", "20%..60%"}, "breaking_load");
    const json free = planned({});
    const double most = free["tension"]["most"].get<double>();
    // An edge that carries the most may break at ten times that, others at a hundred times.
    json net = json::parse(read("net.json"));
    net["breaking_load"] = json::array();
    size_t heaviest = 0;
    for (const json& edge : free["tension"]["edges"]) {
        if (edge["planned"] == most) {
            heaviest = edge["edge"].get<size_t>();
        }
        net["breaking_load"].push_back((edge["planned"] == most ? 10.0 : 100.0) * most);
    }
    write("net.json", net.dump());
    expect_refused({"--tension", "20%"}, "expected a range");
    const json edges = planned({"--tension", "..9.5%", "--confidence", "50%"})["tension"]["edges"];
    EXPECT_NEAR(edges[heaviest]["limit_upper"].get<double>(), 0.95 * most, 1e-6);
    EXPECT_LT(edges[heaviest]["planned"].get<double>(), 0.95 * most * (1.0 + 1e-6));
    const size_t other = heaviest == 0 ? 1 : 0;
    EXPECT_NEAR(edges[other]["limit_upper"].get<double>(), 9.5 * most, 1e-6);
}

TEST_F(PlanCommand, LimitsTheTotalStrokeSinceInstallation) {
    const auto largest_reading = [](const json& document) {
        double largest = 0.0;
        for (const json& turn : document["turns"]) {
            largest = std::max(largest, std::abs(turn["reading_after"].get<double>()));
        }
        return largest;
    };
    ASSERT_GT(largest_reading(planned({})), 1e-3);
    EXPECT_LT(
        largest_reading(planned({"--total-stroke", "1mm", "--turn", "4mm", "--step", "1/16"})),
        1e-3 + 1e-9);
    expect_refused({"--total-stroke", "0mm"}, "--total-stroke is 0mm, expected more than 0");
}

TEST_F(PlanCommand, SuggestsAdjustableEdgesAndTargets) {
    identify({"--draws", "50", "--uncertain", "none", "-o", "result.json"});
    EXPECT_TRUE(planned({})["suggested_adjustable"].is_null());
    const Outcome outcome = plan({"--suggest-adjustable", "2", "--suggest-targets", "0.2mm"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("suggested further adjustable edges"),
                                   HasSubstr("surveyed to 0.2mm")));
    const json document = json::parse(read("plan.json"));
    double before = document["form"]["planned"]["normal_rmse"].get<double>();
    ASSERT_EQ(document["suggested_adjustable"].size(), 2U);
    for (const json& further : document["suggested_adjustable"]) {
        EXPECT_LT(further["normal_rmse_after"].get<double>(), before);
        before = further["normal_rmse_after"].get<double>();
    }
    EXPECT_EQ(plan({"--suggest-adjustable", "0"}).exit_code, 2);
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

TEST_F(PlanCommand, RefusesSamplesAndNetsOfAnotherResult) {
    identify({"--draws", "50", "--seed", "2", "-o", "other.json"});
    write("result_draws.h5", read("other_draws.h5"));
    expect_refused({}, "result_draws.h5:");
    must_run({"example", "hypar:6x5", "-o", "other_net.json"});
    expect_error(run({"plan", "other_net.json", "result.json", "-o", "plan.json"}), 2,
                 "result.json:");
    expect_error(run({"plan", "net.json", "net.json", "-o", "plan.json"}), 2, "net.json:/format");
}

TEST_F(PlanCommand, TakesLimitsOfGroups) {
    json net = json::parse(read("net.json"));
    for (size_t edge = 0; edge < net["edges"].size(); ++edge) {
        net["groups"]["whole"].push_back(edge);
    }
    write("net.json", net.dump());
    EXPECT_EQ(plan({"--tension", "..30kN@whole", "--tension", "20kN.."}).exit_code, 1);
    EXPECT_EQ(plan({"--reaction", "1kN@whole"}).exit_code, 1);
    const Outcome outcome = plan({"--tension", "20kN..", "--tension", "0kN..30kN@whole"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("All limits are kept with a probability of "),
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

TEST_F(PlanCommand, RefusesWrongOptionsAndFiles) {
    expect_refused({"--tension", "1kN..@ridge"}, "--tension names the group 'ridge'");
    expect_refused({"--turn", "5mm", "--step", "5/4"}, "--step is 1.25 of a turn");
    expect_refused({"--turn", "5mm", "--step", "1/0"}, "expected a part of a turn");
    expect_refused({"--step", "1/4"}, "--turn");
    expect_refused({"--stroke=-5mm"}, "--stroke is -5mm, expected more than 0");
    expect_refused({"--weights", "up:1"}, "expected weights");
    expect_refused({"--confidence", "100%"}, "confidence");
    expect_refused({"--crews", "0"}, "crews");
    write("edges.csv", "edge\n3\n3\n");
    expect_refused({"--adjustable", "edges.csv"}, "edges.csv");
    write("strokes.csv", "edge,shortest,longest\n0,0.001,0.002\n");
    expect_refused({"--stroke", "strokes.csv"}, "strokes.csv:2");
    const json interior = json::parse(read("result.json"))["edges"][0]["id"];
    write("strokes.csv",
          "edge,shortest,longest\n" + interior.get<std::string>() + ",-0.001,0.002\n");
    expect_refused({"--stroke", "strokes.csv"}, "which is not adjustable");
    write("wet.csv", "id,x,y,z\nnowhere,0,0,-1\n");
    expect_refused({"--check", "wet.csv"}, "wet.csv:2");
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
    expect_error(run({"control", "net.json", "-o", "jobs", "--trials", "0"}), 2, "trials");
    expect_error(run({"control", "net.json", "-o", "jobs", "--tension", "1%..5%"}), 2,
                 "expected forces");
}

}  // namespace
