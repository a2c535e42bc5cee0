// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against commands that do not fit together: a file that the next one cannot read, a number
// lost between a net and its identified lengths.

#include <cmath>

#include "app/program.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/io/net_json.hpp"
#include "taut/io/read_survey.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/statics/cone_program.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using nlohmann::json;
using testing::HasSubstr;

class Chain : public ProgramTest {
protected:
    Chain() { must_have_run({{"example", "hypar:3x4", "-o", "net.json"}}); }

    void survey() const {
        must_run({"form", "net.json", "--prior", "uniform:2mm", "-o", "form.csv"});
        must_run({"survey", "net.json", "form.csv", "--noise", "0.5mm", "-o", "survey.csv"});
    }

    const CableNet m_net = hypar(3, 4);
};

TEST_F(Chain, ExampleWritesTheBuiltInNetAndInspectShowsIt) {
    const CableNet written = read_net(folder() / "net.json").net;
    EXPECT_EQ(written.fingerprint(), m_net.fingerprint());
    EXPECT_EQ(written.name(), "hypar:3x4");
    const std::string text = must_run({"inspect", "net.json"});
    for (const std::string& words :
         {std::string("12 free nodes, 14 supports, 17 interior and 14 adjustable edges"),
          m_net.fingerprint(), std::string("slack edges: 0")}) {
        EXPECT_THAT(text, HasSubstr(words));
    }
    const json it = json::parse(must_run({"inspect", "net.json", "--json"}));
    EXPECT_EQ(it["net"]["free_nodes"], 12);
    EXPECT_EQ(it["mechanisms"].get<int>(),
              36 - (31 - it["self_stress_states"].get<int>()));  // 3 n_I less rank, m = 31
    EXPECT_EQ(it["identifiability"]["determined"], 17);
    EXPECT_EQ(it["most_sensitive_edges"].size(), 10U);
    EXPECT_LT(it["equilibrium"]["relative_gap"].get<double>(), 1e-12);
    EXPECT_FALSE(it.contains("left_out"));
}

TEST_F(Chain, FormIsTheSameByNewtonsMethodAndByTheConeProgram) {
    write("form.csv", "something else\n");
    EXPECT_THAT(must_run({"form", "net.json", "-o", "form.csv"}), HasSubstr("converged"));
    EXPECT_EQ(read_form(m_net, folder() / "form.csv").cols(), m_net.node_count());
    EXPECT_EQ(files().size(), 2U) << "temporary files were left";
    const json newton = json::parse(must_run({"form", "net.json", "--json"}));
    EXPECT_LT(newton["relative_gap"].get<double>(), 1e-12);
    const double energy = newton["energy"].get<double>();
    for (const std::string cone_form : {"quadratic", "paper"}) {
        const std::vector<std::string> socp{"form",        "net.json", "--solver", "socp",
                                            "--cone-form", cone_form,  "--json"};
        if (!cone_solver_available()) {
            expect_error(run(socp), 2, "without the conic solver");
            continue;
        }
        const json cone = json::parse(must_run(socp));
        EXPECT_EQ(cone["cone_program"]["form"], cone_form);
        EXPECT_NEAR(cone["energy"].get<double>(), energy, 1e-8 * energy);
        EXPECT_LT(cone["largest_move"].get<double>(), 1e-5);
    }
}

TEST_F(Chain, SampleWritesWhatTheLibraryDrawsOnAnyNumberOfThreads) {
    const Words sample{"sample",     "net.json", "-n", "30",          "--prior",
                       "normal:1mm", "--seed",   "7",  "--uncertain", "supports:1mm"};
    must_run(joined(sample, {"-o", "data.h5"}));
    const DataSet data = read_data_set(folder() / "data.h5").data;
    const Sampler sampler(m_net, parse_length_prior("normal:1mm"), 7,
                          {parse_uncertain_parameter("supports:1mm")});
    DataSet expected = sampler.no_samples();
    sampler.extend_to(expected, 30);
    EXPECT_EQ(data.length_deviations, expected.length_deviations);
    EXPECT_EQ(data.form_deviations, expected.form_deviations);
    EXPECT_FALSE(exists("data.h5.partial"));
    must_run(joined(sample, {"-o", "one.h5", "--threads", "1"}));
    EXPECT_EQ(read("one.h5"), read("data.h5"));
    must_run({"train", "data.h5", "-o", "model.h5"});
    must_run({"train", "data.h5", "-o", "one_model.h5", "--threads", "1"});
    EXPECT_EQ(read("one_model.h5"), read("model.h5"));
    expect_error(run({"sample", "net.json", "-n", "50", "--prior", "normal:1mm", "--seed", "7",
                      "--resume", "-o", "data.h5"}),
                 2, "supports:1mm, expected none to resume");
    must_run({"form", "net.json", "-o", "form.csv"});
    EXPECT_THAT(
        must_run({"identify", "net.json", "form.csv", "--noise", "0.5mm", "--model", "model.h5"}),
        HasSubstr("supports:1mm"));
}

