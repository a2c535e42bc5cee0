// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <iterator>
#include <memory>
#include <vector>

#include "estimation/common_parameters.hpp"
#include "estimation/law_blur.hpp"
#include "estimation/observations.hpp"
#include "estimation/saddle_point_layout.hpp"
#include "statics/local_net.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {

/// Order and numbers of the unknowns in the matrix of a Linearisation, the same for all models of a
/// net.
struct StaticsNumbering {
    StaticsNumbering(const CableNet& net, Supports of_supports);

    Supports supports;
    LocalNet local;
    std::vector<int> local_of;     ///< node of the net -> local index
    std::vector<int> interior_of;  ///< edge -> place among the interior edges, or -1
    std::vector<int> free_nodes;   ///< in the order of elimination
    std::vector<int> nodes;        ///< the same, then the supports where these are uncertain

    /// Whether the place of a node is an unknown.
    [[nodiscard]] bool has_place(int node) const { return local_of[node] < std::ssize(nodes); }
};

/// Change at an edge by one unit of a number.
struct EdgeVariation {
    Eigen::Vector3d motion = Eigen::Vector3d::Zero();  ///< of its first end from its second [m]
    double stiffness = 0.0;                            ///< relative
    double length = 0.0;                               ///< unstressed, cold [m]
    double sag = 0.0;                                  ///< of its sag weight, relative
};

/// Tension and rates of an edge at an iterate, docs/theory.md (edge rates).
struct EdgeRates {
    Eigen::Vector3d direction;  ///< u, from its second node to its first
    double tension;             ///< T [N]
    double across;              ///< T / l [N/m]
    double axial;               ///< dT/dl [N/m]
    double by_length;           ///< dT/dd [N/m]
    double by_sag;              ///< dT/d log S, of a cable that sags [N]
    double by_stiffness;        ///< dT/d log EA: T, less of a cable that sags [N]

    /// h of its first node, -h of its second [N].
    [[nodiscard]] Eigen::Vector3d force() const { return tension * direction; }
    /// k = d force / d r of its first node [N/m].
    [[nodiscard]] Eigen::Matrix3d stiffness() const {
        return (axial - across) * direction * direction.transpose() +
               across * Eigen::Matrix3d::Identity();
    }
    /// b = d force / d d [N/m].
    [[nodiscard]] Eigen::Vector3d length_rate() const { return by_length * direction; }
    /// Change of the tension [N], and of the force at its first node [N].
    [[nodiscard]] double tension_by(const EdgeVariation& variation) const {
        return by_stiffness * variation.stiffness + axial * direction.dot(variation.motion) +
               by_length * variation.length + by_sag * variation.sag;
    }
    [[nodiscard]] Eigen::Vector3d force_by(const EdgeVariation& variation) const {
        const double along = direction.dot(variation.motion);
        return tension_by(variation) * direction + across * (variation.motion - along * direction);
    }
};

/// Statics and priors of a net as a fit assumes them, docs/theory.md (statics): what is uncertain
/// besides lengths, which edges are slack, and how tension laws are smoothed.
///
/// Edges carry pressure as well as tension here, so that everything is smooth; edges of the slack
/// set carry nothing. Whether pressure means slack is decided later, edge by edge.
class StaticsModel {
public:
    /// Keeps a reference to the net.
    /// @param uncertain of the net, checked; observations must have places and loads accordingly
    /// @param frame_is_unknown of the survey: places are then in its frame, in which the supports
    ///   move together
    /// @param test_loads as of CommonParameters
    explicit StaticsModel(const CableNet& net,
                          const std::vector<UncertainParameter>& uncertain = {},
                          bool frame_is_unknown = false, const Points& test_loads = Points(3, 0));

