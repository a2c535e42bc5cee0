// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the way of a steel net through every command: of one of our own, and of the cable net of
// the HiLo roof as its designers published it. That file is not in this repository; without it, its
// tests are skipped.

#include <set>

#include "app/program.hpp"
#include "support/real_data.hpp"
#include "support/steel_roof.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;

struct Roof {
    std::string name;
    int interior_edges;
    std::string prior;  ///< by which most samples have slack edges
};

void PrintTo(const Roof& roof, std::ostream* stream) {
    *stream << roof.name;
}

class SteelRoofChain : public ProgramTest, public testing::WithParamInterface<Roof> {
protected:
    void SetUp() override {
        if (GetParam().name == "Hilo") {
            TAUT_NEEDS_REAL_FILE("hilo/cablenet.json");
            m_file = real_file("hilo/cablenet.json").string();
        } else {
            write("roof.json", steel_roof_compas().dump());
        }
    }

    [[nodiscard]] const std::string& file() const { return m_file; }

private:
    std::string m_file = "roof.json";
};

INSTANTIATE_TEST_SUITE_P(Of, SteelRoofChain,
                         testing::Values(Roof{"OurOwn", 536, "uniform:5mm"},
                                         Roof{"Hilo", 1511, "uniform:1mm"}),
                         [](const auto& roof) { return roof.param.name; });

TEST_P(SteelRoofChain, GoesThroughSamplingTrainingAndIdentificationWithItsSlackEdges) {
    must_run({"import", file(), "--young", "205GPa", "--diameter", "size", "--force-unit", "kN",
              "--loads", "balance", "-o", "net.json"});
    const json drawn = json::parse(must_run({"sample", "net.json", "-n", "30", "--prior",
                                             GetParam().prior, "-o", "data.h5", "--json"}));
    EXPECT_EQ(drawn["net"]["interior_edges"], GetParam().interior_edges);
    EXPECT_EQ(drawn["not_converged"], 0);
    EXPECT_GT(drawn["with_slack"], 20);
    must_run({"train", "data.h5", "-o", "model.h5", "--quiet"});
    const auto built = [&](const std::string& prior) {
        const json form =
            json::parse(must_run({"form", "net.json", "--prior", prior, "--seed", "3", "-o",
                                  "built.csv", "--lengths", "truth.csv", "--json"}));
        EXPECT_GT(form["slack_edges"].size(), 0U);
        return form["slack_edges"].get<std::set<int>>();
    };
    const auto identify = [&](const Words& options) {
        return json::parse(
            must_run(joined({"identify", "net.json", "built.csv", "--json"}, options)))["edges"];
    };
    built(GetParam().prior);
    for (const json& edge : identify({"--model", "model.h5"})) {
        EXPECT_LE(edge["lower"], edge["length_deviation"]);
        EXPECT_LE(edge["length_deviation"], edge["upper"]);
    }
    const std::set<int> slack = built("uniform:5mm");
    const std::vector<double> truth = true_deviations();
    const json edges = identify({"--prior", "uniform:5mm", "--method", "balance"});
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
