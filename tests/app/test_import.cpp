// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a guess that is not printed, and a half-written net.

#include "app/program.hpp"
#include "support/foreign_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/io/net_json.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using nlohmann::json;
using testing::HasSubstr;

class Import : public ProgramTest {
protected:
    Import() { write("mesh.json", old_compas_mesh().dump()); }
    [[nodiscard]] CableNet net(const std::string& file) const {
        return parse_net(read(file), file).net;
    }
};

TEST_F(Import, PrintsWhatItReadLeftOutAndAssumed) {
    const Outcome outcome = run({"import", "mesh.json", "-o", "net.json"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.err, HasSubstr("taut: warning: mesh.json: strains of "));
    for (const std::string text :
         {"net tent: 1 free nodes, 4 supports, 0 interior and 4 adjustable edges",
          "read      COMPAS mesh, by its content", "left out  4 sides that are no edges",
          "assumed   coordinates are in m", "assumed   forces of the file are in N",
          "loads     file: sum 0, 0, -1.5 N", "written to net.json"}) {
        EXPECT_THAT(outcome.out, HasSubstr(text));
    }
    EXPECT_EQ(net("net.json").node_count(), 5);
}

TEST_F(Import, GivesTheSameAsJson) {
    const json document = json::parse(must_run({"import", "mesh.json", "-o", "net.json", "--loads",
                                                "balance", "--force-unit", "kN", "--json"}));
    EXPECT_EQ(document["format"], "taut-import");
    EXPECT_EQ(document["detected"], true);
    EXPECT_FALSE(document["assumed"].empty());
    EXPECT_EQ(document["loads"]["from"], "balance");
    EXPECT_EQ(document["left_out"]["inactive_edges"], 4);
    EXPECT_LT(document["out_of_balance"], 1e-9 * document["mean_tension"].get<double>());
}

TEST_F(Import, TakesAStiffnessWithUnits) {
    const auto import = [&](const Words& options) {
        must_run(
            joined({"import", "mesh.json", "--force-unit", "kN", "--loads", "balance"}, options));
    };
    import({"-o", "a.json", "--axial-stiffness", "200kN"});
    EXPECT_EQ(net("a.json").axial_stiffness()(0), 200e3);
    for (const std::string diameter : {"8", "8mm", "0.8cm"}) {
        import({"-o", "b.json", "--young", "205GPa", "--diameter", diameter});
        EXPECT_NEAR(net("b.json").axial_stiffness()(0), 10.3044e6, 1e2) << diameter;
    }
}

TEST_F(Import, ReadsOneOfSeveralAndSupportsFromAFile) {
    json mesh = old_compas_mesh();
    mesh["dva"]["is_anchor"] = false;
    write("session.json", json{{"a", mesh}, {"b", new_compas_graph()}}.dump());
    write("corners.txt", "0 1 2 3\n");
    for (const auto& [file, supports] :
         {std::pair{"a.json", "corners.txt"}, {"b.json", "boundary"}}) {
        must_run({"import", "session.json", "-o", file, "--select", "a", "--supports", supports,
                  "--force-unit", "kN", "--loads", "balance"});
    }
    EXPECT_EQ(net("a.json").fingerprint(), net("b.json").fingerprint());
}

}  // namespace
