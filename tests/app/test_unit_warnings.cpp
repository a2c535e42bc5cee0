// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a slip of units that commands take in silence.

#include <fmt/core.h>

#include <sstream>

#include "app/program.hpp"
#include "support/foreign_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/io/net_json.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class UnitWarnings : public ProgramTest {
protected:
    UnitWarnings() {
        write("net.json", net_to_json(hypar(2, 3)));
        CableNetData data = hypar(2, 3).data();
        data.nodes *= 1000.0;
        data.unstressed_lengths *= 1000.0;
        write("mm.json", net_to_json(CableNet(data)));
        data.nodes /= 1000.0;
        write("long.json", net_to_json(CableNet(std::move(data))));
    }

    /// Succeeds with one warning, which stands in the JSON as well.
    void expect_warning(std::vector<std::string> arguments, const std::string& text) const {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_THAT(outcome.err, AllOf(StartsWith("taut: warning: "), HasSubstr(text)));
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
        arguments.emplace_back("--json");
        const json document = json::parse(run(arguments).out);
        ASSERT_EQ(document["warnings"].size(), 1U) << arguments.front();
        EXPECT_THAT(document["warnings"][0].get<std::string>(), HasSubstr(text));
    }
};

TEST_F(UnitWarnings, NameANetInMillimetres) {
    const std::string question = "are its coordinates in mm?";
    expect_warning({"inspect", "mm.json"}, question);
    expect_warning({"form", "mm.json"}, question);
    expect_warning({"sample", "mm.json", "-n", "1", "-o", "data.h5"}, question);
}

TEST_F(UnitWarnings, AreErrorsWhereNoUnitMakesANet) {
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"inspect", "long.json"},
          {"form", "long.json"},
          {"sample", "long.json", "-n", "1", "-o", "data.h5"},
          {"export", "long.json", "--to", "obj", "-o", "net.obj"}}) {
        expect_error(run(command), 2, "times the lengths of their edges in the median");
    }
}

TEST_F(UnitWarnings, NameWhatIsForgottenOfAnImportedNet) {
    write("mesh.json", old_compas_mesh().dump());
    expect_warning({"import", "mesh.json", "--loads", "balance", "-o", "a.json"},
                   "--force-unit kN");
    expect_warning({"import", "mesh.json", "--force-unit", "kN", "--loads", "none", "-o", "b.json"},
                   "--loads balance");
    expect_warning({"inspect", "a.json"}, "--force-unit kN");
    expect_warning({"inspect", "b.json"}, "--loads balance");
}

TEST_F(UnitWarnings, NameANoiseInMetres) {
    must_run({"form", "net.json", "-o", "form.csv"});
    expect_warning({"survey", "net.json", "form.csv", "--noise", "0.01", "-o", "survey.csv"},
                   "is 0.01mm meant?");
    expect_error(run({"survey", "net.json", "form.csv", "--noise", "5", "-o", "survey.csv"}), 2,
                 "is 5mm meant?");
    const Outcome outcome =
        run({"inspect", "net.json", "--survey", "form.csv", "--noise", "0.05", "--json"});
    EXPECT_THAT(outcome.err, StartsWith("taut: warning: form.csv: noise of 50mm"));
    EXPECT_EQ(json::parse(outcome.out)["survey"]["warnings"].size(), 1U);
}

TEST_F(UnitWarnings, NameASurveyOfAnotherScaleAndStandInTheResult) {
    must_run({"example", "hilo-quarter", "-o", "quarter.json"});
    must_run({"form", "quarter.json", "-o", "form.csv"});
    must_run({"survey", "quarter.json", "form.csv", "--noise", "0.5mm", "-o", "survey.csv"});
    must_run({"inspect", "quarter.json", "--survey", "survey.csv"});
    edit("survey.csv", [](const std::string& line, int number) {
        std::string text = first_fields(line, 1);
        std::istringstream fields(line.substr(text.size() + 1));
        int k = 0;
        for (std::string field; number > 0 && std::getline(fields, field, ','); ++k) {
            text += fmt::format(",{}", (k < 3 ? 1.0005 : 1.0) * std::stod(field));
        }
        return number > 0 ? text : line;
    });
    const auto warned = StartsWith("taut: warning: survey.csv: its 128 supports");
    EXPECT_THAT(run({"inspect", "quarter.json", "--survey", "survey.csv"}).err, warned);
    const Outcome outcome =
        run({"identify", "quarter.json", "survey.csv", "--draws", "0", "-o", "result.json"});
    EXPECT_THAT(outcome.err, warned);
    if (outcome.exit_code == 0) {
        EXPECT_EQ(json::parse(read("result.json"))["survey"]["warnings"].size(), 1U);
    }
}

}  // namespace
