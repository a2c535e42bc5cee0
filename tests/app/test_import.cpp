// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a guess that is not printed, a half-written net, and a net that changes on its way
// out to another program and back.

#include "app/program.hpp"
#include "support/foreign_nets.hpp"
#include "support/real_data.hpp"
#include "support/steel_roof.hpp"
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

TEST_F(Import, TellsWhatItReadLeftOutAndAssumed) {
    const Outcome told = run({"import", "mesh.json", "-o", "net.json"});
    EXPECT_EQ(told.exit_code, 0);
    EXPECT_THAT(told.err, HasSubstr("taut: warning: mesh.json: strains of "));
    for (const std::string text :
         {"net tent: 1 free nodes, 4 supports, 0 interior and 4 adjustable edges",
          "read      COMPAS mesh, by its content", "left out  4 sides that are no edges",
          "assumed   coordinates are in m", "assumed   forces of the file are in N",
          "loads     file: sum 0, 0, -1.5 N", "written to net.json"}) {
        EXPECT_THAT(told.out, HasSubstr(text));
    }
    EXPECT_EQ(net("net.json").node_count(), 5);
}

TEST_F(Import, TellsTheSameAsJson) {
    const json document = json::parse(must_run({"import", "mesh.json", "-o", "net.json", "--loads",
                                                "balance", "--force-unit", "kN", "--json"}));
    expect_keys(document, json::parse(R"({
        "format": "taut-import", "version": 1, "net": {"free_nodes": 1}, "file": "mesh.json",
        "detected": true, "read": [], "assumed": [], "warnings": [],
        "left_out": {"inactive_edges": 4, "edges_between_supports": 0, "isolated_nodes": 0,
                     "all": []},
        "loads": {"from": "balance", "sum": [], "largest_horizontal": 0.5},
        "strains": {"min": 0.5, "max": 0.5}, "mean_tension": 0.5, "out_of_balance": 0.5})"));
    EXPECT_EQ(document["left_out"]["inactive_edges"], 4);
    EXPECT_LT(document["out_of_balance"], 1e-9 * document["mean_tension"].get<double>());
}

