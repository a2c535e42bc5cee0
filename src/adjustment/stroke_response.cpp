// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/stroke_response.hpp"

#include "numerics/memory_budget.hpp"
#include "statics/edge_state.hpp"
#include "taut/statics/form_sensitivity.hpp"

namespace taut {
namespace {

/// The force with which the net pulls at a support [N].
Eigen::Vector3d reaction_at(const CableNet& net, const std::vector<EdgeState>& states,
                            int support) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto [s, t] = net.edges()[e];
        if (s == support || t == support) {
            sum += (s == support ? 1.0 : -1.0) * states[e].tension * states[e].direction;
        }
    }
    return sum;
}

}  // namespace

StrokeResponse::StrokeResponse(const CableNet& net, std::vector<int> edges,
                               std::vector<int> reactions)
    : m_net(&net), m_edges(std::move(edges)), m_reactions(std::move(reactions)), m_solver(net) {}

StrokedNet StrokeResponse::at(const Eigen::Ref<const Eigen::VectorXd>& lengths,
                              const Eigen::Ref<const Eigen::VectorXd>& strokes,
                              const Points& start) {
    StrokedNet result{.unstressed_lengths = lengths};
    result.unstressed_lengths(m_edges) += strokes;
    result.equilibrium = m_solver.solve(result.unstressed_lengths, start);
    result.unstressed_lengths = result.equilibrium.unstressed_lengths;
    result.forces = forces_of(result.unstressed_lengths, result.equilibrium.form);
    return result;
}

Eigen::VectorXd StrokeResponse::forces_of(const Eigen::VectorXd& lengths,
                                          const Points& form) const {
    const auto states = edge_states(*m_net, lengths, form);
    const int m = m_net->edge_count();
    Eigen::VectorXd result(m + static_cast<Eigen::Index>(m_reactions.size()));
    for (int e = 0; e < m; ++e) {
        result(e) = states[e].pull(lengths(e));
    }
    for (size_t r = 0; r < m_reactions.size(); ++r) {
        result(m + static_cast<Eigen::Index>(r)) =
            reaction_at(*m_net, states, m_reactions[r]).norm();
    }
    return result;
}

StrokeRates StrokeResponse::rates(const StrokedNet& stroked) const {
    const CableNet& net = *m_net;
    const Points& form = stroked.equilibrium.form;
    const auto states = edge_states(net, stroked.unstressed_lengths, form);
    StrokeRates rates;
    // Of places, lengths and forces, by each stroke.
    const MemoryCharge charge = charge_numbers(
        static_cast<double>(m_edges.size()) *
        static_cast<double>(form.size() + 2 * net.edge_count() + std::ssize(m_reactions)));
    const FormSensitivity sensitivity(net, stroked.unstressed_lengths, form);
    rates.form = sensitivity.columns(m_edges);
    const Eigen::MatrixXd lengths = sensitivity.slid_columns(m_edges);

    const auto k = static_cast<Eigen::Index>(m_edges.size());
    const int m = net.edge_count();
    rates.forces.resize(m + static_cast<Eigen::Index>(m_reactions.size()), k);
    /// d(r_s - r_t) of an edge (3 x k).
    const auto vector_rates = [&](int edge) {
        Eigen::Matrix3Xd result = Eigen::Matrix3Xd::Zero(3, k);
        const auto [s, t] = net.edges()[edge];
        if (const int i = net.free_index(s); i >= 0) {
            result += rates.form.middleRows(Eigen::Index{3} * i, 3);
        }
        if (const int i = net.free_index(t); i >= 0) {
            result -= rates.form.middleRows(Eigen::Index{3} * i, 3);
        }
        return result;
    };
    for (int e = 0; e < m; ++e) {
        const EdgeState& state = states[e];
        rates.forces.row(e) = state.axial * state.direction.transpose() * vector_rates(e);
        rates.forces.row(e) -=
            state.axial * state.length / stroked.unstressed_lengths(e) * lengths.row(e);
    }
    for (size_t r = 0; r < m_reactions.size(); ++r) {
        const Eigen::Vector3d reaction = reaction_at(net, states, m_reactions[r]);
        const double size = reaction.norm();
        auto row = rates.forces.row(m + static_cast<Eigen::Index>(r));
        row.setZero();
        if (!(size > 0.0)) {
            continue;
        }
        const Eigen::Vector3d along = reaction / size;
        for (int e = 0; e < m; ++e) {
            const auto [s, t] = net.edges()[e];
            if (!states[e].carries() || (s != m_reactions[r] && t != m_reactions[r])) {
                continue;
            }
            const double sign = s == m_reactions[r] ? 1.0 : -1.0;
            const Eigen::Vector3d& u = states[e].direction;
            // d(T u) = u dT + T/l (I - u u') d(r_s - r_t)
            row += sign * along.dot(u) * rates.forces.row(e);
            row += sign * states[e].force_density() * (along - along.dot(u) * u).transpose() *
                   vector_rates(e);
        }
    }
    return rates;
}

}  // namespace taut
