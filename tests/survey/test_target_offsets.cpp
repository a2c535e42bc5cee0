// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against targets moved to the wrong side, or along a direction that is none.

#include "taut/survey/target_offsets.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>

#include "taut/design/builtin_nets.hpp"
#include "taut/survey/simulation.hpp"

namespace taut {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// The net with other places of its nodes.
CableNet with_nodes(const CableNet& net, const Points& nodes) {
    CableNetData data = net.data();
    data.nodes = nodes;
    return CableNet(std::move(data));
}

TEST(NodeNormals, AreThoseOfTheSurface) {
    // On z = k x y every line of the lattice is straight: the polygon of four neighbours lies in
    // the tangent plane, of the normal (-k y, -k x, 1).
    const CableNet lattice = hypar(6, 7);
    Points nodes = lattice.nodes();
    constexpr double k = 0.11;
    nodes.row(2) = k * nodes.row(0).cwiseProduct(nodes.row(1));
    const CableNet net = with_nodes(lattice, nodes);
    const Points normals = node_normals(net, net.nodes());
    for (const int node : net.free_nodes()) {
        const Eigen::Vector3d p = nodes.col(node);
        const Eigen::Vector3d expected = Eigen::Vector3d(-k * p.y(), -k * p.x(), 1.0).normalized();
        EXPECT_LT((normals.col(node) - expected).norm(), 1e-6) << node;
    }
    for (const int node : net.supports()) {
        EXPECT_TRUE(normals.col(node).isZero());
    }
}

TEST(NodeNormals, AreUpInTheMeanAndOnOneSide) {
    const CableNet net = hilo_quarter();
    const Points normals = node_normals(net, net.nodes());
    for (const auto& [s, t] : net.edges()) {
        if (net.free_index(s) >= 0 && net.free_index(t) >= 0) {
            EXPECT_GT(normals.col(s).dot(normals.col(t)), 0.0);
        }
    }
    EXPECT_GT(normals.row(2).sum(), 0.5 * net.free_node_count());
    // A net that stands upright: the side of y; else of x.
    const CableNet upright = hypar(6, 7);
    for (const double turn : {0.5, -0.5}) {
        const auto normals_about = [&](const Eigen::Vector3d& axis) {
            const Eigen::Matrix3d turned = Eigen::AngleAxisd(turn * M_PI, axis).toRotationMatrix();
            return node_normals(upright, turned * upright.nodes());
        };
        const double half = 0.5 * upright.free_node_count();
        EXPECT_GT(normals_about(Eigen::Vector3d::UnitX()).row(1).sum(), half);
        EXPECT_GT(normals_about(Eigen::Vector3d::UnitY()).row(0).sum(), half);
    }
}

TEST(TargetOffsets, AreTakenBackAndWidenTheNoiseAlongTheNormal) {
    const CableNet net = hypar(4, 5);
    const auto points = simulate_survey(net, net.nodes(), {.offset = 0.003});
    Survey survey = match_to_nodes(net, points, 0.5e-3);
    const double before = (survey.form - net.nodes()).colwise().norm().maxCoeff();
    EXPECT_NEAR(before, 0.003, 1e-12);
    take_off_offsets(net, {.all = TargetOffset{.offset = 0.003, .std_dev = 0.2e-3}}, survey);
    EXPECT_LT((survey.form - net.nodes()).cwiseAbs().maxCoeff(), 1e-12);
    const Points normals = node_normals(net, net.nodes());
    for (const int node : net.free_nodes()) {
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(survey.noise_std(k, node), std::hypot(0.5e-3, 0.2e-3 * normals(k, node)),
                        1e-12);
        }
    }
    EXPECT_THAT(survey.notes, ElementsAre(HasSubstr("taken back by 3mm +- 0.2mm")));
    EXPECT_EQ(survey.supports.front().noise_std.x(), 0.5e-3);
}

TEST(TargetOffsets, AreThoseOfTheNameThenOfTheCodeThenOfAll) {
    const CableNet net = hypar(4, 5);
    std::vector<SurveyPoint> points = simulate_survey(net, net.nodes(), {});
    for (SurveyPoint& point : points) {
        point.code = "T";
    }
    const int first = net.free_nodes()[0];
    const int second = net.free_nodes()[1];
    points[net.supports().size() + 1].code = "sticker";
    TargetOffsets offsets{
        .all = TargetOffset{.offset = 0.001},
        .of = {{net.node_id(first), {.offset = 0.004}}, {"sticker", {.offset = -0.002}}}};
    Survey survey = match_to_nodes(net, points);
    take_off_offsets(net, offsets, survey);
    const auto moved = [&](int node) { return (survey.form - net.nodes()).col(node); };
    EXPECT_NEAR(moved(first).norm(), 0.004, 1e-12);
    EXPECT_LT(moved(first).z(), 0.0);
    EXPECT_NEAR(moved(second).norm(), 0.002, 1e-12);
    EXPECT_GT(moved(second).z(), 0.0);
    EXPECT_NEAR(moved(net.free_nodes()[2]).norm(), 0.001, 1e-12);
    // A table of all types that an office has is welcome; one of which none occurs is a slip.
    offsets.of["prism"] = {};
    take_off_offsets(net, offsets, survey);
    EXPECT_THAT(survey.notes, Contains(HasSubstr("no target has the name or code prism")));
    offsets.of = {{"prism", {}}};
    EXPECT_THROW(take_off_offsets(net, offsets, survey), SurveyError);
}

TEST(TargetOffsets, WithoutANormalCountAsNoise) {
    CableNetData data;
    data.nodes.resize(3, 3);
    data.nodes << 0, 1, 2, 0, 0, 0, 0, -0.1, 0;
    data.supports = {0, 2};
    data.edges = {{0, 1}, {1, 2}};
    data.axial_stiffness = Eigen::VectorXd::Constant(2, 2e5);
    data.unstressed_lengths = Eigen::VectorXd::Constant(2, 0.99);
    const CableNet net(std::move(data));
    Survey survey = match_to_nodes(net, {{.id = "1", .position = net.nodes().col(1)}}, 0.3e-3);
    take_off_offsets(net, {.all = TargetOffset{.offset = 0.4e-3}}, survey);
    EXPECT_EQ(survey.form, net.nodes());
    EXPECT_NEAR(survey.noise_std(0, 1), 0.5e-3, 1e-15);
    EXPECT_THAT(survey.warnings, ElementsAre(HasSubstr("has no normal at 1 node with offsets")));
}

TEST(TargetOffsets, AreParsedWithTheirStandardDeviation) {
    EXPECT_DOUBLE_EQ(parse_target_offset("-3mm").offset, -0.003);
    EXPECT_EQ(parse_target_offset("-3mm").std_dev, 0.0);
    EXPECT_DOUBLE_EQ(parse_target_offset("3mm:0.2mm").std_dev, 0.2e-3);
    for (const char* const bad : {"", "3mm:", "3mm:-1mm", "three"}) {
        EXPECT_THROW(static_cast<void>(parse_target_offset(bad)), std::invalid_argument) << bad;
    }
}

}  // namespace
}  // namespace taut
