// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a comparison whose files are incomplete, or that leaves something half done.

#include <algorithm>
#include <cmath>
#include <map>

#include "app/program.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/report/report_html.hpp"
#include "taut/study/comparison.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using nlohmann::json;

class Compare : public ProgramTest {
protected:
    Compare() { must_run({"example", "hypar:6x6", "-o", "net.json"}); }

    std::string compare(const std::string& directory, const std::string& extra = "--quiet") const {
        return must_run({"compare", "net.json", "-o", directory, "--noise", "0,0.5mm", "--training",
                         "20,30", "--hidden", "0,25%", "--surveys", "4", "--prior", "uniform:3mm",
                         "--seed", "5", extra});
    }
};

TEST_F(Compare, WritesARowForEachMethodAndKindOfSurvey) {
    compare("out");
    const json document = json::parse(read("out/comparison.json"));
    EXPECT_EQ(document["format"], "taut-comparison");
    EXPECT_EQ(document["version"], 1);
    EXPECT_EQ(document["net"]["name"], "hypar:6x6");
    EXPECT_EQ(document["prior"], "uniform:3mm");
    EXPECT_EQ(document["samples"]["total"], 34);
    ASSERT_EQ(document["rows"].size(), 2U * 4 + 2U * 2 + 4);
    for (const json& row : document["rows"]) {
        EXPECT_EQ(row["surveys"], 4);
        const bool can = row["failed"] == 0;
        EXPECT_EQ(row["mse"].is_number(), can) << row;
        EXPECT_EQ(row["coverage"].is_number(), can);
        EXPECT_EQ(row["first_failure"].is_null(), can);
        EXPECT_EQ(row["best_possible_mse"].is_number(), row["noise"] > 0.0);
        const bool is_trained = row["method"] == "gp" || row["method"] == "gp_as_in_paper";
        EXPECT_EQ(row["training_samples"].is_number(), is_trained);
    }
    EXPECT_EQ(files().size(), 1U + 1U + (has_report_viewer() ? 3U : 2U));
}

TEST_F(Compare, TellsTheNumbersOfTheComparison) {
    compare("out");
    const json document = json::parse(read("out/comparison.json"));
    const Comparison comparison =
        compare_methods(hypar(6, 6), {.noises = {0.0, 5e-4},
                                      .training_samples = {20, 30},
                                      .hidden_parts = {0.25},
                                      .surveys = 4,
                                      .prior = parse_length_prior("uniform:3mm"),
                                      .seed = 5});
    ASSERT_EQ(document["rows"].size(), comparison.rows.size());
    for (size_t i = 0; i < comparison.rows.size(); ++i) {
        const json& row = document["rows"][i];
        const ComparisonRow& expected = comparison.rows[i];
        EXPECT_EQ(row["method"], expected.result.name);
        EXPECT_EQ(row["noise"], expected.kind.noise_std);
        EXPECT_EQ(row["hidden_fraction"], expected.kind.hidden_part);
        if (expected.result.identified() > 0) {
            EXPECT_DOUBLE_EQ(row["mse"], expected.result.errors.mse);
            EXPECT_DOUBLE_EQ(row["mrse"], expected.result.errors.mrse);
            EXPECT_DOUBLE_EQ(row["form_error"], expected.result.form_error.mean);
            EXPECT_DOUBLE_EQ(row["coverage"], expected.result.coverage);
        }
    }
}

TEST_F(Compare, WritesTheSameNumbersAsATable) {
    compare("out");
    const json rows = json::parse(read("out/comparison.json"))["rows"];
    std::istringstream csv(read("out/comparison.csv"));
    std::string line;
    std::getline(csv, line);
    EXPECT_THAT(line, testing::StartsWith("method,noise,hidden_fraction,training_samples,"));
    const auto commas = std::ranges::count(line, ',');
    for (const json& row : rows) {
        ASSERT_TRUE(std::getline(csv, line));
        EXPECT_THAT(line, testing::StartsWith(row["method"].get<std::string>() + ","));
        EXPECT_EQ(row["mse"].is_null() || line.find(row["mse"].dump()) != std::string::npos, true)
            << line;
        EXPECT_GE(std::ranges::count(line, ','), commas);
    }
    EXPECT_FALSE(std::getline(csv, line));
}

