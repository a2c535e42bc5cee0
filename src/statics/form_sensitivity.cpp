// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/form_sensitivity.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

#include "numerics/memory_budget.hpp"
#include "statics/edge_state.hpp"
#include "statics/length_rates.hpp"
#include "statics/sliding.hpp"
#include "statics/stiffness_factor.hpp"

namespace taut {

struct FormSensitivity::Factor {
    LocalNet net;
    Stiffness stiffness;
    std::vector<EdgeState> states;
    Eigen::VectorXd lengths;  ///< l_0 (m) [m]
    std::vector<int> row_of;  ///< local free node -> its place in r_I
    LengthRates rates{.net = net, .states = states, .lengths = lengths};
    std::optional<SlidingRates> sliding;  ///< of a net whose runs slide

    explicit Factor(const CableNet& cable_net)
        : net(number_for_elimination(cable_net)), stiffness(net) {}

    /// How the rates of an edge change with its ends and its length.
    struct RateChange {
        Eigen::Matrix3d stiffness;   ///< of k = dh_s/dr_s [N/m]
        Eigen::Vector3d force_rate;  ///< of b = dh_s/dl_0 [N/m]
    };
    /// k_v and b_v of docs/theory.md (rate changes).
    /// @param a change of r_s - r_t [m]
    /// @param v change of l_0 [m]
    [[nodiscard]] RateChange rate_change(int edge, const Eigen::Vector3d& a, double v) const {
        const EdgeState& state = states[edge];
        if (!state.carries()) {
            return {.stiffness = Eigen::Matrix3d::Zero(), .force_rate = Eigen::Vector3d::Zero()};
        }
        const Eigen::Vector3d& u = state.direction;
        const double along = u.dot(a);
        // Of a cable that sags: how the axial stiffness changes with the strain.
        const double stretch = state.length / lengths(edge);
        const double by_strain = state.curvature * (along - stretch * v) / lengths(edge);
        const double bend = (state.axial - state.force_density()) / state.length;
        const double soften = state.axial / lengths(edge);
        return {.stiffness = bend * (u * a.transpose() + a * u.transpose() -
                                     3.0 * along * u * u.transpose()) +
                             (bend * along - soften * v) * Eigen::Matrix3d::Identity() +
                             by_strain * u * u.transpose(),
                .force_rate = soften * (2.0 * v * stretch * u - a) - by_strain * stretch * u};
    }

    [[nodiscard]] Eigen::VectorXd to_local(const Eigen::Ref<const Eigen::VectorXd>& free) const {
        Eigen::VectorXd local(free.size());
        for (int i = 0; i < net.free_count; ++i) {
            local.segment<3>(Eigen::Index{3} * i) = free.segment<3>(Eigen::Index{3} * row_of[i]);
        }
        return local;
    }
    [[nodiscard]] Eigen::VectorXd from_local(const Eigen::VectorXd& local) const {
        Eigen::VectorXd free(local.size());
        for (int i = 0; i < net.free_count; ++i) {
            free.segment<3>(Eigen::Index{3} * row_of[i]) = local.segment<3>(Eigen::Index{3} * i);
        }
        return free;
    }

    /// H^-1 times a vector.
    [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd local) const {
        stiffness.factor.solve(local);
        return local;
    }

    /// -B' times a vector.
    [[nodiscard]] Eigen::VectorXd along_force_rates(const Eigen::VectorXd& local) const {
        Eigen::VectorXd result(lengths.size());
        for (int e = 0; e < result.size(); ++e) {
            result(e) = rates.force_rate(e).dot(rates.across(e, local));
        }
        return result;
    }

    /// Changes of the lengths after runs have slid, P v of docs/theory.md (sliding).
    [[nodiscard]] Eigen::VectorXd slid(Eigen::VectorXd changes) const {
        if (sliding) {
            sliding->add_slips(changes);
        }
        return changes;
    }
    /// P' w.
    [[nodiscard]] Eigen::VectorXd slid_transposed(const Eigen::VectorXd& gradient) const {
        return sliding ? Eigen::VectorXd(gradient + sliding->by_length.transpose() *
                                                        sliding->multipliers(gradient))
                       : gradient;
    }

    /// r' v.
    [[nodiscard]] Eigen::VectorXd moves(const Eigen::Ref<const Eigen::VectorXd>& of_lengths) const {
        const Eigen::VectorXd changes = slid(of_lengths);
        Eigen::VectorXd rhs = Eigen::VectorXd::Zero(net.loads.size());
        for (int e = 0; e < changes.size(); ++e) {
            if (changes(e) != 0.0) {
                rates.add_force(e, changes(e) * rates.force_rate(e), rhs);
            }
        }
        return solve(std::move(rhs));
    }

