// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a net that comes back from its file as another one: a digit lost, a key of another
// program dropped, a default filled in wrongly.

#include "taut/io/net_json.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "support/errors.hpp"
#include "support/examples.hpp"
#include "taut/statics/imbalance.hpp"

namespace taut {
namespace {

using nlohmann::json;
using test::same_bits;

/// Two supports and a free node between them.
constexpr const char* smallest = R"({"format": "taut-net", "version": 1,
    "nodes": [[0, 0, 0], [1, 0, 0.5], [2, 0, 0]], "supports": [0, 2],
    "edges": [[0, 1], [1, 2]], "axial_stiffness": 2e5, "unstressed_lengths": [0.99, 0.98]})";

void expect_same(const CableNetData& a, const CableNetData& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_TRUE(same_bits(a.nodes, b.nodes));
    EXPECT_EQ(a.supports, b.supports);
    EXPECT_EQ(a.edges, b.edges);
    EXPECT_TRUE(same_bits(a.axial_stiffness, b.axial_stiffness));
    EXPECT_TRUE(same_bits(a.unstressed_lengths, b.unstressed_lengths));
    EXPECT_EQ(a.adjustable, b.adjustable);
    EXPECT_TRUE(same_bits(a.loads, b.loads));
    EXPECT_EQ(a.node_ids, b.node_ids);
    EXPECT_EQ(a.edge_ids, b.edge_ids);
    EXPECT_EQ(a.tension_law, b.tension_law);
    ASSERT_EQ(a.tension_laws.size(), b.tension_laws.size());
    for (size_t i = 0; i < a.tension_laws.size(); ++i) {
        EXPECT_EQ(a.tension_laws[i].name, b.tension_laws[i].name);
        EXPECT_TRUE(same_bits(a.tension_laws[i].strain, b.tension_laws[i].strain));
        EXPECT_TRUE(same_bits(a.tension_laws[i].tension, b.tension_laws[i].tension));
    }
    EXPECT_EQ(a.groups, b.groups);
    EXPECT_TRUE(same_bits(a.mass, b.mass));
    EXPECT_TRUE(same_bits(a.expansion, b.expansion));
    EXPECT_TRUE(same_bits(a.breaking_load, b.breaking_load));
    EXPECT_EQ(a.thread, b.thread);
    ASSERT_EQ(a.elastic_supports.size(), b.elastic_supports.size());
    for (size_t k = 0; k < a.elastic_supports.size(); ++k) {
        EXPECT_EQ(a.elastic_supports[k].node, b.elastic_supports[k].node);
        EXPECT_EQ(a.elastic_supports[k].stiffness, b.elastic_supports[k].stiffness);
        EXPECT_EQ(a.elastic_supports[k].place, b.elastic_supports[k].place);
    }
    ASSERT_EQ(a.runs.size(), b.runs.size());
    for (size_t k = 0; k < a.runs.size(); ++k) {
        EXPECT_EQ(a.runs[k].name, b.runs[k].name);
        EXPECT_EQ(a.runs[k].edges, b.runs[k].edges);
        EXPECT_EQ(a.runs[k].slides_at, b.runs[k].slides_at);
        EXPECT_EQ(a.runs[k].friction, b.runs[k].friction);
        EXPECT_EQ(a.runs[k].ratios, b.runs[k].ratios);
    }
}

TEST(NetJson, ReadsBackEverythingOfANetToTheLastBit) {
    const NetFile file = test::example_net();
    const NetFile back = parse_net(net_to_json(file.net, file.unknown_keys), "net.json");
    expect_same(back.net.data(), file.net.data());
    EXPECT_EQ(back.net.fingerprint(), file.net.fingerprint());
    EXPECT_EQ(back.unknown_keys, file.unknown_keys);
    EXPECT_EQ(net_to_json(back.net, back.unknown_keys), net_to_json(file.net, file.unknown_keys));
}

TEST(NetJson, ReadsBackTensionLawsGroupsMassesAndExpansionToTheLastBit) {
    const CableNet net = steel_roof();
    const CableNet back = parse_net(net_to_json(net), "net.json").net;
    expect_same(back.data(), net.data());
    EXPECT_EQ(back.fingerprint(), net.fingerprint());
    CableNetData data = net.data();
    data.tension_law[3] = -1;
    data.mass(0) = 0.0;
    data.tension_laws[1].name.clear();
    const CableNet mixed(data);
    expect_same(parse_net(net_to_json(mixed), "net.json").net.data(), mixed.data());
}

