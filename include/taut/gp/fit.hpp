// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/gp/kernel.hpp"
#include "taut/gp/likelihood.hpp"
#include "taut/gp/spectrum.hpp"
#include "taut/progress.hpp"

namespace taut::gp {

/// Whether an output could be fitted.
enum class FitStatus {
    fitted,
    constant_output,    ///< the same number throughout: nothing to learn
    non_finite_output,  ///< holds a NaN or an infinity
};

/// "fitted", "constant output", "non-finite output".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(FitStatus status);

/// One trained process.
struct Process {
    FitStatus status = FitStatus::fitted;  ///< of its hyperparameters
    Hyperparameters hyperparameters;       ///< zero where not fitted, as the numbers below
    double negative_log_likelihood = 0.0;  ///< of its output, at these hyperparameters
    double leave_one_out_rmse = 0.0;  ///< of the mean at each training input, trained without it
    int spectrum = -1;                ///< which of FittedProcesses::spectra it uses
    /// By low rank: bound of the error of its mean against the exact one with the same
    /// hyperparameters, root mean square over the training inputs; else 0. Its variance and
    /// leave-one-out error contain it.
    double approximation_error = 0.0;
};

/// Mean and variance at k inputs of m processes.
struct Prediction {
    Eigen::MatrixXd mean;  ///< m(x_*), eq. mx_* (m x k); 0 for a process that is not fitted
    /// sigma(x_*), eq. sigmax_*, of the latent function (m x k); 0 likewise
    Eigen::MatrixXd std_dev;
};

/// m processes with zero mean and an isotropic squared exponential kernel each, trained on the same
/// n inputs. Made by fit(), or read from a file; that its parts belong together is not checked.
struct TAUT_CORE_EXPORT FittedProcesses {
    Eigen::MatrixXd inputs;               ///< d x n
    std::vector<KernelSpectrum> spectra;  ///< one for each lambda in use
    std::vector<Process> processes;       ///< m
    Eigen::MatrixXd weights;  ///< (R + eta I)^-1 y of each output (n x m); 0 if not fitted
    int decompositions = 0;   ///< made in the search for lambda; 0 of a model that was read
    /// Whether the search ended before max_spectra, with no output that expects to gain more.
    bool is_converged = true;

    /// Eqs. mx_* and sigmax_* at new inputs (d x k).
    /// @throws std::invalid_argument for another dimension, or an input that is not finite
    [[nodiscard]] Prediction predict(const Eigen::Ref<const Eigen::MatrixXd>& at) const;

    /// dm/dx_* at one input (m x d): by eq. mx_*, -lambda^2 sum_i w_i k(x_*, x_i) (x_* - x_i)'.
    /// @throws std::invalid_argument as predict()
    [[nodiscard]] Eigen::MatrixXd mean_gradient(const Eigen::Ref<const Eigen::VectorXd>& at) const;

    /// The largest rank of its spectra, where these are not whole; else nothing.
    [[nodiscard]] std::optional<Eigen::Index> rank() const;

    /// Largest part of the trace of a correlation matrix that a spectrum leaves out; 0 where all
    /// are whole. Where it is larger than the part of the noise, the rank is too low for the length
    /// scale: signal is taken for noise.
    [[nodiscard]] double left_out() const;
};

/// Range and effort of the search for hyperparameters.
struct FitSettings {
    /// The feasible set Theta. Lower end: lambda times the median distance of two training inputs;
    /// there the kernel is a polynomial of low degree, and longer length scales change nothing.
    double smallest_scaled_lambda = 3e-3;
    /// Upper end: lambda times the median distance of an input to its nearest neighbour; there the
    /// outputs are almost independent, and shorter length scales change nothing either.
    double largest_scaled_lambda = 3.0;
    std::optional<NoiseRatioBounds> noise_ratio;  ///< default_noise_ratio_bounds(n) if not given
    /// The search for lambda ends when no output is expected to gain more than this, relative to
    /// its negative log likelihood, or after max_spectra decompositions.
    double relative_tolerance = 1e-7;
    /// At most so many decompositions, 1 or more. One output alone takes 7 to 10. A few dozen with
    /// hyperparameters of their own share 12 at a loss of some hundredths in log likelihood. Two
    /// are made at a time, each by one thread; where they cost less than at n = 1000, allow more.
    int max_spectra = 12;
    /// More inputs than this, 2 or more, are fitted by low rank, docs/theory.md (low-rank). Length
    /// scales then come from so many of them, at most 2000.
    int most_decomposed = 3000;
    int rank = 1500;  ///< directions of each low-rank spectrum, 1 or more
};

/// Algorithm 1 of the paper: estimates each output's hyperparameters by maximum marginal likelihood
/// (eq. max_marginal_likelihood) and conditions its process on the data.
/// @param inputs d x n, finite, not all the same; n >= 2
/// @param outputs n x m; an output that cannot be fitted is marked and does not affect the others
/// @param progress gets the stage "training" before each decomposition
/// @throws std::invalid_argument for sizes that differ, for inputs as excluded above, and for
///   settings out of range
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_CORE_EXPORT FittedProcesses fit(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                                                   const Eigen::Ref<const Eigen::MatrixXd>& outputs,
                                                   const FitSettings& settings = {},
                                                   const Progress& progress = {});

}  // namespace taut::gp
