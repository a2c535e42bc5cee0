// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "estimation/common_parameters.hpp"
#include "taut/design/builtin_nets.hpp"

namespace {

using namespace taut;

// Each load has one error.
TEST(CommonParameters, OfLoadsLeaveWhatIsKnownOtherwise) {
    CableNetData data = hypar(3, 3).data();
    const Points hung = Points::Constant(3, data.nodes.cols(), -50.0);
    data.loads = Points::Constant(3, data.nodes.cols(), -20.0) + hung;
    data.mass = Eigen::VectorXd::Constant(std::ssize(data.edges), 0.3);
    const CableNet net(data);
    const auto change_by = [&](const std::vector<UncertainParameter>& uncertain) -> Points {
        const CommonParameters common(net, uncertain, false, hung);
        Eigen::VectorXd values = Eigen::VectorXd::Zero(common.count());
        values(0) = 1.0;
        return common.load_change(values);
    };
    const UncertainParameter loads = parse_uncertain_parameter("loads:5%");
    const UncertainParameter mass = parse_uncertain_parameter("mass:3%");
    EXPECT_TRUE(change_by({loads}).isApprox(0.05 * (net.loads() - hung)));
    EXPECT_TRUE(change_by({loads, mass}).isApprox(0.05 * (net.data().loads - hung)));
}

}  // namespace