TEST_F(Compare, TriesNetsThatDifferInMoreThanLengthsToldAndNot) {
    const std::string text =
        must_run({"compare", "net.json", "-o", "out", "--noise", "0.5mm", "--training", "60",
                  "--hidden", "0", "--surveys", "8", "--prior", "uniform:2mm", "--uncertain",
                  "supports:2mm", "--uncertain", "stiffness:5%"});
    EXPECT_THAT(text, testing::HasSubstr("On nets that differ in more than lengths, noise 0.5 mm"));
    const json document = json::parse(read("out/comparison.json"));
    EXPECT_EQ(document["uncertain"], (json{"supports:2mm", "stiffness:5%"}));
    std::map<std::string, double> coverage;
    for (const json& row : document["model_error_rows"]) {
        coverage[row["method"].get<std::string>() + " " + row["model_errors"].get<std::string>()] =
            row["coverage"];
    }
    EXPECT_EQ(coverage.size(), 6U);  // four methods not given them, gp and map given
    EXPECT_LT(coverage["map not given"], 0.9);
    EXPECT_GT(coverage["map given"], 0.9);
    for (const json& row : document["rows"]) {
        EXPECT_EQ(row["model_errors"], "none");
    }
}

TEST_F(Compare, TellsWhatSurveysAddWithAndWithoutTurnsInBetween) {
    const std::string text =
        must_run({"compare", "net.json", "-o", "out", "--noise", "0.5mm", "--training", "60",
                  "--hidden", "0", "--surveys", "12", "--prior", "uniform:2mm", "--epochs", "3"});
    EXPECT_THAT(text, testing::HasSubstr("Over the surveys of each net, all used at once"));
    const json document = json::parse(read("out/comparison.json"));
    std::map<std::string, double> mse;
    for (const json& row : document["epoch_rows"]) {
        EXPECT_EQ(row["method"].get<std::string>(), "map");
        EXPECT_EQ(row["failed"], 0);
        EXPECT_GT(row["coverage"], 0.9);
        mse[std::to_string(row["epochs"].get<int>()) + (row["turned"].get<bool>() ? "t" : "")] =
            row["mse"];
    }
    EXPECT_EQ(mse.size(), 5U);
    EXPECT_LT(mse["2"], 0.8 * mse["1"]);
    EXPECT_LT(mse["2t"], 0.8 * mse["1"]);
    EXPECT_LT(mse["3"], mse["2"]);
    EXPECT_LT(mse["3t"], mse["2t"]);
    EXPECT_EQ(run({"compare", "net.json", "-o", "out", "--epochs", "0"}).exit_code, 2);
    EXPECT_EQ(run({"compare", "net.json", "-o", "out", "--noise", "0", "--epochs", "2"}).exit_code,
              2);
}

TEST_F(Compare, PrintsATableForEachAxis) {
    const std::string text = compare("out");
    for (const std::string words :
         {"Over the noise [mm] of a coordinate, 30 training samples",
          "Over the training samples, noise 0 mm", "Over the training samples, noise 0.5 mm",
          "Over the hidden nodes, noise 0.5 mm", "best possible", "gp_as_in_paper", "balance",
          "needs a survey of all free nodes"}) {
        EXPECT_THAT(text, testing::HasSubstr(words));
    }
    EXPECT_THAT(text, testing::HasSubstr(has_report_viewer() ? "report: out/report.html"
                                                             : "report: left out"));
}

TEST_F(Compare, MakesAReportThatItsFileAloneGivesAgain) {
    compare("out");
    if (has_report_viewer()) {
        must_run({"report", "out/comparison.json", "-o", "again.html"});
        EXPECT_EQ(read("again.html"), read("out/report.html"));
    }
}

TEST_F(Compare, PrintsTheResultAsJsonWhenAskedTo) {
    const std::string printed = compare("out", "--json");
    EXPECT_EQ(printed, read("out/comparison.json"));
}

TEST_F(Compare, WritesNothingWhereOneOfItsFilesCannotBeReplaced) {
    std::filesystem::create_directories(folder() / "out/comparison.csv");
    const Files before = files();
    expect_error(run({"compare", "net.json", "-o", "out", "--noise", "0", "--training", "20",
                      "--hidden", "0", "--surveys", "2"}),
                 2, "comparison.csv");
    EXPECT_EQ(files(), before);
}

}  // namespace
