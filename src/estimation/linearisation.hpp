// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "estimation/bordered_factor.hpp"
#include "estimation/statics_model.hpp"

namespace taut {

/// Posterior covariances at a linearisation, docs/theory.md (covariance).
struct Covariance {
    std::vector<Eigen::Matrix3d> places;  ///< one a node; 0 of known supports [m2]
    Eigen::VectorXd lengths;              ///< variances, m_I [m2]
    Eigen::VectorXd extensions;           ///< variances of l - l_0, m_I [m2]
    Eigen::VectorXd tensions;             ///< variances, m [N2]
    Eigen::VectorXd measured;             ///< of force measurements without their own errors [N2]
    std::vector<Eigen::Matrix3d> loads;   ///< of the load deviations, one a node [N2]
    Eigen::MatrixXd common;               ///< of the common parameters, in their stds
    /// The inverse over the multipliers of each free node, in the order of elimination and in the
    /// units of the linearisation.
    std::vector<Eigen::Matrix3d> multipliers;
};

/// The normal equations of observations under a model of statics linearised at an iterate,
/// docs/theory.md (normal), with their factor: with h the out-of-balance forces there, H = dh/dr,
/// B = dh/dl_0, S and P the inverse variances of what is observed and of the prior,
///
///   S dr + H lambda  = S (r_measured - r)
///   P dd + B' lambda = P (d_mean - d)
///   H dr + B dd      = -h
///
/// plus the terms of (uncertain-parameters) and (force-measurement). The inverse of their matrix
/// holds the posterior covariances of r and d, (covariance). H lambda and B' lambda at the lambda
/// of the linearisation stand on the right side: what remains there is as small as the change that
/// is solved for, and so are the rounding errors.
///
/// Moved, not copied: a factor is large.
class Linearisation {
public:
    [[nodiscard]] const StaticsModel& model() const { return *m_model; }
    /// The same matrix with the forces of another model, of other slack edges or tension laws.
    [[nodiscard]] Linearisation under(StaticsModel model) &&;

    /// At the iterate of the linearisation: the change to the conditional mean. At another iterate:
    /// the same with the misfit and forces there, but with the matrix as linearised.
    [[nodiscard]] Iterate step(const Iterate& iterate, const Observations& observations) const;
    /// Largest change of a place or length by a step, and of a common parameter as that number of
    /// standard deviations of the lengths; infinite where the step is not finite [m].
    [[nodiscard]] double size_of(const Iterate& step) const;
    /// Squared length of a change, in standard deviations of observations and priors; forces to
    /// first order, as linearised.
    [[nodiscard]] double squared_norm(const Observations& observations,
                                      const Iterate& change) const;

    [[nodiscard]] Covariance covariance() const;
    /// Half the logarithm of the determinant of the posterior precision of all that is uncertain
    /// (lengths and their mean_root, supports, loads, common parameters), the form eliminated, up
    /// to a constant: docs/theory.md, (determinant).
    [[nodiscard]] double half_log_determinant(const Observations& observations) const;
    /// Covariances of all edges' tensions with a weighted sum of them (m) [N2 of the weights].
    [[nodiscard]] Eigen::VectorXd covariances_with(const Eigen::VectorXd& weights) const {
        return covariances_with(weights, m_tension_rates);
    }
    /// Variance of a weighted sum of force measurements without their own errors (weights: m).
    [[nodiscard]] double measured_variance(const Eigen::VectorXd& weights) const {
        return covariances_with(weights, m_measured_rates).dot(weights);
    }
    /// Covariance of the x of LengthEvidence: all length deviations, then the first common
    /// parameters; takes one solution for each.
    [[nodiscard]] Eigen::MatrixXd evidence_covariance(int common_count) const;
    /// Covariance of all unknowns: the places of all nodes (3 n, 0 where known), then the length
    /// deviations (m_I), then the common parameters in their standard deviations; takes one
    /// solution for each.
    [[nodiscard]] Eigen::MatrixXd joint_covariance() const;
    /// Covariance of the lengths of these edges, 0 for known ones; takes one solution for each (k x
    /// k) [m2].
    [[nodiscard]] Eigen::MatrixXd length_covariance(const std::vector<int>& edges) const;
    /// Covariances of weighted sums of length deviations, one a column of weights (m_I x k), with
    /// all unknowns; takes one solution for each.
    struct LengthResponse {
        Eigen::MatrixXd lengths;  ///< with all length deviations (m_I x k) [m2 of the weights]
        Eigen::MatrixXd common;   ///< with the common parameters, in their standard deviations
    };
    [[nodiscard]] LengthResponse response_to_lengths(const Eigen::MatrixXd& weights) const;

