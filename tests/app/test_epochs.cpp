// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the way from a first survey over turns to a second one: both are used, later commands know
// what was turned, and wrong options are refused in one line.
#include <algorithm>
#include <cmath>

#include "app/program.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;
using ::testing::HasSubstr;

class EpochCommand : public ProgramTest {
protected:
    EpochCommand() {
        must_have_run({{"example", "hypar:6x6", "-o", "net.json"},
                       {"form", "net.json", "--prior", "uniform:3mm", "--seed", "7", "-o",
                        "built.csv", "--lengths", "truth.csv"},
                       {"survey", "net.json", "built.csv", "--noise", "0.3mm", "-o", "first.csv"},
                       {"identify", "net.json", "first.csv", "--prior", "uniform:3mm", "--draws",
                        "50", "-o", "one.json"},
                       {"plan", "net.json", "one.json", "-o", "plan.json", "--csv", "turns.csv"},
                       {"form", "net.json", "--prior", "uniform:3mm", "--seed", "7", "--turned",
                        "turns.csv", "-o", "turned_form.csv"},
                       {"survey", "net.json", "turned_form.csv", "--noise", "0.3mm", "--seed", "2",
                        "-o", "second.csv"}});
    }

    [[nodiscard]] Outcome identify(const std::string& epoch,
                                   const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"identify",    "net.json", "first.csv", "--prior",
                                       "uniform:3mm", "--draws",  "50",        "--epoch",
                                       epoch,         "-o",       "both.json"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    [[nodiscard]] double mean_variance(const std::string& file) const {
        double sum = 0.0;
        const json edges = json::parse(read(file))["edges"];
        for (const json& edge : edges) {
            sum += std::pow(edge["std"].get<double>(), 2);
        }
        return sum / static_cast<double>(edges.size());
    }
};

TEST_F(EpochCommand, TakesTheListThatWasFilledInAsExcelFile) {
    // With a warning, as what the turns gain is little.
    ASSERT_EQ(run({"export", "plan.json", "--to", "xlsx", "-o", "turns.xlsx"}).exit_code, 0);
    const auto turned = [&](const std::string& list) {
        const Outcome outcome = identify("second.csv:" + list);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return json::parse(read("both.json"))["turned"];
    };
    const json as_text = turned("turns.csv");
    const json as_sheet = turned("turns.xlsx");
    ASSERT_EQ(as_sheet.size(), as_text.size());
    ASSERT_GT(as_sheet.size(), 0U);
    for (size_t i = 0; i < as_text.size(); ++i) {
        EXPECT_EQ(as_sheet[i]["id"], as_text[i]["id"]);
        // The text is rounded to a thousandth of a millimetre.
        EXPECT_NEAR(as_sheet[i]["stroke"].get<double>(), as_text[i]["stroke"].get<double>(), 1e-6);
    }
}

TEST_F(EpochCommand, LeadsToAPlanOfTheRemainingTurns) {
    const Outcome outcome = identify("second.csv:turns.csv");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("Checks: passed"));
    EXPECT_THAT(outcome.out, HasSubstr("survey second.csv"));
    EXPECT_THAT(outcome.out, HasSubstr("survey 2: 36 free nodes"));
    const json result = json::parse(read("both.json"));
    ASSERT_EQ(result["epochs"].size(), 2U);
    EXPECT_FALSE(result["turned"].empty());
    EXPECT_EQ(result["turned"], result["epochs"][1]["turned"]);
    EXPECT_LT(mean_variance("both.json"), mean_variance("one.json"));
    // The plan starts from where the net stands: there is little left to do.
    must_run({"plan", "net.json", "both.json", "-o", "again.json"});
    const json before = json::parse(read("plan.json"));
    const json again = json::parse(read("again.json"));
    EXPECT_LT(again["largest_stroke"].get<double>(), 0.5 * before["largest_stroke"].get<double>());
    // So does an export.
    must_run({"export", "both.json", "--to", "net", "-o", "as_built.json"});
    const json exported = json::parse(read("as_built.json"));
    const json designed = json::parse(read("net.json"));
    const json& turned = result["turned"][0];
    const auto edge = turned["edge"].get<size_t>();
    const auto estimate = std::ranges::find_if(result["uncertain"], [&](const json& one) {
        return one["name"] == "adjustable" && one["edge"] == edge;
    });
    ASSERT_NE(estimate, result["uncertain"].end());
    EXPECT_EQ((*estimate)["given"], "adjustable:0.5mm");
    EXPECT_NEAR(exported["unstressed_lengths"][edge].get<double>(),
                designed["unstressed_lengths"][edge].get<double>() +
                    turned["stroke"].get<double>() + (*estimate)["mean"].get<double>(),
                1e-9);
    must_run({"report", "both.json", "-o", "both.html"});
}

TEST_F(EpochCommand, HasTheEdgesThatWereTurnedInTheTruth) {
    must_run({"form", "net.json", "--prior", "uniform:3mm", "--seed", "7", "--turned", "turns.csv",
              "--lengths", "turned_truth.csv", "-o", "form.csv"});
    const std::string before = read("truth.csv");
    const std::string after = read("turned_truth.csv");
    ASSERT_TRUE(after.starts_with(before));
    const json plan = json::parse(read("plan.json"));
    EXPECT_EQ(std::ranges::count(after.substr(before.size()), '\n'), plan["touched"].get<int>());
    must_run({"export", "net.json", "form.csv", "--lengths", "turned_truth.csv", "--to", "csv",
              "-o", "nodes.csv"});
}

TEST_F(EpochCommand, ShowsWidthsOfAFewDigits) {
    std::string turned = "edge,stroke,std\n";
    const json plan = json::parse(read("plan.json"));
    for (const json& turn : plan["turns"]) {
        turned +=
            turn["edge_id"].get<std::string>() + "," + turn["stroke"].dump() + ",0.000123456789\n";
    }
    write("turned.csv", turned);
    ASSERT_EQ(identify("second.csv:turned.csv", {"--uncertain", "none"}).exit_code, 0);
    EXPECT_THAT(json::parse(read("both.json"))["uncertain"].dump(),
                HasSubstr(R"("given":"adjustable:0.124mm")"));
}

}  // namespace
