// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against an experiment whose outcome is incomplete, or says something else in one place
// than in another.

#include <algorithm>

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

class Reproduce : public ProgramTest {
protected:
    Reproduce() { must_run({"example", "hypar:3x4", "-o", "net.json"}); }

    std::string reproduce(const std::string& directory,
                          const std::string& extra = "--quiet") const {
        return must_run({"reproduce", "--net", "net.json", "--samples", "50", "--validation", "8",
                         "--prior", "uniform:3mm", "--seed", "5", "-o", directory, extra});
    }
};

TEST_F(Reproduce, WritesResultsWithEveryKeyOfTheContract) {
    reproduce("study");
    const json results = json::parse(read("study/results.json"));
    expect_keys(results, json::parse(R"({
        "format": "", "version": 1,
        "net": {"name": "", "free_nodes": 1, "supports": 1, "interior_edges": 1, "adjustable_edges": 1},
        "samples": {"total": 1, "training": 1, "validation": 1, "with_slack": 1, "not_converged": 1},
        "methods": {"gp_as_in_paper": {"mse": 0.1, "mrse": 0.1, "error_mean_max_abs": 0.1, "error_std_mean": 0.1}, "gp": {"mse": 0.1}, "balance": {"mse": 0.1}, "map": {"mse": 0.1}},
        "form_error": {"nominal": {"max": 0.1, "min": 0.1, "mean": 0.1, "rmse": 0.1},
                       "identified": {"max": 0.1, "min": 0.1, "mean": 0.1, "rmse": 0.1}},
        "seconds": {"sampling": 0.1, "training": 0.1, "identification": 0.1, "total": 0.1}})"));
    EXPECT_EQ(results["format"], "taut-study");
    EXPECT_EQ(results["version"], 1);
    EXPECT_EQ(results["net"]["name"], "hypar:3x4");
    EXPECT_EQ(results["net"]["free_nodes"], 12);
    EXPECT_EQ(results["net"]["supports"], 14);
    EXPECT_EQ(results["net"]["interior_edges"], 17);
    EXPECT_EQ(results["net"]["adjustable_edges"], 14);
    EXPECT_EQ(results["samples"]["total"], 50);
    EXPECT_EQ(results["samples"]["training"], 42);
    EXPECT_EQ(results["samples"]["validation"], 8);
}

TEST_F(Reproduce, TellsTheNumbersOfTheStudy) {
    reproduce("study");
    const json results = json::parse(read("study/results.json"));
    const Study study = run_study(
        hypar(3, 4),
        {.samples = 50, .validation = 8, .prior = parse_length_prior("uniform:3mm"), .seed = 5});
    const json& method = results["methods"]["gp_as_in_paper"];
    const LengthErrors& errors = study.as_in_paper().errors;
    EXPECT_DOUBLE_EQ(method["mse"], errors.mse);
    EXPECT_DOUBLE_EQ(method["mrse"], errors.mrse);
    EXPECT_DOUBLE_EQ(method["error_mean_max_abs"], errors.mean_max_abs());
    EXPECT_DOUBLE_EQ(method["error_std_mean"], errors.std_mean());
    for (const MethodResult& other : study.methods) {
        const json& found = results["methods"][other.name];
        EXPECT_EQ(found["failed"], other.failed);
        EXPECT_DOUBLE_EQ(found["mse"], other.errors.mse) << other.name;
        EXPECT_DOUBLE_EQ(found["coverage_95"], other.coverage);
        EXPECT_DOUBLE_EQ(found["form_error"]["mean"], other.form_error.mean);
    }
    EXPECT_EQ(results["samples"]["with_slack"], study.data.with_slack());
    const auto expect_summary = [](const json& found, const FormErrorSummary& expected) {
        EXPECT_DOUBLE_EQ(found["max"], expected.max);
        EXPECT_DOUBLE_EQ(found["min"], expected.min);
        EXPECT_DOUBLE_EQ(found["mean"], expected.mean);
        EXPECT_DOUBLE_EQ(found["rmse"], expected.rmse);
    };
    expect_summary(results["form_error"]["nominal"], study.form_errors.nominal);
    expect_summary(results["form_error"]["identified"], study.form_errors.identified);
}

