// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a slip of units that every command takes in silence.

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

    /// Succeeds with one warning and tells it in JSON, too.
    void expect_warning(std::vector<std::string> arguments, const std::string& text) const {
        const Outcome told = run(arguments);
        EXPECT_EQ(told.exit_code, 0) << told.err;
        EXPECT_THAT(told.err, AllOf(StartsWith("taut: warning: "), HasSubstr(text)));
        EXPECT_EQ(std::ranges::count(told.err, '\n'), 1) << told.err;
        arguments.emplace_back("--json");
        const json document = json::parse(run(arguments).out);
        ASSERT_EQ(document["warnings"].size(), 1U) << arguments.front();
        EXPECT_THAT(document["warnings"][0].get<std::string>(), HasSubstr(text));
    }
};

TEST_F(UnitWarnings, TellOfANetInMillimetres) {
    const std::string told = "are its coordinates in mm?";
    expect_warning({"inspect", "mm.json"}, told);
    expect_warning({"form", "mm.json"}, told);
    expect_warning({"sample", "mm.json", "-n", "1", "-o", "data.h5"}, told);
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

TEST_F(UnitWarnings, TellOfAnImportedNetInWhichAUnitOrLoadsAreForgotten) {
    write("mesh.json", old_compas_mesh().dump());
    expect_warning({"import", "mesh.json", "--loads", "balance", "-o", "a.json"},
                   "--force-unit kN");
    expect_warning({"import", "mesh.json", "--force-unit", "kN", "--loads", "none", "-o", "b.json"},
                   "--loads balance");
    expect_warning({"inspect", "a.json"}, "--force-unit kN");
    expect_warning({"inspect", "b.json"}, "--loads balance");
}

TEST_F(UnitWarnings, TellOfANoiseInMetres) {
    must_run({"form", "net.json", "-o", "form.csv"});
    expect_warning({"survey", "net.json", "form.csv", "--noise", "0.01", "-o", "survey.csv"},
                   "is 0.01mm meant?");
    expect_error(run({"survey", "net.json", "form.csv", "--noise", "5", "-o", "survey.csv"}), 2,
                 "is 5mm meant?");
    const Outcome told =
        run({"inspect", "net.json", "--survey", "form.csv", "--noise", "0.05", "--json"});
    EXPECT_THAT(told.err, StartsWith("taut: warning: form.csv: noise of 50mm"));
    EXPECT_EQ(json::parse(told.out)["survey"]["warnings"].size(), 1U);
}

class ScaledSurvey : public ProgramTest {
protected:
    ScaledSurvey() {
        must_run({"example", "hilo-quarter", "-o", "net.json"});
        must_run({"form", "net.json", "-o", "form.csv"});
    }

    /// A survey of noise 0.5 mm, its coordinates times a scale.
    void survey(const std::string& frame, double scale) const {
        must_run({"survey", "net.json", "form.csv", "--noise", "0.5mm", "--frame", frame, "-o",
                  "survey.csv"});
        std::istringstream lines(read("survey.csv"));
        std::string line;
        std::getline(lines, line);
        std::string text = line + "\n";
        while (std::getline(lines, line)) {
            std::istringstream fields(line);
            std::string field;
            std::getline(fields, field, ',');
            text += field;
            for (int k = 0; std::getline(fields, field, ','); ++k) {
                text += fmt::format(",{}", k < 3 ? scale * std::stod(field) : std::stod(field));
            }
            text += "\n";
        }
        write("survey.csv", text);
    }
};

TEST_F(ScaledSurvey, IsToldInAnyFrame) {
    for (const std::string frame : {"net", "random"}) {
        survey(frame, 1.0005);
        const Outcome told = run({"inspect", "net.json", "--survey", "survey.csv"});
        EXPECT_EQ(told.exit_code, 0);
        EXPECT_THAT(told.err, AllOf(StartsWith("taut: warning: survey.csv: its 128 supports"),
                                    HasSubstr("map grid")));
    }
}

TEST_F(ScaledSurvey, IsNotToldWhereTheScaleIsRight) {
    survey("random", 1.0);
    must_run({"inspect", "net.json", "--survey", "survey.csv"});
}

TEST_F(ScaledSurvey, IsToldByIdentifyAndInItsResult) {
    survey("net", 1.0005);
    const Outcome told = run({"identify", "net.json", "survey.csv", "-o", "result.json"});
    EXPECT_THAT(told.err, HasSubstr("taut: warning: survey.csv: its 128 supports"));
    if (told.exit_code == 0) {
        EXPECT_EQ(json::parse(read("result.json"))["survey"]["warnings"].size(), 1U);
    }
}

}  // namespace
