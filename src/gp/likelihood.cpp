// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/gp/likelihood.hpp"

#include <tbb/parallel_for.h>

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "gp/dense.hpp"

namespace taut::gp {
namespace {

/// sum_i log(d_i + eta), with one logarithm for each product of 16 terms. Terms lie between 1e-14
/// and 1e4 or so: such a product stays within the range of doubles.
double log_determinant(const Eigen::VectorXd& eigenvalues, double noise_ratio) {
    constexpr Eigen::Index block = 16;
    double sum = 0.0;
    Eigen::Index i = 0;
    for (; i + block <= eigenvalues.size(); i += block) {
        sum += std::log((eigenvalues.segment<block>(i).array() + noise_ratio).prod());
    }
    for (; i < eigenvalues.size(); ++i) {
        sum += std::log(eigenvalues(i) + noise_ratio);
    }
    return sum;
}

double best_signal_variance(const Eigen::VectorXd& eigenvalues,
                            const Eigen::Ref<const Eigen::VectorXd>& squared_z,
                            double noise_ratio) {
    return (squared_z.array() / (eigenvalues.array() + noise_ratio)).mean();
}

/// The negative log likelihood at the best sigma_f for eta.
double profile_value(const Eigen::VectorXd& eigenvalues,
                     const Eigen::Ref<const Eigen::VectorXd>& squared_z, double noise_ratio) {
    const auto n = static_cast<double>(eigenvalues.size());
    return 0.5 * n * std::log(best_signal_variance(eigenvalues, squared_z, noise_ratio)) +
           0.5 * log_determinant(eigenvalues, noise_ratio) +
           0.5 * n * (1.0 + std::log(2.0 * std::numbers::pi));
}

/// The best eta: a scan finds the right valley, Brent's method its bottom. There can be two
/// valleys, one that explains the output by the inputs and one that takes it for noise.
double best_noise_ratio(const Eigen::VectorXd& eigenvalues,
                        const Eigen::Ref<const Eigen::VectorXd>& squared_z,
                        const NoiseRatioBounds& bounds) {
    constexpr int scan_points = 12;
    const double lower = std::log(bounds.lower);
    const double step = (std::log(bounds.upper) - lower) / (scan_points - 1);
    const auto value = [&](double log_ratio) {
        return profile_value(eigenvalues, squared_z, std::exp(log_ratio));
    };
    int best = 0;
    double best_value = std::numeric_limits<double>::infinity();
    for (int k = 0; k < scan_points; ++k) {
        if (const double v = value(lower + k * step); v < best_value) {
            best = k;
            best_value = v;
        }
    }
    constexpr int bits = 20;  // the value is then exact to rounding: it is flat at its minimum
    const auto [argument, minimum] = boost::math::tools::brent_find_minima(
        value, lower + std::max(0, best - 1) * step,
        lower + std::min(scan_points - 1, best + 1) * step, bits);
    return minimum < best_value ? std::exp(argument) : std::exp(lower + best * step);
}

/// dR / d log lambda = -lambda^2 S o R.
Eigen::MatrixXd correlation_rate(const Eigen::Ref<const Eigen::MatrixXd>& squared_distances,
                                 double inverse_length_scale) {
    const double factor = -inverse_length_scale * inverse_length_scale;
    Eigen::MatrixXd rate = correlation(squared_distances, inverse_length_scale);
    tbb::parallel_for(Eigen::Index{0}, rate.cols(), [&](Eigen::Index j) {
        rate.col(j).array() *= factor * squared_distances.col(j).array();
    });
    return rate;
}

/// The diagonal of Q' M Q.
Eigen::VectorXd diagonal_in_basis(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& basis) {
    return product(matrix, basis).cwiseProduct(basis).colwise().sum().transpose();
}

}  // namespace

Likelihood negative_log_likelihood(const KernelSpectrum& spectrum,
                                   const Eigen::Ref<const Eigen::MatrixXd>& squared_distances,
                                   const Eigen::Ref<const Eigen::VectorXd>& output,
                                   const Hyperparameters& hyperparameters) {
    const double signal = hyperparameters.signal_std * hyperparameters.signal_std;
    const double noise = hyperparameters.noise_std * hyperparameters.noise_std;
    const auto n = static_cast<double>(output.size());
    const Eigen::MatrixXd& basis = spectrum.eigenvectors;
    const Eigen::ArrayXd variances = signal * spectrum.eigenvalues.array() + noise;  // of Q'y
    const Eigen::VectorXd z = basis.transpose() * output;
    const Eigen::VectorXd weights = basis * (z.array() / variances).matrix();  // C^-1 y

    Likelihood result;
    result.value = 0.5 * (z.array().square() / variances).sum() + 0.5 * variances.log().sum() +
                   0.5 * n * std::log(2.0 * std::numbers::pi);
    const Eigen::MatrixXd rate =
        signal * correlation_rate(squared_distances, spectrum.inverse_length_scale);
    const Eigen::ArrayXd squared_weights_in_basis = (z.array() / variances).square();
    result.gradient << 0.5 * (diagonal_in_basis(rate, basis).array() / variances).sum() -
                           0.5 * weights.dot(rate * weights),
        (signal * spectrum.eigenvalues.array() * (1.0 / variances - squared_weights_in_basis))
            .sum(),
        (noise * (1.0 / variances - squared_weights_in_basis)).sum();
    return result;
}

NoiseRatioBounds default_noise_ratio_bounds(Eigen::Index n) {
    return {.lower = 10.0 * std::numeric_limits<double>::epsilon() *
                     static_cast<double>(std::max<Eigen::Index>(1, n))};
}

LikelihoodProfile profile_likelihood(const KernelSpectrum& spectrum,
                                     const Eigen::Ref<const Eigen::MatrixXd>& squared_distances,
                                     const Eigen::Ref<const Eigen::MatrixXd>& outputs,
                                     const NoiseRatioBounds& bounds) {
    const Eigen::Index m = outputs.cols();
    const Eigen::VectorXd& d = spectrum.eigenvalues;
    const Eigen::MatrixXd rate = correlation_rate(squared_distances, spectrum.inverse_length_scale);
    const Eigen::VectorXd rate_diagonal = diagonal_in_basis(rate, spectrum.eigenvectors);
    const Eigen::MatrixXd z = transposed_product(spectrum.eigenvectors, outputs);

    LikelihoodProfile profile{.value = Eigen::VectorXd(m),
                              .slope = Eigen::VectorXd(m),
                              .noise_ratio = Eigen::VectorXd(m),
                              .signal_variance = Eigen::VectorXd(m)};
    Eigen::MatrixXd weights_in_basis(z.rows(), m);  // (d + eta)^-1 z
    tbb::parallel_for(Eigen::Index{0}, m, [&](Eigen::Index j) {
        const Eigen::VectorXd squared_z = z.col(j).array().square();
        const double ratio = best_noise_ratio(d, squared_z, bounds);
        profile.noise_ratio(j) = ratio;
        profile.value(j) = profile_value(d, squared_z, ratio);
        profile.signal_variance(j) = best_signal_variance(d, squared_z, ratio);
        profile.slope(j) = 0.5 * (rate_diagonal.array() / (d.array() + ratio)).sum();
        weights_in_basis.col(j) = z.col(j).array() / (d.array() + ratio);
    });
    // By the envelope theorem the slope of the profile is the partial derivative at its minimiser.
    const Eigen::MatrixXd weights = product(spectrum.eigenvectors, weights_in_basis);
    const Eigen::VectorXd quadratic =
        weights.cwiseProduct(product(rate, weights)).colwise().sum().transpose();
    profile.slope.array() -= 0.5 * quadratic.array() / profile.signal_variance.array();
    return profile;
}

}  // namespace taut::gp
