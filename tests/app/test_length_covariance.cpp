// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards --covariance-of: its covariances agree with the standard deviations of the result, and
// edges that have none are refused.
#include "app/program.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;

class LengthCovarianceOption : public ProgramTest {
protected:
    LengthCovarianceOption() {
        must_run({"example", "hypar:6x6", "-o", "net.json"});
        must_run({"form", "net.json", "--prior", "uniform:3mm", "--seed", "7", "-o", "built.csv"});
        must_run({"survey", "net.json", "built.csv", "--noise", "0.3mm", "-o", "survey.csv"});
    }

    [[nodiscard]] Outcome identify(const Words& options) const {
        return run(joined({"identify", "net.json", "survey.csv", "--prior", "uniform:3mm",
                           "--draws", "20", "--covariance-of", "edges.txt"},
                          options));
    }
};

TEST_F(LengthCovarianceOption, HasTheSquaredStandardDeviationsInTheOrderOfTheList) {
    write("edges.txt", "20\n7\n22\n");
    ASSERT_EQ(identify({"-o", "result.json"}).exit_code, 0);
    const json result = json::parse(read("result.json"));
    const json& written = result["length_covariance"];
    EXPECT_EQ(written["edges"], json({20, 7, 22}));
    EXPECT_EQ(written["ids"], json({"20", "7", "22"}));
    for (const json& edge : result["edges"]) {
        for (size_t k = 0; k < 3; ++k) {
            if (edge["edge"] == written["edges"][k]) {
                const auto std = edge["std"].get<double>();
                EXPECT_NEAR(written["covariance"][k][k].get<double>(), std * std, 1e-9 * std * std);
            }
        }
    }
}

TEST_F(LengthCovarianceOption, RefusesEdgesWithoutCovariancesAndARunWithoutResult) {
    const auto refused = [&](const std::string& edges, const Words& options, const char* words) {
        write("edges.txt", edges);
        expect_error(identify(options), 2, words);
        EXPECT_FALSE(exists("result.json"));
    };
    const json net = json::parse(read("net.json"));
    refused(std::to_string(net["edges"].size() - 1) + "\n", {"-o", "result.json"},
            "which is adjustable");
    refused("nowhere\n", {"-o", "result.json"}, "edges.txt:1");
    refused("", {"-o", "result.json"}, "edges.txt");
    refused("20\n", {}, "-o or --json");
}

}  // namespace
