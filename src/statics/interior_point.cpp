// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/interior_point.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace taut {
namespace {

/// Share of its tension and of its play that a step leaves to every edge.
constexpr double part_kept = 0.01;

/// Bounds of the share of mu that a step aims for.
constexpr double smallest_part = 0.02;
constexpr double largest_part = 0.8;

/// A shorter step has run into the boundary, and this number of steps without a new lowest mu goes
/// in circles. Then the path is restarted: first at a mu smaller by `narrower`, the next time at
/// one larger by `wider`.
constexpr double shortest_step = 0.03;
constexpr int most_fruitless_steps = 4;
constexpr double narrower = 1e-3;
constexpr double wider = 1e4;

/// mu at the start of the path, in mean energies of the edges. In experiments nets with stiffening
/// laws need it below 0.1, and many more steps if it is below 0.001.
constexpr double first_part = 0.01;

/// The path ends if sum T s is below `smallest_gap` times sum T e, twice the energy of linear edges
/// (or the play, weighted by the tensions, is a rounding error of the coordinates), and the largest
/// imbalance of the tensions is below `smallest_imbalance` times their mean.
constexpr double smallest_gap = 1e-9;
constexpr double smallest_imbalance = 1e-6;

/// If the forces by the tension laws balance to this share of the mean tension, nothing is left to
/// do, for example in a net that is slack everywhere.
constexpr double balanced = 1e-9;

/// The smallest x > 0 with a x^2 + 2 b x + c = 0, for c < 0; infinity if there is none. Written
/// without cancellation: for b < 0 the sum b + sqrt(b^2 - a c) would lose all digits at small c.
double first_root(double a, double b, double c) {
    const double discriminant = b * b - a * c;
    if (b < 0.0) {
        return a > 0.0 ? (std::sqrt(discriminant) - b) / a
                       : std::numeric_limits<double>::infinity();
    }
    const double sum = b + std::sqrt(std::max(0.0, discriminant));
    return discriminant >= 0.0 && sum > 0.0 ? -c / sum : std::numeric_limits<double>::infinity();
}

/// l - l_0: negative for a slack edge.
double stretch(const NetState& state, size_t edge) {
    return state.edges()[edge].length - state.unstressed_lengths()(static_cast<Eigen::Index>(edge));
}

/// Mean over the edges of T (l - l_0); slack edges count with the pressure of a linear edge [N m].
double mean_stretch_energy(const NetState& state) {
    double sum = 0.0;
    for (size_t e = 0; e < state.edges().size(); ++e) {
        const EdgeState& edge = state.edges()[e];
        sum += edge.carries() ? edge.tension * edge.extension
                              : edge.axial * stretch(state, e) * stretch(state, e);
    }
    return sum / static_cast<double>(state.edges().size());
}

/// Adds a force along every edge to its ends; the given one acts on the source.
template <typename ForceOfEdge>
void add_forces(const LocalNet& net, const NetState& state, ForceOfEdge&& force_of_edge,
                Eigen::VectorXd& forces) {
    for (size_t e = 0; e < net.edges.size(); ++e) {
        const auto [s, t] = net.edges[e];
        const Eigen::Vector3d force = force_of_edge(e) * state.edges()[e].direction;
        if (s < net.free_count) {
            forces.segment<3>(Eigen::Index{3} * s) += force;
        }
        if (t < net.free_count) {
            forces.segment<3>(Eigen::Index{3} * t) -= force;
        }
    }
}

}  // namespace

InteriorPoint::InteriorPoint(const LocalNet& net)
    : m_edges(net.edges.size()),
      m_springs(net.edges.size()),
      m_imbalance(net.loads.size()),
      m_direction(net.loads.size()) {
    m_parts_begin.push_back(0);
    for (size_t e = 0; e < m_edges.size(); ++e) {
        m_parts_begin.push_back(m_parts_begin.back() + part_count(net.law(e)));
    }
    m_parts.resize(m_parts_begin.back());
}