    CommonParameters common;  ///< iterates must have as many
    std::vector<bool> slack;  ///< the slack set: edges (m) that carry nothing; none at first
    LawBlur blur;             ///< of the tension laws; none at first
    /// With a width w above 0 no cable carries pressure: with e = l - l_0 its tension is
    ///
    ///   T = EA/l_0 (e + sqrt(e^2 + 4 w^2)) / 2,
    ///
    /// a smooth law within EA/l_0 w of a cable's. docs/theory.md, (rounded-law) [m]
    double corner_width = 0.0;

    /// From now on tension laws are replaced by their tangents at an iterate. Draws around it then
    /// have the mean tension of the fit. docs/theory.md, (drawn-law)
    void fix_tension_laws(const Iterate& iterate);
    /// Tension laws are themselves again.
    void release_tension_laws() { m_fixed_laws.clear(); }

    [[nodiscard]] const CableNet& net() const { return *m_net; }
    [[nodiscard]] const StaticsNumbering& numbering() const { return *m_numbering; }
    /// Of each edge, relative (m).
    [[nodiscard]] const Eigen::VectorXd& own_stiffness_stds() const { return m_own_stiffness_stds; }
    /// (own-stiffness): whether a length deviation that stands for more stiffness is negative, -1,
    /// or positive as in a compressed strut, 1.
    [[nodiscard]] double own_stiffness_sign(int edge, double tension) const {
        return m_net->is_strut(edge) && tension < 0.0 ? 1.0 : -1.0;
    }
    [[nodiscard]] bool are_supports_uncertain() const {
        return m_numbering->supports == Supports::uncertain;
    }

    /// With the thermal strain [m].
    [[nodiscard]] double unstressed_length(int edge, const Iterate& iterate) const;
    [[nodiscard]] EdgeRates rates(int edge, const Iterate& iterate) const;
    /// By one standard deviation of a common parameter.
    [[nodiscard]] EdgeVariation common_variation(int edge, int k, const Iterate& iterate) const;
    /// Of all edges: pressure is negative (m) [N].
    [[nodiscard]] Eigen::VectorXd tensions(const Iterate& iterate) const;
    /// What a load of Iterate::loads counts at each node: at an elastic support it stands for an
    /// error of its place, and grows with its stiffness. (elastic-supports) (n).
    [[nodiscard]] Eigen::VectorXd load_factors(const Iterate& iterate) const;
    /// Forces on the springs of elastic supports as designed, which move with the frame,
    /// K (r - r_0 - m); 0 at other nodes (3 x n) [N].
    [[nodiscard]] Points designed_elastic_forces(const Iterate& iterate) const;
    /// Out-of-balance forces (3 x n) [N].
    [[nodiscard]] Points imbalance(const Iterate& iterate) const;

    /// Deviations of the supports from their places in the net, in the frame of the survey; 0 at
    /// free nodes (3 x n) [m].
    [[nodiscard]] Points support_deviations(const Iterate& iterate) const;
    /// Of the length deviations, blur included (m_I) [m2].
    [[nodiscard]] Eigen::VectorXd prior_variances(const Observations& observations) const {
        return (observations.variance + blur.length_variances(observations.variance.size())) /
               (1.0 + observations.length_damping);
    }
    /// Squared length of a change, in standard deviations of observations and priors: the terms
    /// without forces and evidence.
    /// @param of_supports that of the supports' prior
    [[nodiscard]] double quadratic_terms(const Observations& observations, const Iterate& change,
                                         double of_supports) const;
    /// The objective of (map) at an iterate, whether in equilibrium or not.
    [[nodiscard]] double objective(const Observations& observations, const Iterate& iterate) const;

private:
    [[nodiscard]] TensionLaw::Tangent law_tangent(int edge, double strain) const;

    const CableNet* m_net;
    Eigen::VectorXd m_own_stiffness_stds;
    std::shared_ptr<const StaticsNumbering> m_numbering;
    struct FixedLaw {
        double strain = 0.0;
        TensionLaw::Tangent tangent{};
    };
    std::vector<FixedLaw> m_fixed_laws;  ///< one an edge; empty: tension laws as they are
};

}  // namespace taut
