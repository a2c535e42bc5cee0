// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against edges cut to lengths at which they would not carry the tensions asked for.
#include "taut/design/unstressed_lengths.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace taut {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Edges {
    Eigen::VectorXd lengths{{1.02, 0.5, 3.0}};
    Eigen::VectorXd tensions{{4e3, 0.0, 250.0}};
    Eigen::VectorXd axial_stiffness{{200e3, 100e3, 1e3}};

    [[nodiscard]] Eigen::VectorXd unstressed_lengths() const {
        return unstressed_lengths_for(lengths, tensions, axial_stiffness);
    }
};

TEST(UnstressedLengths, AreThoseOfTheFormula) {
    EXPECT_TRUE(Edges().unstressed_lengths().isApprox(Eigen::Vector3d(1.0, 0.5, 2.4), 1e-15));
}

TEST(UnstressedLengths, GiveTheTensionsBack) {
    const Edges edges;
    const Eigen::ArrayXd l_0 = edges.unstressed_lengths();
    const Eigen::VectorXd tensions =
        edges.axial_stiffness.array() * (edges.lengths.array() / l_0 - 1.0);
    EXPECT_TRUE(tensions.isApprox(edges.tensions, 1e-12));
}

TEST(UnstressedLengths, OfNoEdgesAreNone) {
    EXPECT_EQ(
        unstressed_lengths_for(Eigen::VectorXd(), Eigen::VectorXd(), Eigen::VectorXd()).size(), 0);
}

/// Breaks the edges in one way, and expects a refusal with words.
template <typename Break>
void expect_edges_refused(Break&& break_it, const char* word, const char* other) {
    Edges edges;
    break_it(edges);
    EXPECT_THAT([&] { (void)edges.unstressed_lengths(); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(word), HasSubstr(other))));
}

TEST(UnstressedLengths, RefuseSizesThatDiffer) {
    expect_edges_refused([](Edges& e) { e.lengths.setOnes(2); }, "2 lengths", "3 tensions");
    expect_edges_refused([](Edges& e) { e.tensions.setOnes(4); }, "3 lengths", "4 tensions");
    expect_edges_refused([](Edges& e) { e.axial_stiffness.setOnes(1); }, "3 lengths",
                         "1 axial stiffnesses");
}

TEST(UnstressedLengths, RefuseALengthThatIsNotPositiveAndFinite) {
    expect_edges_refused([](Edges& e) { e.lengths(1) = 0.0; }, "edge 1 has length 0 m", "positive");
    expect_edges_refused([](Edges& e) { e.lengths(2) = -3.0; }, "edge 2 has length -3 m",
                         "positive");
    expect_edges_refused([](Edges& e) { e.lengths(0) = nan; }, "edge 0 has length nan m",
                         "positive");
    expect_edges_refused([](Edges& e) { e.lengths(0) = infinity; }, "edge 0 has length inf m",
                         "positive");
}

TEST(UnstressedLengths, RefuseAStiffnessThatIsNotPositiveAndFinite) {
    expect_edges_refused([](Edges& e) { e.axial_stiffness(1) = 0.0; }, "edge 1", "stiffness 0 N");
    expect_edges_refused([](Edges& e) { e.axial_stiffness(2) = -1e3; }, "edge 2",
                         "stiffness -1000 N");
    expect_edges_refused([](Edges& e) { e.axial_stiffness(0) = nan; }, "edge 0", "stiffness nan N");
    expect_edges_refused([](Edges& e) { e.axial_stiffness(0) = infinity; }, "edge 0",
                         "stiffness inf N");
}

TEST(UnstressedLengths, RefuseATensionThatIsNegativeOrNotFinite) {
    expect_edges_refused([](Edges& e) { e.tensions(1) = -1.0; }, "tension -1 N", "not negative");
    expect_edges_refused([](Edges& e) { e.tensions(1) = nan; }, "tension nan N", "not negative");
    expect_edges_refused([](Edges& e) { e.tensions(1) = infinity; }, "tension inf N",
                         "not negative");
}

}  // namespace
}  // namespace taut