TEST_F(Reproduce, WritesTheTablesAndTheReport) {
    reproduce("study");
    const auto lines = [this](const std::string& file) {
        return std::ranges::count(read(file), '\n');
    };
    EXPECT_EQ(lines("study/edges.csv"), 1 + 17);
    EXPECT_EQ(lines("study/errors.csv"), 1 + 17);
    EXPECT_EQ(lines("study/nodes.csv"), 1 + 12);
    if (has_report_viewer()) {
        const std::string report = read("study/report.html");
        EXPECT_THAT(report, testing::HasSubstr("<html"));
        EXPECT_THAT(report, testing::HasSubstr("</html>"));
        EXPECT_THAT(report, testing::HasSubstr("hypar:3x4"));
    }
    EXPECT_EQ(files().size(), 1U + 1U + (has_report_viewer() ? 5U : 4U))
        << "the net, the directory and what is in it";
}

TEST_F(Reproduce, KeepsTheDataSetAndTheModelWhenAskedTo) {
    reproduce("a/new/directory", "--keep");
    const DataSet data = read_data_set(folder() / "a/new/directory/data.h5").data;
    EXPECT_EQ(data.size(), 50);
    EXPECT_EQ(data.seed, 5U);
    const LengthModel model = read_model(folder() / "a/new/directory/model.h5").model;
    EXPECT_EQ(model.training_count(), 42);
    EXPECT_EQ(model.net_fingerprint, hypar(3, 4).fingerprint());
    EXPECT_EQ(exists("a/new/directory/report.html"), has_report_viewer());
}

TEST_F(Reproduce, PrintsThePapersFiguresBesideItsOwn) {
    const std::string text = reproduce("study");
    EXPECT_THAT(text, testing::HasSubstr("paper"));
    EXPECT_THAT(text, testing::HasSubstr("1.7e-08"));  // the paper's MSE
    EXPECT_THAT(text, testing::HasSubstr("13.8"));     // its largest nominal form error [mm]
    EXPECT_THAT(text, testing::HasSubstr("0.776"));    // and identified
    for (const std::string method :
         {"\n  gp_as_in_paper ", "\n  gp ", "\n  balance ", "\n  map "}) {
        EXPECT_THAT(text, testing::HasSubstr(method));
    }
    EXPECT_THAT(text, testing::HasSubstr("The paper's net is another one"));
    EXPECT_THAT(text, testing::HasSubstr(has_report_viewer() ? "report: study/report.html"
                                                             : "report: left out"));
}

TEST_F(Reproduce, TellsHowItCameAbout) {
    reproduce("study");
    const json results = json::parse(read("study/results.json"));
    EXPECT_EQ(
        results["command"],
        "taut reproduce --net net.json --samples 50 --validation 8 --prior uniform:3mm --seed 5 "
        "-o study --quiet");
    EXPECT_THAT(results["date"].get<std::string>(), testing::MatchesRegex("....-..-.. ..:.. UTC"));
}

TEST_F(Reproduce, TheReportCanBeMadeAgainFromTheResultAlone) {
    reproduce("study");
    const std::vector<std::string> report{"report", "study/results.json", "-o", "again.html"};
    if (has_report_viewer()) {
        must_run(report);
        EXPECT_EQ(read("again.html"), read("study/report.html"));
    } else {
        expect_error(run(report), 2, "built without Node.js");
    }
}

TEST_F(Reproduce, PrintsTheResultsAsJsonWhenAskedTo) {
    const std::string printed = reproduce("study", "--json");
    EXPECT_EQ(printed, read("study/results.json"));
}

TEST_F(Reproduce, GivesTheSameNumbersAgain) {
    const auto without_times = [this](const std::string& file) {
        json results = json::parse(read(file));
        results.erase("seconds");
        results.erase("date");
        results.erase("command");
        for (json& method : results["methods"]) {
            method.erase("seconds");
            method.erase("training_seconds");
        }
        return results;
    };
    reproduce("one");
    reproduce("two");
    EXPECT_EQ(without_times("one/results.json"), without_times("two/results.json"));
    EXPECT_EQ(read("one/edges.csv"), read("two/edges.csv"));
    EXPECT_EQ(read("one/nodes.csv"), read("two/nodes.csv"));
}

TEST_F(Reproduce, ReplacesAnEarlierStudyAndLeavesOtherFilesAlone) {
    reproduce("study");
    write("study/results.json", "old");
    write("study/notes.txt", "mine");
    reproduce("study");
    EXPECT_THAT(read("study/results.json"), testing::StartsWith("{"));
    EXPECT_EQ(read("study/notes.txt"), "mine");
}

TEST_F(Reproduce, WritesNothingWhereOneOfItsFilesCannotBeReplaced) {
    reproduce("study");
    for (const std::string name : {"results.json", "edges.csv", "data.h5", "model.h5"}) {
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
