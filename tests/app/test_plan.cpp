// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the way from a result to a list of turns on the command line: keys that others read, a
// list that does what the plan says, and one line for each input that cannot be meant.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
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
        must_run({"form", "net.json", "--prior", "uniform:3mm", "--seed", "7", "-o", "built.csv",
                  "--lengths", "truth.csv"});
        must_run({"survey", "net.json", "built.csv", "--noise", "0.3mm", "-o", "survey.csv"});
        must_run({"identify", "net.json", "survey.csv", "--prior", "uniform:3mm", "--draws", "50",
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
    EXPECT_THAT(outcome.out, HasSubstr("no limits of tension or reaction were given\n"
                                       "no cable goes slack in"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("limits are kept")));
    const json document = json::parse(read("plan.json"));
    EXPECT_EQ(document["format"].get<std::string>(), "taut-plan");
    EXPECT_EQ(document["version"], 1);
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

/// The roof over all of the net as OBJ, its coordinates in a unit.
std::string roof_obj(const json& net, double unit, double up) {
    double low = 1e9;
    double high = -1e9;
    for (const json& node : net["nodes"]) {
        low = std::min(low, std::min(node[0].get<double>(), node[1].get<double>()));
        high = std::max(high, std::max(node[0].get<double>(), node[1].get<double>()));
    }
    const auto height = [&](double x, double y) {
        // The height of the nearest node.
        double nearest = 1e9;
        double z = 0.0;
        for (const json& node : net["nodes"]) {
            const double distance =
                std::hypot(node[0].get<double>() - x, node[1].get<double>() - y);
            if (distance < nearest) {
                nearest = distance;
                z = node[2].get<double>();
            }
        }
        return z + up;
    };
    std::ostringstream text;
    text.precision(17);
    constexpr int cells = 14;
    for (int i = 0; i <= cells; ++i) {
        for (int j = 0; j <= cells; ++j) {
            const double x = low + (high - low) * i / cells;
            const double y = low + (high - low) * j / cells;
            text << "v " << x / unit << ' ' << y / unit << ' ' << height(x, y) / unit << '\n';
        }
    }
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            const int at = i * (cells + 1) + j + 1;
            text << "f " << at << ' ' << at + cells + 1 << ' ' << at + cells + 2 << ' ' << at + 1
                 << '\n';
        }
    }
    return text.str();
}

