// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the way from a survey as it comes from site (noisy, partial, without names, in the frame
// of the instrument) to lengths: a target at a wrong node, or an interval that does not hold.

#include <cmath>

#include "app/built_net.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class SiteWorkflow : public BuiltNetTest {
protected:
    [[nodiscard]] json identified() const {
        return json::parse(must_run({"identify", "net.json", "survey.csv", "--json"}));
    }

    void expect_truth_within(const json& result, double rms, double least_coverage) const {
        const std::vector<double> deviations = true_deviations();
        ASSERT_EQ(result["edges"].size(), deviations.size());
        double squares = 0.0;
        for (size_t i = 0; i < deviations.size(); ++i) {
            const json& edge = result["edges"][i];
            squares += std::pow(edge["length_deviation"].get<double>() - deviations[i], 2);
            // The bounds of a prior are not sharp: its scale and mean are uncertain.
            EXPECT_GE(edge["lower"], -0.0055);
            EXPECT_LE(edge["upper"], 0.0055);
        }
        EXPECT_LT(std::sqrt(squares / static_cast<double>(deviations.size())), rms);
        EXPECT_GE(coverage(result), least_coverage);
    }
};

TEST_F(SiteWorkflow, FindsTheLengthsBehindAnExactSurvey) {
    survey({});
    const json result = identified();
    EXPECT_EQ(result["method"], "balance");
    expect_truth_within(result, 1e-10, 0.95);
}

TEST_F(SiteWorkflow, FindsTheLengthsBehindANoisyPartialSurveyWithoutNamesInAnotherFrame) {
    survey({"--noise", "0.5mm", "--drop", "10%", "--shuffle", "--frame", "random"});
    const json result = identified();
    EXPECT_EQ(result["method"], "map");
    EXPECT_EQ(result["survey"]["used"], 270);
    EXPECT_EQ(result["survey"]["missing"], 30);
    // The Cramér-Rao bound is some 0.8 mm with a tenth of the nodes hidden; of 536 intervals of
    // 95 % fewer than 92 % hold once in a thousand times.
    expect_truth_within(result, 1.0e-3, 0.92);
}

TEST_F(SiteWorkflow, SaysWhereTheFileHasAnotherNoiseThanTheOptionAndEstimatesIt) {
    survey({"--noise", "0.5mm"});
    const auto identified = [this](const std::string& noise) {
        return run({"identify", "net.json", "survey.csv", "--noise", noise, "--draws", "0", "-o",
                    "r.json"});
    };
    const auto printed = [&](const std::string& noise) { return identified(noise).out; };
    EXPECT_THAT(identified("2mm").err,
                HasSubstr("survey.csv: gives standard deviations of its own: "
                          "the noise of 2mm is not used"));
    EXPECT_EQ(identified("0.5mm").err, "");
    edit("survey.csv", [](const std::string& line, int) { return first_fields(line, 4); });
    EXPECT_THAT(printed("1mm"), Not(HasSubstr("Checks: passed")));
    EXPECT_THAT(printed("estimate"), HasSubstr("Checks: passed."));
    EXPECT_NEAR(json::parse(read("r.json"))["noise"].get<double>(), 0.5e-3, 0.05e-3);
}

TEST_F(SiteWorkflow, GivesTensionsWithIntervalsAndKeepsThePosteriorSamples) {
    survey({"--noise", "0.5mm", "--drop", "10%"});
    EXPECT_THAT(must_run({"identify", "net.json", "survey.csv", "-o", "r.json"}),
                AllOf(HasSubstr("mean tension: "),
                      HasSubstr("written to r_draws.h5: 200 posterior samples")));
    EXPECT_TRUE(exists("r_draws.h5"));
    const json result = json::parse(read("r.json"));
    EXPECT_EQ(result["draws"]["count"], 200);
    EXPECT_EQ(result["draws"]["reason"], nullptr);
    EXPECT_EQ(result["adjustable_edges"].size(), 128U);
    EXPECT_EQ(result["missing_places"].size(), 30U);
    for (const json& edge : result["edges"]) {
        ASSERT_LE(edge["tension_lower"], edge["tension"]);
        ASSERT_LE(edge["tension"], edge["tension_upper"]);
        EXPECT_EQ(edge["slack_probability"], 0.0);
    }
    const json none = identify("survey.csv", {"-o", "none.json"}).result;
    EXPECT_EQ(none["draws"], nullptr);
    EXPECT_EQ(none["edges"][0]["tension"], nullptr);
    EXPECT_FALSE(exists("none_draws.h5"));
}

}  // namespace
