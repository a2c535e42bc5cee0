// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/sliding.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "net/sliding_nodes.hpp"

namespace taut {
namespace {

/// The angle by which a run turns at the node that two of its edges share, and its derivatives by
/// the vectors of these.
struct ContactAngle {
    double angle = 0.0;
    Eigen::Vector3d by_before = Eigen::Vector3d::Zero();  ///< as LengthRates::across() [1/m]
    Eigen::Vector3d by_after = Eigen::Vector3d::Zero();
};

ContactAngle contact_angle(const LengthRates& rates, int before, int after) {
    constexpr double straight = 1e-9;
    const auto sign_away = [&](int edge, int other) {
        const auto [s, t] = rates.net.edges[edge];
        const auto [i, j] = rates.net.edges[other];
        return s == i || s == j ? -1.0 : 1.0;
    };
    const double of_before = sign_away(before, after);
    const double of_after = sign_away(after, before);
    const Eigen::Vector3d a = of_before * rates.states[before].direction;
    const Eigen::Vector3d b = of_after * rates.states[after].direction;
    const double cosine = std::clamp(-a.dot(b), -1.0, 1.0);
    const double sine = a.cross(b).norm();
    ContactAngle result{.angle = std::atan2(sine, cosine)};
    if (sine > straight) {
        result.by_before = of_before / (rates.states[before].length * sine) * (b + cosine * a);
        result.by_after = of_after / (rates.states[after].length * sine) * (a + cosine * b);
    }
    return result;
}

/// The largest ratio of tensions on both sides of a node, (capstan).
double largest_ratio(const LengthRates& rates, const SlidingNode& at) {
    constexpr double most = 30.0;  // of the exponent: nothing slides there
    return at.friction > 0.0
               ? std::exp(
                     std::min(most, at.friction * contact_angle(rates, at.before, at.after).angle))
               : 1.0;
}

double pull(const LengthRates& rates, int edge) {
    return rates.states[edge].pull(rates.lengths(edge));
}

double difference(const LengthRates& rates, const SlidingBalance& one) {
    return one.of_after * pull(rates, one.after) - one.of_before * pull(rates, one.before);
}

/// The balances at the limits of friction: that at which length passes on to the edge behind the
/// node, and that at which it comes back.
struct Limits {
    SlidingBalance on;
    SlidingBalance back;
};
Limits limits(const LengthRates& rates, const SlidingNode& at) {
    const double ratio = largest_ratio(rates, at);
    const double by_angle = at.friction * ratio;
    const double before = at.ratio * pull(rates, at.before);
    return {.on = {at.before, at.after, at.ratio * ratio, 1.0, -by_angle * before},
            .back = {at.before, at.after, at.ratio, ratio, by_angle * pull(rates, at.after)}};
}

/// How far the net is from what (capstan) asks for at each node [N].
struct Departure {
    Eigen::VectorXd values;
    std::vector<SlidingBalance> balances;  ///< of nodes that slide; both factors 0 where one sticks
    Eigen::VectorXd stuck_by_slip;         ///< derivative by the slip where a node sticks [N/m]
};

Departure departure_of(const std::vector<SlidingNode>& nodes, const LengthRates& rates,
                       const Eigen::VectorXd& slips) {
    Departure result;
    const auto count = std::ssize(nodes);
    result.values.resize(count);
    result.stuck_by_slip.setZero(count);
    for (int k = 0; k < count; ++k) {
        const SlidingNode& at = nodes[k];
        const auto [on, back] = limits(rates, at);
        const double stiffness =
            std::min(rates.states[at.before].axial, rates.states[at.after].axial);
        const double slip = stiffness * slips(k);
        const bool is_slack =
            at.friction > 0.0 && !(std::max(pull(rates, at.before), pull(rates, at.after)) > 0.0);
        if (at.friction == 0.0 || (!is_slack && slip + difference(rates, on) > 0.0)) {
            result.balances.push_back(on);
            result.values(k) = difference(rates, on);
        } else if (!is_slack && slip + difference(rates, back) < 0.0) {
            result.balances.push_back(back);
            result.values(k) = difference(rates, back);
        } else {
            result.balances.push_back({at.before, at.after, 0.0, 0.0, 0.0});
            result.values(k) = is_slack ? 0.0 : -slip;
            result.stuck_by_slip(k) = -stiffness;
        }
    }
    return result;
}

/// Tensions that rounding errors of the coordinates leave [N].
double rounding(const LocalNet& net, const NetState& state) {
    const double last_place = 16.0 * std::numeric_limits<double>::epsilon();
    double axial = 0.0;
    for (const EdgeState& edge : state.edges()) {
        axial = std::max(axial, edge.axial);
    }
    return last_place * axial * net.nodes.cwiseAbs().maxCoeff();
}

}  // namespace

double contact_angle(const std::vector<Edge>& edges, const Eigen::Ref<const Points>& form,
                     const SlidingNode& at) {
    const auto away = [&](int edge) -> Eigen::Vector3d {
        const auto [s, t] = edges[edge];
        return form.col(s == at.node ? t : s) - form.col(at.node);
    };
    const Eigen::Vector3d a = away(at.before);
    const Eigen::Vector3d b = away(at.after);
    return std::atan2(a.cross(b).norm(), -a.dot(b));
}

std::vector<CableRun> runs_from_here(const CableNet& net, const Eigen::Ref<const Points>& form,
                                     const Eigen::Ref<const Eigen::VectorXd>& tensions,
                                     double friction_error) {
    constexpr double most = 3.0;  // of the logarithm of a ratio
    constexpr double most_ratio = 50.0;
    std::vector<CableRun> runs = net.data().runs;
    for (CableRun& run : runs) {
        if (run.slides_at.empty()) {
            continue;
        }
        const double friction =
            std::max(0.0, run.friction.value_or(CableRun::likely_friction) + friction_error);
        std::vector<double> ratios;
        for (const SlidingNode& at : sliding_nodes_of(net.edges(), run)) {
            const double holds = friction * contact_angle(net.edges(), form, at);
            const double before = at.ratio * tensions(at.before);
            const double after = tensions(at.after);
            const double found = before > 0.0 && after > 0.0
                                     ? std::clamp(std::log(after / before), -most, most)
                                     : 0.0;
            ratios.push_back(
                std::clamp(at.ratio * std::exp(found - std::clamp(found, -holds, holds)),
                           1.0 / most_ratio, most_ratio));
        }
        run.friction = friction;
        run.ratios = std::move(ratios);
    }
    return runs;
}

std::vector<SlidingBalance> sliding_balances(const std::vector<SlidingNode>& nodes,
                                             const LengthRates& rates) {
    constexpr double at_limit = 1e-6;
    std::vector<SlidingBalance> result;
    for (const SlidingNode& at : nodes) {
        const double before = pull(rates, at.before);
        const double after = pull(rates, at.after);
        if (!(before > 0.0 && after > 0.0)) {
            continue;
        }
        const auto [on, back] = limits(rates, at);
        for (const SlidingBalance& one : {on, back}) {
            if (at.friction == 0.0 ||
                std::abs(difference(rates, one)) <= at_limit * std::max(before, after)) {
                result.push_back(one);
                break;
            }
        }
    }
    return result;
}

SlidingRates::SlidingRates(const LengthRates& rates, const StiffnessFactor& factor,
                           std::vector<SlidingBalance> of_balances)
    : balances(std::move(of_balances)) {
    const auto count = std::ssize(balances);
    const Eigen::Index edges = rates.lengths.size();
    by_tension.setZero(count, edges);
    moves.setZero(rates.net.loads.size(), count);
    by_length.resize(count, edges);
    by_slip.resize(count, count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const SlidingBalance& one = balances[static_cast<size_t>(k)];
        by_tension(k, one.after) += one.of_after;
        by_tension(k, one.before) -= one.of_before;
        const ContactAngle turn = contact_angle(rates, one.before, one.after);
        by_turn.push_back({one.by_angle * turn.by_before, one.by_angle * turn.by_after});
        rates.add_force(one.before, by_turn.back()[0], moves.col(k));
        rates.add_force(one.after, by_turn.back()[1], moves.col(k));
        for (const int edge : {one.before, one.after}) {
            const EdgeState& state = rates.states[edge];
            if (state.carries()) {  // a continued tension follows lengths alone
                rates.add_force(edge, by_tension(k, edge) * state.axial * state.direction,
                                moves.col(k));
            }
        }
        factor.solve(moves.col(k));
        by_length.row(k) = rates.lengths_by(by_tension.row(k)).transpose();
        for (int e = 0; e < edges; ++e) {
            by_length(k, e) += rates.force_rate(e).dot(rates.across(e, moves.col(k)));
        }
    }
    for (Eigen::Index k = 0; k < count; ++k) {
        const SlidingBalance& one = balances[static_cast<size_t>(k)];
        by_slip.col(k) = by_length.col(one.after) - by_length.col(one.before);
    }
    m_factor.compute(by_slip);
}

void SlidingRates::add_slips(Eigen::VectorXd& changes) const {
    const Eigen::VectorXd slips = m_factor.solve(-by_length * changes);
    for (Eigen::Index k = 0; k < slips.size(); ++k) {
        changes(balances[static_cast<size_t>(k)].before) -= slips(k);
        changes(balances[static_cast<size_t>(k)].after) += slips(k);
    }
}

Eigen::VectorXd SlidingRates::multipliers(const Eigen::VectorXd& gradient) const {
    Eigen::VectorXd by_slips(std::ssize(balances));
    for (Eigen::Index k = 0; k < by_slips.size(); ++k) {
        const SlidingBalance& one = balances[static_cast<size_t>(k)];
        by_slips(k) = gradient(one.after) - gradient(one.before);
    }
    return by_slip.transpose().colPivHouseholderQr().solve(-by_slips);
}

double RunSliding::run(const LocalNet& net, Stiffness& stiffness, NetState& state,
                       const Balance& balance) const {
    constexpr int most_rounds = 60;
    constexpr int most_halvings = 12;
    constexpr double tolerance = 1e-10;   // of the mean tension
    constexpr double good_enough = 1e-7;  // where rounding errors end the search
    const Eigen::VectorXd marked = state.unstressed_lengths();
    const auto count = std::ssize(m_nodes);
    Eigen::VectorXd slips = Eigen::VectorXd::Zero(count);
    const auto departure = [&] {
        return departure_of(
            m_nodes, {.net = net, .states = state.edges(), .lengths = state.unstressed_lengths()},
            slips);
    };
    const auto left = [&](const Departure& of) {
        const double size = of.values.cwiseAbs().maxCoeff();
        return size <= rounding(net, state) ? 0.0 : size;
    };
    Departure here = departure();
    for (int round = 0; round < most_rounds && left(here) > tolerance * state.mean_force();
         ++round) {
        stiffness.matrix.assemble(net, state.edges());
        for (double shift = smallest_relative_stiffness;
             (!stiffness.factorize() || stiffness.has_loose_nodes()) && shift < 1.0;
             shift *= 10.0) {
            stiffness.matrix.add_shift(shift);
        }
        const SlidingRates rates(
            {.net = net, .states = state.edges(), .lengths = state.unstressed_lengths()},
            stiffness.factor, here.balances);
        Eigen::MatrixXd slopes = rates.by_slip;
        slopes.diagonal() += here.stuck_by_slip;
        const Eigen::VectorXd step = slopes.colPivHouseholderQr().solve(-here.values);
        const NetState state_before = state;
        const Eigen::VectorXd slips_before = slips;
        double part = 1.0;
        bool is_better = false;
        for (int halving = 0; halving < most_halvings && !is_better; ++halving, part *= 0.5) {
            slips = slips_before + part * step;
            Eigen::VectorXd lengths = marked;
            for (Eigen::Index k = 0; k < count; ++k) {
                lengths(m_nodes[static_cast<size_t>(k)].before) -= slips(k);
                lengths(m_nodes[static_cast<size_t>(k)].after) += slips(k);
            }
            // No edge loses more than half of itself at once.
            if (!lengths.allFinite() ||
                !(lengths.array() > 0.5 * state_before.unstressed_lengths().array()).all()) {
                continue;
            }
            state = state_before;
            state.set_unstressed_lengths(net, lengths);
            state.update(net);
            if (!balance()) {
                continue;
            }
            const Departure there = departure();
            is_better = there.values.norm() < (1.0 - 0.01 * part) * here.values.norm();
            if (is_better) {
                here = there;
            }
        }
        if (!is_better) {
            state = state_before;
            slips = slips_before;
            break;
        }
    }
    const double at_end = left(here);
    return at_end <= good_enough * state.mean_force() ? 0.0 : at_end;
}

}  // namespace taut
