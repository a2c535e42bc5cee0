// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a truth that is put beside the wrong edge, or loses digits.

#include "taut/io/lengths_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/errors.hpp"
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

CableNet named_net() {
    CableNetData data = test::two_node_net_data();
    data.edge_ids = {"aA", "a,B", "ab", "bC", "bD"};
    return CableNet(std::move(data));
}

TEST(LengthsCsv, IsReadBackToTheRoundingOfItsSums) {
    const CableNet nominal = named_net();
    CableNetData data = nominal.data();
    data.unstressed_lengths(1) += 1.0 / 3.0;
    data.unstressed_lengths(3) -= 1e-3;
    const CableNet built(std::move(data));
    const Eigen::VectorXd lengths =
        parse_lengths(nominal, lengths_to_csv(nominal, built), "truth.csv");
    EXPECT_LT((lengths - built.unstressed_lengths()).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(LengthsCsv, HoldsTheAdjustableEdgesThatWereTurned) {
    const CableNet nominal = named_net();
    CableNetData data = nominal.data();
    data.unstressed_lengths(4) -= 0.0625;
    const CableNet built(std::move(data));
    const std::string text = lengths_to_csv(nominal, built);
    EXPECT_THAT(text, testing::EndsWith(",-0.0625\n"));
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("aA")));
    EXPECT_EQ(parse_lengths(nominal, text, "truth.csv")(4), built.unstressed_lengths()(4));
}

TEST(LengthsCsv, MayHaveItsRowsInAnyOrder) {
    const Eigen::VectorXd lengths = parse_lengths(named_net(),
                                                  "edge;nominal;length_deviation\n# built\n"
                                                  "bC;0.99;0.25\nab;0.97;0\n\"a,B\";1.45;-0.25\n",
                                                  "truth.csv");
    EXPECT_EQ(lengths(1), 1.2);
    EXPECT_EQ(lengths(2), 0.97);
    EXPECT_EQ(lengths(3), 1.24);
    EXPECT_EQ(lengths(0), named_net().unstressed_lengths()(0));
}

struct BadLengths {
    const char* name;
    std::string rows;  ///< behind the header and the row of bC
    std::string told;
};

class RefusedLengths : public testing::TestWithParam<BadLengths> {};

TEST_P(RefusedLengths, WithTheirLine) {
    const std::string text = "edge,nominal,length_deviation\nbC,0.99,0\n" + GetParam().rows;
    EXPECT_THAT(test::input_error_of([&] { return parse_lengths(named_net(), text, "truth.csv"); }),
                testing::StartsWith("truth.csv:" + GetParam().told));
}

INSTANTIATE_TEST_SUITE_P(
    Rows, RefusedLengths,
    testing::Values(BadLengths{"UnknownEdge", "cE,1,0\n", "3: 'cE' is no edge of the net"},
                    BadLengths{"Twice", "ab,0.97,0\nbC,0.99,0\n",
                               "4: gives edge 'bC' a second time, first in line 2"},
                    BadLengths{"Missing", "ab,0.97,0\n", " holds no length of edge 'a,B'"},
                    BadLengths{"NotPositive", "ab,0.97,-0.97\n", "3: edge 'ab' is 0 m long"},
                    BadLengths{"NotFinite", "ab,0.97,nan\n",
                               "3: length_deviation is 'nan', expected a finite number"},
                    BadLengths{"NominalNotFinite", "ab,inf,0\n", "3: nominal is 'inf'"},
                    BadLengths{"OfAnotherNet", "ab,0.98,0\n",
                               "3: the nominal length of edge 'ab' is 0.98 m, expected 0.97 m"},
                    BadLengths{"TooFewFields", "ab,0.97\n", "3: has 2 fields, expected 3"}),
    [](const auto& bad) { return std::string(bad.param.name); });

TEST(LengthsCsv, RefusesAnotherHeader) {
    for (const std::string text : {"", "id,x,y,z\n", "edge,nominal\n", "ab,0.97,0\n"}) {
        EXPECT_THAT(
            test::input_error_of([&] { return parse_lengths(named_net(), text, "form.csv"); }),
            testing::HasSubstr("does not start with the header edge,nominal,length_deviation"));
    }
}

}  // namespace
}  // namespace taut
