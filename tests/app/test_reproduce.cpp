// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against an experiment whose files are incomplete, or disagree with each other.

#include "app/program.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/io/model_h5.hpp"
#include "taut/report/report_html.hpp"
#include "taut/study/study.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using nlohmann::json;
using testing::HasSubstr;

class Reproduce : public ProgramTest {
protected:
    Reproduce() { must_have_run({{"example", "hypar:3x4", "-o", "net.json"}}); }

    std::string reproduce(const std::string& directory,
                          const std::string& extra = "--quiet") const {
        return must_run({"reproduce", "--net", "net.json", "--samples", "50", "--validation", "8",
                         "--prior", "uniform:3mm", "--seed", "5", "-o", directory, extra});
    }
};

TEST_F(Reproduce, WritesTheNumbersOfTheLibraryAndHowTheyCameAbout) {
    reproduce("study");
    const json results = json::parse(read("study/results.json"));
    const Study study = run_study(
        hypar(3, 4),
        {.samples = 50, .validation = 8, .prior = parse_length_prior("uniform:3mm"), .seed = 5});
    EXPECT_EQ(results["format"], "taut-study");
    for (const auto& [key, count] :
         {std::pair("free_nodes", 12), std::pair("supports", 14), std::pair("interior_edges", 17),
          std::pair("adjustable_edges", 14)}) {
        EXPECT_EQ(results["net"][key], count);
    }
    EXPECT_EQ(results["samples"]["training"], 42);
    EXPECT_EQ(results["samples"]["validation"], 8);
    EXPECT_EQ(results["samples"]["with_slack"], study.data.with_slack());
    const json& method = results["methods"]["gp_as_in_paper"];
    EXPECT_DOUBLE_EQ(method["error_mean_max_abs"], study.as_in_paper().errors.mean_max_abs());
    EXPECT_DOUBLE_EQ(method["error_std_mean"], study.as_in_paper().errors.std_mean());
    for (const MethodResult& expected : study.methods) {
        const json& found = results["methods"][expected.name];
        EXPECT_EQ(found["failed"], expected.failed);
        EXPECT_DOUBLE_EQ(found["mse"], expected.errors.mse) << expected.name;
        EXPECT_DOUBLE_EQ(found["mrse"], expected.errors.mrse);
        EXPECT_DOUBLE_EQ(found["coverage_95"], expected.coverage);
        EXPECT_DOUBLE_EQ(found["form_error"]["mean"], expected.form_error.mean);
    }
    const auto expect_summary = [](const json& found, const FormErrorSummary& expected) {
        EXPECT_DOUBLE_EQ(found["max"], expected.max);
        EXPECT_DOUBLE_EQ(found["min"], expected.min);
        EXPECT_DOUBLE_EQ(found["mean"], expected.mean);
        EXPECT_DOUBLE_EQ(found["rmse"], expected.rmse);
    };
    expect_summary(results["form_error"]["nominal"], study.form_errors.nominal);
    expect_summary(results["form_error"]["identified"], study.form_errors.identified);
    EXPECT_TRUE(results["seconds"]["total"].is_number());
    EXPECT_EQ(
        results["command"],
        "taut reproduce --net net.json --samples 50 --validation 8 --prior uniform:3mm --seed 5 "
        "-o study --quiet");
    EXPECT_THAT(results["date"].get<std::string>(), testing::MatchesRegex("....-..-.. ..:.. UTC"));
}

TEST_F(Reproduce, PrintsThePapersNumbersBesideItsOwnAndWritesTablesAndReport) {
    const std::string text = reproduce("study");
    for (const std::string words :
         {"paper", "1.7e-08" /* its MSE */, "13.8" /* its largest nominal form error [mm] */,
          "0.776" /* and identified */, "\n  gp_as_in_paper ", "\n  gp ", "\n  balance ",
          "\n  map ", "The paper uses another net"}) {
        EXPECT_THAT(text, HasSubstr(words));
    }
    EXPECT_EQ(lines("study/edges.csv").size(), 1U + 17U);
    EXPECT_EQ(lines("study/errors.csv").size(), 1U + 17U);
    EXPECT_EQ(lines("study/nodes.csv").size(), 1U + 12U);
    EXPECT_EQ(files().size(), 1U + 1U + (has_report_viewer() ? 5U : 4U))
        << "the net, the directory and what is in it";
    const Words report{"report", "study/results.json", "-o", "again.html"};
    if (has_report_viewer()) {
        EXPECT_THAT(text, HasSubstr("report: study/report.html"));
        EXPECT_THAT(read("study/report.html"), HasSubstr("hypar:3x4"));
        must_run(report);
        EXPECT_EQ(read("again.html"), read("study/report.html"));
    } else {
        EXPECT_THAT(text, HasSubstr("report: left out"));
        expect_error(run(report), 2, "built without Node.js");
    }
}

TEST_F(Reproduce, KeepsTheDataSetAndTheModelWhenAskedToAndPrintsJson) {
    reproduce("a/new/directory", "--keep");
    const DataSet data = read_data_set(folder() / "a/new/directory/data.h5").data;
    EXPECT_EQ(data.size(), 50);
    EXPECT_EQ(data.seed, 5U);
    const LengthModel model = read_model(folder() / "a/new/directory/model.h5").model;
    EXPECT_EQ(model.training_count(), 42);
    EXPECT_EQ(model.net_fingerprint, hypar(3, 4).fingerprint());
    const std::string printed = reproduce("other", "--json");
    EXPECT_EQ(printed, read("other/results.json"));
    EXPECT_EQ(read("other/nodes.csv"), read("a/new/directory/nodes.csv"));
}

TEST_F(Reproduce, ReplacesAnEarlierStudyAsAWholeAndLeavesOtherFilesAlone) {
    reproduce("study");
    write("study/results.json", "old");
    write("study/notes.txt", "mine");
    reproduce("study");
    EXPECT_THAT(read("study/results.json"), testing::StartsWith("{"));
    EXPECT_EQ(read("study/notes.txt"), "mine");
    for (const std::string name : {"results.json", "data.h5"}) {
        std::filesystem::remove(folder() / "study" / name);
        std::filesystem::create_directory(folder() / "study" / name);
        const Files before = files();
        expect_error(run({"reproduce", "--net", "net.json", "--samples", "20", "--validation", "4",
                          "-o", "study", "--keep"}),
                     2, name);
        EXPECT_EQ(files(), before);
        std::filesystem::remove(folder() / "study" / name);
    }
}

}  // namespace
