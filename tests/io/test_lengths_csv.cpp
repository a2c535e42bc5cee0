// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a length that is put beside the wrong edge, or loses digits.

#include "taut/io/lengths_csv.hpp"

#include <gmock/gmock.h>

#include "support/bad_input.hpp"
#include "support/small_nets.hpp"

namespace taut {
namespace {

class LengthsCsv : public testing::Test {
protected:
    LengthsCsv() { m_data.edge_ids = {"aA", "a,B", "ab", "bC", "bD"}; }

    CableNetData m_data = test::two_node_net_data();
};

TEST_F(LengthsCsv, HasARowAnInteriorEdgeByItsNameToTheLastBit) {
    const CableNet nominal(m_data);
    m_data.unstressed_lengths(1) += 0.25;
    m_data.unstressed_lengths(2) -= 0.03125;
    EXPECT_EQ(lengths_to_csv(nominal, CableNet(m_data)),
              "edge,nominal,length_deviation\n\"a,B\",1.45,0.25\nab,0.97,-0.03125\nbC,0.99,0\n");
    m_data.adjustable = {0};
    EXPECT_THROW(static_cast<void>(lengths_to_csv(nominal, CableNet(m_data))),
                 std::invalid_argument);
}

TEST_F(LengthsCsv, IsReadBackWithTheAdjustableEdgesThatWereTurned) {
    const CableNet nominal(m_data);
    m_data.unstressed_lengths(1) += 1.0 / 3.0;
    m_data.unstressed_lengths(4) -= 0.0625;
    const CableNet built(m_data);
    const std::string text = lengths_to_csv(nominal, built);
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("aA")));
    const Eigen::VectorXd lengths = parse_lengths(nominal, text, "truth.csv");
    EXPECT_LT((lengths - built.unstressed_lengths()).cwiseAbs().maxCoeff(), 1e-15);
}

TEST_F(LengthsCsv, AreRefusedWithTheirLine) {
    const CableNet net(m_data);
    test::expect_refused(
        "truth.csv",
        {{"ab,0.97,0\n", ": holds no length of edge 'a,B'..."},
         {"ab,0.97,-0.97\n", ":3: edge 'ab' is 0 m long..."},
         {"ab,0.98,0\n", ":3: the nominal length of edge 'ab' is 0.98 m, expected 0.97 m..."},
         {"ab,0.96,0\n", ":3: the nominal length of edge 'ab' is 0.96 m, expected 0.97 m..."}},
        [&](const std::string& text) {
            return parse_lengths(net, "edge,nominal,length_deviation\nbC,0.99,0\n" + text,
                                 "truth.csv");
        });
}

}  // namespace
}  // namespace taut
