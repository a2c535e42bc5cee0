// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a frame's stiffness that goes to another support or axis than its file says.

#include "taut/io/frame_csv.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/errors.hpp"
#include "support/examples.hpp"
#include "taut/statics/imbalance.hpp"

namespace taut {
namespace {

using testing::HasSubstr;

class FrameCsv : public testing::Test {
protected:
    [[nodiscard]] std::string error(const std::string& text) const {
        return test::input_error_of([&] { return parse_frame(m_net, text, "frame.csv"); });
    }
    /// A list of entries: the diagonal of two supports, and further lines.
    [[nodiscard]] std::string list(const std::string& more) const {
        std::string text = "row,column,stiffness\n";
        for (const std::string& support : {m_first, m_second}) {
            for (const char axis : {'x', 'y', 'z'}) {
                text += fmt::format("{0}.{1},{0}.{1},1e6\n", support, axis);
            }
        }
        return text + more;
    }

    const CableNet m_net = test::example_net().net;
    const std::string m_first = m_net.node_id(m_net.supports()[3]);
    const std::string m_second = m_net.node_id(m_net.supports()[1]);
};

TEST_F(FrameCsv, GivesOneOrBothTrianglesOfAListOrAWholeMatrix) {
    const std::string a = m_first + ".x";
    const std::string b = m_second + ".z";
    const FrameStiffness one =
        parse_frame(m_net, list(fmt::format("{},{},-2e5\n", a, b)), "frame.csv");
    EXPECT_EQ(one.supports, (std::vector{m_net.supports()[3], m_net.supports()[1]}));
    Eigen::MatrixXd expected = 1e6 * Eigen::MatrixXd::Identity(6, 6);
    expected(0, 5) = expected(5, 0) = -2e5;
    EXPECT_EQ(one.stiffness, expected);
    const FrameStiffness both =
        parse_frame(m_net, list(fmt::format("{0},{1},-2e5\n{1},{0},-2e5\n", a, b)), "frame.csv");
    EXPECT_EQ(both.stiffness, expected);

    std::string matrix = "dof";
    std::vector<std::string> names;
    for (const std::string& support : {m_first, m_second}) {
        for (const char axis : {'x', 'y', 'z'}) {
            names.push_back(fmt::format("{}.{}", support, axis));
            matrix += "," + names.back();
        }
    }
    for (Eigen::Index i = 0; i < 6; ++i) {
        matrix += "\n" + names[static_cast<size_t>(i)];
        for (Eigen::Index k = 0; k < 6; ++k) {
            matrix += fmt::format(",{}", expected(i, k));
        }
    }
    EXPECT_EQ(parse_frame(m_net, matrix + "\n", "frame.csv").stiffness, expected);

    const CableNet net = on_frame(m_net, one);
    ASSERT_EQ(net.support_couplings().size(), 1U);
    EXPECT_EQ(net.support_couplings()[0].stiffness(0, 2), -2e5);
    EXPECT_EQ(net.elastic_supports()[0].node, one.supports[0]);
    EXPECT_EQ(net.adjustable_edges(), m_net.adjustable_edges());
    // As far out of balance as the nominal form was.
    const auto share = [](const CableNet& of) {
        return imbalance_of(of, of.unstressed_lengths(), of.nodes()).largest;
    };
    EXPECT_NEAR(share(net), share(m_net), 1e-9);
}

TEST_F(FrameCsv, RefusesWhatIsNoStiffnessOfAFrame) {
    const std::string a = m_first + ".x";
    const std::string b = m_second + ".z";
    EXPECT_THAT(error("support,x\nA,1\n"),
                HasSubstr("frame.csv:1: expected the header dof,NODE.x"));
    EXPECT_THAT(error(list("N99.x,N99.x,1\n")),
                HasSubstr("frame.csv:8: 'N99.x' is no support and axis"));
    EXPECT_THAT(error(list(fmt::format("{0}.w,{0}.w,1\n", m_first))),
                HasSubstr("is no support and axis"));
    EXPECT_THAT(error(list(fmt::format("{0}.x,{0}.x,1\n", m_net.node_id(m_net.free_nodes()[0])))),
                HasSubstr("is no support and axis"));
    EXPECT_THAT(error(list(fmt::format("{},{},many\n", a, b))), HasSubstr("frame.csv:8:"));
    EXPECT_THAT(
        error(list(fmt::format("{0},{0},2e6\n", a))),
        HasSubstr("frame.csv:8: gives an entry a second time: 2000000, but 1000000 before"));
    EXPECT_THAT(error(list(fmt::format("{0},{1},3e5\n{1},{0},2e5\n", a, b))),
                HasSubstr("that is not symmetric"));
    EXPECT_THAT(error(list(fmt::format("{},{},-1.1e6\n", a, b))),
                HasSubstr("is not positive definite"));
    const std::string other = m_net.node_id(m_net.supports()[0]);
    EXPECT_THAT(error(list(fmt::format("{0}.x,{0}.x,1e6\n", other))),
                HasSubstr(fmt::format("has no stiffness of the support {} along y itself", other)));
}

}  // namespace
}  // namespace taut
