// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/gp/kernel.hpp"

#include "numerics/dense.hpp"
#include "numerics/parallel.hpp"

namespace taut::gp {

Eigen::MatrixXd squared_distances(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                  const Eigen::Ref<const Eigen::MatrixXd>& z) {
    // |x - z|^2 = |x|^2 + |z|^2 - 2 x.z loses digits where the inputs lie far from the origin.
    const Eigen::VectorXd centre = x.rowwise().mean();
    const Eigen::MatrixXd a = x.colwise() - centre;
    const Eigen::MatrixXd b = z.colwise() - centre;
    Eigen::MatrixXd distances = -2.0 * transposed_product(a, b);
    distances.colwise() += a.colwise().squaredNorm().transpose();
    distances.rowwise() += b.colwise().squaredNorm();
    return distances.cwiseMax(0.0);
}

Eigen::MatrixXd squared_distances(const Eigen::Ref<const Eigen::MatrixXd>& x) {
    const Eigen::MatrixXd a = x.colwise() - x.rowwise().mean();
    Eigen::MatrixXd distances = gram(a);
    const Eigen::VectorXd squares = distances.diagonal();
    parallel_for(Eigen::Index{0}, distances.cols(), [&](Eigen::Index j) {
        auto column = distances.col(j).array();
        column = (squares.array() + squares(j) - 2.0 * column).max(0.0);
    });
    return distances;
}

Eigen::MatrixXd correlation(const Eigen::Ref<const Eigen::MatrixXd>& squared_distances,
                            double inverse_length_scale) {
    const double factor = -0.5 * inverse_length_scale * inverse_length_scale;
    Eigen::MatrixXd result(squared_distances.rows(), squared_distances.cols());
    parallel_for(Eigen::Index{0}, result.cols(), [&](Eigen::Index j) {
        result.col(j) = (factor * squared_distances.col(j).array()).exp();
    });
    return result;
}

}  // namespace taut::gp
