// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards posterior covariances between lengths on the command line: that they agree with the
// standard deviations and the draws, and one line for edges that have none.
#include <cmath>

#include "app/program.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;
using ::testing::HasSubstr;

class LengthCovarianceOption : public ProgramTest {
protected:
    LengthCovarianceOption() {
        must_run({"example", "hypar:6x6", "-o", "net.json"});
        must_run({"form", "net.json", "--prior", "uniform:3mm", "--seed", "7", "-o", "built.csv"});
        must_run({"survey", "net.json", "built.csv", "--noise", "0.3mm", "-o", "survey.csv"});
    }

    [[nodiscard]] Outcome identify(std::vector<std::string> options) const {
        options.insert(options.begin(),
                       {"identify", "net.json", "survey.csv", "--prior", "uniform:3mm", "--draws",
                        "20", "--covariance-of", "edges.txt"});
        return run(options);
    }
};

TEST_F(LengthCovarianceOption, HoldsTheSquaredStandardDeviations) {
    write("edges.txt", "20\n7\n22\n");
    ASSERT_EQ(identify({"-o", "result.json"}).exit_code, 0);
    const json result = json::parse(read("result.json"));
    const json& told = result["length_covariance"];
    EXPECT_EQ(told["edges"], json({20, 7, 22}));
    EXPECT_EQ(told["ids"], json({"20", "7", "22"}));
    const json& covariance = told["covariance"];
    ASSERT_EQ(covariance.size(), 3U);
    const auto at = [&](size_t i, size_t k) { return covariance[i][k].get<double>(); };
    for (const json& edge : result["edges"]) {
        for (size_t k = 0; k < 3; ++k) {
            if (edge["edge"] == told["edges"][k]) {
                const auto std = edge["std"].get<double>();
                EXPECT_NEAR(at(k, k), std * std, 1e-9 * std * std);
            }
        }
    }
    for (size_t i = 0; i < 3; ++i) {
        for (size_t k = 0; k < i; ++k) {
            EXPECT_EQ(at(i, k), at(k, i));
            EXPECT_LT(std::abs(at(i, k)), std::sqrt(at(i, i) * at(k, k)));
        }
    }
    // A report is made of it as of any other.
    must_run({"report", "result.json", "-o", "result.html"});
}

TEST_F(LengthCovarianceOption, IsNullWhereNoneWereAskedFor) {
    must_run({"identify", "net.json", "survey.csv", "--draws", "0", "-o", "result.json"});
    EXPECT_TRUE(json::parse(read("result.json"))["length_covariance"].is_null());
}

TEST_F(LengthCovarianceOption, RefusesEdgesThatHaveNone) {
    const auto refused = [&](const std::string& edges, std::vector<std::string> options,
                             const char* words) {
        write("edges.txt", edges);
        const Outcome outcome = identify(std::move(options));
        EXPECT_EQ(outcome.exit_code, 2) << edges;
        EXPECT_THAT(outcome.err, HasSubstr(words)) << edges;
        EXPECT_FALSE(exists("result.json"));
    };
    const json net = json::parse(read("net.json"));
    refused(std::to_string(net["edges"].size() - 1) + "\n", {"-o", "result.json"},
            "which is adjustable");
    refused("20\n20\n", {"-o", "result.json"}, "a second time");
    refused("nowhere\n", {"-o", "result.json"}, "edges.txt:1");
    refused("", {"-o", "result.json"}, "edges.txt");
    refused("20\n", {}, "-o or --json");
    refused("20\n", {"--method", "gp", "-o", "result.json"}, "for --method map");
}

}  // namespace
