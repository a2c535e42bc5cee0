// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a form that is written with the lengths of another net, and so with tensions of
// neither, and against a net that changes on its way out to another program and back.

#include <fmt/core.h>

#include <algorithm>

#include "app/program.hpp"
#include "files/zip_archive.hpp"
#include "support/errors.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/files/table_file.hpp"
#include "taut/io/net_json.hpp"
#include "taut/report/report_html.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using nlohmann::json;
using testing::HasSubstr;

class Export : public ProgramTest {
protected:
    Export() {
        write("net.json", net_to_json(hypar(3, 4), R"({"colour": "red"})"));
        must_run({"form", "net.json", "--prior", "uniform:5mm", "--seed", "7", "-o", "built.csv",
                  "--lengths", "truth.csv"});
    }

    void identify(const Words& survey, const Words& options = {}) const {
        must_run(joined({"survey", "net.json", "built.csv", "-o", "survey.csv"}, survey));
        must_run(joined({"identify", "net.json", "survey.csv", "-o", "result.json"}, options));
    }

    [[nodiscard]] CableNet net(const std::string& file) const {
        return parse_net(read(file), file).net;
    }

    /// Of the net as built.
    [[nodiscard]] Eigen::VectorXd true_lengths() const {
        const std::vector<double> deviations = true_deviations();
        return with_length_deviations(
            hypar(3, 4), Eigen::Map<const Eigen::VectorXd>(deviations.data(), deviations.size()));
    }
};

TEST_F(Export, SaysThatNoOtherFormatHasAFrame) {
    const CableNet rigid = net("net.json");
    std::string frame = "row,column,stiffness\n";
    for (const int node : {rigid.supports()[0], rigid.supports()[1]}) {
        for (const char axis : {'x', 'y', 'z'}) {
            frame += fmt::format("{0}.{1},{0}.{1},1e6\n", node, axis);
        }
    }
    frame += fmt::format("{}.z,{}.z,-3e5\n", rigid.supports()[0], rigid.supports()[1]);
    write("frame.csv", frame);
    EXPECT_THAT(must_run({"frame", "net.json", "frame.csv", "-o", "framed.json"}),
                HasSubstr("frame of 2 supports, of which 1 pairs pass forces on to each other"));
    const CableNet framed = net("framed.json");
    EXPECT_EQ(framed.support_couplings().size(), 1U);
    EXPECT_THAT(read("framed.json"), HasSubstr("colour"));
    const json printed =
        json::parse(must_run({"frame", "net.json", "frame.csv", "-o", "b.json", "--json"}));
    EXPECT_EQ(printed["coupled_pairs"], 1);
    EXPECT_EQ(printed["supports"], (std::vector{rigid.supports()[0], rigid.supports()[1]}));
    EXPECT_NEAR(printed["stiffness"]["min"].get<double>(), 1e6, 1.0);
    must_run({"export", "framed.json", "--to", "net", "-o", "again.json"});
    EXPECT_EQ(net("again.json").support_couplings().size(), 1U);
    const Outcome exported =
        run({"export", "framed.json", "--to", "compas", "-o", "c.json", "--json"});
    EXPECT_THAT(json::parse(exported.out)["warnings"].dump(),
                HasSubstr("what supports on one frame pass on"));
}

TEST_F(Export, WarnsOfAFormThatTheLengthsDoNotBalance) {
    const Outcome outcome =
        run({"export", "net.json", "built.csv", "--to", "vtk", "-o", "net.vtk"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.err, testing::StartsWith("taut: warning: built.csv: with the lengths of "
                                                 "net.json it is "));
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(" N out of balance ("),
                                   HasSubstr(" of the mean tension, "), HasSubstr("--lengths")));
    EXPECT_THAT(outcome.out, HasSubstr(" N out of balance ("));
    const Outcome as_json =
        run({"export", "net.json", "built.csv", "--to", "vtk", "-o", "net.vtk", "--json"});
    const json document = json::parse(as_json.out);
    EXPECT_GT(document["out_of_balance"], 0.01 * document["mean_tension"].get<double>());
    EXPECT_EQ(document["warnings"].size(), 1U);
}

