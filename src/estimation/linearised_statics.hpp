// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/bordered_factor.hpp"
#include "estimation/common_parameters.hpp"
#include "estimation/observations.hpp"
#include "statics/local_net.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {

/// What a linearisation cannot follow, represented as additional length deviations.
///
/// Tension laws are averaged over strains with these standard deviations, which smooths corners and
/// flat parts; what the tangents then miss counts as such a deviation, docs/theory.md
/// (blurred-law). So does the stiffness of each edge: an edge stiffer by some part is as tense as
/// one shorter by that part of its stretch, (own-stiffness).
struct LawBlur {
    Eigen::VectorXd strain_stds;  ///< m; empty: tension laws as they are [-]
    Eigen::VectorXd missed;       ///< m_I, variance of that deviation; empty with strain_stds [m2]
    Eigen::VectorXd stiffness;    ///< m_I, the same of the stiffness; empty where it is known [m2]

    /// Whether no standard deviation differs by more than a tenth.
    [[nodiscard]] bool agrees_with(const LawBlur& other) const;
    [[nodiscard]] bool empty() const { return strain_stds.size() + stiffness.size() == 0; }
    /// Variance of the additional deviations, all together (m_I) [m2].
    [[nodiscard]] Eigen::VectorXd length_variances(Eigen::Index count) const;
};

/// The blur before a fit, by the nominal stretch.
/// @param extension_std standard deviation of all extensions [m]
/// @param uncertain of the net
[[nodiscard]] LawBlur blur_by(const CableNet& net, double extension_std,
                              const std::vector<UncertainParameter>& uncertain = {});

/// The normal equations of observations under linearised statics, docs/theory.md (statics) and
/// (normal): with h the out-of-balance forces at an iterate, H = dh/dr, B = dh/dl_0, S and P the
/// inverse variances of what is observed and of the prior,
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
/// Edges carry pressure as well as tension here, so that everything is smooth; edges of the slack
/// set carry nothing. Whether pressure means slack is decided later, edge by edge.
class LinearisedStatics {
public:
    /// @param uncertain of the net, checked; observations must have places and loads accordingly
    /// @param frame_is_unknown of the survey: places are then in its frame, in which the supports
    ///   move together
    /// @param lengths coupled where observations have evidence
    explicit LinearisedStatics(const CableNet& net,
                               const std::vector<UncertainParameter>& uncertain = {},
                               bool frame_is_unknown = false, const BoundaryReleases& released = {},
                               Lengths lengths = Lengths::independent);
    LinearisedStatics(const LinearisedStatics&) = delete;  // the factor refers to the local net
    LinearisedStatics& operator=(const LinearisedStatics&) = delete;

    /// The slack set: edges (m) that carry nothing.
    void set_slack(std::vector<bool> slack) { m_slack = std::move(slack); }
    [[nodiscard]] const std::vector<bool>& slack() const { return m_slack; }

    /// Releases these adjustable edges and supports, and no others. Iterates must then have as many
    /// common parameters.
    void set_released(const BoundaryReleases& released);

    /// The blur of the tension laws; none at first.
    void set_blur(LawBlur blur) { m_blur = std::move(blur); }
    [[nodiscard]] const LawBlur& blur() const { return m_blur; }
    /// After invert() at the same iterate: the blur by the standard deviations of the fit, but no
    /// less than half of the current one.
    [[nodiscard]] LawBlur blur_found(const Iterate& iterate) const;

    /// Score and information of a number that the fit took as known, docs/theory.md (boundary).
    struct Score {
        Eigen::VectorXd gradient;     ///< derivative of the objective, with opposite sign [1/m]
        Eigen::MatrixXd information;  ///< inverse of its covariance as a free parameter [1/m2]
    };
    /// After invert(), at the same iterate: of an adjustable edge's length.
    [[nodiscard]] Score score_of_edge(int edge, const Iterate& iterate,
                                      const Observations& observations) const;
    /// The same of the three coordinates of a support, where supports are known.
    /// @param edges at it
    [[nodiscard]] Score score_of_support(int node, const std::vector<int>& edges,
                                         const Iterate& iterate,
                                         const Observations& observations) const;
    /// The same of numbers that change the survey: its frame and scale.
    /// @param rates derivative of all coordinates by each number (3 x n)
    [[nodiscard]] Score score_of_survey(const std::vector<Points>& rates, const Iterate& iterate,
                                        const Observations& observations) const;

    /// From now on tension laws are replaced by their tangents at an iterate. Draws around it then
    /// have the mean tension of the fit. docs/theory.md, (drawn-law)
    void fix_tension_laws(const Iterate& iterate);

