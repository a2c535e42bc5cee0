// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against missing shrinkage, or shrinkage wrong by a power of the number of samples: chance
// is then taken for correlation, or correlation for chance.
#include "numerics/shrunk_covariance.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "support/json_numbers.hpp"

namespace taut {
namespace {

using Json = nlohmann::json;

Eigen::MatrixXd matrix_of(const Json& rows) {
    return test::columns_of(rows).transpose();
}

Eigen::MatrixXd centred(const Eigen::MatrixXd& samples) {
    return samples.colwise() - samples.rowwise().mean();
}

// From tests/data/make_shrinkage_reference.py, which evaluates the paper's equations in fractions.
TEST(ShrunkCovariance, IsThatOfThePapersEquations) {
    std::ifstream stream(TAUT_TEST_DATA_DIR "/shrinkage_reference.json");
    const Json reference = Json::parse(stream);
    double least = 1.0;
    double most = 0.0;
    for (const Json& one : reference.at("cases")) {
        const Eigen::MatrixXd expected = matrix_of(one.at("covariance"));
        const Eigen::MatrixXd found = shrunk_covariance(centred(matrix_of(one.at("samples"))));
        EXPECT_LT((found - expected).norm(), 1e-12 * expected.norm()) << one.at("name");
        least = std::min(least, one.at("part").get<double>());
        most = std::max(most, one.at("part").get<double>());
    }
    EXPECT_LT(least, 0.1);
    EXPECT_EQ(most, 1.0);
}

TEST(ShrunkCovariance, OfConstantCoordinatesIsZero) {
    EXPECT_TRUE(shrunk_covariance(Eigen::MatrixXd::Zero(3, 4)).isZero(0.0));
}

}  // namespace
}  // namespace taut
