// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/chain_target.hpp"

#include <algorithm>
#include <utility>

#include "estimation/imagined_observations.hpp"
#include "estimation/potential_pull.hpp"

namespace taut {

ChainTarget::ChainTarget(const StaticsModel& model, const Observations& observations,
                         std::span<const int> taut, const Iterate& centre,
                         const Linearisation& metric, double tolerance)
    : m_model(model),
      m_observations(observations),
      m_taut(taut),
      m_centre(centre),
      m_metric(metric),
      m_tolerance(tolerance),
      m_form(model),
      m_variances(model.prior_variances(observations)),
      m_rest(satisfied(model, observations, centre)),
      m_rest_step(metric.step(centre, m_rest)),
      m_means(common_means()) {}

ChainTarget::CommonMeans ChainTarget::common_means() const {
    const Eigen::MatrixXd root = m_observations.mean_root.size() > 0
                                     ? m_observations.mean_root
                                     : Eigen::MatrixXd(m_variances.size(), 0);
    CommonMeans result;
    result.pulls = m_variances.cwiseInverse().asDiagonal() * root;
    Eigen::MatrixXd precision =
        Eigen::MatrixXd::Identity(root.cols(), root.cols()) + root.transpose() * result.pulls;
    result.precision.compute(precision);
    for (Eigen::Index k = 0; k < root.cols(); ++k) {
        Observations moved = m_rest;
        moved.mean += root.col(k);
        result.responses.push_back(step_to(moved));
        precision.col(k) -= result.pulls.transpose() * result.responses.back().deviations;
    }
    result.shared.compute(0.5 * (precision + precision.transpose()));
    return result;
}

/// Adds multiples of the responses to what the prior means have in common.
Iterate ChainTarget::with_responses(Iterate change, const Eigen::VectorXd& parts) const {
    for (Eigen::Index k = 0; k < parts.size(); ++k) {
        change = change.moved(m_means.responses[static_cast<size_t>(k)], parts(k));
    }
    return change;
}

Iterate ChainTarget::drawn_velocity(RandomNumbers& random) const {
    const Eigen::VectorXd blur = m_variances - m_observations.variance;
    Iterate result = step_to(perturbed(m_model.net(), m_rest, blur, random));
    const Eigen::VectorXd parts = standard_normals(m_means.pulls.cols(), random);
    return with_responses(std::move(result), m_means.shared.matrixU().solve(parts));
}

double ChainTarget::kinetic_energy(const Iterate& velocity) const {
    const Eigen::VectorXd shared = m_means.pulls.transpose() * velocity.deviations;
    return 0.5 * (m_metric.squared_norm(m_observations, velocity) -
                  shared.dot(m_means.precision.solve(shared)));
}

std::optional<ChainState> ChainTarget::state_at(Iterate iterate) {
    for (int e = 0; e < m_model.net().edge_count(); ++e) {
        if (!(m_model.unstressed_length(e, iterate) > 0.0)) {
            return std::nullopt;
        }
    }
    if (!m_form.converge(iterate, m_tolerance)) {
        return std::nullopt;
    }
    const Eigen::VectorXd shared =
        m_means.pulls.transpose() * (iterate.deviations - m_observations.mean);
    const double potential = m_model.objective(m_observations, iterate) -
                             0.5 * shared.dot(m_means.precision.solve(shared));
    // From A^-1 to the inverse with what the prior means have in common.
    Iterate force = step_to(pulled(iterate));
    const Eigen::VectorXd parts =
        m_means.shared.solve(m_means.pulls.transpose() * force.deviations);
    force = with_responses(std::move(force), parts);
    return ChainState{std::move(iterate), potential, std::move(force)};
}

bool ChainTarget::is_as_seen(const Iterate& iterate) const {
    return std::ranges::all_of(m_taut, [&](int e) {
        const auto [s, t] = m_model.net().edges()[e];
        return (iterate.form.col(s) - iterate.form.col(t)).norm() >
               m_model.unstressed_length(e, iterate);
    });
}

/// (hamiltonian): observations to which one step from the centre is A^-1 (- dU/dx).
Observations ChainTarget::pulled(const Iterate& at) const {
    const CableNet& net = m_model.net();
    const Observations& y = m_observations;
    const PotentialPull pull = potential_pull(m_model, y, m_form, at);
    Observations result = m_rest;
    const Eigen::VectorXd off = y.mean - at.deviations;
    result.mean += off + m_variances.cwiseProduct(pull.lengths(net.interior_edges()));
    if (y.mean_root.cols() > 0) {
        result.mean -=
            y.mean_root * m_means.precision.solve(m_means.pulls.transpose() * off).eval();
    }
    result.load_mean += y.load_mean - at.loads;
    const Eigen::VectorXd load_factors = m_model.load_factors(at);
    for (const int node : net.free_nodes()) {
        if (y.load_variance.col(node).maxCoeff() > 0.0) {
            result.load_mean.col(node) +=
                load_factors(node) * y.load_covariance(node) * pull.multipliers.col(node);
        }
    }
    if (m_model.are_supports_uncertain()) {
        for (const int node : net.supports()) {
            result.support_mean.col(node) +=
                pull.places.col(node).cwiseQuotient(y.support_weights.col(node));
        }
    }
    result.common_mean += pull.common;
    return result;
}

}  // namespace taut
