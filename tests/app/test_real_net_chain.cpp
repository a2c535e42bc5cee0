// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the way of a steel net through every command.

#include <set>

#include "app/program.hpp"
#include "support/steel_roof.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;

using SteelRoofChain = ProgramTest;

TEST_F(SteelRoofChain, GoesThroughSamplingTrainingAndIdentificationWithItsSlackEdges) {
    const std::string prior = "uniform:5mm";  // by which most samples have slack edges
    write("roof.json", steel_roof_compas().dump());
    must_run({"import", "roof.json", "--young", "205GPa", "--diameter", "size", "--force-unit",
              "kN", "--loads", "balance", "-o", "net.json"});
    const json drawn = json::parse(
        must_run({"sample", "net.json", "-n", "30", "--prior", prior, "-o", "data.h5", "--json"}));
    EXPECT_EQ(drawn["net"]["interior_edges"], 536);
    EXPECT_EQ(drawn["not_converged"], 0);
    EXPECT_GT(drawn["with_slack"], 20);
    must_run({"train", "data.h5", "-o", "model.h5", "--quiet"});
    const json form =
        json::parse(must_run({"form", "net.json", "--prior", prior, "--seed", "3", "-o",
                              "built.csv", "--lengths", "truth.csv", "--json"}));
    const auto slack = form["slack_edges"].get<std::set<int>>();
    EXPECT_GT(slack.size(), 0U);
    const auto identify = [&](const Words& options) {
        return json::parse(
            must_run(joined({"identify", "net.json", "built.csv", "--json"}, options)))["edges"];
    };
    for (const json& edge : identify({"--model", "model.h5"})) {
        EXPECT_LE(edge["lower"], edge["length_deviation"]);
        EXPECT_LE(edge["length_deviation"], edge["upper"]);
    }
    const std::vector<double> truth = true_deviations();
    const json edges = identify({"--prior", prior, "--method", "balance"});
    ASSERT_EQ(edges.size(), truth.size());
    for (size_t i = 0; i < truth.size(); ++i) {
        const bool is_slack = slack.contains(edges[i]["edge"].get<int>());
        EXPECT_EQ(edges[i]["status"], is_slack ? "slack" : "determined") << edges[i];
        if (is_slack) {  // a lower bound
            EXPECT_GE(truth[i], edges[i]["lower"].get<double>() - 1e-9);
        } else {
            EXPECT_NEAR(edges[i]["length_deviation"].get<double>(), truth[i], 1e-9) << edges[i];
        }
    }
}

}  // namespace
