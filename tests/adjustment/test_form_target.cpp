// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against plans for another form than the given one.
#include "taut/adjustment/form_target.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <limits>
#include <stdexcept>

#include "support/refusals.hpp"
#include "support/small_nets.hpp"
#include "support/surfaces.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

using ::testing::HasSubstr;

TEST(FormTarget, WeighsSquaresAlongAndAcrossItsNormal) {
    const CableNet net = hypar(5, 5);
    const FormTarget target(net, net.nodes(), {.normal = 4.0, .tangential = 0.25});
    const int node = net.free_nodes()[12];
    const Eigen::Vector3d normal = target.normals().col(node);
    ASSERT_NEAR(normal.norm(), 1.0, 1e-12);
    const Eigen::Vector3d across = normal.unitOrthogonal();
    EXPECT_NEAR(target.weighted(node, 3.0 * normal + 2.0 * across).squaredNorm(),
                4.0 * 9.0 + 0.25 * 4.0, 1e-12);
}

TEST(FormTarget, OfASingleCableHasTheNormalsWeightInAllDirections) {
    CableNetData data = test::chain_data(2, 2.0, 0.0);
    data.nodes(2, 1) = -0.1;
    const CableNet net(data);
    const FormTarget target(net, net.nodes());
    EXPECT_TRUE(target.normals().isZero(0.0));
    EXPECT_NEAR(target.weighted(1, Eigen::Vector3d(0.3, 0.0, 0.4)).norm(), 0.5, 1e-15);
    const FormDeviation none = deviation_from(target, net, net.nodes());
    EXPECT_EQ(none.normal_max, 0.0);
}

TEST(FormTarget, HasDeviationsOverTheFreeNodes) {
    const CableNet net = hypar(3, 3);
    const FormTarget target(net, net.nodes());
    Points form = net.nodes();
    const int first = net.free_nodes()[0];
    const int second = net.free_nodes()[1];
    form.col(first) += 9e-3 * target.normals().col(first);
    form.col(second) += 18e-3 * target.normals().col(second).unitOrthogonal();
    form.col(net.supports()[0]) += Eigen::Vector3d(1.0, 1.0, 1.0);  // does not count
    const FormDeviation deviation = deviation_from(target, net, form);
    EXPECT_NEAR(deviation.mean, 3e-3, 1e-12);
    EXPECT_NEAR(deviation.max, 18e-3, 1e-12);
    EXPECT_NEAR(deviation.rmse, std::sqrt((81.0 + 324.0) / 9.0) * 1e-3, 1e-12);
    EXPECT_NEAR(deviation.normal_mean, 1e-3, 1e-12);
    EXPECT_NEAR(deviation.normal_max, 9e-3, 1e-12);
    EXPECT_NEAR(deviation.normal_rmse, 3e-3, 1e-12);
}

TEST(FormTarget, OfASurfaceCountsTheDistanceFromItAndTheWayAlongItFromTheDesignedPlace) {
    const CableNet net = hypar(5, 5);
    const auto plane = test::plane_at(0.3, net);
    CableNetData data = net.data();
    data.nodes.row(2).setConstant(0.32);
    const CableNet flat(data);  // 20 mm above the plane
    const FormTarget target(flat, plane, {.normal = 1.0, .tangential = 0.25});
    Points form = flat.nodes();
    const int node = flat.free_nodes()[12];
    form.col(node) += Eigen::Vector3d(4e-3, 0.0, 10e-3);
    const FormTarget here = target.at(form);
    EXPECT_NEAR(here.normals()(2, node), 1.0, 1e-12);
    const Eigen::Vector3d weighted = here.weighted(node, form.col(node) - here.places().col(node));
    EXPECT_NEAR(weighted.squaredNorm(), 30e-3 * 30e-3 + 0.25 * 4e-3 * 4e-3, 1e-12);
    const FormDeviation deviation = deviation_from(target, flat, form);
    EXPECT_NEAR(deviation.normal_max, 30e-3, 1e-12);
    EXPECT_NEAR(deviation.normal_mean, (24 * 20e-3 + 30e-3) / 25, 1e-12);
}

