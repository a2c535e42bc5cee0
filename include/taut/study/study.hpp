// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "taut/identification/identification.hpp"
#include "taut/identification/model.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/study/error_statistics.hpp"

namespace taut {

struct StudySettings {
    int samples = 1000;   ///< drawn in all
    int validation = 50;  ///< of these the last, kept from training
    LengthLaw law;
    std::uint64_t seed = 1;

    /// @throws std::invalid_argument for less than 3 samples, no validation sample, or fewer than
    /// two
    ///   samples left to train on
    void check() const;
};

/// Form errors (eq. enomident) of the model before and after identification [m].
struct FormErrors {
    FormErrorSummary nominal;
    FormErrorSummary identified;
};

/// How well one method identified the validation samples.
struct MethodResult {
    std::string name;  ///< "gp_as_in_paper"
    LengthErrors errors;
    double coverage = 0.0;  ///< part of the true length deviations inside their 95 % interval
};

/// The paper's numerical experiment (section 5) on one net.
struct Study {
    CableNet net;
    StudySettings settings;
    DataSet data;
    LengthModel model;
    std::vector<int> validation;  ///< indices of the validation samples, those that converged
    LengthEstimates estimates;    ///< of the validation samples (m_I x n_v) [m]
    MethodResult gp_as_in_paper;
    /// Per free node (n_I) for the first validation sample, the paper's k = 1 [m].
    Eigen::VectorXd nominal_form_error;
    Eigen::VectorXd identified_form_error;
    Points identified_form;       ///< all nodes' (3 x n), of that sample [m]
    FormErrors form_errors;       ///< of that sample
    FormErrors mean_form_errors;  ///< each number's mean over the validation samples
    int forms_not_converged = 0;  ///< validation samples left out of these means
    struct Seconds {
        double sampling = 0.0;
        double training = 0.0;
        double identification = 0.0;
        double total = 0.0;
    } seconds;
};

/// Told of the work as it goes on: the stage ("sampling", "training", "identification"), steps done
/// and steps in all. In training the steps are decompositions, of which fewer than announced may be
/// needed.
using StudyProgress = std::function<void(std::string_view stage, int done, int total)>;

/// Thrown where a stop was requested before the study was done.
class Interrupted : public std::runtime_error {
public:
    Interrupted() : std::runtime_error("interrupted") {}
};

/// Runs the experiment: draws the data set (Algorithm 2), trains on all samples but the validation
/// samples (Algorithm 1), identifies these (eq. ident) and compares with the truth.
/// @throws std::invalid_argument as StudySettings::check() and Sampler
/// @throws std::runtime_error where too few samples converge
/// @throws Interrupted
[[nodiscard]] Study run_study(const CableNet& net, const StudySettings& settings,
                              const StudyProgress& progress = {}, const std::stop_token& stop = {});

}  // namespace taut
