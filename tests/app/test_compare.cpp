// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a comparison whose files are incomplete or disagree, or that leaves something half
// done.

#include "app/program.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/report/report_html.hpp"
#include "taut/study/comparison.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class Compare : public ProgramTest {
protected:
    Compare() { must_have_run({{"example", "hypar:4x5", "-o", "net.json"}}); }
};

TEST_F(Compare, WritesTheNumbersOfTheLibraryAsJsonAsTableAndAsReport) {
    const Words command{"compare",    "net.json",    "-o",       "out",   "--noise",   "0,0.5mm",
                        "--training", "20,30",       "--hidden", "0,25%", "--surveys", "4",
                        "--prior",    "uniform:3mm", "--seed",   "5"};
    const std::string text = must_run(command);
    for (const std::string words :
         {"Over the noise [mm] of a coordinate, 30 training samples",
          "Over the training samples, noise 0 mm", "Over the training samples, noise 0.5 mm",
          "Over the hidden nodes, noise 0.5 mm", "Cramér-Rao", "gp_as_in_paper", "balance"}) {
        EXPECT_THAT(text, HasSubstr(words));
    }
    EXPECT_THAT(text,
                HasSubstr(has_report_viewer() ? "report: out/report.html" : "report: left out"));
    const Comparison comparison =
        compare_methods(hypar(4, 5), {.noises = {0.0, 5e-4},
                                      .training_samples = {20, 30},
                                      .hidden_parts = {0.25},
                                      .surveys = 4,
                                      .prior = parse_length_prior("uniform:3mm"),
                                      .seed = 5});
    const json document = json::parse(read("out/comparison.json"));
    const Words table = lines("out/comparison.csv");
    EXPECT_EQ(document["format"], "taut-comparison");
    EXPECT_EQ(document["prior"], "uniform:3mm");
    EXPECT_EQ(document["samples"]["total"], 34);
    ASSERT_EQ(document["rows"].size(), 2U * 4 + 2U * 2 + 4);
    ASSERT_EQ(document["rows"].size(), comparison.rows.size());
    ASSERT_EQ(table.size(), comparison.rows.size() + 1);
    EXPECT_THAT(table[0], StartsWith("method,noise,hidden_fraction,training_samples,"));
    for (size_t i = 0; i < comparison.rows.size(); ++i) {
        const json& row = document["rows"][i];
        const ComparisonRow& expected = comparison.rows[i];
        EXPECT_EQ(row["method"], expected.result.name);
        EXPECT_EQ(row["noise"], expected.kind.noise_std);
        EXPECT_EQ(row["hidden_fraction"], expected.kind.hidden_part);
        EXPECT_EQ(row["cramer_rao_mse"].is_number(), row["noise"] > 0.0);
        EXPECT_EQ(row["training_samples"].is_number(),
                  row["method"].get<std::string>().starts_with("gp"));
        EXPECT_THAT(table[i + 1], StartsWith(expected.result.name + ","));
        const bool can = expected.result.identified() > 0;
        EXPECT_EQ(row["first_failure"].is_null(), expected.result.failed == 0);
        ASSERT_EQ(row["mse"].is_number(), can) << row;
        if (can) {
            EXPECT_DOUBLE_EQ(row["mse"], expected.result.errors.mse);
            EXPECT_DOUBLE_EQ(row["mrse"], expected.result.errors.mrse);
            EXPECT_DOUBLE_EQ(row["form_error"], expected.result.form_error.mean);
            EXPECT_DOUBLE_EQ(row["coverage"], expected.result.coverage);
            EXPECT_THAT(table[i + 1], HasSubstr(row["mse"].dump()));
        }
    }
    EXPECT_EQ(files().size(), 1U + 1U + (has_report_viewer() ? 3U : 2U));
    const std::string printed = must_run(joined(command, {"--json"}));
    EXPECT_EQ(printed, read("out/comparison.json"));
    if (has_report_viewer()) {
        must_run({"report", "out/comparison.json", "-o", "again.html"});
        EXPECT_EQ(read("again.html"), read("out/report.html"));
    }
}

TEST_F(Compare, AddsNetsWithModelErrorsAndSeveralSurveysOfOneNet) {
    EXPECT_THAT(must_run({"compare", "net.json", "-o", "out", "--noise", "0.5mm", "--training",
                          "20", "--hidden", "0", "--surveys", "2", "--uncertain", "supports:2mm",
                          "--uncertain", "stiffness:5%", "--epochs", "2"}),
                AllOf(HasSubstr("On nets with model errors, noise 0.5 mm"),
                      HasSubstr("Over the number of surveys used together")));
    const json document = json::parse(read("out/comparison.json"));
    EXPECT_EQ(document["uncertain"], (json{"supports:2mm", "stiffness:5%"}));
    EXPECT_EQ(document["model_error_rows"].size(), 6U);
    EXPECT_EQ(document["epoch_rows"].size(), 3U);
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