    /// Score and information of a number that the fit took as known, docs/theory.md (boundary).
    struct Score {
        Eigen::VectorXd gradient;     ///< derivative of the objective, with opposite sign [1/m]
        Eigen::MatrixXd information;  ///< inverse of its covariance as a free parameter [1/m2]
    };
    /// Of an adjustable edge's length.
    /// @param covariance of this linearisation
    [[nodiscard]] Score score_of_edge(int edge, const Covariance& covariance,
                                      const Iterate& iterate,
                                      const Observations& observations) const;
    /// The same of the three coordinates of a support, where supports are known.
    /// @param edges at it
    [[nodiscard]] Score score_of_support(int node, const std::vector<int>& edges,
                                         const Covariance& covariance, const Iterate& iterate,
                                         const Observations& observations) const;
    /// The same of numbers that change the survey: its frame and scale.
    /// @param rates derivative of all coordinates by each number (3 x n)
    [[nodiscard]] Score score_of_survey(const std::vector<Points>& rates, const Iterate& iterate,
                                        const Observations& observations) const;
    /// The same of a multiple of loads.
    /// @param loads at all nodes (3 x n) [N]
    [[nodiscard]] Score score_of_loads(const Points& loads) const;

private:
    [[nodiscard]] Eigen::VectorXd covariances_with(const Eigen::VectorXd& weights,
                                                   const Eigen::MatrixXd& rates) const;
    friend std::optional<Linearisation> linearise(const StaticsModel& model, const Iterate& iterate,
                                                  const Observations& observations,
                                                  std::optional<Linearisation> before);
    Linearisation() = default;
    [[nodiscard]] bool factorize(const Iterate& iterate, const Observations& observations);
    void set_weights(const Observations& observations);
    void add_edge(int edge, const Iterate& iterate, const Observations& observations);
    void set_border(const Observations& observations);
    void add_elastic_supports(const Iterate& iterate);
    void add_motions_to_border(const Observations& observations);
    void set_evidence(const Observations& observations);
    void set_reactions(const Eigen::Matrix3Xd& multipliers);

    [[nodiscard]] BorderedFactor::Vector empty_vector() const;
    [[nodiscard]] BorderedFactor::Vector right_side(const Iterate& iterate,
                                                    const Observations& observations) const;
    void add_force_measurements(const Iterate& iterate, const Observations& observations,
                                BorderedFactor::Vector& right_side) const;
    void add_evidence(const Iterate& iterate, const Observations& observations,
                      BorderedFactor::Vector& right_side) const;
    void add_place_rates(int edge, double factor, Eigen::Matrix3Xd& places) const;
    double add_to_column(int edge, const EdgeRates& e, const EdgeVariation& variation, double bias,
                         double force_weight, BorderedFactor::Inner& column) const;
    struct ScoreColumn;
    [[nodiscard]] ScoreColumn empty_score_column() const;
    void add_edge_to_score(ScoreColumn& column, int edge, const EdgeVariation& variation,
                           const Iterate& iterate, const Observations& observations) const;
    [[nodiscard]] Score score_of(const std::vector<ScoreColumn>& columns) const;
    [[nodiscard]] std::optional<Score> score_at_one_node(
        int edge, const std::vector<EdgeVariation>& variations, const Score& of_survey,
        const Eigen::MatrixXd& in_border, const Covariance& covariance, const Iterate& iterate,
        const Observations& observations) const;

    std::shared_ptr<const StaticsModel> m_model;
    std::unique_ptr<BorderedFactor> m_matrix;
    Eigen::Matrix3Xd m_multipliers;      ///< lambda, 3 x free nodes
    BorderedFactor::Vector m_reactions;  ///< H lambda, B' lambda and those of the border
    Eigen::VectorXd m_load_factors;      ///< free nodes
    Eigen::MatrixXd m_tension_rates;     ///< m x common parameters: dT by each [N]
    Eigen::MatrixXd m_measured_rates;    ///< the same of force measurements, (shared-error) [N]
    // Units that make all blocks of order 1: of places and lengths, and of multipliers.
    double m_length_unit = 1.0;
    double m_multiplier_unit = 1.0;
};

/// Linearises a model at an iterate and factorises; nothing where there is no factor.
/// @param before of the same net, no longer needed: its memory and its analysis of the matrix are
///   used again, so that no two factors exist at once
[[nodiscard]] std::optional<Linearisation> linearise(
    const StaticsModel& model, const Iterate& iterate, const Observations& observations,
    std::optional<Linearisation> before = std::nullopt);

/// A fit and the linearisation at it.
struct LinearisedFit {
    Iterate iterate;
    Linearisation linearisation;
    Covariance covariance;

    [[nodiscard]] const StaticsModel& model() const { return linearisation.model(); }
    /// One step of the fit to other observations: the result, to first order, with the covariances
    /// before the step. Nothing where there is none.
    [[nodiscard]] std::optional<LinearisedFit> stepped(const Observations& observations) &&;
};

/// As linearise(), with the covariances.
/// @throws NumericalError where there is no factor
[[nodiscard]] LinearisedFit linearised_fit(const StaticsModel& model, Iterate iterate,
                                           const Observations& observations);

/// The blur by the standard deviations of a fit, but no less than half of the model's.
[[nodiscard]] LawBlur blur_found(const StaticsModel& model, const Covariance& covariance,
                                 const Iterate& fitted, const Observations& observations);

}  // namespace taut
