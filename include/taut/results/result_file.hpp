// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The parts of a saved study that its figures need. Lengths are in the order of the interior
/// edges, form errors in that of the free nodes.
struct StudyResult {
    CableNet net;         ///< as designed
    Points nominal_form;  ///< equilibrium of the nominal lengths (3 x n) [m]
    int validation = 0;   ///< samples
    /// Of the first validation sample: length deviations (m_I) and form errors (n_I) [m].
    Eigen::VectorXd true_deviation;
    Eigen::VectorXd identified_deviation;   ///< estimate of that (m_I) [m]
    Eigen::VectorXd nominal_form_error;     ///< of `nominal_form` (n_I) [m]
    Eigen::VectorXd identified_form_error;  ///< of the form of the identified lengths (n_I) [m]
    /// Of the errors over all validation samples (m_I) [m].
    Eigen::VectorXd error_mean;
    Eigen::VectorXd error_std;  ///< standard deviation, divisor `validation` (m_I) [m]
    Eigen::MatrixXd errors;     ///< all of them (m_I x samples), or m_I x 0 where not saved [m]
};

/// The parts of a saved identification that figures and plans need.
struct IdentificationResult {
    CableNet net;                              ///< as designed
    std::vector<IdentifiedEdge> edges;         ///< in the order of the file
    Points form;                               ///< predicted (3 x n) [m]
    std::vector<ParameterEstimate> uncertain;  ///< estimates besides lengths
    /// Adjustable edges and supports that are not as designed.
    std::vector<BoundaryOutlier> boundary_outliers;
    std::vector<EdgeTurned> turned;  ///< since the net was as designed, until the last survey
    /// Of the form, whose supports are moved by it; where the survey's frame was unknown.
    std::optional<FrameOffset> frame_offset;
    Trust trust;                    ///< empty in results of older versions
    int draws = 0;                  ///< number of posterior samples
    std::string draws_fingerprint;  ///< fingerprint_of() them; empty in older versions
    /// Residual of one surveyed node.
    struct Residual {
        int node = 0;                                 ///< index of a free node
        Eigen::Vector3d surveyed_less_predicted;      ///< [m]
        std::optional<Eigen::Vector3d> standardised;  ///< in standard deviations
        bool is_in_use = true;  ///< false for a target that was left out for a gross error
    };
    std::vector<Residual> residuals;  ///< in the order of the file
};

/// The parts of a saved comparison of methods.
struct ComparisonResult {
    /// One method on surveys of one kind.
    struct Row {
        std::string method;  ///< "gp_as_in_paper", "gp", "balance" or "map"
        double noise = 0.0;  ///< standard deviation of a surveyed coordinate [m]
        /// Empty for a method that learns from no samples.
        std::optional<double> training_samples;
        std::optional<double> mse;             ///< [m2]; empty where the method gave none
        std::optional<double> cramer_rao_mse;  ///< [m2]
        double hidden_fraction = 0.0;          ///< of the free nodes, not surveyed
    };
    std::vector<Row> rows;  ///< as Comparison::rows, in the order of the file
};

/// The parts of a saved plan that its figures need.
struct PlanResult {
    CableNet net;           ///< as designed
    Points built_form;      ///< before turning, of the estimate (3 x n) [m]
    Points planned_form;    ///< after turning, of the estimate (3 x n) [m]
    Points target_form;     ///< where each node should stand (3 x n) [m]
    Points target_normals;  ///< 0 at nodes without normal
    /// Of one edge.
    struct Tension {
        int edge = 0;                 ///< index in the net
        double as_built = 0.0;        ///< before turning, of the estimate [N]
        double planned = 0.0;         ///< after turning, of the estimate [N]
        std::optional<double> lower;  ///< 95 % interval; empty without samples
        std::optional<double> upper;  ///< its upper end; empty likewise
        /// As given, without the plan's margin; empty: none, of a strut.
        std::optional<double> limit_lower = 0.0;
        std::optional<double> limit_upper;  ///< empty: no limit
    };
    std::vector<Tension> tensions;  ///< of each edge [N]
};

/// The parts of saved simulated jobs that their figures need.
struct ControlResult {
    /// The nets after a round.
    struct Round {
        double normal_rmse = 0.0;  ///< along the target's normal, over nodes and trials [m]
        std::vector<double> normal_rmse_of_trials;  ///< [m]
        int broken_trials = 0;                      ///< in which an edge breaks a limit
        double turned = 0.0;                        ///< sum of |stroke|, mean over the trials [m]
        int failed = 0;                             ///< trials in which nothing could be planned
    };
    /// One strategy.
    struct Strategy {
        std::string name;           ///< to_string() of the ControlStrategy
        std::vector<Round> rounds;  ///< from round 0, as built
    };
    int trials = 0;                    ///< of each strategy
    std::vector<Strategy> strategies;  ///< in the order of the file
};

/// The JSON Schema of all saved results, as `share/taut/result.schema.json` holds it.
[[nodiscard]] TAUT_IO_EXPORT const std::string& result_schema();

/// A saved result of `taut reproduce`, `identify`, `compare`, `plan` or `control`.
struct ResultFile {
    std::variant<StudyResult, IdentificationResult, ComparisonResult, PlanResult, ControlResult>
        content;       ///< by its "format"
    std::string json;  ///< the whole document, without white space
};

/// Reads a result in one of the formats "taut-study", "taut-identification", "taut-comparison",
/// "taut-plan" and "taut-control", version 1 or 2. It must follow result_schema() and the rules
/// that a schema cannot express: sizes and indices of the net, one entry per interior edge, one
/// state per trial and round.
/// @param file_name for messages
/// @throws InputError at a line and column for what is no JSON, and at a JSON pointer for what is
///   missing, of another type or size, or breaks a rule
[[nodiscard]] TAUT_IO_EXPORT ResultFile parse_result(std::string_view text,
                                                     const std::string& file_name);

/// Reads a file as parse_result().
/// @throws InputError as parse_result() and read_file()
[[nodiscard]] TAUT_IO_EXPORT ResultFile read_result(const std::filesystem::path& path);

}  // namespace taut
