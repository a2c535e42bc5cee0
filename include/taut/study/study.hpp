// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "taut/export/adjustment.hpp"
#include "taut/identification/length_estimates.hpp"
#include "taut/identification/model.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/progress.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/study/error_statistics.hpp"
#include "taut/study/method_result.hpp"

namespace taut {

/// Size and prior of the experiment.
struct TAUT_ADJUSTMENT_EXPORT StudySettings {
    int samples = 1000;      ///< drawn in all
    int validation = 50;     ///< the last of these, not used for training
    LengthPrior prior;       ///< of the length deviations
    std::uint64_t seed = 1;  ///< of the samples

    /// Checks the settings.
    /// @throws std::invalid_argument for less than 3 samples, no validation sample, or fewer than
    ///   two samples left to train on, and as LengthPrior::check()
    void check() const;
};

/// Form errors (eq. enomident) of the model before and after identification [m].
struct FormErrors {
    FormErrorSummary nominal;     ///< of the equilibrium of the nominal lengths
    FormErrorSummary identified;  ///< of the form predicted with the identified lengths
};

/// The paper's numerical experiment (section 5) on one net.
struct Study {
    CableNet net;                 ///< as designed
    StudySettings settings;       ///< as given
    DataSet data;                 ///< all samples, those for validation last
    LengthModel model;            ///< as in the paper
    std::vector<int> validation;  ///< indices of the validation samples, those that converged
    /// Every method of identification on exact surveys of the validation samples: "gp_as_in_paper",
    /// "gp", "balance", "map". All members below are of the first, the paper's.
    std::vector<MethodResult> methods;
    LengthEstimates estimates;  ///< of the validation samples (m_I x n_v) [m]
    /// Per free node (n_I) for the first validation sample, the paper's k = 1 [m].
    Eigen::VectorXd nominal_form_error;
    Eigen::VectorXd identified_form_error;  ///< of `identified_form`, likewise (n_I) [m]
    Points identified_form;                 ///< all nodes' (3 x n), of that sample [m]
    FormErrors form_errors;                 ///< of that sample
    FormErrors mean_form_errors;            ///< each number's mean over the validation samples
    /// The first of the methods, the paper's; there must be one: run_study() gives four.
    [[nodiscard]] const MethodResult& as_in_paper() const { return methods.front(); }
    /// Wall time [s].
    struct Seconds {
        double sampling = 0.0;        ///< of all samples
        double training = 0.0;        ///< of the models of "gp_as_in_paper" and "gp"
        double identification = 0.0;  ///< by all methods
        double total = 0.0;           ///< of the whole experiment
    } seconds;                        ///< of the parts
};

/// Runs the experiment: draws the data set (Algorithm 2), trains on all samples but the validation
/// samples (Algorithm 1), identifies these (eq. ident) and compares with the truth; then does the
/// same by the other methods.
/// @throws std::invalid_argument as StudySettings::check() and Sampler
/// @throws std::runtime_error where the nominal net finds no equilibrium, too few samples converge,
///   or the method of the paper fails on one
/// @param progress gets the stages "sampling", "training" and "identification"
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT Study run_study(const CableNet& net,
                                                     const StudySettings& settings,
                                                     const Progress& progress = {});

}  // namespace taut
