// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against simulated nets with lengths outside the prior, with other adjustable edges than
// designed, or with lengths that the processes were trained on.

#include "taut/sampling/built_net.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "taut/design/builtin_nets.hpp"
#include "taut/sampling/sampler.hpp"

namespace {

using namespace taut;

constexpr LengthPrior built_prior{LengthPrior::Kind::uniform, 0.005};

Eigen::VectorXd deviations(const CableNet& net, std::uint64_t seed) {
    return (built_net(net, built_prior, seed).unstressed_lengths() -
            net.unstressed_lengths())(net.interior_edges());
}

TEST(BuiltNet, HasInteriorLengthsOfThePriorAndAllElseAsDesigned) {
    const CableNet net = hypar(6, 8);
    const Eigen::VectorXd drawn = deviations(net, 7);
    EXPECT_LE(drawn.cwiseAbs().maxCoeff(), built_prior.scale);
    EXPECT_NEAR(drawn.norm() / std::sqrt(static_cast<double>(drawn.size())), built_prior.std_dev(),
                0.2 * built_prior.std_dev());
    CableNetData data = built_net(net, built_prior, 7).data();
    for (const int edge : net.adjustable_edges()) {
        EXPECT_EQ(data.unstressed_lengths(edge), net.unstressed_lengths()(edge));
    }
    data.unstressed_lengths = net.unstressed_lengths();
    EXPECT_EQ(CableNet(data).fingerprint(), net.fingerprint());
    EXPECT_THROW(static_cast<void>(built_net(net, {LengthPrior::Kind::uniform, 9.0}, 1)),
                 std::invalid_argument);
}

TEST(BuiltNet, WeighsAsDesigned) {
    CableNetData data = hypar(3, 4).data();
    data.mass = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(data.edges.size()), 1.2);
    const CableNet net(std::move(data));
    EXPECT_EQ(built_net(net, built_prior, 7).loads(), net.loads());
}

TEST(BuiltNet, IsTheSameForASeedAndNoSampleOfIt) {
    const CableNet net = hypar(3, 4);
    EXPECT_EQ(deviations(net, 7), deviations(net, 7));
    EXPECT_NE(deviations(net, 7), deviations(net, 8));
    const DataSet data = draw_samples(Sampler(net, built_prior, 7), 20);
    for (const auto& sample : data.length_deviations.colwise()) {
        EXPECT_GT((sample - deviations(net, 7)).norm(), 1e-4);
    }
}

}  // namespace