TEST(FormTarget, RefusesASurfaceOutOfReachAndSaysInWhichUnitItWouldFit) {
    const CableNet net = hypar(5, 5);
    const auto refused = [&](const auto& surface, const char* text) {
        test::expect_refused([&] { return FormTarget(net, surface); }, text);
    };
    refused(test::plane_at(3.0, net), "m from the surface, expected at most");
    refused(test::plane_at(3.0, net), "unit or frame");
    CableNetData half = net.data();
    half.nodes.row(0) *= 0.5;
    half.nodes.row(1) *= 0.5;
    refused(test::surface_through(net, half.nodes), "m beyond the border of the surface");
    refused(test::surface_through(net, net.nodes(), 1e3), "in mm it would fit");
    FormTarget sound(net, test::surface_through(net, net.nodes()));
    test::expect_refused([&] { sound.move_to(net.nodes()); }, "surface cannot be moved");
}

TEST(FormTarget, IsMadeOfWhatIsGiven) {
    const CableNet net = hypar(3, 3);
    const int node = net.free_nodes()[1];
    GivenTarget given{.points = net.nodes(),
                      .weights = {.normal = 2.0},
                      .node_weights = {{.node = node, .normal = 9.0, .tangential = 3.0}},
                      .objective = FormObjective::largest};
    const FormTarget form = target_of(net, given);
    EXPECT_EQ(form.objective(), FormObjective::largest);
    EXPECT_EQ(form.normal_weights()(node), 9.0);
    EXPECT_EQ(form.tangential_weights()(node), 3.0);
    EXPECT_EQ(form.normal_weights()(net.free_nodes()[0]), 2.0);
    EXPECT_EQ(form.surface(), nullptr);
    EXPECT_TRUE(target_warnings(net, form).empty());
    given.node_weights[0].node = net.node_count();
    EXPECT_THROW(static_cast<void>(target_of(net, given)), std::out_of_range);
}

TEST(FormTarget, WarnsOfTrianglesWithoutAreaAndNodesBeyondTheBorder) {
    CableNetData data = hypar(3, 3).data();
    data.nodes.row(2).setZero();
    const CableNet net(data);
    const Eigen::Vector3d low = data.nodes.rowwise().minCoeff();
    Eigen::Vector3d high = data.nodes.rowwise().maxCoeff();
    // The border is 10 mm short of the outermost free node.
    high.x() = data.nodes(0, net.free_nodes()).maxCoeff() - 0.01;
    Points corners(3, 4);
    corners << low.x(), high.x(), high.x(), low.x(), low.y(), low.y(), high.y(), high.y(), 0.0, 0.0,
        0.0, 0.0;
    const FormTarget surface =
        target_of(net, {.points = corners, .triangles = {{0, 1, 2}, {0, 2, 3}, {0, 0, 1}}});
    ASSERT_NE(surface.surface(), nullptr);
    EXPECT_THAT(target_warnings(net, surface),
                ::testing::ElementsAre(
                    "1 of 3 triangles have no area and are not used",
                    ::testing::AllOf(HasSubstr("outside the border of the surface, '"),
                                     HasSubstr("' by 10mm. The surface is extended there"))));
}

TEST(FormTarget, RefusesWhatIsNoTarget) {
    const CableNet net = hypar(3, 3);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [&](const Points& places, double weight, const char* text) {
        test::expect_refused([&] { return FormTarget(net, places, {.normal = weight}); }, text);
    };
    refused(net.nodes().leftCols(4), 1.0, "target");
    Points broken = net.nodes();
    broken(0, 0) = nan;
    refused(broken, 1.0, "target");
    refused(net.nodes(), -1.0, "weight is -1");
    refused(net.nodes(), nan, "weight is nan");
    FormTarget target(net, net.nodes());
    const Eigen::VectorXd few = Eigen::VectorXd::Ones(3);
    test::expect_refused([&] { target.set_weights(few, few); }, "3 and 3 weights");
    EXPECT_THROW(static_cast<void>(target.weight(net.node_count())), std::out_of_range);
    EXPECT_THROW(static_cast<void>(target.weighted(-1, Eigen::Vector3d::Zero())),
                 std::out_of_range);
}

}  // namespace
}  // namespace taut
