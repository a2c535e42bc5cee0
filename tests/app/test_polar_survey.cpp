// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the way from stations to lengths on the command line: what `inspect --survey` promises of
// a layout of stations must be what `identify` then gives, and what is told wrong is refused.

#include <cmath>
#include <sstream>

#include "app/program.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;

class PolarWorkflow : public ProgramTest {
protected:
    PolarWorkflow() {
        must_run({"example", "hypar:8x8", "-o", "net.json"});
        must_run({"form", "net.json", "--prior", "uniform:4mm", "--seed", "7", "-o", "built.csv",
                  "--lengths", "truth.csv"});
    }

    void survey(std::vector<std::string> options) const {
        options.insert(options.begin(), {"survey", "net.json", "built.csv", "-o", "readings.csv"});
        must_run(options);
    }

    [[nodiscard]] json identified() const {
        return json::parse(run({"identify", "net.json", "readings.csv", "--prior", "uniform:4mm",
                                "--uncertain", "none", "--draws", "0", "--json"})
                               .out);
    }

    [[nodiscard]] double forecast() const {
        const json told =
            json::parse(run({"inspect", "net.json", "--survey", "readings.csv", "--prior",
                             "uniform:4mm", "--uncertain", "none", "--json"})
                            .out);
        return told["survey"]["rms_std"];
    }
};

double rms_std(const json& result) {
    double squares = 0.0;
    for (const json& edge : result["edges"]) {
        squares += std::pow(edge["std"].get<double>(), 2);
    }
    return std::sqrt(squares / static_cast<double>(result["edges"].size()));
}

TEST_F(PolarWorkflow, FindsTheLengthsBehindReadingsOfTwoStations) {
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
    EXPECT_NEAR(forecast(), rms_std(result), 0.15 * rms_std(result));
}

TEST_F(PolarWorkflow, TellsWhichLayoutOfStationsIsBetter) {
    survey({"--station", "1,-6,1.6", "--range", "2mm+2ppm"});
    const double one = forecast();
    survey({"--station", "1,-6,1.6", "--station", "-6,2,1.6", "--range", "2mm+2ppm"});
    EXPECT_LT(forecast(), 0.8 * one);
}

TEST_F(PolarWorkflow, WarnsWhereNoPrecisionIsTold) {
    survey({"--station", "1,-6,1.6"});
    std::string text;
    std::istringstream lines(read("readings.csv"));
    for (std::string line; std::getline(lines, line);) {
        text += line.substr(0, line.rfind(',', line.rfind(',') - 1)) + "\n";
    }
    write("readings.csv", text);
    const std::vector<std::string> identify{"identify", "net.json", "readings.csv", "--draws", "0"};
    EXPECT_NE(run(identify).err.find("tells no precision of its readings: a common total "
                                     "station's is taken, angles 0.3 mgon, distances 1 mm + 1.5 "
                                     "ppm (--angle, --range)"),
              std::string::npos);
    std::vector<std::string> told = identify;
    told.insert(told.end(), {"--angle", "0.6mgon", "--range", "2mm+2ppm"});
    EXPECT_NE(must_run(told).find("angles 0.6 mgon, distances 2 mm + 2 ppm"), std::string::npos);
}

TEST_F(PolarWorkflow, RefusesWhatIsToldWrongInOneLine) {
    survey({"--station", "1,-6,1.6"});
    const auto with = [&](const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"identify", "net.json", "readings.csv"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return run(arguments);
    };
    expect_error(with({"--angle", "0.3"}), 2, "'0.3' is no angle");
    expect_error(with({"--angle", "0gon"}), 2, "--angle is '0gon', expected");
    expect_error(with({"--range", "1mm+1"}), 2, "'1mm+1' is no precision of distances");
    const std::vector<std::string> survey_of{"survey", "net.json", "built.csv", "-o", "s.csv"};
    std::vector<std::string> bad = survey_of;
    bad.insert(bad.end(), {"--station", "1,2"});
    expect_error(run(bad), 2, "--station is '1,2', expected a place in m");
    bad = survey_of;
    bad.insert(bad.end(), {"--angle", "0.3mgon"});
    EXPECT_EQ(run(bad).exit_code, 2);
    must_run({"survey", "net.json", "built.csv", "--noise", "1mm", "-o", "points.csv"});
    expect_error(run({"identify", "net.json", "points.csv", "--angle", "0.3mgon"}), 2,
                 "points.csv: holds no readings of angles and distances");
}

}  // namespace