TEST(NetJson, ReadsBackBreakingLoadsAndThreadsEachOfItsEdge) {
    CableNetData data = hypar(2, 2).data();
    const auto edges = static_cast<Eigen::Index>(data.edges.size());
    data.breaking_load = Eigen::VectorXd::LinSpaced(edges, 1e4, 1e5 / 3.0);
    data.adjustable = {5, 0, 3};
    data.thread = {Thread::left, Thread::right, Thread::right};
    data.cable_ends.assign(data.edges.size(), CableEnds::hinged);
    data.cable_ends[3] = CableEnds::fixed;
    data.runs = {{.name = "warp \"1\"", .edges = {2, 0}}, {.name = "", .edges = {4}}};
    const CableNet net(data);
    // Sorted with their edges.
    EXPECT_EQ(net.adjustable_edges(), (std::vector<int>{0, 3, 5}));
    EXPECT_EQ(net.data().thread, (std::vector{Thread::right, Thread::right, Thread::left}));
    expect_same(parse_net(net_to_json(net), "net.json").net.data(), net.data());
    // They change nothing of how the net behaves.
    CableNetData bare = data;
    bare.breaking_load.resize(0);
    bare.thread.clear();
    bare.cable_ends.clear();
    bare.runs.clear();
    EXPECT_EQ(net.fingerprint(), CableNet(bare).fingerprint());
}

TEST(NetJson, ReadsBackRunsThatSlide) {
    CableNetData data = sliding_ridge().data();
    ASSERT_EQ(data.runs.at(0).slides_at.size(), 7U);
    data.runs[0].friction.reset();
    data.runs[0].ratios = {1.0, 1.1, 0.9, 1.0, 1.0, 1.0 / 3.0, 1.0};
    for (const CableNet& net : {sliding_ridge(), CableNet(data)}) {
        const CableNet back = parse_net(net_to_json(net), "net.json").net;
        expect_same(back.data(), net.data());
        EXPECT_EQ(back.fingerprint(), net.fingerprint());
    }
}

TEST(NetJson, ReadsBackStruts) {
    CableNetData data = cable_dome().data();
    const std::vector<int>& struts = data.groups.at("strut");
    data.buckling_load =
        Eigen::VectorXd::Constant(std::ssize(data.edges), std::numeric_limits<double>::infinity());
    data.buckling_load(struts[2]) = 4e4;
    const CableNet net(data);
    const CableNet again = parse_net(net_to_json(net), "net.json").net;
    EXPECT_EQ(again.data().kind, net.data().kind);
    EXPECT_EQ(again.data().buckling_load, net.data().buckling_load);
    EXPECT_EQ(again.fingerprint(), net.fingerprint());
    // One number is that of all struts.
    auto document = nlohmann::json::parse(net_to_json(net));
    document["buckling_load"] = 5e4;
    const CableNet one = parse_net(document.dump(), "net.json").net;
    for (int e = 0; e < net.edge_count(); ++e) {
        EXPECT_EQ(one.data().buckling_load(e) == 5e4, net.is_strut(e)) << e;
    }
    // A strut is another edge, however strong.
    data.buckling_load.resize(0);
    EXPECT_EQ(CableNet(data).fingerprint(), net.fingerprint());
    data.kind.assign(data.edges.size(), EdgeKind::cable);
    EXPECT_FALSE(CableNet(data).has_struts());
    EXPECT_NE(CableNet(data).fingerprint(), net.fingerprint());
}

TEST(NetJson, ReadsBackSagsAndThoseOfMasses) {
    CableNetData data = cable_dome().data();
    data.mass = Eigen::VectorXd::Constant(std::ssize(data.edges), 4.0);
    data.sag_weight = sag_weights_by_mass(data);
    const CableNet net(data);
    ASSERT_TRUE(net.sags());
    const CableNet again = parse_net(net_to_json(net), "net.json").net;
    EXPECT_EQ(again.data().sag_weight, net.data().sag_weight);
    EXPECT_EQ(again.fingerprint(), net.fingerprint());
    auto document = nlohmann::json::parse(net_to_json(net));
    document["sag_weight"] = "mass";
    EXPECT_EQ(parse_net(document.dump(), "net.json").net.data().sag_weight, data.sag_weight);
    document["sag_weight"] = 7.5;
    const CableNet one = parse_net(document.dump(), "net.json").net;
    for (int e = 0; e < net.edge_count(); ++e) {
        EXPECT_EQ(one.data().sag_weight(e), net.is_strut(e) ? 0.0 : 7.5) << e;
    }
}

