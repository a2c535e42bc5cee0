// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/duality.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "net/support_stiffness.hpp"
#include "numerics/sparse_cholesky.hpp"
#include "statics/edge_state.hpp"
#include "taut/statics/energy.hpp"

namespace taut {
namespace {

/// Share of its axial stiffness with which a slack edge takes part in the correction. A force in it
/// costs T (l_0 - l), so it should take only forces that no taut edge can, as at a loose node.
constexpr double slack_share = 1e-6;

/// A net with smaller strains is practically slack. Its elastic energy may be as small as the cost
/// of rounding errors of some EA 1e-16 in slack edges, so it is no scale for the gap.
constexpr double negligible_strain = 1e-6;

/// Forces that edges exert, and forces on the springs of elastic supports, 0 at other nodes [N].
struct BalancingForces {
    Points edges;    ///< 3 x m
    Points springs;  ///< 3 x n
};

/// sum_(s,t) f - sum_(t,s) f + g - p_s of the free nodes (n_I x 3) [N].
Eigen::MatrixX3d imbalance(const CableNet& net, const BalancingForces& of) {
    Points forces = of.springs - net.loads();
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto [s, t] = net.edges()[e];
        forces.col(s) += of.edges.col(e);
        forces.col(t) -= of.edges.col(e);
    }
    return forces(Eigen::all, net.free_nodes()).transpose();
}

/// Balances forces by the correction g with the least sum |g|^2 / (2 c), c being an edge's
/// stiffness. With multipliers y at the free nodes (0 at supports), g = -c (y_s - y_t), and balance
/// requires C y = h with the imbalance h and the Laplacian C of the net weighted by c. A spring
/// counts as an edge to a support, with its mean stiffness. C is positive definite, since a path of
/// edges joins every node to a support.
void balance(const CableNet& net, const Eigen::VectorXd& stiffness, BalancingForces& forces) {
    const auto mean_of = [](const ElasticSupport& one) { return one.stiffness.trace() / 3.0; };
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * net.edges().size());
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto [s, t] = net.edges()[e];
        const int i = net.free_index(s);
        const int j = net.free_index(t);
        for (const int k : {i, j}) {
            if (k >= 0) {
                entries.emplace_back(k, k, stiffness(e));
            }
        }
        if (i >= 0 && j >= 0) {
            entries.emplace_back(i, j, -stiffness(e));
            entries.emplace_back(j, i, -stiffness(e));
        }
    }
    for (const ElasticSupport& support : net.elastic_supports()) {
        const int k = net.free_index(support.node);
        entries.emplace_back(k, k, mean_of(support));
    }
    Eigen::SparseMatrix<double> laplacian(net.free_node_count(), net.free_node_count());
    laplacian.setFromTriplets(entries.begin(), entries.end());
    const SparseCholesky factor(laplacian);

    // The second round removes the imbalance that rounding errors left in the first.
    for (int round = 0; round < 2; ++round) {
        Points multipliers = Points::Zero(3, net.node_count());
        multipliers(Eigen::all, net.free_nodes()) =
            factor.solve(imbalance(net, forces)).transpose();
        for (int e = 0; e < net.edge_count(); ++e) {
            const auto [s, t] = net.edges()[e];
            forces.edges.col(e) -= stiffness(e) * (multipliers.col(s) - multipliers.col(t));
        }
        for (const ElasticSupport& support : net.elastic_supports()) {
            forces.springs.col(support.node) -= mean_of(support) * multipliers.col(support.node);
        }
    }
}

/// phi(e) + phi*(T) - T e of an edge with extension e, of tension T_e, and a force T; phi* is the
/// conjugate. With c = EA/l_0 it is (T - T_e)^2 / (2c). For a law it is the area between the law
/// and T, from e to the extension at which the law gives T.
double misfit_energy(const EdgeState& state, double unstressed_length, const TensionLaw* law,
                     double tension) {
    const double misfit = tension - state.tension;
    if (law == nullptr) {
        return misfit * misfit / (2.0 * state.axial);
    }
    const double strain = state.extension / unstressed_length;
    const double wanted = law->strain_at(tension);
    return std::max(0.0, unstressed_length * (0.5 * misfit * (wanted - strain) +
                                              law->corner_energy(strain, wanted)));
}

/// phi*(f) - T l_0 of an edge; T^2 / (2c) if it is linear [J].
double complementary_energy(double tension, double unstressed_length, double axial_stiffness,
                            const TensionLaw* law) {
    if (law == nullptr) {
        return tension * tension * unstressed_length / (2.0 * axial_stiffness);
    }
    const double strain = law->strain_at(tension);
    return unstressed_length * (tension * strain - law->energy_between(0.0, strain));
}

