// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a truth that is put beside the wrong edge, or loses digits.

#include "taut/io/lengths_csv.hpp"

#include <gtest/gtest.h>

#include "support/small_nets.hpp"

namespace taut {
namespace {

TEST(LengthsCsv, HasARowAnInteriorEdgeByItsNameToTheLastBit) {
    CableNetData data = test::two_node_net_data();
    data.edge_ids = {"aA", "a,B", "ab", "bC", "bD"};
    const CableNet nominal(data);
    data.unstressed_lengths(1) += 0.25;
    data.unstressed_lengths(2) -= 0.03125;
    const CableNet built(data);
    EXPECT_EQ(lengths_to_csv(nominal, built),
              "edge,nominal,length_deviation\n\"a,B\",1.45,0.25\nab,0.97,-0.03125\nbC,0.99,0\n");
}

TEST(LengthsCsv, RefusesAnotherNet) {
    CableNetData data = test::two_node_net_data();
    const CableNet nominal(data);
    data.adjustable = {0};
    EXPECT_THROW(static_cast<void>(lengths_to_csv(nominal, CableNet(data))), std::invalid_argument);
}

}  // namespace
}  // namespace taut