TEST_F(PlanCommand, GoesForASurfaceAndRefusesOneInAnotherUnit) {
    const json net = json::parse(read("net.json"));
    write("roof.obj", roof_obj(net, 1e-3, 0.0));
    expect_refused({"--target", "roof.obj"}, "in mm it would fit");
    expect_refused({"--target", "built.csv", "--target-unit", "mm"}, "no surface");
    write("far.obj", roof_obj(net, 1.0, 5.0));
    expect_refused({"--target", "far.obj"}, "far.obj: node '");
    write("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
    expect_refused({"--target", "cut.ply"}, "cut.ply:3: ends within the header");
    const Outcome outcome = plan({"--target", "roof.obj", "--target-unit", "mm"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json document = json::parse(read("plan.json"));
    EXPECT_EQ(document["options"]["target"].get<std::string>(), "surface");
    EXPECT_LT(document["form"]["planned"]["normal_rmse"],
              document["form"]["as_built"]["normal_rmse"]);
}

TEST_F(PlanCommand, WeighsSingleNodesAndRefusesWeightsThatCannotBeMeant) {
    const json net = json::parse(read("net.json"));
    std::vector<char> is_support(net["nodes"].size());
    for (const json& node : net["supports"]) {
        is_support[node.get<size_t>()] = 1;
    }
    const auto free =
        static_cast<size_t>(std::ranges::find(is_support, char{0}) - is_support.begin());
    const auto support = net["supports"][0].get<int>();
    const auto refused = [&](const std::string& line, const char* text) {
        write("weights.csv", "id,normal,tangential\n" + line + "\n");
        expect_refused({"--node-weights", "weights.csv"}, text);
    };
    const std::string id = std::to_string(free);
    refused("nowhere,1,1", "weights.csv:2: 'nowhere' is no node");
    refused(id + ",1,1\n" + id + ",2,1", "weights.csv:3: names node");
    refused(std::to_string(support) + ",1,1", "is a support");
    refused(id + ",-1,1", "the weights are -1 and 1");
    refused(id + ",nan,1", "normal is 'nan'");
    refused(id + ",1", "has 2 fields");
    expect_refused({"--node-weights", "no.csv"}, "no.csv: cannot be read");

    const auto deviation = [&](const json& plan) {
        Eigen::Vector3d planned;
        Eigen::Vector3d sought;
        for (int k = 0; k < 3; ++k) {
            planned(k) = plan["planned_form"][free][k].get<double>();
            sought(k) = plan["target_form"][free][k].get<double>();
        }
        return (planned - sought).norm();
    };
    ASSERT_EQ(plan({}).exit_code, 0);
    const double before = deviation(json::parse(read("plan.json")));
    write("weights.csv", id + ",1000,1000\n");
    ASSERT_EQ(plan({"--node-weights", "weights.csv"}).exit_code, 0);
    const json weighed = json::parse(read("plan.json"));
    EXPECT_LT(deviation(weighed), 0.5 * before);
    EXPECT_EQ(weighed["options"]["node_weights"]["normal"][0], 1000.0);
    EXPECT_EQ(weighed["options"]["node_weights"]["tangential"][1], 0.1);
}

TEST_F(PlanCommand, TakesLimitsAsPartsOfBreakingLoads) {
    expect_refused({"--tension", "20%..60%"}, "breaking_load in N is missing");
    json net = json::parse(read("net.json"));
    ASSERT_EQ(plan({}).exit_code, 0);
    const json free = json::parse(read("plan.json"));
    const double most = free["tension"]["most"].get<double>();
    std::filesystem::remove(folder() / "plan.json");
    // An edge that carries the most may break at ten times that, others at a hundred times.
    net["breaking_load"] = json::array();
    size_t heaviest = 0;
    for (const json& edge : free["tension"]["edges"]) {
        if (edge["planned"] == most) {
            heaviest = edge["edge"].get<size_t>();
        }
        net["breaking_load"].push_back((edge["planned"] == most ? 10.0 : 100.0) * most);
    }
    write("net.json", net.dump());
    expect_refused({"--tension", "60%..20%"}, "an upper one above it");
    expect_refused({"--tension", "..120%"}, "no more than 100 %");
    expect_refused({"--tension", "20%"}, "expected a range");
    expect_refused({"--tension", "..-5%"}, "an upper one above it");
    const Outcome outcome = plan({"--tension", "..9.5%", "--confidence", "50%"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const json document = json::parse(read("plan.json"));
    const json& edges = document["tension"]["edges"];
    EXPECT_NEAR(edges[heaviest]["limit_upper"].get<double>(), 0.95 * most, 1e-6);
    EXPECT_LT(edges[heaviest]["planned"].get<double>(), 0.95 * most * (1.0 + 1e-6));
    const size_t other = heaviest == 0 ? 1 : 0;
    EXPECT_NEAR(edges[other]["limit_upper"].get<double>(), 9.5 * most, 1e-6);
    expect_error(run({"control", "net.json", "-o", "jobs", "--tension", "1%..5%"}), 2,
                 "expected forces");
}

TEST_F(PlanCommand, TellsARotationOnlyWhereTheThreadIsTold) {
    const auto rotations_are = [&](const std::function<json(const json&)>& expected) {
        const json document = json::parse(read("plan.json"));
        EXPECT_FALSE(document["turns"].empty());
        std::istringstream list(read("turns.csv"));
        std::string line;
        std::getline(list, line);
        for (const json& turn : document["turns"]) {
            const json rotation = expected(turn);
            EXPECT_EQ(turn["rotation"], rotation);
            std::getline(list, line);
            EXPECT_THAT(line,
                        HasSubstr("," + turn["action"].get<std::string>() + "," +
                                  (rotation.is_null() ? "" : rotation.get<std::string>()) + ","));
        }
    };
    const auto by = [](const json& turn, bool is_right) {
        return (turn["stroke"].get<double>() < 0.0) == is_right ? "clockwise" : "counterclockwise";
    };
    ASSERT_EQ(plan({"--csv", "turns.csv"}).exit_code, 0);
    rotations_are([](const json&) { return json(); });
    EXPECT_TRUE(json::parse(read("plan.json"))["options"]["thread"].is_null());
    json net = json::parse(read("net.json"));
    std::map<int, bool> is_right;
    for (const json& edge : net["adjustable"]) {
        is_right[edge.get<int>()] = is_right.size() % 3 == 0;
        net["thread"].push_back(is_right[edge.get<int>()] ? "right" : "left");
    }
    write("net.json", net.dump());
    ASSERT_EQ(plan({"--csv", "turns.csv"}).exit_code, 0);
    rotations_are([&](const json& turn) { return by(turn, is_right[turn["edge"].get<int>()]); });
    ASSERT_EQ(plan({"--csv", "turns.csv", "--thread", "left"}).exit_code, 0);
    rotations_are([&](const json& turn) { return by(turn, false); });
    EXPECT_EQ(json::parse(read("plan.json"))["options"]["thread"], "left");
    EXPECT_EQ(plan({"--thread", "up"}).exit_code, 2);
}

TEST_F(PlanCommand, HoldsTheTotalStrokeSinceInstallation) {
    // The net is told as designed with one turnbuckle 4 mm longer than it is built.
    ASSERT_EQ(plan({}).exit_code, 0);
    const json free = json::parse(read("plan.json"));
    double most = 0.0;
    for (const json& turn : free["turns"]) {
        most = std::max(most, std::abs(turn["reading_after"].get<double>()));
    }
    ASSERT_GT(most, 1e-3);
    ASSERT_EQ(plan({"--total-stroke", "1mm", "--turn", "4mm", "--step", "1/16"}).exit_code, 0);
    const json document = json::parse(read("plan.json"));
    for (const json& turn : document["turns"]) {
        EXPECT_LT(std::abs(turn["reading_after"].get<double>()), 1e-3 + 1e-9);
    }
    std::filesystem::remove(folder() / "plan.json");
    expect_refused({"--total-stroke", "0mm"}, "--total-stroke is '0mm', expected more than 0");
    expect_refused({"--total-stroke=-3mm"}, "expected more than 0");
    expect_refused({"--total-stroke", "lots"}, "lots");
    // Where an interior cable may be recut, its deviation counts as its reading.
    const json result = json::parse(read("result.json"));
    double deviation = 0.0;
    int edge = 0;
    for (const json& one : result["edges"]) {
        if (std::abs(one["length_deviation"].get<double>()) > std::abs(deviation)) {
            deviation = one["length_deviation"].get<double>();
            edge = one["edge"].get<int>();
        }
    }
    ASSERT_GT(std::abs(deviation), 1e-3);
    write("edges.csv", std::to_string(edge) + "\n");
    expect_refused({"--adjustable", "edges.csv", "--total-stroke", "1mm"},
                   "from its designed length already");
    EXPECT_EQ(plan({"--adjustable", "edges.csv", "--total-stroke", "4mm"}).exit_code, 0);
    const json limited = json::parse(read("plan.json"));
    for (const json& turn : limited["turns"]) {
        EXPECT_LT(std::abs(turn["reading_after"].get<double>()), 4e-3 + 1e-9);
        EXPECT_NEAR(turn["reading_after"].get<double>(), deviation + turn["stroke"].get<double>(),
                    1e-9);
    }
}

TEST_F(PlanCommand, TellsFurtherEdgesThatWouldHelp) {
    must_run({"identify", "net.json", "survey.csv", "--prior", "uniform:3mm", "--draws", "50",
              "--uncertain", "none", "-o", "result.json"});
    ASSERT_EQ(plan({}).exit_code, 0);
    EXPECT_TRUE(json::parse(read("plan.json"))["suggested_adjustable"].is_null());
    const Outcome outcome = plan({"--suggest-adjustable", "2"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("further edges that would help most"));
    const json document = json::parse(read("plan.json"));
    double before = document["form"]["planned"]["normal_rmse"].get<double>();
    ASSERT_EQ(document["suggested_adjustable"].size(), 2U);
    for (const json& further : document["suggested_adjustable"]) {
        EXPECT_EQ(further["edge_id"], std::to_string(further["edge"].get<int>()));
        EXPECT_LT(std::abs(further["stroke"].get<double>()), 15e-3 + 1e-9);
        EXPECT_LT(further["normal_rmse_after"].get<double>(), before);
        before = further["normal_rmse_after"].get<double>();
    }
    EXPECT_EQ(plan({"--suggest-adjustable", "0"}).exit_code, 2);
    EXPECT_EQ(plan({"--suggest-adjustable", "many"}).exit_code, 2);
}

TEST_F(PlanCommand, HoldsLimitsForTheEstimateAloneWithoutDraws) {
    must_run({"identify", "net.json", "survey.csv", "--prior", "uniform:3mm", "--draws", "0", "-o",
              "bare.json"});
    const Outcome outcome = run({"plan", "net.json", "bare.json", "-o", "plan.json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("by the estimate, which cannot be promised, since the "
                                       "result was made without draws\n"));
    EXPECT_THAT(outcome.out, HasSubstr("no cable goes slack by the estimate"));
    // Draws of a result that stood there before are not taken for its own.
    must_run({"identify", "net.json", "survey.csv", "--prior", "uniform:3mm", "--draws", "0", "-o",
              "result.json"});
    ASSERT_TRUE(exists("result_draws.h5"));
    EXPECT_EQ(json::parse(must_run(
                  {"plan", "net.json", "result.json", "-o", "plan.json", "--json"}))["draws"],
              0);
}

TEST_F(PlanCommand, RefusesDrawsOfAnotherResult) {
    must_run({"identify", "net.json", "survey.csv", "--prior", "uniform:3mm", "--draws", "50",
              "--seed", "2", "-o", "other.json"});
    write("result_draws.h5", read("other_draws.h5"));
    expect_refused({}, "result_draws.h5: holds draws of another result than");
}

TEST_F(PlanCommand, HoldsWhatAGroupIsNotToldByTheLimitOfAll) {
    json net = json::parse(read("net.json"));
    for (size_t edge = 0; edge < net["edges"].size(); ++edge) {
        net["groups"]["whole"].push_back(edge);
    }
    write("net.json", net.dump());
    for (const auto& options :
         {std::vector<std::string>{"--tension", "20kN..", "--tension", "..30kN@whole"},
          {"--tension", "..30kN@whole", "--tension", "20kN.."}}) {
        EXPECT_EQ(plan(options).exit_code, 1);
    }
    EXPECT_EQ(plan({"--tension", "20kN..", "--tension", "0kN..30kN@whole"}).exit_code, 0);
}

// Cables that are slack and are turned taut: draws of their lengths can lie where the estimate does
// not, and keep limits that it breaks.
TEST_F(PlanCommand, IsNotFeasibleWhereItsOwnEstimateBreaksALimit) {
    must_run({"example", "hypar:7x7", "-o", "net.json"});
    json net = json::parse(read("net.json"));
    for (const size_t edge : {9, 10, 24, 25, 40, 41}) {
        net["unstressed_lengths"][edge] = 1.06 * net["unstressed_lengths"][edge].get<double>();
    }
    write("net.json", net.dump());
    // With a warning: the nodes of the file are not the form of such lengths.
    const Outcome form =
        run({"form", "net.json", "--prior", "uniform:5mm", "--seed", "3", "-o", "built.csv"});
    ASSERT_EQ(form.exit_code, 0) << form.err;
    must_run(
        {"survey", "net.json", "built.csv", "--noise", "0.5mm", "--seed", "3", "-o", "survey.csv"});
    must_run({"identify", "net.json", "survey.csv", "--uncertain", "none", "-o", "result.json"});
    const Outcome outcome = plan({"--tension", "1kN.."});
    const json document = json::parse(read("plan.json"));
    ASSERT_LT(document["tension"]["least"].get<double>(), 1e3);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
    EXPECT_FALSE(document["feasible"].get<bool>());
    EXPECT_LT(document["violations"][0]["value"].get<double>(), 1e3);
}

TEST_F(PlanCommand, MarksAListByWhichLimitsAreBroken) {
    ASSERT_EQ(plan({"--tension", "20kN..", "--csv", "turns.csv"}).exit_code, 1);
    EXPECT_THAT(read("turns.csv"), testing::StartsWith("# DO NOT TURN BY THIS LIST"));
    EXPECT_FALSE(json::parse(read("plan.json"))["order"]["safe"].get<bool>());
}

TEST_F(PlanCommand, RefusesAFailedIdentificationUnlessThatIsAccepted) {
    // 0.3 mm of noise, taken for 0.1 mm.
    std::istringstream survey(read("survey.csv"));
    std::string bare;
    for (std::string line; std::getline(survey, line);) {
        size_t end = 0;
        for (int comma = 0; comma < 4; ++comma) {
            end = line.find(',', end + 1);
        }
        bare += line.substr(0, end) + "\n";
    }
    write("bare.csv", bare);
    ASSERT_EQ(run({"identify", "net.json", "bare.csv", "--noise", "0.1mm", "--prior", "uniform:3mm",
                   "--draws", "50", "-o", "result.json"})
                  .exit_code,
              0);
    const json result = json::parse(read("result.json"));
    ASSERT_EQ(result["trust"]["verdict"], "failed");
    const std::string reason = result["findings"][0]["reason"];
    const Outcome refused = plan({"--csv", "turns.csv"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, testing::StartsWith("taut: error: result.json: the identification "
                                                 "failed its tests: " +
                                                 reason));
    EXPECT_THAT(refused.err, HasSubstr("--accept-failed"));
    EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1);
    EXPECT_FALSE(exists("plan.json"));
    EXPECT_FALSE(exists("turns.csv"));
    const Outcome accepted = plan({"--csv", "turns.csv", "--accept-failed"});
    ASSERT_EQ(accepted.exit_code, 0) << accepted.err;
    const std::string first = "DO NOT TURN BY THIS LIST: the identification failed its tests: ";
    EXPECT_THAT(accepted.out, testing::StartsWith(first + reason));
    EXPECT_THAT(read("turns.csv"), testing::StartsWith("# " + first + reason));
    EXPECT_THAT(json::parse(read("plan.json"))["warnings"][0].get<std::string>(),
                testing::StartsWith(first));
}

// Where the free strokes hold their limits without a margin, whole steps must not go right up to
// them.
TEST_F(PlanCommand, KeepsTheConfidenceOfFreeStrokesInWholeSteps) {
    must_run({"identify", "net.json", "survey.csv", "--prior", "uniform:3mm", "--draws", "50",
              "--uncertain", "none", "-o", "result.json"});
    for (const char* tension : {"2.2kN..", "2.4kN.."}) {
        ASSERT_EQ(plan({"--tension", tension}).exit_code, 0);
        const Outcome outcome = plan({"--tension", tension, "--turn", "5mm", "--step", "1/4"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        const json document = json::parse(read("plan.json"));
        EXPECT_GE(document["tension"]["limit_probability"].get<double>(), 49.0 / 50.0);
        EXPECT_GE(document["order"]["safe_probability"].get<double>(), 49.0 / 50.0);
    }
}

TEST_F(PlanCommand, SaysHowSurelyItsOrderIsSafe) {
    const Outcome outcome = plan({"--tension", "2kN.."});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("all limits are kept in"));
    EXPECT_THAT(outcome.out, HasSubstr("probability that no step breaks a limit: "));
    EXPECT_TRUE(json::parse(read("plan.json"))["limits_given"].get<bool>());
}

TEST_F(PlanCommand, EndsWithOneWhereLimitsCannotBeKeptAndNamesThem) {
    const Outcome outcome = plan({"--tension", "20kN.."});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("no strokes were found that keep all limits"));
    EXPECT_FALSE(json::parse(read("plan.json"))["feasible"].get<bool>());
    EXPECT_FALSE(json::parse(read("plan.json"))["violations"].empty());
}

TEST_F(PlanCommand, HoldsLimitsOverDrawsOfAllThatIsUncertain) {
    const auto spread_of = [this](const std::vector<std::string>& uncertain) {
        std::vector<std::string> command{"identify", "net.json",    "survey.csv",
                                         "--prior",  "uniform:3mm", "--draws",
                                         "50",       "-o",          "result.json"};
        command.insert(command.end(), uncertain.begin(), uncertain.end());
        must_run(command);
        const Outcome outcome = plan({});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_THAT(outcome.out, HasSubstr("of 50 draws"));
        const json edge = json::parse(read("plan.json"))["tension"]["edges"][0];
        return (edge["upper"].get<double>() - edge["lower"].get<double>()) /
               edge["planned"].get<double>();
    };
    const double exact = spread_of({"--uncertain", "none"});
    EXPECT_GT(spread_of({"--uncertain", "none", "--uncertain", "adjustable:0.5mm"}), exact);
    // EA to 5 % is tensions to 5 %, 95 % of them within twice that.
    EXPECT_GT(spread_of({"--uncertain", "none", "--uncertain", "stiffness:5%"}), 0.12);
}

TEST_F(PlanCommand, PromisesNoLimitsWithoutDraws) {
    must_run({"identify", "net.json", "survey.csv", "--prior", "uniform:3mm", "--draws", "0", "-o",
              "result.json"});
    const Outcome outcome = plan({"--tension", "0.1kN..", "--csv", "turns.csv"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("LIMITS CANNOT BE PROMISED"));
    const json document = json::parse(read("plan.json"));
    EXPECT_TRUE(document["tension"]["limit_probability"].is_null());
    const std::string list = read("turns.csv");
    EXPECT_THAT(list, testing::StartsWith("# LIMITS CANNOT BE PROMISED"));
    std::istringstream lines(list);
    int turns = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("1,")) {
            EXPECT_TRUE(line.ends_with(",")) << line;
            ++turns;
        }
    }
    EXPECT_GT(turns, 0);
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
    const json interior = json::parse(read("result.json"))["edges"][0]["id"];
    write("strokes.csv",
          "edge,shortest,longest\n" + interior.get<std::string>() + ",-0.001,0.002\n");
    expect_refused({"--stroke", "strokes.csv"}, "which is not adjustable");
    write("wet.csv", "id,x,y,z\nnowhere,0,0,-1\n");
    expect_refused({"--check", "wet.csv"}, "wet.csv:2");
}

TEST_F(PlanCommand, IsTriedOverWholeJobsByControl) {
    const std::string told =
        must_run({"control", "net.json", "-o", "jobs", "--prior", "uniform:2mm", "--noise", "0.2mm",
                  "--draws", "50", "--rounds", "1", "--trials", "2"});
    EXPECT_THAT(told, HasSubstr("identified"));
    const json document = json::parse(read("jobs/control.json"));
    EXPECT_EQ(document["format"].get<std::string>(), "taut-control");
    // As on a site, unless it is given.
    EXPECT_EQ(document["settings"]["uncertain"],
              json({"stiffness:5%", "stiffness-each:2%", "adjustable:0.5mm", "supports:1mm"}));
    EXPECT_EQ(document["strategies"].size(), 4U);
    EXPECT_EQ(document["strategies"][1]["states"].size(), 4U);
    EXPECT_THAT(read("jobs/control.csv"), testing::StartsWith("strategy,trial,round,mean"));
    if (taut::has_report_viewer()) {
        const std::string page = read("jobs/report.html");
        must_run({"report", "jobs/control.json", "-o", "again.html"});
        EXPECT_EQ(read("again.html"), page);
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
