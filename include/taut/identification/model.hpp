// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "taut/export/core.hpp"
#include "taut/gp/fit.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/progress.hpp"
#include "taut/sampling/data_set.hpp"

namespace taut {

/// What a length deviation is expected to be at a form, before anything is learnt.
enum class MeanFunction {
    zero,      ///< as in the paper
    geometry,  ///< that of an edge at its nominal strain: nominal l_0 (l / nominal l - 1)
};

/// How the kernel measures the distance of two forms.
enum class KernelMetric {
    isotropic,  ///< all coordinates alike, as in the paper (eq. SEkernel_iso)
    direction,  ///< a scale for x, y and z each (eq. SEkernel)
    node,       ///< a scale for each node (eq. SEkernel)
};

/// "zero", "geometry".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(MeanFunction mean);
/// "isotropic", "direction", "node".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(KernelMetric metric);

/// How a model is to be trained.
struct TrainingSettings {
    /// Taken off length deviations before they are learnt.
    MeanFunction mean = MeanFunction::geometry;
    KernelMetric metric = KernelMetric::isotropic;  ///< of the kernel of all processes
    gp::FitSettings fit = {};  ///< where hyperparameters are looked for, and for how long
    /// Zero mean, isotropic kernel, and every survey taken for exact and whole: see LengthModel.
    bool as_in_paper = false;

    /// The paper's: for exact surveys of all nodes.
    [[nodiscard]] static TrainingSettings paper() {
        return {.mean = MeanFunction::zero, .metric = KernelMetric::isotropic, .as_in_paper = true};
    }
};

/// What is known of the form before a survey: a normal distribution of the free coordinates'
/// deviations from the nominal form, x = mean + directions' t, with independent t.
struct FormPrior {
    Eigen::VectorXd mean;        ///< 3 n_I [m]
    Eigen::VectorXd variances;   ///< of t, ascending (3 n_I) [m2]
    Eigen::MatrixXd directions;  ///< a row each, orthonormal (3 n_I x 3 n_I)
    Eigen::MatrixXd inputs;      ///< of the processes, along the directions (3 n_I x n) [m]
};

/// The learnt map from form deviation to length deviations: one Gaussian process an interior edge.
struct LengthModel {
    std::string net_fingerprint;  ///< CableNet::fingerprint() of the net it was trained for
    LengthPrior prior;            ///< of the data it was trained on
    std::uint64_t seed = 1;       ///< of the data it was trained on
    std::vector<UncertainParameter> uncertain;      ///< that its data were drawn with
    MeanFunction mean = MeanFunction::zero;         ///< that was taken off the length deviations
    KernelMetric metric = KernelMetric::isotropic;  ///< of the kernel of all processes
    /// Trained for the paper's algorithm: eq. ident as it stands, which takes every survey for
    /// exact and whole.
    bool as_in_paper = false;
    Eigen::VectorXd nominal_form;  ///< r_I that form deviations refer to (3 n_I) [m]
    /// Of each free coordinate in the kernel's metric (3 n_I), relative to their geometric mean.
    Eigen::VectorXd input_scales;
    Eigen::MatrixXd length_deviations;  ///< that it was trained on (m_I x n) [m]
    /// Inputs: form deviations times input_scales; outputs: length deviations less their mean
    /// function [m].
    gp::FittedProcesses processes;
    /// For surveys with noise or missing nodes; empty if as_in_paper, and for nets of more than
    /// 1,000 free nodes, for which each such survey makes it.
    FormPrior form_prior;

    /// n, the samples that it was trained on.
    [[nodiscard]] int training_count() const { return static_cast<int>(processes.inputs.cols()); }

    /// The form deviations it was trained on (3 n_I x n) [m].
    [[nodiscard]] Eigen::MatrixXd form_deviations() const {
        return input_scales.cwiseInverse().asDiagonal() * processes.inputs;
    }
};

/// Algorithm 1 of the paper on samples of a data set of the net.
/// @param samples which to train on; their forces must balance: DataSet::converged_in()
/// @param progress gets the stages of gp::estimate_input_scales() and gp::fit()
/// @throws std::invalid_argument for a data set of another net, fewer than two samples, or an index
///   out of range, and for `as_in_paper` with another mean function or kernel than the paper's
/// @throws NetError where a run of the net slides
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_CORE_EXPORT LengthModel train_model(const CableNet& net, const DataSet& data,
                                                       const std::vector<int>& samples,
                                                       const TrainingSettings& settings = {},
                                                       const Progress& progress = {});

}  // namespace taut