    /// With a width w [m] above 0 no edge carries pressure: with e = l - l_0 its tension is
    ///
    ///   T = EA/l_0 (e + sqrt(e^2 + 4 w^2)) / 2,
    ///
    /// a smooth law within EA/l_0 w of a cable's. docs/theory.md, (rounded-law)
    void round_corners(double width) { m_corner_width = width; }

    /// Linearises at an iterate and factorises.
    /// @return false where there is no factor
    [[nodiscard]] bool linearise(const Iterate& iterate, const Observations& observations);

    /// After linearise(), at the same iterate: the change to the conditional mean. At another
    /// iterate: the same with the misfit and forces there, but with the matrix as linearised.
    [[nodiscard]] Iterate step(const Iterate& iterate, const Observations& observations) const;

    /// Largest change of a place or length by a step, and of a common parameter as that number of
    /// standard deviations of the lengths; infinite where the step is not finite [m].
    [[nodiscard]] double size_of(const Iterate& step) const;

    /// Squared length of a change, in standard deviations of observations and priors; forces to
    /// first order, as linearised.
    [[nodiscard]] double squared_norm(const Observations& observations,
                                      const Iterate& change) const;
    /// The objective of (map) at an iterate, whether in equilibrium or not.
    [[nodiscard]] double objective(const Observations& observations, const Iterate& iterate) const;

    /// Tensions of all edges at an iterate, as the linearisation has them: pressure is negative (m)
    /// [N].
    [[nodiscard]] Eigen::VectorXd tensions(const Iterate& iterate) const;

    [[nodiscard]] const CommonParameters& common() const { return m_common; }

    /// Deviations of the supports from their places in the net, in the frame of the survey; 0 at
    /// free nodes (3 x n) [m].
    [[nodiscard]] Points support_deviations(const Iterate& iterate) const;

    /// Computes the covariances below, after linearise().
    void invert() { m_covariance = m_matrix.covariance(); }
    [[nodiscard]] Eigen::VectorXd length_variances() const;     ///< m_I [m2]
    [[nodiscard]] Eigen::VectorXd extension_variances() const;  ///< of l - l_0, m_I [m2]
    /// Of a free node, or of a support where supports or frame are uncertain [m2].
    [[nodiscard]] Eigen::Matrix3d form_covariance(int node) const;
    [[nodiscard]] Eigen::VectorXd tension_variances() const;  ///< m [N2]
    /// Of a free node's load deviation [N2].
    [[nodiscard]] Eigen::Matrix3d load_covariance(int node) const;
    /// Of the common parameters, in their standard deviations.
    [[nodiscard]] const Eigen::MatrixXd& common_covariance() const { return m_covariance.border; }
    /// Covariances of all edges' tensions with a weighted sum of them (m) [N2 of the weights].
    [[nodiscard]] Eigen::VectorXd covariances_with(const Eigen::VectorXd& weights) const;
    /// Covariance of the x of LengthEvidence: all length deviations, then the first common
    /// parameters; takes one solution for each.
    [[nodiscard]] Eigen::MatrixXd evidence_covariance(int common_count) const;
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
    /// Covariances of all edges' tensions with their mean (m) [N2].
    [[nodiscard]] Eigen::VectorXd covariances_with_mean_tension() const {
        return covariances_with(
            Eigen::VectorXd::Constant(m_net.edge_count(), 1.0 / m_net.edge_count()));
    }

private:
    /// Tension and rates of an edge at an iterate.
    struct EdgeRates {
        Eigen::Vector3d direction;  ///< u, from its second node to its first
        double tension;             ///< T [N]
        double across;              ///< T / l [N/m]
        double axial;               ///< dT/dl [N/m]
        double by_length;           ///< dT/dd [N/m]

