// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against cables that slide to tensions that do not balance, slide where friction holds
// them, or lose length on the way, and against derivatives that forget that they slide.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "net/sliding_nodes.hpp"
#include "statics/reference_net.hpp"
#include "statics/sliding.hpp"
#include "support/finite_differences.hpp"
#include "support/small_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/cone_program.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/form_sensitivity.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

CableNet with_friction(const CableNet& net, double friction, double ratio = 1.0) {
    CableNetData data = net.data();
    for (CableRun& run : data.runs) {
        run.friction = friction;
        run.ratios.assign(run.slides_at.size(), ratio);
    }
    return CableNet(std::move(data));
}

CableNet ridge(const std::string& name = "ridge") {
    const test::Json json = test::reference_net("sliding_reference.json", name);
    CableNetData data = test::net_of(json).data();
    for (const test::Json& run : json.at("runs")) {
        data.runs.push_back({.name = "ridge",
                             .edges = run.at("edges").get<std::vector<int>>(),
                             .slides_at = run.at("slides_at").get<std::vector<int>>()});
    }
    return CableNet(std::move(data));
}

/// A pulley on a rope between two supports at different heights.
CableNet pulley(double load) {
    CableNetData data;
    data.nodes = Points{{0.0, 3.0, 1.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, -2.0}};
    data.supports = {0, 1};
    data.edges = {{0, 2}, {2, 1}};
    data.axial_stiffness = Eigen::VectorXd::Constant(2, 1e6);
    data.unstressed_lengths = Eigen::VectorXd{{1.2, 3.8}};
    data.loads = Points::Zero(3, 3);
    data.loads(2, 2) = -load;
    data.runs = {{.name = "rope", .edges = {0, 1}, .slides_at = {2}}};
    return CableNet(std::move(data));
}

TEST(Sliding, ARopeOverAPulleyHangsAtEqualAngles) {
    constexpr double load = 1000.0;
    const CableNet net = pulley(load);
    const Equilibrium e = solve_equilibrium(net);
    ASSERT_EQ(e.status, EquilibriumStatus::converged);
    EXPECT_NEAR(e.unstressed_lengths.sum(), 5.0, 1e-12);
    const Eigen::VectorXd tension = tensions_of(net, e.unstressed_lengths, e.form);
    EXPECT_NEAR(tension(0), tension(1), 1e-7);
    // Both parts hang at the angle with cos = 3 m / the length of the rope.
    const double rope = 5.0 * (1.0 + tension(0) / 1e6);
    const double sine = std::sqrt(1.0 - 9.0 / (rope * rope));
    EXPECT_NEAR(tension(0), 0.5 * load / sine, 1e-6);
    EXPECT_NEAR(e.form(2, 2), 0.5 * (1.0 - rope * sine), 1e-9);
}

TEST(Sliding, FormsAndTensionsAreThoseThatSciPyFinds) {
    for (const char* name : {"ridge", "slack ridge"}) {
        const CableNet net = ridge(name);
        const test::Json json = test::reference_net("sliding_reference.json", name);
        const Equilibrium e = solve_equilibrium(net);
        ASSERT_EQ(e.status, EquilibriumStatus::converged) << name;
        EXPECT_LT((e.form - test::points_of(json.at("form"))).cwiseAbs().maxCoeff(), 1e-8) << name;
        const Eigen::VectorXd expected = test::vector_of(json.at("tensions"));
        EXPECT_LT((tensions_of(net, e.unstressed_lengths, e.form) - expected).cwiseAbs().maxCoeff(),
                  1e-4)
            << name;
        // Once more: nothing slides any further.
        const Equilibrium again = EquilibriumSolver(net).solve(e.unstressed_lengths, e.form);
        EXPECT_LT((again.unstressed_lengths - e.unstressed_lengths).cwiseAbs().maxCoeff(), 1e-9);
    }
}

