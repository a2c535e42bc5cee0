// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against edges cut to lengths at which they would not carry the required tensions.
#include "taut/design/unstressed_lengths.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "support/not_finite.hpp"

namespace taut {
namespace {

using test::infinity;
using test::nan;

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

TEST(UnstressedLengths, OfAPressedStrutAreLonger) {
    Edges edges;
    edges.tensions(2) = -250.0;
    EXPECT_DOUBLE_EQ(edges.unstressed_lengths()(2), 4.0);
}

TEST(UnstressedLengths, RefuseWrongSizesAndValues) {
    const auto expect_refused = [](const auto& change, const char* words) {
        Edges edges;
        change(edges);
        EXPECT_THAT([&] { (void)edges.unstressed_lengths(); },
                    testing::ThrowsMessage<std::invalid_argument>(
                        testing::AllOf(testing::HasSubstr(words), testing::HasSubstr("expected"))));
    };
    expect_refused([](Edges& e) { e.lengths.setOnes(2); }, "2 lengths, 3 tensions");
    expect_refused([](Edges& e) { e.tensions.setOnes(4); }, "3 lengths, 4 tensions");
    expect_refused([](Edges& e) { e.axial_stiffness.setOnes(1); }, "1 axial stiffnesses");
    for (const auto& [value, text] :
         {std::pair{0.0, "0"}, {-3.0, "-3"}, {nan, "nan"}, {infinity, "inf"}}) {
        const std::string number(text);
        expect_refused([v = value](Edges& e) { e.lengths(1) = v; },
                       ("edge 1 has length " + number + " m").c_str());
        expect_refused([v = value](Edges& e) { e.axial_stiffness(2) = v; },
                       ("axial stiffness " + number + " N").c_str());
        if (!std::isfinite(value)) {
            expect_refused([v = value](Edges& e) { e.tensions(1) = v; },
                           ("tension " + number + " N").c_str());
        }
    }
    expect_refused([](Edges& e) { e.tensions(2) = -1e3; }, "tension -1000 N");  // -EA
}

}  // namespace
}  // namespace taut
