// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a bad net file that is taken for a good one, that crashes the reader, or whose
// message does not say where and what is wrong.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/bad_input.hpp"
#include "support/errors.hpp"
#include "support/examples.hpp"
#include "taut/io/net_json.hpp"

namespace taut {
namespace {

using nlohmann::json;
using test::input_error_of;

json good() {
    return json::parse(R"({"format": "taut-net", "version": 1, "name": "good",
        "nodes": [[0, 0, 0], [1, 0, 0.5], [2, 0, 0]], "supports": [0, 2],
        "edges": [[0, 1], [1, 2]], "axial_stiffness": [2e5, 2e5],
        "unstressed_lengths": [0.99, 0.98], "adjustable": [0],
        "loads": [[0, 0, 0], [0, 0, -1], [0, 0, 0]], "node_ids": ["a", "b", "c"],
        "edge_ids": ["ab", "bc"]})");
}

std::string repeated(const char* text, int count, std::string result = "") {
    for (int i = 0; i < count; ++i) {
        result += text;
    }
    return result;
}

TEST(NetJsonErrors, AreAtTheLineAndColumnOfTheSyntax) {
    test::expect_refused(
        "net.json",
        {{"", ": is empty, expected JSON"},
         {"\x89HDF\r\n\x1a\n", ": is an HDF5 file, expected JSON"},
         {"{\n  \"nodes\": ,\n}",
          ":2:12: is no JSON: syntax error while parsing value - unexpected ','; expected '[', "
          "'{', or a literal"},
         {std::string("{}\n\0{}", 6), ":2:1: is a zero byte, expected text"},
         {"{\"a\": \"\xC3(\"}",
          ":1:9: is no JSON: syntax error while parsing value - invalid string: ill-formed UTF-8 "
          "byte"},
         {"{\"a\": NaN}", ":1:7: is no JSON: syntax error while parsing value - invalid literal"},
         {R"({"a": {"b/c": [1, {"k": 1, "k": 2}]}})", ":/a/b~1c/1/k: the key 'k' comes twice"},
         {R"({"nodes": [[0, 1, -1e999]]})",
          ":/nodes/0/2: the number '-1e999' is too large for a double"},
         {repeated("[", 1'000'000), repeated("/0", 64, ":") + ": is nested deeper than 64 levels"}},
        [](const std::string& text) { return parse_net(text, "net.json"); });
}

TEST(NetJsonErrors, AreAtTheJsonPointerOfTheValue) {
    test::expect_refused("net.json", good(), R"(
/tension_laws | [1] | /tension_laws/0: is 1, expected an object with "strain" and "tension"
/tension_laws | [{"strain": [0], "tension": [0]}] |
    /tension_laws/0: has 1 strains and 1 tensions, expected equal numbers, two at least
/tension_laws | [{"tension": [0, 5]}] |
    /tension_laws/0/strain: is missing, expected an array of numbers
/tension_law | [null, 0] | /tension_law/1: is 0, expected the index of one of the 0 tension laws
/groups | {"a": [0, 7]} | 'a'[1]: is 7, expected the index of one of the 2 edges
/runs | [{"edges": [0, 7]}] | /runs/0: edges[1]: is 7, expected the index of one of the 2 edges
/runs | [{"edges": [0, 1], "slides_at": 1}] | /runs/0/slides_at: is 1, expected an array of indices
/runs | [{"edges": [0, 1], "slides_at": [1], "friction": "x"}] | /runs/0/friction: is the text 'x', expected a number
/runs | [{"name": "a"}] | /runs/0/edges: is missing, expected an array of edges
/mass | [1, -1] | /mass/1: is -1, expected a finite number of at least 0
/expansion | [1e-5, 1e-5, 1e-5] | has 3 entries, expected 2, one for each edge
/support_stiffness | [1e6] |
    has 1 entries, expected one number or an array with an entry for each support
/support_stiffness | [null, [1e6, 1e6]] |
    /support_stiffness/1: has 2 entries, expected null, a number, three numbers [x, y, z] or a
    matrix of 3 x 3 [N/m]
/support_stiffness | [null, [1e6, 0, 1e6]] |
    /supports/1: has a stiffness at node 2 that is not symmetric and positive definite, expected one
    in every direction
/support_stiffness | [null, [[1e6, 5e5, 0], [0, 1e6, 0], [0, 0, 1e6]]] |
    /supports/1: has a stiffness at node 2 that is not symmetric and positive definite, expected one
    in every direction
/support_place | [null, [0, 0, 0]] | is given without "support_stiffness"
/kind | ["strut", "beam"] | /kind/1: is 'beam', expected "cable" or "strut"
/kind | ["strut"] | has 1 entries, expected 2, one for each edge
/cable_ends | "clamped" | is 'clamped', expected "hinged", "fixed" or "unknown"
/cable_ends | ["hinged"] | has 1 entries, expected 2, one for each edge
/buckling_load | [null, 4e3] | is given, but no edge is a strut by "kind"
/sag_weight | "weight" | is 'weight', expected "mass", one number, or an array of numbers
/sag_weight | "mass" | is "mass", but the net has no "mass"
/sag_weight | [1, 2, 3] | has 3 entries, expected 2, one for each edge
/sag_weight | -5 | is -5, expected a finite number of at least 0
/sag_weight | 1e9 |
    is 1000000000: the cable weighs 9.9e+08 N, expected no more than a tenth of its axial stiffness
    of 2e+05 N
/thread | ["right", "left", "left"] | has 3 entries, expected 1, one for each adjustable edge
/thread | ["up"] | /thread/0: is 'up', expected "right" or "left"
 | [] | is an array, expected an object with "format": "taut-net"
/format |  | is missing, expected "taut-net"
/format | "other" | is 'other', expected "taut-net"
/version |  | is missing, expected 1
/version | 2 | is 2, expected 1, the only one that this taut knows
/nodes |  | is missing, expected an array
/nodes/1 | 3 | is 3, expected an array of three numbers [x, y, z]
/nodes/1 | [1, 2] | has 2 entries, expected an array of three numbers [x, y, z]
/nodes/1/2 | "1.5" | is the text '1.5', expected a number
/supports/1 | 1.5 | is 1.5, expected a whole number
/supports/1 | 4294967298 | is 4294967298, expected a whole number up to 2147483647
/supports/1 | 18446744073709551615 |
    is 18446744073709551615, expected a whole number up to 2147483647
/edges/0 | [0, 1, 2] | has 3 entries, expected an array of two nodes [s, t]
/edges/0/1 | 7 | /edges/0: names node 7, expected one of the 3 nodes
/axial_stiffness |  | is missing, expected an array of numbers, or one number
/axial_stiffness | "200 kN" | is the text '200 kN', expected an array of numbers
/adjustable | [1, 1] | /adjustable/1: lists edge 1 a second time
/node_ids/1 | 1 | is 1, expected text
)",
                         [](const std::string& net) { return parse_net(net, "net.json"); });
}

TEST(NetJsonErrors, AreNoneForTheNetThatTheOthersStartFrom) {
    EXPECT_NO_THROW(static_cast<void>(parse_net(good().dump(), "net.json")));
}

TEST(NetJsonErrors, ComeForAFileCutShortAnywhere) {
    const NetFile file = test::example_net();
    const std::string text = net_to_json(file.net, file.unknown_keys);
    ASSERT_TRUE(text.ends_with("}\n"));
    for (size_t length = 0; length + 1 < text.size(); ++length) {
        const std::string message = input_error_of(
            [&] { return parse_net(std::string_view(text).substr(0, length), "net.json"); });
        ASSERT_THAT(message, testing::StartsWith("net.json:")) << "cut after " << length;
    }
}

}  // namespace
}  // namespace taut
