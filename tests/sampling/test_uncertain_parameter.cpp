// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against an uncertain parameter that is taken for another, or accepted though it makes no
// sense.

#include "taut/sampling/uncertain_parameter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sampling/uncertain_widths.hpp"
#include "support/refusals.hpp"
#include "support/uncertain.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/sampling/model_perturbation.hpp"
#include "taut/statics/equilibrium.hpp"

namespace {

using namespace taut;
using taut::test::refusal_of;
using taut::test::uncertain;
using testing::HasSubstr;

TEST(UncertainParameter, IsReadBackAsWritten) {
    for (const std::string text :
         {"stiffness:5%", "stiffness:0.5%@ridge", "stiffness-each:3%", "temperature:10K",
          "temperature:2.5K@a@b", "supports:1mm", "adjustable:0.5mm", "loads:20N", "loads:10%"}) {
        EXPECT_EQ(to_string(parse_uncertain_parameter(text)), text);
    }
    EXPECT_EQ(parse_uncertain_parameter("loads:0.2kN"), parse_uncertain_parameter("loads:200N"));
    EXPECT_DOUBLE_EQ(parse_uncertain_parameter("stiffness:5 %").std_dev, 0.05);
    EXPECT_EQ(parse_uncertain_parameter("loads:10%").kind, UncertainParameter::Kind::loads);
    EXPECT_EQ(parse_uncertain_parameter("loads:10N").kind, UncertainParameter::Kind::loads_each);
}

TEST(UncertainParameter, IsRefusedWithWhatIsWrong) {
    for (const auto& [text, message] : {std::pair("wind:5%", "no uncertain parameter"),
                                        {"stiffness", "has no width"},
                                        {"stiffness@ridge", "no uncertain parameter"},
                                        {"stiffness:", "percentage"},
                                        {"stiffness:5", "percentage"},
                                        {"stiffness:0%", "positive"},
                                        {"stiffness:-5%", "positive"},
                                        {"stiffness:nan%", "percentage"},
                                        {"stiffness:30%", "width of 30 %"},
                                        {"support-stiffness:70%", "width of 70 %"},
                                        {"stiffness:5%@", "no group"},
                                        {"temperature:10", "temperature"},
                                        {"supports:1mm@ridge", "takes no group"},
                                        {"supports:5%", "length"},
                                        {"loads:5mm", "force"}}) {
        EXPECT_THAT(refusal_of([&, text = text] { return parse_uncertain_parameter(text); }),
                    AllOf(HasSubstr(text), HasSubstr(message)));
    }
}

CableNet net_with(const auto& change) {
    CableNetData data = hypar(3, 3).data();
    change(data);
    return CableNet(std::move(data));
}

TEST(UncertainParameter, IsRefusedWhereTheNetHasNothingOfIt) {
    const CableNet net = net_with([](CableNetData& data) { data.groups["ridge"] = {0, 1}; });
    const auto refused = [](const CableNet& of, const std::vector<UncertainParameter>& given,
                            const char* words) {
        test::expect_refused([&] { check_uncertain_parameters(of, given); }, words);
    };
    EXPECT_NO_THROW(check_uncertain_parameters(
        net, uncertain({"stiffness:5%", "stiffness:5%@ridge", "supports:1mm", "loads:20N"})));
    refused(net, uncertain({"stiffness:5%@valley"}), "expected one of ridge");
    refused(net, uncertain({"stiffness:5%", "stiffness:3%"}), "twice");
    refused(net, uncertain({"temperature:10K"}), "no expansion");
    refused(net, uncertain({"loads:10%"}), "the net has none");
    refused(net, uncertain({"adjustable:400mm"}), "third of the shortest");
    refused(net, uncertain({"supports:2m"}), "third of the shortest");
    refused(net, uncertain({"loads:1000kN"}), "third of the largest axial stiffness");
    // Made by hand, past the parser.
    refused(net, {{UncertainParameter::Kind::adjustable, 0.0, ""}}, "no positive width");
    refused(net, {{UncertainParameter::Kind::supports, 1e-3, "ridge"}}, "takes no group");
    const CableNet fixed = net_with([](CableNetData& data) { data.adjustable.clear(); });
    refused(fixed, uncertain({"adjustable:1mm"}), "adjustable edges");
}

TEST(UncertainParameter, OfASiteIsWhatIsNotGiven) {
    CableNetData data = hypar(4, 4).data();
    EXPECT_EQ(to_string(with_site_assumptions(CableNet(data), {})),
              "stiffness:5%, stiffness-each:2%, adjustable:0.5mm, supports:1mm");
    data.expansion = Eigen::VectorXd::Constant(std::ssize(data.edges), 12e-6);
    data.groups = {{"ridge", {0, 1}}};
    data.loads = Points::Constant(3, data.nodes.cols(), -20.0);
    const CableNet net(data);
    EXPECT_EQ(std_of(with_site_assumptions(net, {}), UncertainParameter::Kind::loads), 0.05);
    EXPECT_EQ(
        to_string(with_site_assumptions(net, uncertain({"loads:20N", "stiffness:10%@ridge"}))),
        "loads:20N, stiffness:10%@ridge, stiffness-each:2%, temperature:5K, "
        "adjustable:0.5mm, supports:1mm");
    // With edges of 4 mm the assumptions are narrower.
    data.nodes *= 1e-2;
    data.unstressed_lengths *= 1e-2;
    const CableNet small(data);
    const std::vector<UncertainParameter> assumed = with_site_assumptions(small, {});
    EXPECT_NO_THROW(check_uncertain_parameters(small, assumed));
    EXPECT_LT(std_of(assumed, UncertainParameter::Kind::supports), 1e-3);
}

TEST(ModelPerturbation, UnperturbedLeaveTheNetAsItIs) {
    const CableNet net = hypar(3, 4);
    const CableNet same = net_under(net, unperturbed(net), net.unstressed_lengths());
    EXPECT_EQ(same.unstressed_lengths(), net.unstressed_lengths());
    EXPECT_EQ(same.axial_stiffness(), net.axial_stiffness());
    EXPECT_EQ(same.nodes(), net.nodes());
    EXPECT_EQ(same.loads(), net.loads());
}

TEST(ModelPerturbation, ChangeTheNetByWhatTheyAre) {
    const CableNet net = net_with([](CableNetData& data) {
        data.loads = Points::Constant(3, data.nodes.cols(), -7.0);
        data.mass = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(data.edges.size()), 0.3);
        data.tension_laws = {{.name = "two slopes",
                              .strain = Eigen::Vector3d(0.0, 0.01, 0.02),
                              .tension = Eigen::Vector3d(0.0, 2e3, 5e3)}};
        data.tension_law.assign(data.edges.size(), -1);
        data.tension_law[2] = 0;
    });
    ModelPerturbation c = unperturbed(net);
    c.stiffness(1) = std::log(1.1);
    c.stiffness(2) = std::log(0.9);
    c.thermal(3) = 1e-3;
    c.adjustable(net.adjustable_edges()[0]) = 2e-3;
    c.supports.col(net.supports()[1]) << 1e-3, 0.0, 0.0;
    c.loads = 0.5;
    c.own_loads.col(net.free_nodes()[0]) << 0.0, 3.0, 0.0;
    const CableNet changed = net_under(net, c, net.unstressed_lengths());
    EXPECT_DOUBLE_EQ(changed.axial_stiffness()(1), 1.1 * net.axial_stiffness()(1));
    EXPECT_DOUBLE_EQ(changed.tension_law(2)->tension(1), 0.9 * 2e3);
    EXPECT_DOUBLE_EQ(changed.unstressed_lengths()(3), 1.001 * net.unstressed_lengths()(3));
    const int adjustable = net.adjustable_edges()[0];
    EXPECT_DOUBLE_EQ(changed.unstressed_lengths()(adjustable),
                     net.unstressed_lengths()(adjustable) + 2e-3);
    EXPECT_DOUBLE_EQ(changed.nodes()(0, net.supports()[1]),
                     net.nodes()(0, net.supports()[1]) + 1e-3);
    const int node = net.free_nodes()[0];
    EXPECT_LT(
        (changed.loads().col(node) - 1.5 * net.loads().col(node) - Eigen::Vector3d(0, 3, 0)).norm(),
        1e-9);
}