TEST(Sliding, WithFrictionSlidesOnlyAtItsLimit) {
    const CableNet nominal = ridge();
    int slid = 0;
    int stuck = 0;
    for (const double friction : {0.02, 0.1, 0.3}) {
        const CableNet net = with_friction(nominal, friction);
        Eigen::VectorXd marked = net.unstressed_lengths();
        marked(0) -= 0.004;
        marked(4) += 0.006;
        const Equilibrium e = EquilibriumSolver(net).solve(marked, net.nodes());
        ASSERT_EQ(e.status, EquilibriumStatus::converged) << friction;
        EXPECT_NEAR((e.unstressed_lengths - marked).sum(), 0.0, 1e-12);
        const Eigen::VectorXd tension = tensions_of(net, e.unstressed_lengths, e.form);
        const auto along = [&](int edge) {
            return (e.form.col(net.edges()[edge][1]) - e.form.col(net.edges()[edge][0]))
                .normalized();
        };
        double passed = 0.0;  // from the edges before the node
        for (int before = 0; before < 4; ++before) {
            passed += marked(before) - e.unstressed_lengths(before);
            if (before == 1) {
                EXPECT_NEAR(passed, 0.0, 1e-12);  // the clamp
                continue;
            }
            const double angle = std::acos(along(before).dot(along(before + 1)));
            const double ratio = std::log(tension(before + 1) / tension(before));
            EXPECT_LT(std::abs(ratio), friction * angle + 1e-8);
            if (std::abs(passed) > 1e-9) {
                // Length passes on towards the greater tension.
                EXPECT_NEAR(ratio, std::copysign(friction * angle, passed), 1e-7);
                ++slid;
            } else {
                ++stuck;
            }
        }
    }
    EXPECT_GT(slid, 2);
    EXPECT_GE(stuck, 2);
}

TEST(Sliding, GoesOnFromWhereItWasFound) {
    // Tensions that differ by more than friction holds, as estimates do.
    CableNetData data = with_friction(ridge(), 0.05).data();
    data.unstressed_lengths(0) -= 0.004;
    data.unstressed_lengths(4) += 0.006;
    const Equilibrium found = solve_equilibrium(clamped(CableNet(data)));
    ASSERT_EQ(found.status, EquilibriumStatus::converged);
    const CableNet net(data);
    const Eigen::VectorXd tension = tensions_of(net, found.unstressed_lengths, found.form);
    data.runs = runs_from_here(net, found.form, tension);
    const CableNet held(data);
    const Equilibrium there = EquilibriumSolver(held).solve(found.unstressed_lengths, found.form);
    EXPECT_LT((there.unstressed_lengths - found.unstressed_lengths).cwiseAbs().maxCoeff(), 1e-9);
    // On from there, within what friction holds on both sides of the ratios.
    Eigen::VectorXd turned = found.unstressed_lengths;
    turned(0) -= 0.05;
    const Equilibrium on = EquilibriumSolver(held).solve(turned, found.form);
    EXPECT_EQ(on.status, EquilibriumStatus::converged);
    EXPECT_GT((on.unstressed_lengths - turned).cwiseAbs().maxCoeff(), 1e-3);
    const Eigen::VectorXd then = tensions_of(held, on.unstressed_lengths, on.form);
    for (const SlidingNode& at : held.sliding_nodes()) {
        EXPECT_LE(std::abs(std::log(then(at.after) / then(at.before) / at.ratio)),
                  at.friction * contact_angle(held.edges(), on.form, at) + 1e-8);
    }
}

TEST(Sliding, DerivativesAreThoseOfTheNetThatSlides) {
    for (const auto& [friction, ratio] :
         {std::pair(0.0, 1.0), {0.05, 1.0}, {0.0, 1.02}, {0.05, 0.98}}) {
        const CableNet net = with_friction(ridge(), friction, ratio);
        EquilibriumSolver solver(net);
        Eigen::VectorXd marked = net.unstressed_lengths();
        marked(0) -= 0.004;
        marked(4) += 0.006;
        // From where it has slid to: with friction it goes on only in the same direction.
        const Equilibrium e = solver.solve(marked, net.nodes());
        ASSERT_EQ(e.status, EquilibriumStatus::converged);
        const FormSensitivity sensitivity(net, e.unstressed_lengths, e.form);
        const Eigen::MatrixXd expected = test::finite_differences(
            [&](const Eigen::VectorXd& l_0) {
                return free_coordinates(net, solver.solve(l_0, e.form).form);
            },
            marked, 1e-5);
        const auto edges = test::all_edges(net);
        const Eigen::MatrixXd columns = sensitivity.columns(edges);
        EXPECT_LT((columns - expected).cwiseAbs().maxCoeff(), 2e-5 * expected.cwiseAbs().maxCoeff())
            << friction;
        const Eigen::VectorXd gradient = Eigen::VectorXd::LinSpaced(columns.rows(), -1.0, 2.0);
        EXPECT_LT((sensitivity.apply_transposed(gradient) - columns.transpose() * gradient).norm(),
                  1e-9 * columns.norm());
        EXPECT_LT((sensitivity.apply(marked) - columns * marked).norm(), 1e-9 * columns.norm());
        const Eigen::MatrixXd lengths = test::finite_differences(
            [&](const Eigen::VectorXd& l_0) {
                return solver.solve(l_0, e.form).unstressed_lengths;
            },
            marked, 1e-5);
        EXPECT_LT((sensitivity.slid_columns(edges) - lengths).cwiseAbs().maxCoeff(), 2e-5);
        EXPECT_THAT([&] { (void)sensitivity.apply_second(marked, marked); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr("slide")));
    }
}

