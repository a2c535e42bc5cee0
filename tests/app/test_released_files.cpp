// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against files of older versions that are no longer read, or read as something else. Each
// folder of tests/data/released/ holds files that the program of that version wrote; a release adds
// one.

#include <algorithm>
#include <filesystem>

#include "app/program.hpp"
#include "taut/report/report_html.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using nlohmann::json;

class FilesOfRelease : public ProgramTest, public testing::WithParamInterface<const char*> {
protected:
    FilesOfRelease() {
        std::filesystem::copy(std::filesystem::path(TAUT_TEST_DATA_DIR) / "released" / GetParam(),
                              folder(), std::filesystem::copy_options::recursive);
    }
};

TEST_P(FilesOfRelease, NetFormAndSurveyGiveTheLengthsOfThen) {
    must_run({"form", "net.json", "-o", "form.csv"});
    const json now = json::parse(
        must_run({"identify", "net.json", "survey.csv", "--prior", "uniform:2mm", "--prior-exact",
                  "--uncertain", "none", "--draws", "40", "-o", "now.json", "--json"}));
    const json then = json::parse(read("result.json"));
    ASSERT_EQ(now["edges"].size(), then["edges"].size());
    for (size_t i = 0; i < then["edges"].size(); ++i) {
        EXPECT_NEAR(now["edges"][i]["length_deviation"].get<double>(),
                    then["edges"][i]["length_deviation"].get<double>(), 1e-6);
    }
}

TEST_P(FilesOfRelease, DataSetAndModelAreStillUsed) {
    const auto has_no_digest = testing::HasSubstr("has no digest");
    EXPECT_THAT(run({"train", "data.h5", "-o", "again.h5"}).err, has_no_digest);
    const auto by_model = [&](const std::string& model) {
        return run(
            {"identify", "net.json", "survey.csv", "--model", model, "-o", "gp.json", "--json"});
    };
    const Outcome by_old = by_model("model.h5");
    const Outcome by_new = by_model("again.h5");
    EXPECT_THAT(by_old.err, has_no_digest);
    EXPECT_EQ(by_new.err, "");
    const json then = json::parse(by_old.out)["edges"];
    const json now = json::parse(by_new.out)["edges"];
    for (size_t i = 0; i < then.size(); ++i) {
        EXPECT_NEAR(now[i]["length_deviation"].get<double>(),
                    then[i]["length_deviation"].get<double>(), 1e-6);
    }
}

TEST_P(FilesOfRelease, ResultWithItsSamplesAndTurnsIsPlannedOn) {
    const json then = json::parse(read("plan.json"));
    const json now =
        json::parse(must_run({"plan", "net.json", "result.json", "-o", "now.json", "--json"}));
    EXPECT_EQ(now["draws"], then["draws"]);
    EXPECT_NEAR(now["form"]["planned"]["normal_rmse"].get<double>(),
                then["form"]["planned"]["normal_rmse"].get<double>(), 1e-6);
    must_run({"form", "net.json", "--turned", "turns.csv", "-o", "turned.csv"});
    must_run({"export", "net.json", "site.csv", "--lengths", "lengths.csv", "--to", "csv", "-o",
              "site_net.csv"});
}

TEST_P(FilesOfRelease, ResultAndPlanAreShown) {
    for (const std::string name : {"result", "plan"}) {
        if (has_report_viewer()) {
            must_run({"report", name + ".json", "-o", name + ".html"});
            EXPECT_GT(std::filesystem::file_size(folder() / (name + ".html")), 100'000U) << name;
        } else {
            expect_error(run({"report", name + ".json", "-o", name + ".html"}), 2, "Node.js");
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Versions, FilesOfRelease, testing::Values("0.1.0"),
                         [](const auto& version) {
                             std::string name = std::string("Of_") + version.param;
                             std::ranges::replace(name, '.', '_');
                             return name;
                         });

}  // namespace
