// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/gp/likelihood.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "gp/likelihood_profile.hpp"
#include "numerics/dense.hpp"
#include "numerics/parallel.hpp"

namespace taut::gp {
namespace {

/// The n eigenvalues of a correlation matrix: d, and last the mean of those that are left out,
/// which stands for all of them.
struct Eigenvalues {
    Eigen::VectorXd values;
    Eigen::Index n;  ///< with those left out

    explicit Eigenvalues(const KernelSpectrum& spectrum)
        : values(spectrum.eigenvalues), n(spectrum.eigenvectors.rows()) {
        if (!spectrum.is_whole()) {
            values.conservativeResize(values.size() + 1);
            values(values.size() - 1) = spectrum.tail_mean;
        }
    }
};

/// The energy z^2 of each output in each direction, and of what the directions leave out (as many
/// as Eigenvalues::values x m).
Eigen::MatrixXd energies(const KernelSpectrum& spectrum,
                         const Eigen::Ref<const Eigen::MatrixXd>& outputs,
                         const Eigen::MatrixXd& z) {
    Eigen::MatrixXd squared = z.cwiseAbs2();
    if (!spectrum.is_whole()) {
        squared.conservativeResize(squared.rows() + 1, Eigen::NoChange);
        squared.bottomRows<1>().setZero();
        squared.bottomRows<1>() =
            (outputs.colwise().squaredNorm() - squared.colwise().sum()).cwiseMax(0.0);
    }
    return squared;
}

/// sum_i log(d_i + eta), with one logarithm for each product of 16 terms. Terms lie between 1e-14
/// and 1e4 or so: such a product stays within the range of doubles.
double log_determinant(const Eigenvalues& eigenvalues, double noise_ratio) {
    constexpr Eigen::Index block = 16;
    const Eigen::VectorXd& d = eigenvalues.values;
    double sum = 0.0;
    Eigen::Index i = 0;
    for (; i + block <= d.size(); i += block) {
        sum += std::log((d.segment<block>(i).array() + noise_ratio).prod());
    }
    for (; i < d.size(); ++i) {
        sum += std::log(d(i) + noise_ratio);
    }
    const auto others = static_cast<double>(eigenvalues.n - d.size());  // equal to the last one
    return sum + (others > 0.0 ? others * std::log(d(d.size() - 1) + noise_ratio) : 0.0);
}

double best_signal_variance(const Eigenvalues& eigenvalues,
                            const Eigen::Ref<const Eigen::VectorXd>& squared_z,
                            double noise_ratio) {
    return (squared_z.array() / (eigenvalues.values.array() + noise_ratio)).sum() /
           static_cast<double>(eigenvalues.n);
}

/// The negative log likelihood of n outputs at the best sigma_f for some eta.
double profile_value(Eigen::Index n, double signal_variance, double log_determinant) {
    const auto count = static_cast<double>(n);
    return 0.5 * (count * std::log(signal_variance) + log_determinant +
                  count * (1.0 + std::log(2.0 * std::numbers::pi)));
}

/// The profile over log eta of every output at evenly spread points: a row of values each.
struct NoiseScan {
    double lower;
    double step;
    Eigen::MatrixXd values;
};

/// Steps of at most 1 in log eta: an eigenvalue's term turns within about 4, so that hardly a
/// valley hides between two points.
NoiseScan scan_noise_ratios(const Eigenvalues& eigenvalues, const Eigen::MatrixXd& squared_z,
                            const NoiseRatioBounds& bounds) {
    const double range = std::log(bounds.upper / bounds.lower);
    const auto intervals = static_cast<Eigen::Index>(std::ceil(range));
    NoiseScan scan{.lower = std::log(bounds.lower),
                   .step = intervals > 0 ? range / static_cast<double>(intervals) : 0.0,
                   .values = Eigen::MatrixXd(intervals + 1, squared_z.cols())};
    Eigen::MatrixXd inverse(eigenvalues.values.size(), intervals + 1);
    Eigen::VectorXd log_determinants(intervals + 1);
    for (Eigen::Index k = 0; k <= intervals; ++k) {
        const double ratio = std::exp(scan.lower + static_cast<double>(k) * scan.step);
        inverse.col(k) = (eigenvalues.values.array() + ratio).inverse();
        log_determinants(k) = log_determinant(eigenvalues, ratio);
    }
    const Eigen::Index n = eigenvalues.n;
    const Eigen::MatrixXd sums = transposed_product(inverse, squared_z);
    for (Eigen::Index j = 0; j < sums.cols(); ++j) {
        for (Eigen::Index k = 0; k <= intervals; ++k) {
            scan.values(k, j) =
                profile_value(n, sums(k, j) / static_cast<double>(n), log_determinants(k));
        }
    }
    return scan;
}

/// The best eta of one output: Brent's method from each of the scan's valleys. There can be
/// several, such as one that explains the output by the inputs and one that takes it for noise.
double best_noise_ratio(const Eigenvalues& eigenvalues,
                        const Eigen::Ref<const Eigen::VectorXd>& squared_z, const NoiseScan& scan,
                        const Eigen::Ref<const Eigen::VectorXd>& scanned) {
    const auto value = [&](double log_ratio) {
        const double ratio = std::exp(log_ratio);
        return profile_value(eigenvalues.n, best_signal_variance(eigenvalues, squared_z, ratio),
                             log_determinant(eigenvalues, ratio));
    };
    const auto at = [&](Eigen::Index k) { return scan.lower + static_cast<double>(k) * scan.step; };
    double best = scan.lower;
    double best_value = std::numeric_limits<double>::infinity();
    const auto offer = [&](double log_ratio, double its_value) {
        if (its_value < best_value) {
            best = log_ratio;
            best_value = its_value;
        }
    };
    const Eigen::Index last = scanned.size() - 1;
    for (Eigen::Index k = 0; k <= last; ++k) {
        const Eigen::Index left = std::max<Eigen::Index>(0, k - 1);
        const Eigen::Index right = std::min(last, k + 1);
        if (scanned(k) > scanned(left) || scanned(k) > scanned(right)) {
            continue;
        }
        offer(at(k), scanned(k));
        if (left < right) {
            constexpr int bits = 20;  // the value is then exact to rounding: it is flat there
            const auto [argument, minimum] =
                boost::math::tools::brent_find_minima(value, at(left), at(right), bits);
            offer(argument, minimum);
        }
    }
    return std::exp(best);
}

/// dR / d log lambda = -lambda^2 S o R, its lower triangle.
Eigen::MatrixXd correlation_rate(const Eigen::Ref<const Eigen::MatrixXd>& squared_distances,
                                 double inverse_length_scale) {
    const double square = inverse_length_scale * inverse_length_scale;
    const Eigen::Index n = squared_distances.rows();
    Eigen::MatrixXd rate(n, n);
    parallel_for(Eigen::Index{0}, n, [&](Eigen::Index j) {
        const auto scaled = square * squared_distances.col(j).tail(n - j).array();
        rate.col(j).tail(n - j) = -scaled * (-0.5 * scaled).exp();
    });
    return rate;
}

/// The slope of each output, by the envelope theorem: the partial derivative at the minimiser,
/// 1/2 tr((R + eta I)^-1 dR) - 1/2 w' dR w / sigma_f^2 with w = (R + eta I)^-1 y.
/// @param z Q'y
Eigen::VectorXd profile_slope(const KernelSpectrum& spectrum,
                              const Eigen::Ref<const Eigen::MatrixXd>& squared_distances,
                              Eigen::MatrixXd z, const LikelihoodProfile& profile) {
    const Eigen::MatrixXd& basis = spectrum.eigenvectors;
    const Eigen::MatrixXd rate = correlation_rate(squared_distances, spectrum.inverse_length_scale);
    const Eigen::VectorXd rate_diagonal = quadratic_forms(rate, basis);  // of Q' dR Q
    Eigen::VectorXd slope(z.cols());
    parallel_for(Eigen::Index{0}, z.cols(), [&](Eigen::Index j) {
        const Eigen::ArrayXd shifted = spectrum.eigenvalues.array() + profile.noise_ratio(j);
        slope(j) = 0.5 * (rate_diagonal.array() / shifted).sum();
        z.col(j).array() /= shifted;
    });
    slope.array() -=
        0.5 * quadratic_forms(rate, product(basis, z)).array() / profile.signal_variance.array();
    return slope;
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
    const Eigen::MatrixXd rate = correlation_rate(squared_distances, spectrum.inverse_length_scale);
    const Eigen::ArrayXd squared_weights_in_basis = (z.array() / variances).square();
    result.gradient << 0.5 * signal *
                           ((quadratic_forms(rate, basis).array() / variances).sum() -
                            quadratic_forms(rate, weights)(0)),
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
                                     const NoiseRatioBounds& bounds, Slope slope) {
    const Eigen::Index m = outputs.cols();
    const Eigenvalues d(spectrum);
    Eigen::MatrixXd z = transposed_product(spectrum.eigenvectors, outputs);
    const Eigen::MatrixXd squared_z = energies(spectrum, outputs, z);
    const NoiseScan scan = scan_noise_ratios(d, squared_z, bounds);

    LikelihoodProfile profile{.value = Eigen::VectorXd(m),
                              .slope = {},
                              .noise_ratio = Eigen::VectorXd(m),
                              .signal_variance = Eigen::VectorXd(m)};
    parallel_for(Eigen::Index{0}, m, [&](Eigen::Index j) {
        const double ratio = best_noise_ratio(d, squared_z.col(j), scan, scan.values.col(j));
        profile.noise_ratio(j) = ratio;
        profile.signal_variance(j) = best_signal_variance(d, squared_z.col(j), ratio);
        profile.value(j) =
            profile_value(d.n, profile.signal_variance(j), log_determinant(d, ratio));
    });
    if (slope == Slope::wanted && spectrum.is_whole()) {
        profile.slope = profile_slope(spectrum, squared_distances, std::move(z), profile);
    }
    return profile;
}

}  // namespace taut::gp
