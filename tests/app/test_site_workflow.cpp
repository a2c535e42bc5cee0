// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the way from a survey as it comes from site (noisy, partial, without names, in the frame
// of the instrument) to lengths: a target on a wrong node, or an interval that does not hold.

#include <cmath>
#include <sstream>

#include "app/program.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;

class SiteWorkflow : public ProgramTest {
protected:
    SiteWorkflow() {
        must_run({"example", "hilo-quarter", "-o", "net.json"});
        must_run({"form", "net.json", "--prior", "uniform:5mm", "--seed", "7", "-o", "built.csv",
                  "--lengths", "truth.csv"});
    }

    void survey(std::vector<std::string> options) const {
        options.insert(options.begin(), {"survey", "net.json", "built.csv", "-o", "survey.csv"});
        must_run(options);
    }

    json identify(std::vector<std::string> options = {}) const {
        options.insert(options.begin(), {"identify", "net.json", "survey.csv", "--json"});
        return json::parse(must_run(options));
    }

    void expect_truth_within(const json& result, double rms, double least_coverage) const {
        const std::vector<double> deviations = true_deviations();
        ASSERT_EQ(result["edges"].size(), deviations.size());
        double squares = 0.0;
        double inside = 0.0;
        for (size_t i = 0; i < deviations.size(); ++i) {
            const json& edge = result["edges"][i];
            const double error = edge["length_deviation"].get<double>() - deviations[i];
            squares += error * error;
            inside += edge["lower"] <= deviations[i] && deviations[i] <= edge["upper"] ? 1 : 0;
            // The bounds of a prior are not sharp: its scale and mean are uncertain.
            EXPECT_GE(edge["lower"], -0.0055);
            EXPECT_LE(edge["upper"], 0.0055);
        }
        const auto count = static_cast<double>(deviations.size());
        EXPECT_LT(std::sqrt(squares / count), rms);
        EXPECT_GE(inside / count, least_coverage);
    }
};

TEST_F(SiteWorkflow, FindsTheLengthsBehindAnExactSurvey) {
    survey({});
    const json result = identify();
    EXPECT_EQ(result["method"], "balance");
    expect_truth_within(result, 1e-10, 0.95);
}

TEST_F(SiteWorkflow, FindsTheLengthsBehindANoisyPartialSurveyWithoutNamesInAnotherFrame) {
    survey({"--noise", "0.5mm", "--drop", "10%", "--shuffle", "--frame", "random"});
    const json result = identify();
    EXPECT_EQ(result["method"], "map");
    EXPECT_EQ(result["survey"]["used"], 270);
    EXPECT_EQ(result["survey"]["missing"], 30);
    // The best possible is some 0.8 mm with a tenth of the nodes hidden; of 536 intervals of 95 %
    // fewer than 92 % hold once in a thousand times.
    expect_truth_within(result, 1.0e-3, 0.92);
}

TEST_F(SiteWorkflow, SaysWhereTheFileTellsAnotherNoiseThanTheOption) {
    survey({"--noise", "0.5mm"});
    const auto told_with = [&](const std::string& noise) {
        return must_run({"identify", "net.json", "survey.csv", "--noise", noise, "-o", "r.json"});
    };
    const std::string differs = "not --noise 2mm: the file tells the noise of 300 of these";
    EXPECT_NE(told_with("2mm").find(differs), std::string::npos);
    EXPECT_EQ(told_with("0.5mm").find("not --noise"), std::string::npos);
}

