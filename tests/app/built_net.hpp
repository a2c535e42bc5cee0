// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "app/program.hpp"

namespace taut::test {

/// The built-in net as it might be built, net.json, built.csv and truth.csv, to be surveyed.
class BuiltNetTest : public ProgramTest {
protected:
    BuiltNetTest() {
        must_have_run({{"example", "hilo-quarter", "-o", "net.json"},
                       {"form", "net.json", "--prior", "uniform:5mm", "--seed", "7", "-o",
                        "built.csv", "--lengths", "truth.csv"}});
    }

    void survey(const Words& options) const {
        must_run(joined({"survey", "net.json", "built.csv", "-o", "survey.csv"}, options));
    }

    /// The result of a survey, and what is printed on standard error.
    struct Identified {
        nlohmann::json result;
        std::string err;
    };

    /// Whatever it finds, a report reads it.
    Identified identify(const std::string& survey, const Words& options = {}) const {
        const Outcome outcome =
            run(joined({"identify", "net.json", survey, "--draws", "0", "--json"}, options));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        write("identified.json", outcome.out);
        must_run({"report", "identified.json", "-o", "report.html"});
        return {.result = nlohmann::json::parse(outcome.out, nullptr, false), .err = outcome.err};
    }

    /// How many intervals hold the truth.
    int count_inside(const nlohmann::json& result) const {
        const std::vector<double> deviations = true_deviations();
        EXPECT_EQ(result["edges"].size(), deviations.size());
        int inside = 0;
        for (size_t i = 0; i < deviations.size(); ++i) {
            const nlohmann::json& edge = result["edges"][i];
            inside += edge["lower"] <= deviations[i] && deviations[i] <= edge["upper"] ? 1 : 0;
        }
        return inside;
    }

    double coverage(const nlohmann::json& result) const {
        return count_inside(result) / static_cast<double>(result["edges"].size());
    }
};

}  // namespace taut::test
