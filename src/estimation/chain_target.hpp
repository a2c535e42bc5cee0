// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "estimation/form_of_model.hpp"
#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "numerics/random_numbers.hpp"

namespace taut {

/// Where a chain is, with what a trajectory needs there.
struct ChainState {
    Iterate iterate;  ///< in equilibrium
    double potential = 0.0;
    Iterate force;  ///< A^-1 (- dU/dx)
};

/// The posterior that chains sample, with the metric A of their trajectories: the normal equations
/// at a centre. docs/theory.md, (hamiltonian).
class ChainTarget {
public:
    /// Keeps references to all but numbers.
    /// @param taut edges that were seen to be taut
    /// @param metric linearised at the centre
    /// @param tolerance of the form [m]
    ChainTarget(const StaticsModel& model, const Observations& observations,
                std::span<const int> taut, const Iterate& centre, const Linearisation& metric,
                double tolerance);

    [[nodiscard]] const StaticsModel& model() const { return m_model; }
    [[nodiscard]] const Observations& observations() const { return m_observations; }
    /// Of the length deviations, blur included (m_I) [m2].
    [[nodiscard]] const Eigen::VectorXd& variances() const { return m_variances; }
    [[nodiscard]] const Iterate& centre() const { return m_centre; }

    /// Nothing where there is no equilibrium near the iterate.
    [[nodiscard]] std::optional<ChainState> state_at(Iterate iterate);
    /// Whether all edges are taut that were seen to be.
    [[nodiscard]] bool is_as_seen(const Iterate& iterate) const;
    /// From the normal distribution of covariance A^-1.
    [[nodiscard]] Iterate drawn_velocity(RandomNumbers& random) const;
    [[nodiscard]] double kinetic_energy(const Iterate& velocity) const;

private:
    /// What the prior means have in common, (length-trend), in the metric.
    struct CommonMeans {
        Eigen::MatrixXd pulls;                  ///< P G (m_I x r) [1/m]
        Eigen::LLT<Eigen::MatrixXd> precision;  ///< I + G' P G
        std::vector<Iterate> responses;         ///< A^-1 P G, one a column
        Eigen::LLT<Eigen::MatrixXd> shared;     ///< I + G' P G - G' P A^-1 P G
    };
    [[nodiscard]] CommonMeans common_means() const;
    [[nodiscard]] Iterate with_responses(Iterate change, const Eigen::VectorXd& parts) const;
    [[nodiscard]] Iterate step_to(const Observations& observations) const {
        return m_metric.step(m_centre, observations).moved(m_rest_step, -1.0);
    }
    [[nodiscard]] Observations pulled(const Iterate& at) const;

    const StaticsModel& m_model;
    const Observations& m_observations;
    std::span<const int> m_taut;
    const Iterate& m_centre;
    const Linearisation& m_metric;
    double m_tolerance;
    FormOfModel m_form;
    Eigen::VectorXd m_variances;
    Observations m_rest;  ///< to which nothing moves from the centre
    Iterate m_rest_step;
    CommonMeans m_means;
};

}  // namespace taut