int InteriorPoint::run(const LocalNet& net, Stiffness& stiffness, NetState& state, int max_steps) {
    start_on_path(net, state, first_part * mean_stretch_energy(state));
    int steps = 0;
    int fruitless_steps = 0;
    int restarts = 0;
    double lowest = std::numeric_limits<double>::infinity();
    while (steps < max_steps && !arrived(net, state) && factorize(net, stiffness, state)) {
        ++steps;
        const double mu = mean_product_after(0.0, state);
        fruitless_steps = mu < lowest ? 0 : fruitless_steps + 1;
        lowest = std::min(lowest, mu);
        aim_at(0.0);
        find_direction(net, stiffness, state);
        const double part = std::pow(mean_product_after(longest_step(state), state) / mu, 3);
        aim_at(mu * std::clamp(part, smallest_part, largest_part));
        correct(state);
        find_direction(net, stiffness, state);
        if (const double step = longest_step(state);
            step >= shortest_step && fruitless_steps < most_fruitless_steps) {
            move(step, net, state);
        } else {
            start_on_path(net, state, (restarts++ % 2 == 0 ? narrower : wider) * mu);
            lowest = std::numeric_limits<double>::infinity();
        }
    }
    return steps;
}

std::span<PathPart> InteriorPoint::parts_of(size_t edge) {
    return std::span(m_parts).subspan(m_parts_begin[edge],
                                      m_parts_begin[edge + 1] - m_parts_begin[edge]);
}

std::span<const PathPart> InteriorPoint::parts_of(size_t edge) const {
    return std::span(m_parts).subspan(m_parts_begin[edge],
                                      m_parts_begin[edge + 1] - m_parts_begin[edge]);
}

/// Starts on the path at this form: tensions follow from the laws with corners rounded by mu.
void InteriorPoint::start_on_path(const LocalNet& net, const NetState& state, double mu) {
    for (size_t e = 0; e < m_edges.size(); ++e) {
        const auto edge = static_cast<Eigen::Index>(e);
        const double unstressed = state.unstressed_lengths()(edge);
        m_edges[e].tension = start_parts(net.law(e), net.axial_stiffness(edge) / unstressed,
                                         unstressed, stretch(state, e), mu, parts_of(e));
        m_edges[e].elongation = elongation(parts_of(e));
        m_edges[e].play = mu / m_edges[e].tension;
    }
    update_imbalance(net, state);
}

/// h(r, T) of the tensions on the path.
void InteriorPoint::update_imbalance(const LocalNet& net, const NetState& state) {
    m_imbalance = -net.loads;
    net.add_spring_forces(state.form(), m_imbalance);
    add_forces(net, state, [&](size_t e) { return m_edges[e].tension; }, m_imbalance);
}

bool InteriorPoint::arrived(const LocalNet& net, const NetState& state) const {
    if (state.imbalance(net, balanced) <= 1.0) {
        return true;
    }
    const double last_place =
        4.0 * std::numeric_limits<double>::epsilon() * state.form().cwiseAbs().maxCoeff();
    double gap = 0.0;
    double energy = 0.0;
    double tension = 0.0;
    for (size_t e = 0; e < m_edges.size(); ++e) {
        const PathEdge& edge = m_edges[e];
        gap += edge.tension * edge.play + products_after(parts_of(e), 0.0).sum;
        energy += edge.tension * std::abs(edge.elongation);
        tension += edge.tension;
    }
    const double largest = m_imbalance.reshaped(3, net.free_count).colwise().norm().maxCoeff();
    return !(gap > std::max(smallest_gap * energy, last_place * tension)) &&
           !(largest > smallest_imbalance * tension / static_cast<double>(m_edges.size()));
}

bool InteriorPoint::factorize(const LocalNet& net, Stiffness& stiffness, const NetState& state) {
    for (size_t e = 0; e < m_edges.size(); ++e) {
        const PathEdge& edge = m_edges[e];
        const double flexibility = tangent_of(parts_of(e), edge.tension).flexibility;
        m_springs[e] = {.direction = state.edges()[e].direction,
                        .length = state.edges()[e].length,
                        .extension = edge.play,  // taut, all of them
                        .axial = edge.tension / (edge.play + edge.tension * flexibility),
                        .tension = edge.tension};
    }
    stiffness.matrix.assemble(net, m_springs);
    return stiffness.factorize();
}

void InteriorPoint::aim_at(double mu) {
    for (PathEdge& edge : m_edges) {
        edge.wanted = mu - edge.tension * edge.play;
    }
    aim_parts(m_parts, mu);
}

