// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <boost/math/distributions/normal.hpp>

#include "numerics/truncated_mixture.hpp"

namespace {

using taut::TruncatedMixture;

TEST(TruncatedMixture, HasTheQuantilesOfItsDensity) {
    const boost::math::normal normal(2.0, 0.5);
    const TruncatedMixture above({{.mean = 2.0, .std_dev = 0.5, .lower = 2.0, .upper = 1e3}});
    for (const double p : {0.025, 0.5, 0.975}) {
        EXPECT_NEAR(above.quantile(p), quantile(normal, 0.5 + 0.5 * p), 1e-9);
        EXPECT_NEAR(above.cumulative(above.quantile(p)), p, 1e-9);
    }
}

TEST(TruncatedMixture, OfOneNumberHasItAsEachQuantile) {
    // A width that is less than the digits of its place.
    const TruncatedMixture narrow({{.mean = 1.0, .std_dev = 1e-20, .lower = 0.0, .upper = 2.0}});
    for (const double p : {0.025, 0.5, 0.975}) {
        EXPECT_EQ(narrow.quantile(p), 1.0);
    }
}

}  // namespace