TEST(NetJson, ReadsBackElasticSupports) {
    CableNetData data = hypar(2, 2).data();
    const int stiff = data.supports[1];
    const int skew = data.supports[4];
    std::erase(data.supports, stiff);
    std::erase(data.supports, skew);
    Eigen::Matrix3d stiffness = Eigen::Vector3d(1e6 / 3.0, 2e6, 3e6).asDiagonal();
    data.elastic_supports = {{.node = skew, .stiffness = stiffness, .place = {0.1, 0.2, 1.0 / 3.0}},
                             {.node = stiff, .stiffness = stiffness, .place = {1.0, 2.0, 3.0}}};
    data.elastic_supports[0].stiffness(0, 1) = data.elastic_supports[0].stiffness(1, 0) = 1e4;
    const CableNet net(data);
    const CableNet back = parse_net(net_to_json(net), "net.json").net;
    expect_same(back.data(), net.data());
    EXPECT_EQ(back.fingerprint(), net.fingerprint());
    data.elastic_supports[1].stiffness *= 2.0;
    EXPECT_NE(CableNet(data).fingerprint(), net.fingerprint());
}

TEST(NetJson, TakesPlacesOfElasticSupportsFromTheNodesOrFromTheBalance) {
    auto json = nlohmann::json::parse(net_to_json(hypar(2, 2)));
    const CableNet rigid = parse_net(json.dump(), "net.json").net;
    json["support_stiffness"] = std::vector<nlohmann::json>(rigid.supports().size());
    json["support_stiffness"][2] = 5e5;
    json["support_stiffness"][3] = {1e6, 2e6, 3e6};
    const CableNet net = parse_net(json.dump(), "net.json").net;
    ASSERT_EQ(net.elastic_supports().size(), 2U);
    EXPECT_EQ(net.adjustable_edges(), rigid.adjustable_edges());
    for (const ElasticSupport& support : net.elastic_supports()) {
        EXPECT_EQ(support.place, net.nodes().col(support.node));
    }
    EXPECT_EQ(net.elastic_supports()[0].stiffness, 5e5 * Eigen::Matrix3d::Identity());
    json["support_place"] = "balanced";
    const CableNet balanced = parse_net(json.dump(), "net.json").net;
    EXPECT_LT(imbalance_of(balanced, balanced.unstressed_lengths(), balanced.nodes()).share(),
              1e-9);
    EXPECT_GT(imbalance_of(net, net.unstressed_lengths(), net.nodes()).share(), 0.5);
}

TEST(NetJson, TakesCouplingsOfSupportsByTheirNodesInAnyOrder) {
    auto json = nlohmann::json::parse(net_to_json(hypar(2, 2)));
    json["support_stiffness"] = 1e6;
    const std::vector<int> supports = json["supports"];
    const nlohmann::json block{{1e5, 2e5, 0.0}, {0.0, 1e5, 0.0}, {0.0, 0.0, -1e5}};
    json["support_couplings"] = {{supports[4], supports[2], block}};
    const CableNet net = parse_net(json.dump(), "net.json").net;
    ASSERT_EQ(net.support_couplings().size(), 1U);
    const SupportCoupling& coupling = net.support_couplings()[0];
    EXPECT_EQ(net.elastic_supports()[coupling.first].node, supports[2]);
    EXPECT_EQ(net.elastic_supports()[coupling.second].node, supports[4]);
    EXPECT_EQ(coupling.stiffness(1, 0), 2e5);
    const CableNet again = parse_net(net_to_json(net), "net.json").net;
    EXPECT_EQ(again.fingerprint(), net.fingerprint());
    EXPECT_EQ(again.support_couplings()[0].stiffness, coupling.stiffness);

    const auto error = [&] {
        return test::input_error_of([&] { return parse_net(json.dump(), "net.json"); });
    };
    json["support_couplings"][0][1] = hypar(2, 2).free_nodes()[0];
    EXPECT_THAT(error(), testing::HasSubstr("/support_couplings/0/1: names no support with a"));
    json["support_couplings"] = {{supports[4], supports[2], block},
                                 {supports[2], supports[4], block}};
    EXPECT_THAT(error(),
                testing::HasSubstr("/support_couplings/1: joins the nodes 2 and 6 a second"));
    json["support_couplings"] = {{supports[4], supports[4], block}};
    EXPECT_THAT(error(), testing::HasSubstr("expected two different"));
    json["support_couplings"] = {{supports[4], supports[2], 2e6}};
    EXPECT_THAT(error(), testing::HasSubstr("/support_couplings: make a stiffness of all elastic "
                                            "supports that is not positive definite"));
}

