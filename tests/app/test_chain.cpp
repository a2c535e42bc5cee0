// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against subcommands that do not fit together: a file that the next one cannot read, a
// number lost on the way from a net to its identified lengths.

#include <cmath>
#include <sstream>

#include "app/program.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/io/form_csv.hpp"
#include "taut/io/net_json.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/statics/cone_program.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using nlohmann::json;

class Chain : public ProgramTest {
protected:
    Chain() { must_run({"example", "hypar:3x4", "-o", "net.json"}); }

    /// Samples and a model of the net.
    void sample_and_train(const std::string& count = "120") const {
        must_run({"sample", "net.json", "-n", count, "--prior", "uniform:2mm", "-o", "data.h5"});
        must_run({"train", "data.h5", "-o", "model.h5"});
    }

    const CableNet m_net = hypar(3, 4);
};

TEST_F(Chain, ExampleWritesTheBuiltInNet) {
    const CableNet written = read_net(folder() / "net.json").net;
    EXPECT_EQ(written.fingerprint(), m_net.fingerprint());
    EXPECT_EQ(written.name(), "hypar:3x4");
}

TEST_F(Chain, InspectTellsTheCounts) {
    const std::string text = must_run({"inspect", "net.json"});
    EXPECT_THAT(text, testing::HasSubstr(
                          "12 free nodes, 14 supports, 17 interior and 14 adjustable edges"));
    EXPECT_THAT(text, testing::HasSubstr(m_net.fingerprint()));
    EXPECT_THAT(text, testing::HasSubstr("slack edges: 0"));
}

TEST_F(Chain, InspectAsksWhetherANetInMillimetresIsOne) {
    json net = json::parse(read("net.json"));
    must_run({"inspect", "net.json"});  // without a warning
    for (json& node : net["nodes"]) {
        for (json& coordinate : node) {
            coordinate = 1e3 * coordinate.get<double>();
        }
    }
    for (json& length : net["unstressed_lengths"]) {
        length = 1e3 * length.get<double>();
    }
    write("mm.json", net.dump());
    EXPECT_THAT(run({"inspect", "mm.json"}).err, testing::HasSubstr("are its coordinates in mm?"));
}

TEST_F(Chain, InspectTellsWhatTheFormTells) {
    const json it = json::parse(must_run({"inspect", "net.json", "--json"}));
    EXPECT_GE(it["self_stress_states"].get<int>(), 1);
    EXPECT_EQ(it["mechanisms"].get<int>(),
              36 - (31 - it["self_stress_states"].get<int>()));  // 3 n_I less rank, m = 31
    EXPECT_EQ(it["identifiability"]["determined"], 17);
    EXPECT_TRUE(it["identifiability"]["undetermined"].empty());
    EXPECT_GT(it["identifiability"]["condition"].get<double>(), 1.0);
    EXPECT_EQ(it["most_sensitive_edges"].size(), 10U);
    EXPECT_LT(it["equilibrium"]["relative_gap"].get<double>(), 1e-12);
    EXPECT_FALSE(it.contains("left_out"));
}

TEST_F(Chain, FormByNewtonsMethodIsCertified) {
    const json newton = json::parse(must_run({"form", "net.json", "--json"}));
    EXPECT_LT(newton["relative_gap"].get<double>(), 1e-12);
}

TEST_F(Chain, FormByTheConeProgramIsRefusedWhereTautHasNone) {
    if (cone_solver_available()) {
        GTEST_SKIP() << "built with Clarabel";
    }
    expect_error(run({"form", "net.json", "--solver", "socp"}), 2, "without the conic solver");
}

