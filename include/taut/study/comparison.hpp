// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/export/adjustment.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/progress.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"
#include "taut/study/method_result.hpp"

namespace taut {

/// The surveys on which the methods of identification are compared. Not all combinations, but
/// points along axes:
/// - noise, at common_training() samples;
/// - training samples, without noise (if that is one of the noises) and at common_noise();
/// - hidden nodes, at both common values;
/// - with uncertain parameters, at both common values: nets that differ in them, once with the
///   uncertainty given to the methods and once without;
/// - with several epochs, at the common noise: one, two, ... surveys of each net at once.
struct TAUT_ADJUSTMENT_EXPORT ComparisonSettings {
    std::vector<double> noises{0.0, 0.1e-3, 0.2e-3, 0.5e-3, 1e-3, 2e-3};  ///< [m]
    /// Numbers of samples to train on, including those that do not converge; 2 to 20,000 each.
    std::vector<int> training_samples{100, 200, 500, 950, 2000};
    std::vector<double> hidden_parts{0.1};  ///< of the free nodes; 0 is always included
    int surveys = 50;        ///< of other samples than for training; the same for all methods
    LengthPrior prior = {};  ///< of the length deviations, given to all methods
    std::uint64_t seed = 1;  ///< of samples and surveys
    std::vector<UncertainParameter> uncertain = {};  ///< besides the lengths; empty: no such axis
    int epochs = 1;                                  ///< surveys of one net; 1: no such axis

    /// 950, as in the paper, where that is among the training samples; else the most.
    [[nodiscard]] int common_training() const;
    /// 0.5 mm where that is among the noises; else the largest [m].
    [[nodiscard]] double common_noise() const;

    /// Checks the settings.
    /// @throws std::invalid_argument for an empty list, noise that is negative or not finite, fewer
    ///   than two training samples, a hidden part outside [0, 1), no survey, fewer than one epoch
    ///   or more than ten, epochs without noise; and as LengthPrior::check()
    void check() const;
};

/// Whether the surveyed nets differ from the design in more than lengths, and whether that
/// uncertainty was given to a method.
enum class ModelErrors { none, not_given, given };

/// "none", "not given", "given".
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::string_view to_string(ModelErrors errors);

/// Noise and hidden nodes of a survey.
struct SurveyKind {
    double noise_std = 0.0;    ///< normal noise on every coordinate of a free node [m]
    double hidden_part = 0.0;  ///< of the free nodes, not surveyed; in [0, 1)

    friend bool operator==(const SurveyKind&, const SurveyKind&) = default;  ///< by all members
};

/// One method on surveys of one kind.
struct ComparisonRow {
    SurveyKind kind;                               ///< noise and hidden nodes
    ModelErrors model_errors = ModelErrors::none;  ///< differences in more than lengths
    std::optional<int> training_samples;           ///< empty: the method learns from none
    int epochs = 1;                                ///< surveys of each net that are used at once
    bool is_turned = false;                        ///< whether edges were turned between them
    MethodResult result;                           ///< over all these surveys
    /// Cramer-Rao bound of these surveys, for any method. Empty without noise and hidden nodes,
    /// where all lengths but those of slack edges follow exactly; and where it could not be
    /// computed.
    std::optional<CramerRaoBound> cramer_rao;
};

/// The methods of identification compared on one net.
struct Comparison {
    CableNet net;                 ///< as designed
    ComparisonSettings settings;  ///< its lists ascending, without repetitions
    /// The axes of noise, of training samples and of hidden nodes, each kind of survey once, with
    /// "gp_as_in_paper", "gp", "balance" and "map" each.
    std::vector<ComparisonRow> rows;
    /// Of nets that differ in more than lengths: of each method without that given, then of "gp"
    /// and "map" with it.
    std::vector<ComparisonRow> model_error_rows;
    /// Of several epochs: "map" of one survey, then of two without and with turns in between, and
    /// so on.
    std::vector<ComparisonRow> epoch_rows;
    int samples = 0;             ///< drawn
    int not_converged = 0;       ///< of these, left out
    int surveys = 0;             ///< of each kind
    int surveys_with_slack = 0;  ///< in whose true form an edge is slack
    /// Wall time [s].
    struct Seconds {
        double sampling = 0.0;        ///< of all samples
        double training = 0.0;        ///< of all models
        double identification = 0.0;  ///< by all methods
        double total = 0.0;           ///< of the whole comparison
    } seconds;                        ///< of the parts
};

/// Compares all methods on simulated surveys of one net.
/// @throws std::invalid_argument as ComparisonSettings::check(), check_uncertain_parameters()
///   and Sampler
/// @throws std::runtime_error where too few samples converge
/// @param progress gets the stages "sampling", "training" and "identification"
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT Comparison compare_methods(const CableNet& net,
                                                                const ComparisonSettings& settings,
                                                                const Progress& progress = {});

}  // namespace taut