TEST(NetJson, KeepsSupportsAndAdjustableEdgesThatAreNotTheDefault) {
    CableNetData data = hypar(2, 2).data();
    std::ranges::reverse(data.supports);
    data.adjustable = {1, 0};
    const CableNet net(data);
    expect_same(parse_net(net_to_json(net), "net.json").net.data(), net.data());
    data.adjustable = {};
    EXPECT_TRUE(parse_net(net_to_json(CableNet(data)), "net.json").net.adjustable_edges().empty());
}

RC_GTEST_PROP(NetJson, ReadsBackAnyFiniteNumberToTheLastBit, ()) {
    CableNetData data = hypar(1, 2).data();
    const auto any_finite = [] {
        return *rc::gen::suchThat(
            rc::gen::map(rc::gen::arbitrary<std::uint64_t>(),
                         [](std::uint64_t bits) {
                             // All of the generator's sizes should reach the exponent too.
                             return std::bit_cast<double>(bits * 0x9E3779B97F4A7C15ULL);
                         }),
            [](double x) { return std::isfinite(x); });
    };
    data.loads = Points::Zero(3, data.nodes.cols());
    for (double& load : data.loads.reshaped()) {
        load = std::clamp(any_finite(), -1e15, 1e15);
    }
    for (double& length : data.unstressed_lengths) {
        length = std::clamp(std::abs(any_finite()), 1e-15, 1e15);
    }
    const CableNet net(data);
    const NetFile back = parse_net(net_to_json(net), "net.json");
    RC_ASSERT(same_bits(back.net.loads(), net.loads()));
    RC_ASSERT(same_bits(back.net.unstressed_lengths(), net.unstressed_lengths()));
    RC_ASSERT(back.net.fingerprint() == net.fingerprint());
}

TEST(NetJson, WritesBackKeysThatItDoesNotKnow) {
    json with_more = json::parse(smallest);
    with_more["author"] = {{"name", "Ä. \"B\""}, {"year", 2026}};
    with_more["a/b~c"] = {1, 2.5, nullptr, true, 18446744073709551615ULL, -0.1};
    const NetFile file = parse_net(with_more.dump(), "net.json");
    const json written = json::parse(net_to_json(file.net, file.unknown_keys));
    EXPECT_EQ(written["author"], with_more["author"]);
    EXPECT_EQ(written["a/b~c"], with_more["a/b~c"]);
    EXPECT_EQ(parse_net(written.dump(), "net.json").unknown_keys, file.unknown_keys);
}

TEST(NetJson, FillsInWhatIsOptional) {
    const CableNet net = parse_net(smallest, "some/where/bridge.v2.json").net;
    EXPECT_EQ(net.name(), "bridge.v2");
    EXPECT_THAT(net.adjustable_edges(), testing::ElementsAre(0, 1));
    EXPECT_EQ(net.loads(), Points::Zero(3, 3));
    EXPECT_EQ(net.node_id(1), "1");
    EXPECT_EQ(net.edge_id(1), "1");
    EXPECT_EQ(net.axial_stiffness(), Eigen::Vector2d(2e5, 2e5));
}

TEST(NetJson, NamesANetAfterAFileWhoseNameIsNotUtf8) {
    const CableNet net = parse_net(smallest, "a\xFF.json").net;
    EXPECT_EQ(parse_net(net_to_json(net), "net.json").net.name(), net.name());
}

TEST(NetJson, RefusesToWriteANameThatIsNotUtf8) {
    CableNetData data = hypar(1, 1).data();
    data.node_ids = {"a", "b", "c", "d", "e\xFF"};
    EXPECT_THROW(static_cast<void>(net_to_json(CableNet(data))), std::invalid_argument);
}

TEST(NetJson, RefusesToWriteUnknownKeysThatAreNoObjectOrOfTheFormat) {
    const CableNet net = hypar(1, 1);
    for (const char* keys : {"", "[]", "{", "1", R"({"nodes": []})", R"({"a": 1, "a": 2})"}) {
        EXPECT_THROW(static_cast<void>(net_to_json(net, keys)), std::invalid_argument) << keys;
    }
}

}  // namespace
}  // namespace taut