    /// Adds a value at the source of an edge, and its opposite at the target, where these are
    /// supports.
    void add_at_supports(int edge, const Eigen::Vector3d& value, Points& nodes) const {
        const auto [s, t] = net.edges[edge];
        if (s >= net.free_count) {
            nodes.col(net.node_of[s]) += value;
        }
        if (t >= net.free_count) {
            nodes.col(net.node_of[t]) -= value;
        }
    }

    void check_lengths(const char* name, const Eigen::Ref<const Eigen::VectorXd>& changes) const {
        check_size(name, changes.size(), lengths.size());
    }
    void check_free(const char* name, const Eigen::Ref<const Eigen::VectorXd>& free) const {
        check_size(name, free.size(), net.loads.size());
    }
    void require_no_sliding() const {
        if (sliding) {
            throw std::invalid_argument(
                "runs of the net slide: its second derivatives are not known");
        }
    }
    static void check_size(const char* name, Eigen::Index size, Eigen::Index expected) {
        if (size != expected) {
            throw std::invalid_argument(
                fmt::format("{} has {} entries, expected {}", name, size, expected));
        }
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
    f.states = edge_states(net, unstressed_lengths, form);
    f.lengths = unstressed_lengths;
    f.stiffness.matrix.assemble(f.net, f.states);
    f.stiffness.factorize();
    if (f.stiffness.has_loose_nodes()) {
        double shift = smallest_relative_stiffness;
        do {
            f.stiffness.matrix.add_shift(shift);
            shift *= 10.0;
        } while (!f.stiffness.factorize() && shift < 1.0);
    }
    if (auto balances = sliding_balances(net.sliding_nodes(), f.rates); !balances.empty()) {
        f.sliding.emplace(f.rates, f.stiffness.factor, std::move(balances));
    }
}
FormSensitivity::~FormSensitivity() = default;
FormSensitivity::FormSensitivity(FormSensitivity&&) noexcept = default;
FormSensitivity& FormSensitivity::operator=(FormSensitivity&&) noexcept = default;

Eigen::VectorXd FormSensitivity::apply(
    const Eigen::Ref<const Eigen::VectorXd>& length_changes) const {
    m_factor->check_lengths("length_changes", length_changes);
    return m_factor->from_local(m_factor->moves(length_changes));
}

Eigen::VectorXd FormSensitivity::apply_transposed(
    const Eigen::Ref<const Eigen::VectorXd>& gradient) const {
    m_factor->check_free("gradient", gradient);
    // H is symmetric
    return m_factor->slid_transposed(
        m_factor->along_force_rates(m_factor->solve(m_factor->to_local(gradient))));
}

NetGradient FormSensitivity::net_gradient(const Eigen::Ref<const Points>& gradient) const {
    const Factor& f = *m_factor;
    const auto nodes = static_cast<Eigen::Index>(f.net.node_of.size());
    Factor::check_size("gradient", gradient.cols(), nodes);
    Eigen::VectorXd multipliers(f.net.loads.size());
    for (int i = 0; i < f.net.free_count; ++i) {
        multipliers.segment<3>(Eigen::Index{3} * i) = gradient.col(f.net.node_of[i]);
    }
    multipliers = f.solve(std::move(multipliers));
    Eigen::VectorXd of_tensions = Eigen::VectorXd::Zero(f.lengths.size());
    Eigen::VectorXd of_balances;
    if (f.sliding) {  // (sliding-gradient)
        of_balances = f.sliding->multipliers(f.along_force_rates(multipliers));
        multipliers += f.sliding->moves * of_balances;
        of_tensions = f.sliding->by_tension.transpose() * of_balances;
    }
    NetGradient result{
        .unstressed_lengths = f.along_force_rates(multipliers) + f.rates.lengths_by(of_tensions),
        .axial_stiffness = Eigen::VectorXd::Zero(f.lengths.size()),
        .loads = Points::Zero(3, nodes),
        .nodes = Points::Zero(3, nodes)};
    for (int i = 0; i < nodes; ++i) {
        if (i < f.net.free_count) {
            result.loads.col(f.net.node_of[i]) = multipliers.segment<3>(Eigen::Index{3} * i);
        } else {
            result.nodes.col(f.net.node_of[i]) = gradient.col(f.net.node_of[i]);
        }
    }
    for (const Spring& spring : f.net.springs) {
        result.nodes.col(f.net.node_of[spring.node]) =
            spring.stiffness * multipliers.segment<3>(Eigen::Index{3} * spring.node);
    }
    for (const SpringPair& pair : f.net.spring_pairs) {
        const Eigen::Index a = Eigen::Index{3} * pair.first;
        const Eigen::Index b = Eigen::Index{3} * pair.second;
        result.nodes.col(f.net.node_of[pair.first]) += pair.stiffness * multipliers.segment<3>(b);
        result.nodes.col(f.net.node_of[pair.second]) +=
            pair.stiffness.transpose() * multipliers.segment<3>(a);
    }
    for (int e = 0; e < f.lengths.size(); ++e) {
        const EdgeState& state = f.states[e];
        if (!state.carries()) {
            continue;
        }
        const Eigen::Vector3d multiplier = f.rates.across(e, multipliers);
        const double along = state.direction.dot(multiplier);
        if (f.net.law(e) == nullptr || state.sags) {
            const double EA = f.net.axial_stiffness(e);
            result.axial_stiffness(e) =
                (of_tensions(e) - along) * state.tension / EA * (state.axial * f.lengths(e) / EA);
        }
        const double across = state.force_density();
        const Eigen::Vector3d pull =  // k x
            ((state.axial - across) * along - of_tensions(e) * state.axial) * state.direction +
            across * multiplier;
        f.add_at_supports(e, -pull, result.nodes);
    }
    for (Eigen::Index k = 0; k < of_balances.size(); ++k) {
        const SlidingBalance& one = f.sliding->balances[static_cast<size_t>(k)];
        const auto& [by_before, by_after] = f.sliding->by_turn[static_cast<size_t>(k)];
        f.add_at_supports(one.before, of_balances(k) * by_before, result.nodes);
        f.add_at_supports(one.after, of_balances(k) * by_after, result.nodes);
    }
    return result;
}

Eigen::VectorXd FormSensitivity::apply_second(
    const Eigen::Ref<const Eigen::VectorXd>& length_changes,
    const Eigen::Ref<const Eigen::VectorXd>& more_changes) const {
    const Factor& f = *m_factor;
    f.check_lengths("length_changes", length_changes);
    f.check_lengths("more_changes", more_changes);
    f.require_no_sliding();
    // docs/theory.md (second derivative)
    const Eigen::VectorXd moves = f.moves(length_changes);
    const Eigen::VectorXd more_moves = f.moves(more_changes);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(moves.size());
    for (int e = 0; e < f.lengths.size(); ++e) {
        const auto [k, b] = f.rate_change(e, f.rates.across(e, moves), length_changes(e));
        f.rates.add_force(e, -(k * f.rates.across(e, more_moves) + b * more_changes(e)), rhs);
    }
    return f.from_local(f.solve(std::move(rhs)));
}

Eigen::VectorXd FormSensitivity::apply_second_transposed(
    const Eigen::Ref<const Eigen::VectorXd>& gradient,
    const Eigen::Ref<const Eigen::VectorXd>& length_changes) const {
    const Factor& f = *m_factor;
    f.check_free("gradient", gradient);
    f.check_lengths("length_changes", length_changes);
    f.require_no_sliding();
    const Eigen::VectorXd moves = f.moves(length_changes);
    const Eigen::VectorXd multipliers = f.solve(f.to_local(gradient));
    Eigen::VectorXd direct(f.lengths.size());
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(moves.size());
    for (int e = 0; e < f.lengths.size(); ++e) {
        const auto [k, b] = f.rate_change(e, f.rates.across(e, moves), length_changes(e));
        const Eigen::Vector3d multiplier = f.rates.across(e, multipliers);
        direct(e) = -b.dot(multiplier);
        f.rates.add_force(e, -(k * multiplier), rhs);
    }
    return direct + f.along_force_rates(f.solve(std::move(rhs)));
}

Eigen::MatrixXd FormSensitivity::columns(std::span<const int> edges) const {
    const Factor& f = *m_factor;
    check_edges(f.lengths.size(), edges);
    const MemoryCharge charge =
        charge_numbers(static_cast<double>(f.net.loads.size()) * static_cast<double>(edges.size()));
    Eigen::MatrixXd result(f.net.loads.size(), static_cast<Eigen::Index>(edges.size()));
    for (size_t k = 0; k < edges.size(); ++k) {
        result.col(static_cast<Eigen::Index>(k)) =
            f.from_local(f.moves(Eigen::VectorXd::Unit(f.lengths.size(), edges[k])));
    }
    return result;
}

Eigen::MatrixXd FormSensitivity::slid_columns(std::span<const int> edges) const {
    const Factor& f = *m_factor;
    check_edges(f.lengths.size(), edges);
    Eigen::MatrixXd result(f.lengths.size(), static_cast<Eigen::Index>(edges.size()));
    for (size_t k = 0; k < edges.size(); ++k) {
        result.col(static_cast<Eigen::Index>(k)) =
            f.slid(Eigen::VectorXd::Unit(f.lengths.size(), edges[k]));
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