TEST_F(Chain, IdentifyAssumesWhatIsNotGivenAndSaysSo) {
    survey();
    const auto assumed = [this](const Words& uncertain) {
        const std::string text = must_run(
            joined({"identify", "net.json", "survey.csv", "--draws", "0", "-o", "result.json"},
                   uncertain));
        Words values;
        const json result = json::parse(read("result.json"));
        for (const json& one : result["assumptions"]) {
            values.push_back(one["value"].get<std::string>() + " " +
                             one["source"].get<std::string>());
            EXPECT_THAT(text, HasSubstr(one["value"].get<std::string>()));
        }
        return values;
    };
    EXPECT_EQ(assumed({"--uncertain", "stiffness:20%"}),
              (Words{"stiffness:20% given", "stiffness-each:2% default", "adjustable:0.5mm default",
                     "supports:1mm default"}));
    EXPECT_TRUE(assumed({"--uncertain", "none"}).empty());
    const std::string printed = must_run(
        {"identify", "net.json", "survey.csv", "--draws", "0", "-o", "result.json", "--json"});
    EXPECT_EQ(printed, read("result.json"));
}

TEST_F(Chain, IdentifyTakesForceMeasurementsAndUncertainParameters) {
    survey();
    const json plain = json::parse(must_run({"inspect", "net.json", "--json"}));
    write("forces.csv", "edge,tension\n3," +
                            std::to_string(plain["tensions"]["mean"].get<double>() / 1000.0) +
                            "\n");
    const std::string text = must_run(
        {"identify", "net.json", "survey.csv", "--prior", "uniform:2mm", "--forces", "forces.csv",
         "--force-unit", "kN", "--force-noise", "50%", "--uncertain", "none", "--uncertain",
         "stiffness:5%", "--uncertain", "supports:1mm", "-o", "result.json"});
    EXPECT_THAT(text, HasSubstr("force measurements: 1, of which 0 not used"));
    EXPECT_THAT(text, HasSubstr("stiffness:5%: "));
    EXPECT_THAT(text, Not(HasSubstr("assumed exact")));  // there are no loads
    const json result = json::parse(read("result.json"));
    EXPECT_EQ(result["forces"]["measurements"], 1);
    ASSERT_GT(result["uncertain"].size(), 1U);
    EXPECT_EQ(result["uncertain"][0]["name"], "stiffness");
    EXPECT_EQ(result["uncertain"][1]["axis"], "x");
    // The identified net is in equilibrium, moved supports and all.
    must_run({"export", "result.json", "--to", "net", "-o", "built.json"});
    const json built = json::parse(must_run({"inspect", "built.json", "--json"}));
    EXPECT_LT(built["out_of_balance"].get<double>(),
              1e-6 * built["tensions"]["mean"].get<double>());
}

TEST_F(Chain, IdentifyWritesTheCovariancesOfAListOfEdgesInItsOrder) {
    survey();
    const auto identify = [&](const std::string& edges, const Words& options) {
        write("edges.txt", edges);
        return run(joined(
            {"identify", "net.json", "survey.csv", "--draws", "0", "--covariance-of", "edges.txt"},
            options));
    };
    const std::string interior = m_net.edge_id(m_net.interior_edges()[1]);
    const std::string adjustable = m_net.edge_id(m_net.adjustable_edges()[0]);
    expect_error(identify(adjustable + "\n", {"-o", "result.json"}), 2, "which is adjustable");
    expect_error(identify("nowhere\n", {"-o", "result.json"}), 2, "edges.txt:1");
    expect_error(identify(interior + "\n", {}), 2, "-o or --json");
    EXPECT_FALSE(exists("result.json"));
    const std::string first = m_net.edge_id(m_net.interior_edges()[0]);
    ASSERT_EQ(identify(interior + "\n" + first + "\n", {"-o", "result.json"}).exit_code, 0);
    const json result = json::parse(read("result.json"));
    EXPECT_EQ(result["length_covariance"]["ids"], json({interior, first}));
    for (size_t k = 0; k < 2; ++k) {
        const auto std_dev = result["edges"][1 - k]["std"].get<double>();
        EXPECT_NEAR(result["length_covariance"]["covariance"][k][k].get<double>(),
                    std_dev * std_dev, 1e-9 * std_dev * std_dev);
    }
}

