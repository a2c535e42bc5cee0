// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the way of a steel net through every command: one of our own, and the cable net of the
// HiLo roof as its designers published it, which is no part of this repository: where it is not
// there, its tests are skipped.

#include <cmath>
#include <set>

#include "app/program.hpp"
#include "support/real_data.hpp"
#include "support/steel_roof.hpp"
#include "taut/statics/cone_program.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;

struct Roof {
    std::string name;
    int interior_edges;
    double move;        ///< of a node, by the load [m]
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

    // Without its loads the net is told to be out of balance: a warning, no failure.
    void import_with_loads(const std::string& loads) const {
        const Outcome outcome = run({"import", m_file, "--young", "205GPa", "--diameter", "size",
                                     "--force-unit", "kN", "--loads", loads, "-o", "net.json"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }

    json form(const std::string& solver) const {
        return json::parse(run({"form", "net.json", "--solver", solver, "--json"}).out);
    }

private:
    std::string m_file = "roof.json";
};

INSTANTIATE_TEST_SUITE_P(Of, SteelRoofChain,
                         testing::Values(Roof{"OurOwn", 536, 0.0039, "uniform:5mm"},
                                         Roof{"Hilo", 1511, 0.0343, "uniform:1mm"}),
                         [](const auto& roof) { return roof.param.name; });

/// Of two points [m].
double distance(const json& a, const json& b) {
    double squares = 0.0;
    for (size_t k = 0; k < 3; ++k) {
        squares += std::pow(a[k].get<double>() - b[k].get<double>(), 2);
    }
    return std::sqrt(squares);
}

/// Of two forms' nodes [m].
double largest_distance(const json& a, const json& b) {
    double largest = 0.0;
    for (size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, distance(a[i], b[i]));
    }
    return largest;
}

TEST_P(SteelRoofChain, TakesTheSameFormByNewtonsMethodAndByTheConicSolver) {
    if (!taut::cone_solver_available()) {
        GTEST_SKIP() << "built without Clarabel";
    }
    for (const std::string loads : {"balance", "none"}) {
        import_with_loads(loads);
        const json newton = form("newton");
        const json socp = form("socp");
        EXPECT_LT(largest_distance(newton["form"], socp["form"]), 1e-6) << loads;
        EXPECT_NEAR(newton["energy"].get<double>() / socp["energy"].get<double>(), 1.0, 1e-9);
        // The designers' form, with its load; without it the net rises.
        EXPECT_NEAR(newton["largest_move"].get<double>(), loads == "none" ? GetParam().move : 0.0,
                    2e-4);
    }
}

TEST_P(SteelRoofChain, GoesThroughSamplingTrainingAndIdentificationAndItsSlackEdgesAreTold) {
    import_with_loads("balance");
    const json drawn = json::parse(must_run({"sample", "net.json", "-n", "30", "--prior",
                                             GetParam().prior, "-o", "data.h5", "--json"}));
    EXPECT_EQ(drawn["not_converged"], 0);
    EXPECT_GT(drawn["with_slack"], 20);
    must_run({"train", "data.h5", "-o", "model.h5", "--quiet"});
    // Of a net as built, some edges are slack.
    const json built = json::parse(must_run({"form", "net.json", "--prior", GetParam().prior,
                                             "--seed", "3", "-o", "built.csv", "--json"}));
    EXPECT_GT(built["slack_edges"].size(), 0U);
    const json result = json::parse(
        must_run({"identify", "net.json", "built.csv", "--model", "model.h5", "--json"}));
    ASSERT_EQ(result["edges"].size(), GetParam().interior_edges);
    for (const json& edge : result["edges"]) {
        EXPECT_LE(edge["lower"], edge["length_deviation"]);
        EXPECT_LE(edge["length_deviation"], edge["upper"]);
    }
}

TEST_P(SteelRoofChain, TellsTheSlackEdgesOfAnExactFormAndNoOthersAndNoMoreThanTheirMeasuredLength) {
    import_with_loads("balance");
    const json built =
        json::parse(must_run({"form", "net.json", "--prior", "uniform:5mm", "--seed", "3", "-o",
                              "built.csv", "--lengths", "truth.csv", "--json"}));
    const std::vector<double> truth = true_deviations();
    const json result = json::parse(must_run({"identify", "net.json", "built.csv", "--prior",
                                              "uniform:5mm", "--method", "balance", "--json"}));
    ASSERT_EQ(result["edges"].size(), truth.size());
    const std::set<int> truly_slack = built["slack_edges"];
    int slack = 0;
    for (size_t i = 0; i < truth.size(); ++i) {
        const json& edge = result["edges"][i];
        const bool is_slack = truly_slack.contains(edge["edge"].get<int>());
        EXPECT_EQ(edge["status"], is_slack ? "slack" : "determined") << edge;
        if (!is_slack) {
            EXPECT_NEAR(edge["length_deviation"].get<double>(), truth[i], 1e-9) << edge;
            continue;
        }
        ++slack;
        const double measured = distance(built["form"][edge["nodes"][0].get<size_t>()],
                                         built["form"][edge["nodes"][1].get<size_t>()]);
        EXPECT_NEAR(edge["lower"].get<double>(), measured - edge["nominal"].get<double>(), 1e-9);
        EXPECT_NEAR(edge["upper"].get<double>(), 5e-3, 1e-12);
        EXPECT_GE(truth[i], edge["lower"].get<double>() - 1e-9);
    }
    EXPECT_GT(slack, 5);
}

}  // namespace
