// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a result that is exported with the lengths of the design, or whose slack edges
// count as determined.

#include "taut/results/net_or_result.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/errors.hpp"
#include "support/studies.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

json identification() {
    return json::parse(test::made_up_identification(hypar(2, 3)).json);
}

NetOrResult parse(const json& document) {
    return parse_net_or_result(document.dump(), "result.json");
}

TEST(NetOrResult, OfAnIdentificationHasItsLengthsAndItsForm) {
    json document = identification();
    document["form"][4] = {0.125, 0.25, 0.5};
    const CableNet designed = hypar(2, 3);
    const NetOrResult read = parse(document);
    const CableNet& net = read.file.net;
    EXPECT_TRUE(read.is_identified);
    EXPECT_EQ(net.nodes().col(4), Eigen::Vector3d(0.125, 0.25, 0.5));
    EXPECT_EQ(net.nodes().col(1), designed.nodes().col(1));
    for (const int edge : designed.interior_edges()) {
        EXPECT_NEAR(net.unstressed_lengths()(edge),
                    designed.unstressed_lengths()(edge) + 0.004 * std::sin(1.0 + edge), 1e-15);
    }
    for (const int edge : designed.adjustable_edges()) {
        EXPECT_EQ(net.unstressed_lengths()(edge), designed.unstressed_lengths()(edge));
    }
}

TEST(NetOrResult, HasTheElasticSupportsBesideRigidOnes) {
    CableNetData data = hypar(2, 3).data();
    const int node = data.supports.back();
    data.supports.pop_back();
    data.elastic_supports = {
        {.node = node,
         .stiffness = 1e6 * (Eigen::Matrix3d::Identity() + 0.2 * Eigen::Matrix3d::Ones()),
         .place = data.nodes.col(node)}};
    const CableNet designed(data);
    const CableNet net = parse(json::parse(test::made_up_identification(designed).json)).file.net;
    EXPECT_EQ(net.supports(), designed.supports());
    ASSERT_EQ(net.elastic_supports().size(), 1U);
    EXPECT_EQ(net.elastic_supports()[0].node, node);
    EXPECT_EQ(net.elastic_supports()[0].stiffness, designed.elastic_supports()[0].stiffness);
    EXPECT_EQ(net.elastic_supports()[0].place, designed.elastic_supports()[0].place);
}

TEST(NetOrResult, ListsEdgesThatTheSurveyDoesNotDetermine) {
    json document = identification();
    document["edges"][3]["status"] = "unobserved";
    const NetOrResult read = parse(document);
    const std::vector<int>& interior = read.file.net.interior_edges();
    EXPECT_THAT(read.slack, ElementsAre(interior[0]));
    EXPECT_THAT(read.not_determined, ElementsAre(interior[3]));
}

TEST(NetOrResult, KeepsWhatElseTheNetHolds) {
    CableNetData data = hypar(2, 3).data();
    data.name = "roof";
    data.loads = Points::Constant(3, data.nodes.cols(), -2.0);
    for (int node = 0; node < data.nodes.cols(); ++node) {
        data.node_ids.push_back("N" + std::to_string(node));
    }
    json document = json::parse(test::made_up_identification(CableNet(std::move(data))).json);
    document["cable_net"]["colour"] = "red";
    const NetOrResult read = parse(document);
    EXPECT_EQ(read.file.net.name(), "roof");
    EXPECT_EQ(read.file.net.loads()(0, 0), -2.0);
    EXPECT_EQ(read.file.net.node_id(2), "N2");
    EXPECT_EQ(json::parse(read.file.unknown_keys), json({{"colour", "red"}}));
}

TEST(NetOrResult, OfANetIsTheNet) {
    const NetOrResult read =
        parse_net_or_result(net_to_json(hypar(2, 3), R"({"colour": "red"})"), "net.json");
    EXPECT_FALSE(read.is_identified);
    EXPECT_THAT(read.slack, IsEmpty());
    EXPECT_EQ(read.file.net.fingerprint(), hypar(2, 3).fingerprint());
    EXPECT_EQ(json::parse(read.file.unknown_keys), json({{"colour", "red"}}));
}

TEST(NetOrResult, RefusesAResultThatIsNotOfOneBuiltNet) {
    for (const std::string& text :
         {test::saved(test::made_up_study(hypar(2, 3))).json, test::made_up_comparison().json,
          test::made_up_plan(hypar(2, 3)).json, test::made_up_control(hypar(2, 3)).json}) {
        EXPECT_THAT(test::input_error_of([&] { return parse_net_or_result(text, "r.json"); }),
                    AllOf(HasSubstr("r.json:/format: is 'taut-"),
                          HasSubstr(R"(expected "taut-net", or "taut-identification")")));
    }
}

TEST(NetOrResult, RefusesWhatNeitherReaderTakes) {
    const auto error = [](const std::string& text) {
        return test::input_error_of([&] { return parse_net_or_result(text, "x.json"); });
    };
    EXPECT_THAT(error("[]"), HasSubstr("x.json: is"));
    EXPECT_THAT(error(R"({"format": 3})"), HasSubstr("x.json:/format"));
    EXPECT_THAT(error(R"({"format": "taut-identification"})"), HasSubstr("/version: is missing"));
    json document = identification();
    for (const char* key : {"length_deviation", "lower", "upper"}) {
        document["edges"][0][key] = -9.0;
    }
    EXPECT_THAT(error(document.dump()), HasSubstr("expected a positive and finite number"));
}

}  // namespace
}  // namespace taut