TEST_F(Chain, FormByTheConeProgramIsNewtonsAndCertified) {
    if (!cone_solver_available()) {
        GTEST_SKIP() << "built without Clarabel";
    }
    const json newton = json::parse(must_run({"form", "net.json", "--json"}));
    const double energy = newton["energy"].get<double>();
    for (const std::string cone_form : {"quadratic", "paper"}) {
        const json cone = json::parse(
            must_run({"form", "net.json", "--solver", "socp", "--cone-form", cone_form, "--json"}));
        EXPECT_EQ(cone["solver"], "socp");
        EXPECT_EQ(cone["cone_program"]["form"], cone_form);
        EXPECT_LT(cone["relative_gap"].get<double>(), 1e-8);
        EXPECT_NEAR(cone["energy"].get<double>(), energy, 1e-8 * energy);
        EXPECT_NEAR(cone["cone_program"]["primal_objective"].get<double>(), energy, 1e-6 * energy);
        EXPECT_LT(cone["largest_move"].get<double>(), 1e-5);
    }
}

TEST_F(Chain, FormWritesARowForEachNode) {
    const std::string text = must_run({"form", "net.json", "-o", "form.csv"});
    EXPECT_THAT(text, testing::HasSubstr("converged"));
    std::istringstream lines(read("form.csv"));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "id,x,y,z");
    int rows = 0;
    while (std::getline(lines, line)) {
        EXPECT_THAT(line, testing::StartsWith(std::to_string(rows) + ","));
        ++rows;
    }
    EXPECT_EQ(rows, m_net.node_count());
}

TEST_F(Chain, SampleWritesWhatTheLibraryDraws) {
    must_run({"sample", "net.json", "-n", "30", "--prior", "normal:1mm", "--seed", "7", "-o",
              "data.h5"});
    const DataSet data = read_data_set(folder() / "data.h5").data;
    const Sampler sampler(m_net, parse_length_prior("normal:1mm"), 7);
    DataSet expected = sampler.empty();
    sampler.extend(expected, 30);
    EXPECT_EQ(data.length_deviations, expected.length_deviations);
    EXPECT_EQ(data.form_deviations, expected.form_deviations);
    EXPECT_FALSE(exists("data.h5.partial"));
}

TEST_F(Chain, SampleWritesTheSameBytesOnOneThreadAndOnTwo) {
    must_run({"sample", "net.json", "-n", "100", "-o", "one.h5", "--threads", "1"});
    must_run({"sample", "net.json", "-n", "100", "-o", "two.h5", "--threads", "2"});
    EXPECT_EQ(read("one.h5"), read("two.h5"));
    must_run({"sample", "net.json", "-n", "100", "-o", "other.h5", "--seed", "2"});
    EXPECT_NE(read("one.h5"), read("other.h5"));
}

TEST_F(Chain, TrainWritesTheSameBytesOnOneThreadAndOnTwo) {
    must_run({"sample", "net.json", "-n", "150", "-o", "data.h5"});
    must_run({"train", "data.h5", "-o", "one.h5", "--threads", "1"});
    must_run({"train", "data.h5", "-o", "two.h5", "--threads", "2"});
    EXPECT_EQ(read("one.h5"), read("two.h5"));
}