/// An edge's part of V - D. Of an edge with d = r_s - r_t, l = |d|, c = EA/l_0 and extension
/// e = max(0, l - l_0), V has phi(d) = c e^2 / 2, whose convex conjugate is
///
///   phi*(f) = sup_d ( f . d - phi(d) ) = T l_0 + T^2 / (2c).
///
/// Hence phi(d) >= f . d - phi*(f) for every f. In the sum over all edges, balance turns f . d into
/// the work of the loads and the reactions' R_b . r_b: that is V >= D. The edge's part of the gap,
/// phi(d) + phi*(f) - f . d, is with l = l_0 + e - max(0, l_0 - l)
///
///   (T - c e)^2 / (2c)  +  T max(0, l_0 - l)  +  (T l - f . d)
///
/// each term at least 0; with a tension law the first is misfit_energy(). If f and d point the same
/// way, the last one is computed as |f x d|^2 / (T l + f . d) to avoid cancellation.
double gap_of(const EdgeState& state, double unstressed_length, const TensionLaw* law,
              const Eigen::Vector3d& force) {
    const double tension = force.norm();
    const Eigen::Vector3d vector = state.length * state.direction;
    const double work = force.dot(vector);
    const double product = tension * state.length;
    const double across =
        work > 0.0 ? force.cross(vector).squaredNorm() / (product + work) : product - work;
    return misfit_energy(state, unstressed_length, law, tension) +
           (state.carries() ? 0.0 : tension * (unstressed_length - state.length)) + across;
}

EnergyCertificate certify_states(const CableNet& net,
                                 const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                 const Eigen::Ref<const Points>& form,
                                 const std::vector<EdgeState>& states, Points edge_forces) {
    if (net.has_struts()) {
        throw std::invalid_argument(
            "net has struts: its energy is not convex, and has no certificate");
    }
    const Points springs = elastic_forces(net, form);
    BalancingForces forces{.edges = std::move(edge_forces), .springs = springs};
    Eigen::VectorXd stiffness =
        slack_share * net.axial_stiffness().cwiseQuotient(unstressed_lengths);
    for (int e = 0; e < net.edge_count(); ++e) {
        if (states[e].carries()) {
            stiffness(e) = std::max(stiffness(e), states[e].axial);
        }
    }
    balance(net, stiffness, forces);

    EnergyCertificate result{.energy = potential_energy(net, unstressed_lengths, form)};
    double elastic = 0.0;
    double complementary = 0.0;
    for (int e = 0; e < net.edge_count(); ++e) {
        const EdgeState& state = states[e];
        const TensionLaw* law = net.tension_law(e);
        elastic += std::abs(energy_of(state, unstressed_lengths(e), law));
        complementary += complementary_energy(forces.edges.col(e).norm(), unstressed_lengths(e),
                                              net.axial_stiffness()(e), law);
        result.duality_gap += gap_of(state, unstressed_lengths(e), law, forces.edges.col(e));
    }
    if (!net.elastic_supports().empty()) {
        const SupportStiffness supports(net);
        const auto energy_by = [&supports](const Points& of_springs) {
            return 0.5 * of_springs.cwiseProduct(supports.shifts_by(of_springs)).sum();
        };
        elastic += energy_by(springs);
        complementary += energy_by(forces.springs);
        result.duality_gap += energy_by(forces.springs - springs);
    }
    result.complementary_energy = result.energy - result.duality_gap;
    const double negligible =
        0.5 * negligible_strain * negligible_strain * net.axial_stiffness().dot(unstressed_lengths);
    result.relative_gap = result.duality_gap / std::max({elastic, complementary, negligible});
    return result;
}

}  // namespace

EnergyCertificate energy_certificate(const CableNet& net,
                                     const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                     const Eigen::Ref<const Points>& form) {
    const auto states = edge_states(net, unstressed_lengths, form);
    Points forces(3, net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        const EdgeState& state = states[e];
        forces.col(e) = state.tension * state.direction;
    }
    return certify_states(net, unstressed_lengths, form, states, std::move(forces));
}

EnergyCertificate energy_certificate(const CableNet& net,
                                     const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                     const Eigen::Ref<const Points>& form,
                                     const Eigen::Ref<const Points>& edge_forces) {
    const auto states = edge_states(net, unstressed_lengths, form);
    check_edge_forces(net.edge_count(), edge_forces);
    return certify_states(net, unstressed_lengths, form, states, edge_forces);
}

}  // namespace taut