        /// h of its first node, -h of its second [N].
        [[nodiscard]] Eigen::Vector3d force() const { return tension * direction; }
        /// k = d force / d r of its first node [N/m].
        [[nodiscard]] Eigen::Matrix3d stiffness() const {
            return (axial - across) * direction * direction.transpose() +
                   across * Eigen::Matrix3d::Identity();
        }
        /// b = d force / d d [N/m].
        [[nodiscard]] Eigen::Vector3d length_rate() const { return by_length * direction; }
    };
    [[nodiscard]] EdgeRates rates(int edge, const Iterate& iterate) const;
    /// The tension law, blurred or fixed, at a strain; without factors of uncertain parameters.
    [[nodiscard]] TensionLaw::Tangent law_tangent(int edge, double strain) const;
    [[nodiscard]] double unstressed_length(int edge, const Iterate& iterate) const;
    [[nodiscard]] Eigen::VectorXd prior_variances(const Observations& observations) const {
        return (observations.variance + m_blur.length_variances(observations.variance.size())) /
               (1.0 + observations.length_damping);
    }
    [[nodiscard]] double length_variance(int edge, const Iterate& iterate) const;
    [[nodiscard]] double stiffness_as_length(int edge, const Iterate& iterate) const;
    /// Change at an edge by one unit of a number of the border.
    struct EdgeVariation {
        Eigen::Vector3d motion = Eigen::Vector3d::Zero();  ///< of its first end from its second [m]
        double stiffness = 0.0;                            ///< relative
        double length = 0.0;                               ///< unstressed, cold [m]
    };
    [[nodiscard]] EdgeVariation common_variation(int edge, int k, const Iterate& iterate) const;
    [[nodiscard]] static double tension_rate_of(const EdgeRates& e, const EdgeVariation& variation);
    [[nodiscard]] Eigen::Vector3d force_of(const EdgeRates& e,
                                           const EdgeVariation& variation) const;
    void add_place_rates(int edge, double factor, Eigen::Matrix3Xd& places) const;
    double add_to_column(int edge, const EdgeRates& e, const EdgeVariation& variation,
                         double force_weight, BorderedFactor::Inner& column) const;
    [[nodiscard]] BorderedFactor::Vector empty_vector() const;
    struct ScoreColumn;
    void add_edge_to_score(ScoreColumn& column, int edge, const EdgeVariation& variation,
                           const Iterate& iterate, const Observations& observations) const;
    [[nodiscard]] ScoreColumn empty_score_column() const;
    [[nodiscard]] Score score_of(const std::vector<ScoreColumn>& columns) const;
    [[nodiscard]] Score score_at(int local, const Eigen::Matrix3Xd& forces) const;
    void set_weights(const Observations& observations);
    void add_edge(int edge, const Iterate& iterate, const Observations& observations);
    void set_border(const Observations& observations);
    void set_evidence(const Observations& observations);
    void add_evidence(const Iterate& iterate, const Observations& observations,
                      BorderedFactor::Vector& right_side) const;
    void add_motions_to_border(const Observations& observations);
    [[nodiscard]] Points support_misfit(const Iterate& iterate,
                                        const Observations& observations) const;
    [[nodiscard]] double quadratic_terms(const Observations& observations, const Iterate& change,
                                         double of_supports) const;
    [[nodiscard]] bool are_supports_uncertain() const {
        return std::ssize(m_nodes) > m_local.free_count;
    }
    [[nodiscard]] BorderedFactor::Vector right_side(const Iterate& iterate,
                                                    const Observations& observations) const;
    void add_force_measurements(const Iterate& iterate, const Observations& observations,
                                BorderedFactor::Vector& right_side) const;
    void set_reactions(const Eigen::Matrix3Xd& multipliers);

    const CableNet& m_net;
    std::vector<UncertainParameter> m_uncertain;
    CommonParameters m_common;
    Eigen::VectorXd m_own_stiffness_stds;  ///< m, relative
    LocalNet m_local;
    std::vector<int> m_local_of;     ///< node of the net -> local index
    std::vector<int> m_interior_of;  ///< edge -> place among the interior edges, or -1
    std::vector<int> m_free_nodes;   ///< in the order of elimination
    std::vector<int> m_nodes;        ///< the same, then the supports where these are uncertain
    std::vector<bool> m_slack;
    LawBlur m_blur;
    struct FixedLaw {
        double strain = 0.0;
        TensionLaw::Tangent tangent{};
    };
    std::vector<FixedLaw> m_fixed_laws;  ///< one an edge; empty: tension laws as they are
    double m_corner_width = 0.0;
    BorderedFactor m_matrix;
    BorderedFactor::Covariance m_covariance;
    // As linearised, with H, B and V.
    Eigen::Matrix3Xd m_multipliers;      ///< lambda, 3 x free nodes
    Eigen::Matrix3Xd m_place_reactions;  ///< H lambda, 3 x nodes
    Eigen::VectorXd m_length_reactions;  ///< B' lambda, one an edge
    Eigen::VectorXd m_common_reactions;  ///< G' lambda, one a common parameter
    Eigen::MatrixXd m_tension_rates;     ///< m x common parameters: dT by each [N]

    // Units that make all blocks of order 1: of places and lengths, and of multipliers.
    double m_length_unit = 1.0;
    double m_widest_prior = 1.0;  ///< variance of a length [m2]
    double m_multiplier_unit = 1.0;
};

}  // namespace taut