TEST_F(Chain, SampleDrawsWhatElseIsUnknown) {
    const std::vector<std::string> command{"sample",      "net.json",    "-n",
                                           "40",          "--uncertain", "supports:1mm",
                                           "--uncertain", "stiffness:5%"};
    const auto with = [&command](std::vector<std::string> more) {
        std::vector<std::string> all = command;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    must_run(with({"-o", "drawn.h5"}));
    must_run({"sample", "net.json", "-n", "40", "-o", "plain.h5"});
    const DataSet drawn = read_data_set(folder() / "drawn.h5").data;
    const DataSet plain = read_data_set(folder() / "plain.h5").data;
    EXPECT_EQ(to_string(drawn.uncertain), "supports:1mm, stiffness:5%");
    EXPECT_TRUE(plain.uncertain.empty());
    EXPECT_EQ(drawn.length_deviations, plain.length_deviations);
    EXPECT_NE(drawn.form_deviations, plain.form_deviations);
    // The same whatever the threads, and no other data set goes on from it.
    must_run(with({"-o", "one.h5", "--threads", "1"}));
    EXPECT_EQ(read("one.h5"), read("drawn.h5"));
    expect_error(run({"sample", "net.json", "-n", "50", "--resume", "-o", "drawn.h5"}), 2,
                 "was made with the uncertain supports:1mm, stiffness:5%, expected none to resume");
    // A model learns from it and says so.
    must_run({"train", "drawn.h5", "-o", "drawn_model.h5"});
    must_run({"form", "net.json", "-o", "form.csv"});
    EXPECT_THAT(must_run({"identify", "net.json", "form.csv", "--noise", "0.5mm", "--model",
                          "drawn_model.h5"}),
                testing::HasSubstr("drawn with supports:1mm, stiffness:5%"));
}

TEST_F(Chain, IdentifyAssumesWhatIsNotGivenAndSaysSo) {
    must_run({"form", "net.json", "--prior", "uniform:2mm", "-o", "form.csv"});
    must_run({"survey", "net.json", "form.csv", "--noise", "0.5mm", "-o", "survey.csv"});
    const auto identified = [this](std::vector<std::string> uncertain) {
        std::vector<std::string> command{"identify",    "net.json", "survey.csv", "--prior",
                                         "uniform:2mm", "-o",       "result.json"};
        command.insert(command.end(), uncertain.begin(), uncertain.end());
        const std::string text = must_run(command);
        std::vector<std::string> values;
        const json result = json::parse(read("result.json"));
        for (const json& one : result["assumptions"]) {
            values.push_back(one["value"].get<std::string>() + " " +
                             one["source"].get<std::string>());
            EXPECT_THAT(text, testing::HasSubstr(one["value"].get<std::string>()));
        }
        return std::pair(values, result["mean_tension"]["std"].get<double>());
    };
    const auto [assumed, std_on_site] = identified({});
    EXPECT_EQ(assumed,
              (std::vector<std::string>{"stiffness:5% default", "stiffness-each:2% default",
                                        "adjustable:0.5mm default", "supports:1mm default"}));
    const auto [changed, std_softer] = identified({"--uncertain", "stiffness:20%"});
    EXPECT_EQ(changed,
              (std::vector<std::string>{"stiffness:20% given", "stiffness-each:2% default",
                                        "adjustable:0.5mm default", "supports:1mm default"}));
    const auto [none, std_exact] = identified({"--uncertain", "none"});
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(identified({"--unknown", "stiffness:5%"}).first,
              std::vector<std::string>{"stiffness:5% given"});
    EXPECT_GT(std_on_site, 1.5 * std_exact);
    EXPECT_GT(std_softer, 1.3 * std_on_site);
}

TEST_F(Chain, IdentifyTakesForcesAndUnknowns) {
    must_run({"form", "net.json", "--prior", "uniform:2mm", "-o", "form.csv"});
    must_run({"survey", "net.json", "form.csv", "--noise", "0.5mm", "-o", "survey.csv"});
    const json plain = json::parse(must_run({"inspect", "net.json", "--json"}));
    write("forces.csv", "edge,tension\n3," +
                            std::to_string(plain["tensions"]["mean"].get<double>() / 1000.0) +
                            "\n");
    const std::string text = must_run(
        {"identify", "net.json", "survey.csv", "--prior", "uniform:2mm", "--forces", "forces.csv",
         "--force-unit", "kN", "--force-noise", "50%", "--uncertain", "none", "--uncertain",
         "stiffness:5%", "--uncertain", "supports:1mm", "-o", "result.json"});
    EXPECT_THAT(text, testing::HasSubstr("forces: 1 reading, 0 left out"));
    EXPECT_THAT(text, testing::HasSubstr("stiffness:5%: "));
    EXPECT_THAT(text, testing::HasSubstr("loads taken as given"));
    const json result = json::parse(read("result.json"));
    EXPECT_EQ(result["forces"]["measurements"], 1);
    ASSERT_GT(result["uncertain"].size(), 1U);
    EXPECT_EQ(result["uncertain"][0]["name"], "stiffness");
    EXPECT_EQ(result["uncertain"][0]["unit"], "1");
    EXPECT_EQ(result["uncertain"][1]["axis"], "x");
    // The net as it was identified is in balance, moved supports and all.
    must_run({"export", "result.json", "--to", "net", "-o", "built.json"});
    const json built = json::parse(must_run({"inspect", "built.json", "--json"}));
    EXPECT_LT(built["out_of_balance"].get<double>(),
              1e-6 * built["tensions"]["mean"].get<double>());
}

TEST_F(Chain, IdentifyFindsNoDeviationInTheNominalForm) {
    sample_and_train();
    must_run({"form", "net.json", "-o", "form.csv"});
    must_run({"identify", "net.json", "form.csv", "--model", "model.h5", "-o", "result.json"});
    const json result = json::parse(read("result.json"));
    ASSERT_EQ(result["edges"].size(), 17U);
    for (const json& edge : result["edges"]) {
        EXPECT_EQ(edge["status"], "determined");
        EXPECT_LT(std::abs(edge["length_deviation"].get<double>()),
                  4.0 * edge["std"].get<double>());
    }
    EXPECT_LT(result["survey"]["max_residual"], 1e-3);
}

TEST_F(Chain, IdentifyFindsTheLengthsOfASampleFromItsForm) {
    sample_and_train();
    must_run({"sample", "net.json", "-n", "1", "--prior", "uniform:2mm", "--seed", "99", "-o",
              "truth.h5"});
    const DataSet truth = read_data_set(folder() / "truth.h5").data;
    const Points form =
        with_free_coordinates(m_net, truth.nominal_form + truth.form_deviations.col(0));
    write("survey.csv", form_to_csv(m_net, form));
    must_run({"identify", "net.json", "survey.csv", "--model", "model.h5", "-o", "result.json"});
    const json result = json::parse(read("result.json"));
    double squares = 0.0;
    for (size_t i = 0; i < result["edges"].size(); ++i) {
        const json& edge = result["edges"][i];
        const double error = edge["length_deviation"].get<double>() -
                             truth.length_deviations(static_cast<int>(i), 0);
        EXPECT_LT(std::abs(error), 6.0 * edge["std"].get<double>()) << edge.dump();
        squares += error * error;
    }
    EXPECT_LT(squares, 0.05 * truth.length_deviations.col(0).squaredNorm());
}

TEST_F(Chain, ResultHasTheKeysOfTheContract) {
    sample_and_train();
    must_run({"form", "net.json", "-o", "form.csv"});
    must_run({"identify", "net.json", "form.csv", "--model", "model.h5", "-o", "result.json"});
    const json result = json::parse(read("result.json"));
    expect_keys(result, json::parse(R"({
        "format": "", "version": 1, "method": "", "net_fingerprint": "", "edges": [], "form": [],
        "survey": {"used": 1, "missing": 0, "outliers": [], "rms_residual": 0.1, "max_residual": 0.1}})"));
    EXPECT_EQ(result["format"], "taut-identification");
    EXPECT_EQ(result["version"], 1);
    EXPECT_EQ(result["method"], "gp");
    EXPECT_EQ(result["net_fingerprint"], m_net.fingerprint());
    ASSERT_EQ(result["edges"].size(), m_net.interior_edges().size());
    for (size_t i = 0; i < result["edges"].size(); ++i) {
        const json& edge = result["edges"][i];
        expect_keys(edge,
                    json::parse(R"({"edge": 1, "nodes": [], "nominal": 0.1, "length_deviation": 0.1,
            "std": 0.1, "lower": 0.1, "upper": 0.1, "status": ""})"));
        const int index = m_net.interior_edges()[i];
        EXPECT_EQ(edge["edge"], index);
        EXPECT_EQ(edge["nodes"], json(m_net.edges()[index]));
        EXPECT_EQ(edge["nominal"], m_net.unstressed_lengths()(index));
        EXPECT_LT(edge["lower"], edge["length_deviation"]);
        EXPECT_LT(edge["length_deviation"], edge["upper"]);
    }
    ASSERT_EQ(result["form"].size(), m_net.node_count());
    EXPECT_EQ(result["form"][0].size(), 3U);
    EXPECT_EQ(result["survey"]["used"], 12);
    EXPECT_EQ(result["survey"]["missing"], 0);
}

TEST_F(Chain, IdentifyTrainsAModelWhereNoneIsGiven) {
    must_run({"form", "net.json", "-o", "form.csv"});
    const std::string text =
        must_run({"identify", "net.json", "form.csv", "--method", "gp", "-o", "result.json"});
    EXPECT_THAT(text, testing::HasSubstr("1000 samples of uniform:5mm"));
    EXPECT_EQ(json::parse(read("result.json"))["edges"].size(), 17U);
}

TEST_F(Chain, IdentifyChoosesTheMethodByWhatIsThere) {
    must_run({"form", "net.json", "-o", "form.csv"});
    const std::string form = read("form.csv");
    write("part.csv", form.substr(0, form.rfind("\n7,") + 1));
    const auto chosen = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"identify", "net.json"});
        arguments.emplace_back("--json");
        return json::parse(must_run(arguments));
    };
    json result = chosen({"form.csv"});
    EXPECT_EQ(result["method"], "balance");
    EXPECT_THAT(result["method_reason"].get<std::string>(), testing::HasSubstr("no noise"));
    result = chosen({"form.csv", "--noise", "0.5mm"});
    EXPECT_EQ(result["method"], "map");
    EXPECT_DOUBLE_EQ(result["survey"]["noise"].get<double>(), 0.0005);
    result = chosen({"part.csv", "--noise", "0.5mm"});
    EXPECT_EQ(result["method"], "map");
    EXPECT_THAT(result["method_reason"].get<std::string>(), testing::HasSubstr("not surveyed"));
    EXPECT_GT(result["survey"]["missing"], 0);
    result = chosen({"form.csv", "--noise", "0.5mm", "--method", "balance"});
    EXPECT_EQ(result["method"], "balance");
}

