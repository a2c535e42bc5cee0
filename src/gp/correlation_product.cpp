// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "gp/correlation_product.hpp"

#include "numerics/dense.hpp"
#include "numerics/parts.hpp"
#include "numerics/serial_blas.hpp"

namespace taut::gp {

Eigen::MatrixXd correlation_product(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                                    double inverse_length_scale, const Eigen::MatrixXd& b,
                                    const Progress& progress) {
    const double factor = -0.5 * inverse_length_scale * inverse_length_scale;
    const Eigen::Index n = inputs.cols();
    // |x - z|^2 = |x|^2 + |z|^2 - 2 x.z loses digits where the inputs lie far from the origin.
    const Eigen::MatrixXd centred = inputs.colwise() - inputs.rowwise().mean();
    const Eigen::ArrayXd squares = centred.colwise().squaredNorm();
    Eigen::MatrixXd result(n, b.cols());
    const SerialBlas serial;
    by_parts(Parts::parallel, 0, n, [&](Eigen::Index first, Eigen::Index count) {
        progress.throw_if_stopped();
        Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(n, count);
        add_transposed_product(columns, -2.0, centred, centred.middleCols(first, count));
        for (Eigen::Index j = 0; j < count; ++j) {
            auto column = columns.col(j).array();
            column = (factor * (column + squares + squares(first + j)).max(0.0)).exp();
        }
        Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(count, b.cols());
        add_transposed_product(rows, 1.0, columns, b);
        result.middleRows(first, count) = rows;
    });
    return result;
}

}  // namespace taut::gp