/// By differences: of the sum of all coordinates of the form, each with a weight.
class FormFunction {
public:
    explicit FormFunction(const CableNet& net)
        : m_net(net),
          m_start(solve_equilibrium(net)),
          m_weights(Points::NullaryExpr(3, net.node_count(), [](Eigen::Index i) {
              return std::sin(1.7 * static_cast<double>(i));
          })) {}

    [[nodiscard]] NetGradient gradient() const {
        EXPECT_EQ(m_start.status, EquilibriumStatus::converged);
        return FormSensitivity(m_net, m_start.unstressed_lengths, m_start.form)
            .net_gradient(m_weights);
    }
    [[nodiscard]] double slope(const std::function<void(CableNetData&, double)>& change,
                               double step) const {
        const auto value = [&](double by) {
            CableNetData data = m_net.data();
            change(data, by);
            const CableNet other(std::move(data));
            return EquilibriumSolver(other)
                .solve(other.unstressed_lengths(), m_start.form)
                .form.cwiseProduct(m_weights)
                .sum();
        };
        return (value(step) - value(-step)) / (2.0 * step);
    }

private:
    const CableNet& m_net;
    Equilibrium m_start;
    Points m_weights;
};

TEST(Sliding, TheGradientByTheNetIsThatOfTheNetThatSlides) {
    const CableNet net = ridge();
    const FormFunction function(net);
    const NetGradient gradient = function.gradient();
    for (const int edge : {0, 2, 4, 6}) {
        const double by_stiffness = function.slope(
            [&](CableNetData& data, double step) { data.axial_stiffness(edge) += step; }, 100.0);
        EXPECT_NEAR(gradient.axial_stiffness(edge), by_stiffness,
                    1e-5 * gradient.axial_stiffness.cwiseAbs().maxCoeff());
        const double by_length = function.slope(
            [&](CableNetData& data, double step) { data.unstressed_lengths(edge) += step; }, 1e-5);
        EXPECT_NEAR(gradient.unstressed_lengths(edge), by_length, 1e-4);
    }
    for (const auto& [node, axis] : {std::pair(0, 0), std::pair(5, 2), std::pair(8, 1)}) {
        const double by_place = function.slope(
            [&, n = node, a = axis](CableNetData& data, double step) { data.nodes(a, n) += step; },
            1e-5);
        EXPECT_NEAR(gradient.nodes(axis, node), by_place, 1e-4);
    }
    const double by_load =
        function.slope([&](CableNetData& data, double step) { data.loads(2, 3) += step; }, 0.1);
    EXPECT_NEAR(gradient.loads(2, 3), by_load, 1e-5 * gradient.loads.cwiseAbs().maxCoeff());
}

TEST(Sliding, TheGradientByPlacesHasTheAngleOfTheCableAtASupport) {
    CableNetData data = sliding_ridge().data();
    const auto& edges = data.runs.at(0).edges;
    data.runs.at(0).friction = 0.05;
    data.unstressed_lengths(edges.front()) -= 0.03;
    data.unstressed_lengths(edges.back()) += 0.02;
    const CableNet net(std::move(data));
    const Equilibrium e = solve_equilibrium(net);
    const FormFunction function(net);
    const NetGradient gradient = function.gradient();
    int masts = 0;
    for (const SlidingNode& at : net.sliding_nodes()) {
        if (net.free_index(at.node) >= 0) {
            continue;
        }
        ++masts;
        for (const int axis : {0, 1, 2}) {
            const double by_place = function.slope(
                [&](CableNetData& moved, double step) { moved.nodes(axis, at.node) += step; },
                1e-5);
            EXPECT_NEAR(gradient.nodes(axis, at.node), by_place, 1e-3) << at.node << ' ' << axis;
        }
    }
    EXPECT_EQ(masts, 2);
    EXPECT_GT((e.unstressed_lengths - net.unstressed_lengths()).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(Sliding, HasNoConeProgram) {
    const CableNet net = ridge();
    EXPECT_THAT([&] { (void)solve_cone_program(net, net.unstressed_lengths()); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("slide")));
}

}  // namespace
}  // namespace taut
