// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/turned_net.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

TEST(TurnedNet, HasTheWeightThatItHadBefore) {
    CableNetData data = hypar(3, 4).data();
    data.mass = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(data.edges.size()), 1.2);
    const CableNet net(std::move(data));
    const int edge = net.adjustable_edges().front();
    const CableNet turned =
        turned_net(net, std::vector<EdgeTurned>{{.edge = edge, .stroke = 0.05}});
    EXPECT_EQ(turned.unstressed_lengths()(edge), net.unstressed_lengths()(edge) + 0.05);
    EXPECT_EQ(turned.loads(), net.loads());
}

}  // namespace
}  // namespace taut