TEST(ModelPerturbation, OfLoadsLeaveTheWeightOfAnUncertainMass) {
    const CableNet net = net_with([](CableNetData& data) {
        data.loads = Points::Constant(3, data.nodes.cols(), -7.0);
        data.mass = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(data.edges.size()), 0.3);
    });
    const ModelPerturbation c = draw_perturbation(net, uncertain({"loads:10%", "mass:3%"}), 0, 1);
    const Points weight = net.loads() - net.data().loads;
    const Points expected = (1.0 + c.loads) * net.data().loads + (1.0 + c.sag) * weight;
    EXPECT_TRUE(net_under(net, c, net.unstressed_lengths()).loads().isApprox(expected, 1e-12));
}

TEST(ModelPerturbation, AreDrawnWithTheGivenWidths) {
    const CableNet net = net_with([](CableNetData& data) {
        data.loads = Points::Constant(3, data.nodes.cols(), -7.0);
        data.expansion =
            Eigen::VectorXd::Constant(static_cast<Eigen::Index>(data.edges.size()), 1e-5);
    });
    const auto given = uncertain({"stiffness:5%", "temperature:10K", "supports:1mm",
                                  "adjustable:0.5mm", "loads:10%", "loads:20N"});
    constexpr int count = 2000;
    double squares[6] = {};
    for (int k = 0; k < count; ++k) {
        const ModelPerturbation c = draw_perturbation(net, given, 1, k);
        const double values[6] = {c.stiffness(0) / 0.05,
                                  c.thermal(0) / 1e-4,
                                  c.supports(1, net.supports()[0]) / 1e-3,
                                  c.adjustable(net.adjustable_edges()[1]) / 0.5e-3,
                                  c.loads / 0.1,
                                  c.own_loads(2, net.free_nodes()[2]) / 20.0};
        for (int i = 0; i < 6; ++i) {
            squares[i] += values[i] * values[i] / count;
        }
        EXPECT_EQ(c.stiffness(3), c.stiffness(0));  // one factor for all
        EXPECT_TRUE(c.supports(Eigen::all, net.free_nodes()).isZero(0.0));
    }
    for (const double square : squares) {
        EXPECT_NEAR(square, 1.0, 5.0 * std::sqrt(2.0 / count));
    }
    const ModelPerturbation again = draw_perturbation(net, given, 1, 7);
    EXPECT_EQ(again.supports, draw_perturbation(net, given, 1, 7).supports);
    EXPECT_NE(again.loads, draw_perturbation(net, given, 2, 7).loads);
}

}  // namespace
