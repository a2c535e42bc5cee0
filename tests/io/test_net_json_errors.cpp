// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a bad net file that is taken for a good one, that crashes the reader, or whose
// message does not say where and what is wrong.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <random>

#include "support/bad_input.hpp"
#include "support/errors.hpp"
#include "support/examples.hpp"
#include "taut/io/net_json.hpp"

namespace taut {
namespace {

using nlohmann::json;
using test::BadText;
using test::BadValue;
using test::input_error_of;

json good() {
    return json::parse(R"({"format": "taut-net", "version": 1, "name": "good",
        "nodes": [[0, 0, 0], [1, 0, 0.5], [2, 0, 0]], "supports": [0, 2],
        "edges": [[0, 1], [1, 2]], "axial_stiffness": [2e5, 2e5],
        "unstressed_lengths": [0.99, 0.98], "adjustable": [0],
        "loads": [[0, 0, 0], [0, 0, -1], [0, 0, 0]], "node_ids": ["a", "b", "c"],
        "edge_ids": ["ab", "bc"]})");
}

class BadJson : public testing::TestWithParam<BadText> {};

TEST_P(BadJson, IsRefusedWithLineAndColumnOrPointer) {
    const BadText& bad = GetParam();
    EXPECT_EQ(input_error_of([&] { return parse_net(bad.text, "net.json"); }),
              std::string("net.json") + bad.message);
}

std::string repeated(const char* text, int count, std::string result = "") {
    for (int i = 0; i < count; ++i) {
        result += text;
    }
    return result;
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, BadJson,
    testing::Values(
        BadText{"Empty", "", ": is empty, expected JSON"},
        BadText{"Hdf5", "\x89HDF\r\n\x1a\n", ": is an HDF5 file, expected JSON"},
        BadText{"Hole", "{\n  \"nodes\": ,\n}",
                ":2:12: is no JSON: syntax error while parsing value - unexpected ','; expected "
                "'[', '{', or a literal"},
        BadText{"ZeroByte", std::string("{}\n\0{}", 6), ":2:1: is a zero byte, expected text"},
        BadText{"InvalidUtf8", "{\"a\": \"\xC3(\"}",
                ":1:9: is no JSON: syntax error while parsing value - invalid string: ill-formed "
                "UTF-8 byte"},
        BadText{"NotANumber", "{\"a\": NaN}",
                ":1:7: is no JSON: syntax error while parsing value - invalid literal"},
        BadText{"KeyTwice", R"({"a": {"b/c": [1, {"k": 1, "k": 2}]}})",
                ":/a/b~1c/1/k: the key 'k' comes twice"},
        BadText{"NumberTooLarge", R"({"nodes": [[0, 1, -1e999]]})",
                ":/nodes/0/2: the number '-1e999' is too large for a double"},
        BadText{"DeepArray", repeated("[", 1'000'000),
                repeated("/0", 64, ":") + ": is nested deeper than 64 levels"}),
    [](const auto& param) { return param.param.name; });

class BadNet : public testing::TestWithParam<BadValue> {};

TEST_P(BadNet, IsRefusedAtItsJsonPointer) {
    const BadValue& bad = GetParam();
    json value = good();
    if (*bad.value == '\0') {
        value.erase(std::string(bad.at).substr(1));
    } else {
        value[json::json_pointer(bad.at)] = json::parse(bad.value);
    }
    EXPECT_EQ(input_error_of([&] { return parse_net(value.dump(), "net.json"); }),
              std::string("net.json") + bad.message);
}

INSTANTIATE_TEST_SUITE_P(
    Value, BadNet,
    testing::Values(
        BadValue{"LawNoObject", "/tension_laws", "[1]",
                 ":/tension_laws/0: is 1, expected an object with \"strain\" and \"tension\""},
        BadValue{"LawOfOnePoint", "/tension_laws", R"([{"strain": [0], "tension": [0]}])",
                 ":/tension_laws/0: has 1 strains and 1 tensions, expected equal "
                 "numbers, two at least"},
        BadValue{"LawWithoutStrain", "/tension_laws", R"([{"tension": [0, 5]}])",
                 ":/tension_laws/0/strain: is missing, expected an array of numbers"},
        BadValue{"LawIndexTooLarge", "/tension_law", "[null, 0]",
                 ":/tension_law/1: is 0, expected the index of one of the 0 tension laws"},
        BadValue{"GroupOfNoEdge", "/groups", R"({"a": [0, 7]})",
                 ":/groups: 'a'[1]: is 7, expected the index of one of the 2 edges"},
        BadValue{"RunOfNoEdge", "/runs", R"([{"edges": [0, 7]}])",
                 ":/runs/0: edges[1]: is 7, expected the index of one of the 2 edges"},
        BadValue{"RunWithoutEdges", "/runs", R"([{"name": "a"}])",
                 ":/runs/0/edges: is missing, expected an array of edges"},
        BadValue{"NegativeMass", "/mass", "[1, -1]",
                 ":/mass/1: is -1, expected a finite number of at least 0"},
        BadValue{"ExpansionOfTooManyEdges", "/expansion", "[1e-5, 1e-5, 1e-5]",
                 ":/expansion: has 3 entries, expected 2, one for each edge"},
        BadValue{"StiffnessOfTooFewSupports", "/support_stiffness", "[1e6]",
                 ":/support_stiffness: has 1 entries, expected one number or an array with an "
                 "entry for each support"},
        BadValue{"StiffnessOfTwoNumbers", "/support_stiffness", "[null, [1e6, 1e6]]",
                 ":/support_stiffness/1: has 2 entries, expected null, a number, three numbers "
                 "[x, y, z] or a matrix of 3 x 3 [N/m]"},
        BadValue{"StiffnessOfNoDirection", "/support_stiffness", "[null, [1e6, 0, 1e6]]",
                 ":/supports/1: has a stiffness at node 2 that is not symmetric and positive "
                 "definite, expected one in every direction"},
        BadValue{"StiffnessThatIsSkew", "/support_stiffness",
                 "[null, [[1e6, 5e5, 0], [0, 1e6, 0], [0, 0, 1e6]]]",
                 ":/supports/1: has a stiffness at node 2 that is not symmetric and positive "
                 "definite, expected one in every direction"},
        BadValue{"PlaceWithoutStiffness", "/support_place", "[null, [0, 0, 0]]",
                 ":/support_place: is given without \"support_stiffness\""},
        BadValue{"KindOfNoEdge", "/kind", R"(["strut", "beam"])",
                 R"(:/kind/1: is 'beam', expected "cable" or "strut")"},
        BadValue{"KindOfTooFewEdges", "/kind", R"(["strut"])",
                 ":/kind: has 1 entries, expected 2, one for each edge"},
        BadValue{"BucklingLoadWithoutStrut", "/buckling_load", "[null, 4e3]",
                 ":/buckling_load: is given, but no edge is a strut by \"kind\""},
        BadValue{
            "SagByAnotherWord", "/sag_weight", R"("weight")",
            R"(:/sag_weight: is 'weight', expected "mass", one number, or an array of numbers)"},
        BadValue{"SagByMassOfNone", "/sag_weight", R"("mass")",
                 R"(:/sag_weight: is "mass", but the net has no "mass")"},
        BadValue{"SagOfTooManyEdges", "/sag_weight", "[1, 2, 3]",
                 ":/sag_weight: has 3 entries, expected 2, one for each edge"},
        BadValue{"SagUpwards", "/sag_weight", "-5",
                 ":/sag_weight: is -5, expected a finite number of at least 0"},
        BadValue{"SagOfAnAbsurdWeight", "/sag_weight", "1e9",
                 ":/sag_weight: is 1000000000: the cable weighs 9.9e+08 N, expected no more than a "
                 "tenth of its axial stiffness of 2e+05 N"},
        BadValue{"ThreadOfTooManyEdges", "/thread", R"(["right", "left", "left"])",
                 ":/thread: has 3 entries, expected 1, one for each adjustable edge"},
        BadValue{"ThreadNeitherRightNorLeft", "/thread", R"(["up"])",
                 R"(:/thread/0: is 'up', expected "right" or "left")"},
        BadValue{"TopLevelArray", "", "[]",
                 ": is an array, expected an object with \"format\": \"taut-net\""},
        BadValue{"NoFormat", "/format", "", ":/format: is missing, expected \"taut-net\""},
        BadValue{"OtherFormat", "/format", R"("other")",
                 ":/format: is 'other', expected \"taut-net\""},
        BadValue{"NoVersion", "/version", "", ":/version: is missing, expected 1"},
        BadValue{"LaterVersion", "/version", "2",
                 ":/version: is 2, expected 1, the only one that this taut knows"},
        BadValue{"NoNodes", "/nodes", "", ":/nodes: is missing, expected an array"},
        BadValue{"NodeNumber", "/nodes/1", "3",
                 ":/nodes/1: is 3, expected an array of three numbers [x, y, z]"},
        BadValue{"NodeOfTwo", "/nodes/1", "[1, 2]",
                 ":/nodes/1: has 2 entries, expected an array of three numbers [x, y, z]"},
        BadValue{"CoordinateText", "/nodes/1/2", R"("1.5")",
                 ":/nodes/1/2: is the text '1.5', expected a number"},
        BadValue{"CoordinateTooLarge", "/nodes/1/2", "1e60",
                 ":/nodes/1/2: is 1e+60, expected no more than 1e+15"},
        BadValue{"SupportsAll", "/supports", "[0, 1, 2]",
                 ":/supports: holds every node, expected at least one free node"},
        BadValue{"SupportFraction", "/supports/1", "1.5",
                 ":/supports/1: is 1.5, expected a whole number"},
        BadValue{"SupportAboveInt", "/supports/1", "4294967298",
                 ":/supports/1: is 4294967298, expected a whole number up to 2147483647"},
        BadValue{"SupportAboveInt64", "/supports/1", "18446744073709551615",
                 ":/supports/1: is 18446744073709551615, expected a whole number up to 2147483647"},
        BadValue{"SupportNegative", "/supports/1", "-1",
                 ":/supports/1: is -1, expected the index of one of the 3 nodes"},
        BadValue{"EdgeOfThree", "/edges/0", "[0, 1, 2]",
                 ":/edges/0: has 3 entries, expected an array of two nodes [s, t]"},
        BadValue{"EdgeToNowhere", "/edges/0/1", "7",
                 ":/edges/0: names node 7, expected one of the 3 nodes"},
        BadValue{"NoStiffness", "/axial_stiffness", "",
                 ":/axial_stiffness: is missing, expected an array of numbers, or one number"},
        BadValue{"StiffnessText", "/axial_stiffness", R"("200 kN")",
                 ":/axial_stiffness: is the text '200 kN', expected an array of numbers"},
        BadValue{"LengthZero", "/unstressed_lengths/1", "0",
                 ":/unstressed_lengths/1: is 0, expected a positive and finite number"},
        BadValue{"AdjustableTwice", "/adjustable", "[1, 1]",
                 ":/adjustable/1: lists edge 1 a second time"},
        BadValue{"LoadsTooFew", "/loads", "[[0, 0, 0]]",
                 ":/loads: has 1 entries, expected 3, one for each node"},
        BadValue{"NodeIdNumber", "/node_ids/1", "1", ":/node_ids/1: is 1, expected text"}),
    [](const auto& param) { return param.param.name; });

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

TEST(NetJsonErrors, ComeOrNotButNothingElseDoesForAFileWithDamagedBytes) {
    const NetFile file = test::example_net();
    const std::string text = net_to_json(file.net, file.unknown_keys);
    std::mt19937 random(1);
    int refused = 0;
    for (int i = 0; i < 2000; ++i) {
        std::string damaged = text;
        damaged[random() % damaged.size()] = static_cast<char>(random());
        refused +=
            test::succeeds_or_refuses([&] { return parse_net(damaged, "net.json"); }) ? 0 : 1;
    }
    EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace taut