TEST_F(Chain, JsonIsAllThatStandardOutputHolds) {
    const std::vector<std::vector<std::string>> commands{
        {"example", "hypar:3x4", "-o", "again.json"},
        {"inspect", "net.json"},
        {"form", "net.json", "-o", "form.csv"},
        {"sample", "net.json", "-n", "60", "-o", "data.h5"},
        {"train", "data.h5", "-o", "model.h5"},
        {"identify", "net.json", "form.csv", "--model", "model.h5", "-o", "result.json"},
        {"reproduce", "--net", "net.json", "--samples", "30", "--validation", "5", "-o", "study"}};
    for (std::vector<std::string> command : commands) {
        command.emplace_back("--json");
        const json document = json::parse(must_run(command), nullptr, false);
        EXPECT_TRUE(document.is_object()) << testing::PrintToString(command);
    }
    EXPECT_EQ(json::parse(must_run({"inspect", "net.json", "--json"}))["net"]["free_nodes"], 12);
    const std::string printed = must_run(
        {"identify", "net.json", "form.csv", "--model", "model.h5", "-o", "result.json", "--json"});
    EXPECT_EQ(printed, read("result.json"));
}

TEST_F(Chain, ACommandThatSucceedsReplacesItsOutput) {
    write("form.csv", "something else\n");
    must_run({"form", "net.json", "-o", "form.csv"});
    EXPECT_THAT(read("form.csv"), testing::StartsWith("id,x,y,z\n"));
    EXPECT_EQ(files().size(), 2U) << "temporary files were left";
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

}  // namespace