/// Subtracts the second-order change of T s along the last direction: dT ds, and T times the growth
/// of the length by turning.
void InteriorPoint::correct(const NetState& state) {
    for (size_t e = 0; e < m_edges.size(); ++e) {
        const EdgeState& at = state.edges()[e];
        PathEdge& edge = m_edges[e];
        const double lengthening = at.direction.dot(edge.difference);
        const double turned = (at.length * at.direction + edge.difference).norm() - at.length;
        edge.wanted -= edge.tension_rate * (edge.elongation_rate - lengthening) -
                       edge.tension * (turned - lengthening);
    }
    correct_parts(m_parts);
}

/// Solves dT s + T ds = wanted and h(r + dr, T + dT) = 0, both to first order: with de = F dT + g
/// of the parts and ds = de - dl, dT = (wanted - T g + T dl) / (s + T F).
void InteriorPoint::find_direction(const LocalNet& net, const Stiffness& stiffness,
                                   const NetState& state) {
    for (size_t e = 0; e < m_edges.size(); ++e) {  // for dl = 0
        PathEdge& edge = m_edges[e];
        const auto [flexibility, drift] = tangent_of(parts_of(e), edge.tension);
        edge.tension_rate =
            (edge.wanted - edge.tension * drift) / (edge.play + edge.tension * flexibility);
    }
    m_direction = -m_imbalance;
    add_forces(net, state, [&](size_t e) { return -m_edges[e].tension_rate; }, m_direction);
    stiffness.factor.solve(m_direction);
    for (size_t e = 0; e < m_edges.size(); ++e) {
        const auto [s, t] = net.edges[e];
        PathEdge& edge = m_edges[e];
        edge.difference.setZero();
        if (s < net.free_count) {
            edge.difference += m_direction.segment<3>(Eigen::Index{3} * s);
        }
        if (t < net.free_count) {
            edge.difference -= m_direction.segment<3>(Eigen::Index{3} * t);
        }
        const double lengthening = m_springs[e].direction.dot(edge.difference);
        edge.tension_rate += m_springs[e].axial * lengthening;
        find_part_rates(parts_of(e), edge.tension, edge.tension_rate);
        edge.elongation_rate =
            std::transform_reduce(parts_of(e).begin(), parts_of(e).end(), 0.0, std::plus<>(),
                                  [](const PathPart& part) { return part.stretch_rate; });
    }
}

/// The longest step, at most 1, that leaves part_kept of their tension and play to all edges, and
/// likewise to their parts. The play along the direction is l_0 + e + a de - |l u + a d|.
double InteriorPoint::longest_step(const NetState& state) const {
    double step = limit_step(m_parts, part_kept, 1.0);
    for (size_t e = 0; e < m_edges.size(); ++e) {
        const EdgeState& at = state.edges()[e];
        const PathEdge& edge = m_edges[e];
        const double rate = edge.elongation_rate;
        if (edge.tension_rate < 0.0) {
            step = std::min(step, (part_kept - 1.0) * edge.tension / edge.tension_rate);
        }
        // |l u + a d| = l + reach + a rate
        const double reach = (1.0 - part_kept) * edge.play;
        step = std::min(step, first_root(edge.difference.squaredNorm() - rate * rate,
                                         at.length * at.direction.dot(edge.difference) -
                                             (at.length + reach) * rate,
                                         -reach * (2.0 * at.length + reach)));
    }
    return step;
}

/// mu after a step along the direction, by the rates at its start.
double InteriorPoint::mean_product_after(double step, const NetState& state) const {
    auto [sum, count] = products_after(m_parts, step);
    for (size_t e = 0; e < m_edges.size(); ++e) {
        const EdgeState& at = state.edges()[e];
        const PathEdge& edge = m_edges[e];
        const double length = (at.length * at.direction + step * edge.difference).norm();
        sum += (edge.tension + step * edge.tension_rate) *
               (edge.play + step * edge.elongation_rate - (length - at.length));
    }
    return sum / static_cast<double>(std::ssize(m_edges) + count);
}

void InteriorPoint::move(double step, const LocalNet& net, NetState& state) {
    state.form().reshaped().head(m_direction.size()) += step * m_direction;
    state.update(net);
    move_parts(m_parts, step);
    for (size_t e = 0; e < m_edges.size(); ++e) {
        PathEdge& edge = m_edges[e];
        edge.tension += step * edge.tension_rate;
        edge.elongation = elongation(parts_of(e));
        // at least the rounding error of the length, so that the play stays positive
        edge.play = std::max(edge.elongation - stretch(state, e),
                             std::numeric_limits<double>::epsilon() * state.edges()[e].length);
    }
    update_imbalance(net, state);
}

}  // namespace taut
