// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/form_sensitivity.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "statics/edge_state.hpp"
#include "statics/stiffness_factor.hpp"

namespace taut {

struct FormSensitivity::Factor {
    LocalNet net;
    Stiffness stiffness;
    Eigen::Matrix3Xd force_rates;  ///< 3 x m, -dh_s/dl_0 = dh_t/dl_0 of each edge (s, t) [N/m]
    std::vector<int> row_of;       ///< local free node -> its place in r_I

    explicit Factor(const CableNet& cable_net)
        : net(number_for_elimination(cable_net)), stiffness(net) {}

    /// Adds -dh/dl_0 of an edge times its change of length to a right-hand side.
    void add_force(int edge, double change, Eigen::Ref<Eigen::VectorXd> rhs) const {
        const auto [s, t] = net.edges[edge];
        const Eigen::Vector3d force = change * force_rates.col(edge);
        if (s < net.free_count) {
            rhs.segment<3>(Eigen::Index{3} * s) += force;
        }
        if (t < net.free_count) {
            rhs.segment<3>(Eigen::Index{3} * t) -= force;
        }
    }

    /// The inner product of -dh/dl_0 of an edge with a vector of local coordinates.
    [[nodiscard]] double along_force(int edge, const Eigen::VectorXd& local) const {
        const auto [s, t] = net.edges[edge];
        double sum = 0.0;
        if (s < net.free_count) {
            sum += local.segment<3>(Eigen::Index{3} * s).dot(force_rates.col(edge));
        }
        if (t < net.free_count) {
            sum -= local.segment<3>(Eigen::Index{3} * t).dot(force_rates.col(edge));
        }
        return sum;
    }

    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const {
        Eigen::VectorXd local = rhs;
        stiffness.factor.solve(local);
        Eigen::VectorXd result(local.size());
        for (int i = 0; i < net.free_count; ++i) {
            result.segment<3>(Eigen::Index{3} * row_of[i]) = local.segment<3>(Eigen::Index{3} * i);
        }
        return result;
    }
};

FormSensitivity::FormSensitivity(const CableNet& net,
                                 const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                 const Eigen::Ref<const Points>& form)
    : m_factor(std::make_unique<Factor>(net)) {
    Factor& f = *m_factor;
    for (int i = 0; i < f.net.free_count; ++i) {
        f.row_of.push_back(net.free_index(f.net.node_of[i]));
    }
    const auto states = edge_states(net, unstressed_lengths, form);
    f.force_rates.setZero(3, net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        const EdgeState& state = states[e];
        if (state.taut()) {
            f.force_rates.col(e) =
                state.axial * state.length / unstressed_lengths(e) * state.direction;
        }
    }
    f.stiffness.matrix.assemble(f.net, states);
    f.stiffness.factorize();
    if (f.stiffness.has_loose_nodes()) {
        double shift = smallest_relative_stiffness;
        do {
            f.stiffness.matrix.add_shift(shift);
            shift *= 10.0;
        } while (!f.stiffness.factorize() && shift < 1.0);
    }
}
FormSensitivity::~FormSensitivity() = default;
FormSensitivity::FormSensitivity(FormSensitivity&&) noexcept = default;
FormSensitivity& FormSensitivity::operator=(FormSensitivity&&) noexcept = default;

Eigen::VectorXd FormSensitivity::apply(
    const Eigen::Ref<const Eigen::VectorXd>& length_changes) const {
    if (length_changes.size() != m_factor->force_rates.cols()) {
        throw std::invalid_argument(fmt::format("length_changes has {} entries, expected {}",
                                                length_changes.size(),
                                                m_factor->force_rates.cols()));
    }
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(m_factor->net.loads.size());
    for (int e = 0; e < length_changes.size(); ++e) {
        if (length_changes(e) != 0.0) {
            m_factor->add_force(e, length_changes(e), rhs);
        }
    }
    return m_factor->solve(rhs);
}

Eigen::VectorXd FormSensitivity::apply_transposed(
    const Eigen::Ref<const Eigen::VectorXd>& gradient) const {
    const Factor& f = *m_factor;
    if (gradient.size() != f.net.loads.size()) {
        throw std::invalid_argument(fmt::format("gradient has {} entries, expected {}",
                                                gradient.size(), f.net.loads.size()));
    }
    Eigen::VectorXd local(gradient.size());
    for (int i = 0; i < f.net.free_count; ++i) {
        local.segment<3>(Eigen::Index{3} * i) = gradient.segment<3>(Eigen::Index{3} * f.row_of[i]);
    }
    f.stiffness.factor.solve(local);  // H is symmetric
    Eigen::VectorXd result(f.force_rates.cols());
    for (int e = 0; e < result.size(); ++e) {
        result(e) = f.along_force(e, local);
    }
    return result;
}

Eigen::MatrixXd FormSensitivity::columns(std::span<const int> edges) const {
    check_edges(m_factor->force_rates.cols(), edges);
    Eigen::MatrixXd result(m_factor->net.loads.size(), static_cast<Eigen::Index>(edges.size()));
    for (size_t k = 0; k < edges.size(); ++k) {
        Eigen::VectorXd rhs = Eigen::VectorXd::Zero(result.rows());
        m_factor->add_force(edges[k], 1.0, rhs);
        result.col(static_cast<Eigen::Index>(k)) = m_factor->solve(rhs);
    }
    return result;
}

std::vector<EdgeSensitivity> most_sensitive_edges(const FormSensitivity& sensitivity,
                                                  std::span<const int> edges, int count) {
    constexpr size_t block = 64;  // columns in memory at a time
    std::vector<EdgeSensitivity> result;
    result.reserve(edges.size());
    for (size_t begin = 0; begin < edges.size(); begin += block) {
        const auto some = edges.subspan(begin, std::min(block, edges.size() - begin));
        const Eigen::VectorXd moves = sensitivity.columns(some).colwise().norm();
        for (size_t k = 0; k < some.size(); ++k) {
            result.push_back({.edge = some[k], .move = moves(static_cast<Eigen::Index>(k))});
        }
    }
    std::ranges::stable_sort(result, std::ranges::greater{}, &EdgeSensitivity::move);
    result.resize(std::min(result.size(), static_cast<size_t>(std::max(0, count))));
    return result;
}

}  // namespace taut