TEST_F(SiteWorkflow, SaysWhichNoiseWouldFitWhereTheOneToldDoesNot) {
    survey({"--noise", "0.5mm"});
    std::istringstream lines(read("survey.csv"));
    std::string text;
    for (std::string line; std::getline(lines, line);) {  // without sx, sy, sz
        for (int k = 0; k < 3; ++k) {
            line.resize(line.rfind(','));
        }
        text += line + "\n";
    }
    write("survey.csv", text);
    const auto told = [&](const std::string& noise) {
        return must_run({"identify", "net.json", "survey.csv", "--noise", noise, "-o", "r.json"});
    };
    EXPECT_NE(told("0.3mm").find("times the standard deviation given, 0.3mm."), std::string::npos);
    EXPECT_NE(told("1mm").find("times the standard deviation given, 1mm."), std::string::npos);
    EXPECT_NE(told("0.5mm").find("checks: passed\n"), std::string::npos);
    EXPECT_NE(told("estimate").find("checks: passed"), std::string::npos);
    EXPECT_NEAR(json::parse(read("r.json"))["noise"].get<double>(), 0.5e-3, 0.05e-3);
}

TEST_F(SiteWorkflow, FindsATargetThatSomebodyMoved) {
    survey({"--noise", "0.5mm"});
    std::istringstream lines(read("survey.csv"));
    std::string moved;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("40,")) {
            // Its height, 50 mm higher.
            size_t z = line.find(',', line.find(',', line.find(',') + 1) + 1) + 1;
            const size_t end = line.find(',', z);
            line.replace(z, end - z, std::to_string(std::stod(line.substr(z)) + 0.05));
        }
        moved += line + "\n";
    }
    write("survey.csv", moved);
    const json result = identify();
    ASSERT_EQ(result["survey"]["outliers"].size(), 1U);
    EXPECT_EQ(result["survey"]["outliers"][0]["node"], 40);
    expect_truth_within(result, 1.0e-3, 0.92);
}

TEST_F(SiteWorkflow, TellsTensionsWithIntervalsAndKeepsTheDraws) {
    survey({"--noise", "0.5mm", "--drop", "10%"});
    const std::string told = must_run({"identify", "net.json", "survey.csv", "-o", "r.json"});
    EXPECT_NE(told.find("mean tension: "), std::string::npos);
    EXPECT_NE(told.find("written to r_draws.h5: 200 draws"), std::string::npos);
    EXPECT_TRUE(exists("r_draws.h5"));
    const json result = json::parse(read("r.json"));
    EXPECT_EQ(result["draws"]["count"], 200);
    EXPECT_EQ(result["draws"]["reason"], nullptr);
    EXPECT_EQ(result["adjustable_edges"].size(), 128U);
    EXPECT_EQ(result["missing_places"].size(), 30U);
    for (const json& edge : result["edges"]) {
        ASSERT_LE(edge["tension_lower"], edge["tension"]);
        ASSERT_LE(edge["tension"], edge["tension_upper"]);
        EXPECT_EQ(edge["slack_probability"], 0.0);
    }
    const json none = identify({"--draws", "0", "-o", "none.json"});
    EXPECT_EQ(none["draws"], nullptr);
    EXPECT_EQ(none["edges"][0]["tension"], nullptr);
    EXPECT_FALSE(exists("none_draws.h5"));
}

TEST_F(SiteWorkflow, RefusesASurveyInMillimetres) {
    survey({});
    std::istringstream lines(read("survey.csv"));
    std::string text;
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::istringstream fields(line);
        std::string field;
        std::getline(fields, field, ',');
        text += field;
        while (std::getline(fields, field, ',')) {
            text += "," + std::to_string(1000.0 * std::stod(field));
        }
        text += "\n";
    }
    write("survey.csv", text);
    expect_error(run({"identify", "net.json", "survey.csv"}), 2,
                 "survey.csv: the control points are measured 1000 times as far apart as they are");
}

TEST_F(SiteWorkflow, RefusesHiddenNodesWithoutNoise) {
    survey({"--drop", "10%"});
    expect_error(run({"identify", "net.json", "survey.csv"}), 2,
                 "holds 270 of 300 free nodes, expected all, or their noise");
}

TEST_F(SiteWorkflow, RefusesTooFewSupportsToFindTheFrame) {
    write("survey.csv", "0,1,2,3\n");
    expect_error(run({"identify", "net.json", "survey.csv", "--frame", "supports"}), 2,
                 "survey.csv: holds 0 named supports or control points, expected at least 3");
}

}  // namespace
