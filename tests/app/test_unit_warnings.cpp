// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a slip of units that commands take in silence.

#include "app/program.hpp"
#include "support/foreign_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/io/net_json.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using nlohmann::json;

class UnitWarnings : public ProgramTest {
protected:
    UnitWarnings() {
        write("net.json", net_to_json(hypar(2, 3)));
        CableNetData data = hypar(2, 3).data();
        data.nodes *= 1000.0;
        data.unstressed_lengths *= 1000.0;
        write("mm.json", net_to_json(CableNet(std::move(data))));
    }

    /// Succeeds with one warning, which stands in the JSON as well.
    /// @param of what the line on standard error names
    void expect_warning(const Words& command, const std::string& of) const {
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        json document = json::parse(run(joined(command, {"--json"})).out);
        const json& warnings =
            (document.contains("survey") ? document["survey"] : document)["warnings"];
        ASSERT_EQ(warnings.size(), 1U) << command.front();
        EXPECT_EQ(outcome.err,
                  "taut: warning: " + of + ": " + warnings[0].get<std::string>() + "\n");
    }
};

TEST_F(UnitWarnings, NameANetInMillimetres) {
    expect_warning({"inspect", "mm.json"}, "mm.json");
    expect_warning({"form", "mm.json"}, "mm.json");
    expect_warning({"sample", "mm.json", "-n", "1", "-o", "data.h5"}, "mm.json");
}

TEST_F(UnitWarnings, NameAnImportedNetWithoutItsUnitOrLoads) {
    write("mesh.json", old_compas_mesh().dump());
    expect_warning({"import", "mesh.json", "--loads", "balance", "-o", "a.json"}, "mesh.json");
    expect_warning({"import", "mesh.json", "--force-unit", "kN", "--loads", "none", "-o", "b.json"},
                   "mesh.json");
    expect_warning({"inspect", "b.json"}, "b.json");
}

TEST_F(UnitWarnings, NameANoiseInMetres) {
    must_run({"form", "net.json", "-o", "form.csv"});
    expect_warning({"survey", "net.json", "form.csv", "--noise", "0.01", "-o", "survey.csv"},
                   "--noise");
    expect_warning({"inspect", "net.json", "--survey", "form.csv", "--noise", "0.05"}, "form.csv");
}

}  // namespace