TEST_F(Export, TakesTheLengthsOfTheForm) {
    for (const std::string format : {"csv", "vtk", "compas", "obj", "net"}) {
        must_run({"export", "net.json", "built.csv", "--lengths", "truth.csv", "--to", format, "-o",
                  "out." + format});
    }
    must_run({"export", "net.json", "--lengths", "truth.csv", "--to", "net", "-o", "found.json"});
    const CableNet built = net("out.net");
    EXPECT_LT((net("found.json").nodes() - built.nodes()).cwiseAbs().maxCoeff(), 1e-9)
        << "the equilibrium where no form is given";
    EXPECT_LT((built.unstressed_lengths() - true_lengths()).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_EQ(json::parse(read("out.net"))["colour"], "red");
    must_run({"import", "out.csv", "--edges", "out_edges.csv", "-o", "again.json"});
    EXPECT_LT((net("again.json").nodes() - built.nodes()).cwiseAbs().maxCoeff(), 1e-15);
}

TEST_F(Export, GivesTheNetAsAnIdentificationFoundIt) {
    identify({});
    must_run({"export", "result.json", "--to", "net", "-o", "out.net"});
    const CableNet built = net("out.net");
    EXPECT_LT((built.unstressed_lengths() - true_lengths()).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_EQ(built.name(), net("net.json").name());
    const json form = json::parse(must_run({"form", "out.net", "--json"}));
    EXPECT_LT(form["largest_move"], 1e-9) << "the exported form is not in equilibrium";
}

TEST_F(Export, WritesTheListOfTurnsAsAnExcelFile) {
    identify({"--noise", "0.5mm", "--seed", "3"}, {"--draws", "60"});
    static_cast<void>(
        run({"plan", "net.json", "result.json", "-o", "plan.json", "--csv", "turns.csv"}));
    const Outcome good = run({"export", "plan.json", "--to", "xlsx", "-o", "turns.xlsx"});
    EXPECT_EQ(good.exit_code, 0) << good.err;
    const std::string text = read("turns.csv");
    const TableFile sheet = read_table_file(folder() / "turns.xlsx");
    EXPECT_EQ(sheet.sheet, "turns");
    EXPECT_EQ(std::ranges::count(sheet.text, '\n'), std::ranges::count(text, '\n'));
    EXPECT_EQ(sheet.text.substr(0, sheet.text.find('\n')), text.substr(0, text.find('\n')));
    json plan = json::parse(read("plan.json"));
    json named = plan;
    std::vector<std::string> ids;
    for (size_t e = 0; e < plan["cable_net"]["edges"].size(); ++e) {
        ids.push_back(e % 2 == 0 ? fmt::format("{}.5", e) : fmt::format("=e{}", e));
    }
    named["cable_net"]["edge_ids"] = ids;
    for (json& turn : named["turns"]) {
        turn["edge_id"] = ids[turn["edge"]];
    }
    write("named.json", named.dump());
    ASSERT_EQ(run({"export", "named.json", "--to", "xlsx", "-o", "named.xlsx"}).exit_code, 0);
    const std::string first = named["turns"][0]["edge_id"];
    // A number with a decimal would show without it, and other names are as in a CSV file.
    EXPECT_THAT(read_table(folder() / "named.xlsx"),
                HasSubstr(first.starts_with('=') ? ",'" + first + "," : "," + first + ","));
    const std::string bytes = read("named.xlsx");
    const std::string file_name = "named.xlsx";
    EXPECT_THAT(ZipArchive(bytes, file_name).part("xl/worksheets/sheet1.xml").value_or(""),
                testing::AllOf(HasSubstr("<t"), testing::Not(HasSubstr(".5</v>"))));
    plan["warnings"] = {"DO NOT TURN BY THIS LIST: the plan breaks limits"};
    write("bad.json", plan.dump());
    const Outcome bad = run({"export", "bad.json", "--to", "xlsx", "-o", "bad.xlsx"});
    EXPECT_THAT(bad.err, HasSubstr("bad.json: DO NOT TURN BY THIS LIST"));
    EXPECT_THAT(read_table(folder() / "bad.xlsx"),
                testing::StartsWith("# DO NOT TURN BY THIS LIST: the plan breaks limits\nnumber,"));
}

TEST_F(Export, WritesEdgesAndNodesOfAResultAsAnExcelFile) {
    identify({"--noise", "0.5mm", "--seed", "3"}, {"--draws", "20"});
    const json written = json::parse(
        must_run({"export", "result.json", "--to", "xlsx", "-o", "tables.xlsx", "--json"}));
    EXPECT_EQ(written["files"], json{"tables.xlsx"});
    EXPECT_THAT(input_error_of([&] { return read_table(folder() / "tables.xlsx"); }),
                HasSubstr("holds tables in the sheets 'edges', 'nodes'"));
}

TEST_F(Export, LeavesTheDrawsOfItsResultAsTheyAre) {
    identify({"--noise", "0.5mm", "--seed", "3"}, {"--draws", "20"});
    const std::string draws = read("result_draws.h5");
    for (const Words& words :
         {Words{"export", "result.json", "--to", "net"}, {"report", "result.json"}}) {
        expect_error(run(joined(words, {"-o", "result_draws.h5"})), 2,
                     "result_draws.h5: is an input of this command");
    }
    EXPECT_EQ(read("result_draws.h5"), draws);
}

TEST_F(Export, PrintsTheNameOfAReportThatIsNotUtf8) {
    if (!has_report_viewer()) {
        GTEST_SKIP() << "built without Node.js";
    }
    identify({});
    const json written =
        json::parse(must_run({"report", "result.json", "-o", "name\xff.html", "--json"}));
    EXPECT_EQ(written["written"], json{"name\uFFFD.html"});
}

TEST_F(Export, SaysHowAResultIsExported) {
    identify({});
    must_run({"form", "net.json", "-o", "nominal.csv"});
    const Outcome outcome =
        run({"export", "result.json", "nominal.csv", "--to", "vtk", "-o", "net.vtk"});
    EXPECT_THAT(outcome.err, HasSubstr("Leave out FORM"));
}

TEST_F(Export, CountsTheLengthsThatTheSurveyDoesNotDetermine) {
    identify({});
    json result = json::parse(read("result.json"));
    result["edges"][0]["status"] = "slack";
    result["edges"][1]["status"] = "not_determined";
    result["edges"][2]["status"] = "not_determined";
    write("result.json", result.dump());
    EXPECT_THAT(must_run({"export", "result.json", "--to", "net", "-o", "built.json"}),
                HasSubstr("not known: 1 slack, 2 not determined, of 17"));
    const json document = json::parse(
        must_run({"export", "result.json", "--to", "net", "-o", "built.json", "--json"}));
    EXPECT_EQ(document["lengths_not_known"]["slack"].size(), 1U);
    EXPECT_EQ(document["lengths_not_known"]["not_determined"].size(), 2U);
}

}  // namespace