TEST_F(Import, TakesAStiffnessWithUnits) {
    const auto import = [&](std::vector<std::string> options) {
        options.insert(options.begin(),
                       {"import", "mesh.json", "--force-unit", "kN", "--loads", "balance"});
        must_run(options);
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

TEST_F(Import, ReadsWhatExportWrites) {
    write("hypar.json", net_to_json(hypar(3, 4)));
    must_run({"export", "hypar.json", "--to", "compas", "-o", "graph.json"});
    must_run({"export", "hypar.json", "--to", "csv", "-o", "net.csv"});
    must_run({"export", "hypar.json", "--to", "obj", "-o", "net.obj"});
    must_run({"export", "hypar.json", "--to", "vtk", "-o", "net.vtk"});
    must_run({"import", "graph.json", "-o", "graph_net.json"});
    must_run({"import", "net.csv", "--edges", "net_edges.csv", "-o", "csv_net.json"});
    EXPECT_THAT(run({"import", "net.obj", "--axial-stiffness", "200kN", "-o", "obj_net.json"}).err,
                HasSubstr("taut: warning: net.obj: the file gives no forces"));
    EXPECT_EQ(net("graph_net.json").fingerprint(), net("csv_net.json").fingerprint());
    EXPECT_EQ(net("obj_net.json").edge_count(), hypar(3, 4).edge_count());
    EXPECT_NEAR(net("csv_net.json").unstressed_lengths().sum(),
                hypar(3, 4).unstressed_lengths().sum(), 1e-12);
}

TEST_F(Import, ExportsAFormThatIsGiven) {
    write("hypar.json", net_to_json(hypar(3, 4)));
    must_run({"form", "hypar.json", "-o", "form.csv"});
    EXPECT_THAT(must_run({"export", "hypar.json", "form.csv", "--to", "obj", "-o", "given.obj"}),
                HasSubstr("form: form.csv"));
    must_run({"export", "hypar.json", "--to", "obj", "-o", "found.obj"});
    EXPECT_EQ(read("given.obj"), read("found.obj"));
}

TEST_F(Import, MakesASteelRoofReadyForEverythingElse) {
    write("roof.json", steel_roof_compas().dump());
    const json document = json::parse(
        must_run({"import", "roof.json", "--young", "205GPa", "--diameter", "size", "--force-unit",
                  "kN", "--loads", "balance", "-o", "net.json", "--json"}));
    EXPECT_EQ(document["net"]["free_nodes"], 300);
    EXPECT_EQ(document["net"]["interior_edges"], 536);
    EXPECT_EQ(document["net"]["adjustable_edges"], 128);
    EXPECT_LT(document["out_of_balance"], 1e-9 * document["mean_tension"].get<double>());
    const json form = json::parse(must_run({"form", "net.json", "--json"}));
    EXPECT_LT(form["largest_move"], 1e-9);
}

TEST_F(Import, MakesHiloReadyForEverythingElse) {
    TAUT_NEEDS_REAL_FILE("hilo/cablenet.json");
    const json document = json::parse(must_run(
        {"import", real_file("hilo/cablenet.json").string(), "--young", "205GPa", "--diameter",
         "size", "--force-unit", "kN", "--loads", "balance", "-o", "hilo.json", "--json"}));
    EXPECT_EQ(document["net"]["free_nodes"], 800);
    EXPECT_EQ(document["net"]["interior_edges"], 1511);
    EXPECT_EQ(document["net"]["adjustable_edges"], 186);
    EXPECT_LT(document["out_of_balance"], 1e-9 * document["mean_tension"].get<double>());
    const json form = json::parse(must_run({"form", "hilo.json", "--json"}));
    EXPECT_LT(form["largest_move"], 1e-9);
}

struct WrongInput {
    std::string name;
    std::string content;  ///< of the file "input"
    std::vector<std::string> options;
    std::string told;
};

void PrintTo(const WrongInput& input, std::ostream* stream) {
    *stream << input.name;
}

class RefusedImport : public ProgramTest, public testing::WithParamInterface<WrongInput> {};

TEST_P(RefusedImport, InOneLineAndNoFileIsTouched) {
    write("input", GetParam().content);
    write("net.json", "an earlier outcome\n");
    write("list", "0 1\n77\n");
    const Files before = files();
    std::vector<std::string> arguments{"import", "input", "-o", "net.json"};
    arguments.insert(arguments.end(), GetParam().options.begin(), GetParam().options.end());
    expect_error(run(arguments), 2, GetParam().told);
    EXPECT_EQ(files(), before);
}

std::string mesh_with(const std::string& pointer, const json& value) {
    json mesh = old_compas_mesh();
    mesh[json::json_pointer(pointer)] = value;
    return mesh.dump();
}

std::string repeated(const std::string& text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i) {
        result += text;
    }
    return result;
}

INSTANTIATE_TEST_SUITE_P(
    Inputs, RefusedImport,
    testing::Values(
        WrongInput{"Empty", "", {}, "input: is empty"},
        WrongInput{"Words", "a net, in words\nfor people", {}, "input: is taken as the CSV file"},
        WrongInput{"Word", "net", {}, "is neither JSON"},
        WrongInput{"Hdf5", "\x89HDF\r\n", {}, "is an HDF5 file"},
        WrongInput{"NativeNet", net_to_json(hypar(2, 2)), {}, "holds no mesh or network"},
        WrongInput{
            "WrongFormat", old_compas_mesh().dump(), {"--from", "obj"}, "input:1: starts with"},
        WrongInput{"Brackets", repeated("[", 1'000'000), {}, "is nested deeper than 64 levels"},
        WrongInput{"BracketsInside",
                   R"({"vertex": )" + repeated(R"({"a":)", 1'000'000),
                   {},
                   "is nested deeper than 64 levels"},
        WrongInput{"Nan", R"({"vertex": {"0": {"x": NaN}}, "face": {}})", {}, "is no JSON"},
        WrongInput{
            "UnknownVertex", mesh_with("/face/7/0", 99), {}, "/face/7/0: names the vertex '99'"},
        WrongInput{"EmptyFace",
                   mesh_with("/face/7", json::array()),
                   {},
                   "/face/7: has 0 vertices, expected at least 3"},
        WrongInput{"NoFaces", mesh_with("/face", json::object()), {}, "holds no edges"},
        WrongInput{"Contradiction", mesh_with("/edgedata/(0, 4)/q", 1.0), {}, "contradicts"},
        WrongInput{
            "Compression", mesh_with("/edgedata/(4, 0)/q", -1.0), {}, "edge 0-4 is in compression"},
        WrongInput{"Units",
                   old_compas_mesh().dump(),
                   {"--force-unit", "kN", "--axial-stiffness", "30kN"},
                   "edge 0-4 has a strain of 15 %, expected at most 10 %"},
        WrongInput{"NoStiffness", mesh_with("/dea/E", 0), {}, "gives no axial stiffness"},
        WrongInput{"StiffnessWord",
                   old_compas_mesh().dump(),
                   {"--axial-stiffness", "stiff"},
                   "'stiff' is no force"},
        WrongInput{"StiffnessNegative",
                   old_compas_mesh().dump(),
                   {"--axial-stiffness=-5kN"},
                   "expected a positive"},
        WrongInput{"YoungWord",
                   old_compas_mesh().dump(),
                   {"--young", "steel", "--diameter", "8"},
                   "'steel' is no stress"},
        WrongInput{"YoungAlone", old_compas_mesh().dump(), {"--young", "205GPa"}, "expected both"},
        WrongInput{"DiameterUnknown",
                   old_compas_mesh().dump(),
                   {"--young", "205GPa", "--diameter", "size"},
                   "edge 1-4 has no attribute 'size'"},
        WrongInput{"UnknownSupport",
                   old_compas_mesh().dump(),
                   {"--supports", "list"},
                   "list:2: '77' is no node of input"},
        WrongInput{"NoSupportsFile",
                   old_compas_mesh().dump(),
                   {"--supports", "nothing"},
                   "nothing: cannot be read"},
        WrongInput{"SelectUnknown", old_compas_mesh().dump(), {"--select", "x"}, "named 'x'"},
        WrongInput{
            "CsvWithoutEdges", "id,x,y,z\n1,0,0,0\n", {}, "name that of the edges with --edges"},
        WrongInput{"EdgesOfAMesh", old_compas_mesh().dump(), {"--edges", "list"}, "--edges"},
        WrongInput{"ForceUnit", old_compas_mesh().dump(), {"--force-unit", "lbf"}, "lbf"},
        WrongInput{"Loads", old_compas_mesh().dump(), {"--loads", "some"}, "some"}),
    [](const auto& param) { return param.param.name; });

class RefusedExport : public ProgramTest {};

TEST_F(RefusedExport, InOneLineAndNoFileIsTouched) {
    write("net.json", net_to_json(hypar(2, 3)));
    write("short.csv", "id,x,y,z\n0,0,0,0\n");
    write("old", "an earlier outcome\n");
    const Files before = files();
    expect_error(run({"export", "net.json", "--to", "dxf", "-o", "old"}), 2, "dxf");
    expect_error(run({"export", "net.json", "-o", "old"}), 2, "--to");
    expect_error(run({"export", "no.json", "--to", "obj", "-o", "old"}), 2, "no.json");
    expect_error(run({"export", "net.json", "short.csv", "--to", "obj", "-o", "old"}), 2,
                 "short.csv");
    expect_error(run({"export", "net.json", "--to", "obj", "-o", "no/such/folder/x"}), 2,
                 "no/such");
    EXPECT_EQ(files(), before);
}

}  // namespace