TEST_F(Chain, ANetWithoutEquilibriumIsANumericalFailure) {
    // Stiffnesses of thirty orders, and loads beside which the soft ones are nothing.
    CableNetData content = m_net.data();
    content.loads.setConstant(3, content.nodes.cols(), 1e15);
    for (Eigen::Index e = 0; e < content.axial_stiffness.size(); ++e) {
        content.axial_stiffness(e) = std::pow(10.0, static_cast<double>(5 * e % 31) - 15.0);
    }
    write("loaded.json", net_to_json(CableNet(content)));
    const Files before = files();
    Outcome outcome = run({"form", "loaded.json", "-o", "form.csv"});
    EXPECT_THAT(outcome.err, testing::StartsWith("taut: warning: loaded.json: its nodes are"));
    outcome.err.erase(0, outcome.err.find('\n') + 1);
    expect_error(outcome, 1, "loaded.json: no equilibrium");
    expect_error(run({"sample", "loaded.json", "-n", "3", "-o", "data.h5"}), 1, "no equilibrium");
    EXPECT_EQ(files(), before);
}

TEST_F(Chain, ACableThatSlidesGoesThroughAllOfIt) {
    must_run({"example", "sliding-ridge", "-o", "ridge.json"});
    must_run({"form", "ridge.json", "--prior", "normal:2mm", "-o", "built.csv"});
    must_run({"survey", "ridge.json", "built.csv", "--noise", "0.5mm", "-o", "of_ridge.csv"});
    EXPECT_THAT(must_run({"inspect", "ridge.json"}), HasSubstr("runs of the net slide"));
    must_run({"export", "ridge.json", "--to", "net", "-o", "slid.json"});
    const json again = json::parse(must_run({"form", "slid.json", "--json"}));
    EXPECT_LT(again.at("largest_move").get<double>(), 1e-6);  // it slides no further
    const std::string text = must_run({"identify", "ridge.json", "of_ridge.csv", "--prior",
                                       "normal:2mm", "--draws", "60", "-o", "ridge_result.json"});
    EXPECT_THAT(text, HasSubstr("cable that slides, edges 0 to 7, friction up to 0.15: "));
    const json result = json::parse(read("ridge_result.json"));
    EXPECT_EQ(result.at("trust").at("verdict"), "passed");
    EXPECT_EQ(result.at("stretches").size(), 1U);
    must_run({"plan", "ridge.json", "ridge_result.json", "--tension", "0.5kN..60kN",
              "--total-stroke", "20mm", "-o", "ridge_plan.json"});
    for (const char* const made : {"ridge_result.json", "ridge_plan.json"}) {
        must_run({"report", made, "-o", "ridge.html"});
        EXPECT_THAT(read("ridge.html"), HasSubstr("stretches"));
    }
    // The net of the result, with the lengths that have slid, is in equilibrium as identified.
    must_run({"export", "ridge_result.json", "--to", "net", "-o", "ridge_built.json"});
    const json built = json::parse(must_run({"form", "ridge_built.json", "--json"}));
    EXPECT_LT(built.at("largest_move").get<double>(), 1e-6);
    const json predicted =
        json::parse(must_run({"inspect", "ridge.json", "--survey", "of_ridge.csv", "--prior",
                              "normal:2mm", "--suggest", "--json"}));
    EXPECT_THAT(predicted.at("survey").at("suggestions").at("left_out").back().get<std::string>(),
                HasSubstr("of edges that slide"));
    must_run({"survey", "ridge.json", "built.csv", "--noise", "0.5mm", "--seed", "2", "-o",
              "again.csv"});
    must_run({"identify", "ridge.json", "of_ridge.csv", "--epoch", "again.csv", "--prior",
              "normal:2mm", "--draws", "60", "-o", "twice.json"});
    const json twice = json::parse(read("twice.json"));
    EXPECT_EQ(twice.at("trust").at("verdict"), "passed");
    EXPECT_LT(twice.at("stretches")[0].at("std"), result.at("stretches")[0].at("std"));
    must_run({"plan", "ridge.json", "twice.json", "--total-stroke", "20mm", "-o", "plan.json"});
    must_run({"control", "ridge.json", "--prior", "normal:2mm", "--trials", "1", "--rounds", "1",
              "--draws", "60", "-o", "jobs"});
    EXPECT_THAT(read("jobs/report.html"), HasSubstr("identified"));
    must_run({"sample", "ridge.json", "--prior", "normal:2mm", "-n", "20", "-o", "ridge.h5"});
    for (const Words& refused : {Words{"train", "ridge.h5", "-o", "model.h5"},
                                 {"compare", "ridge.json", "-o", "methods"},
                                 {"reproduce", "--net", "ridge.json", "-o", "study"},
                                 {"form", "ridge.json", "--solver", "socp"}}) {
        const std::string file = refused[0] == "train" ? "ridge.h5" : "ridge.json";
        const Outcome outcome = run(refused);
        expect_error(outcome, 2, "slide");
        EXPECT_THAT(outcome.err, HasSubstr("taut: error: " + file));
    }
    for (const char* const written : {"model.h5", "methods", "study"}) {
        EXPECT_FALSE(exists(written)) << written;
    }
}

}  // namespace
