// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the way from stations to lengths: the precision that `inspect --survey` predicts for a
// layout of stations must be that of `identify`, and wrong options are refused.

#include <cmath>

#include "app/program.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;
using testing::HasSubstr;

class PolarWorkflow : public ProgramTest {
protected:
    PolarWorkflow() {
        must_run({"example", "hypar:8x8", "-o", "net.json"});
        must_run({"form", "net.json", "--prior", "uniform:4mm", "--seed", "7", "-o", "built.csv",
                  "--lengths", "truth.csv"});
    }

    void survey(const Words& options) const {
        must_run(joined({"survey", "net.json", "built.csv", "-o", "polar.csv"}, options));
    }

    [[nodiscard]] json identified() const {
        return json::parse(run({"identify", "net.json", "polar.csv", "--prior", "uniform:4mm",
                                "--uncertain", "none", "--draws", "0", "--json"})
                               .out);
    }

    [[nodiscard]] double predicted() const {
        const json document =
            json::parse(run({"inspect", "net.json", "--survey", "polar.csv", "--prior",
                             "uniform:4mm", "--uncertain", "none", "--json"})
                            .out);
        return document["survey"]["rms_std"];
    }
};

double rms_std(const json& result) {
    double squares = 0.0;
    for (const json& edge : result["edges"]) {
        squares += std::pow(edge["std"].get<double>(), 2);
    }
    return std::sqrt(squares / static_cast<double>(result["edges"].size()));
}

TEST_F(PolarWorkflow, FindsTheLengthsBehindTwoStationsWithThePredictedPrecision) {
    survey({"--station", "1,-6,1.6", "--station=-6,2,1.6"});
    const json result = identified();
    const std::vector<double> truth = true_deviations();
    ASSERT_EQ(result["edges"].size(), truth.size());
    int inside = 0;
    for (size_t i = 0; i < truth.size(); ++i) {
        const json& edge = result["edges"][i];
        inside += edge["lower"] <= truth[i] && truth[i] <= edge["upper"] ? 1 : 0;
    }
    EXPECT_GE(inside, static_cast<int>(truth.size() * 88 / 100));
    EXPECT_EQ(result["trust"]["verdict"], "passed");
    EXPECT_NEAR(predicted(), rms_std(result), 0.15 * rms_std(result));
}

TEST_F(PolarWorkflow, UsesThePrecisionThatIsGivenAndWarnsWhereNoneIs) {
    survey({"--station", "1,-6,1.6"});
    edit("polar.csv", [](const std::string& line, int) {
        return line.substr(0, line.rfind(',', line.rfind(',') - 1));
    });
    const auto with = [&](const Words& options) {
        return run(joined({"identify", "net.json", "polar.csv", "--draws", "0"}, options));
    };
    EXPECT_THAT(with({}).err, HasSubstr("that of a common total station is assumed"));
    const Outcome given = with({"--angle", "0.6mgon", "--range", "2mm+2ppm"});
    EXPECT_EQ(given.err, "");
    EXPECT_THAT(given.out, HasSubstr("angles 0.6 mgon, distances 2 mm + 2 ppm"));
}

}  // namespace
