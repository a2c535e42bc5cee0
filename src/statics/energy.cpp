// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/energy.hpp"

#include <utility>

#include "net/support_stiffness.hpp"
#include "statics/edge_state.hpp"
#include "statics/local_net.hpp"
#include "statics/stiffness_matrix.hpp"

namespace taut {
namespace {

/// From their places without load; 0 at other nodes (3 x n) [m].
Points shifts_of_supports(const CableNet& net, const Eigen::Ref<const Points>& form) {
    Points shifts = Points::Zero(3, net.node_count());
    for (const ElasticSupport& support : net.elastic_supports()) {
        shifts.col(support.node) = form.col(support.node) - support.place;
    }
    return shifts;
}

}  // namespace

double potential_energy(const CableNet& net,
                        const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                        const Eigen::Ref<const Points>& form) {
    double total = 0.0;
    const auto states = edge_states(net, unstressed_lengths, form);
    for (int e = 0; e < net.edge_count(); ++e) {
        total += energy_of(states[e], unstressed_lengths(e), net.tension_law(e));
    }
    for (const int node : net.free_nodes()) {
        total -= net.loads().col(node).dot(form.col(node));
    }
    const Points shifts = shifts_of_supports(net, form);
    return total + 0.5 * shifts.cwiseProduct(support_forces(net, shifts)).sum();
}

Points elastic_forces(const CableNet& net, const Eigen::Ref<const Points>& form) {
    return support_forces(net, shifts_of_supports(net, form));
}

Eigen::VectorXd out_of_balance_forces(const CableNet& net,
                                      const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                      const Eigen::Ref<const Points>& form) {
    Points forces = elastic_forces(net, form) - net.loads();
    const auto states = edge_states(net, unstressed_lengths, form);
    for (size_t e = 0; e < states.size(); ++e) {
        const auto [s, t] = net.edges()[e];
        const Eigen::Vector3d force = states[e].tension * states[e].direction;
        forces.col(s) += force;
        forces.col(t) -= force;
    }
    return free_coordinates(net, forces);
}

CableNet with_supports_in_balance(const CableNet& net) {
    if (net.elastic_supports().empty()) {
        return net;
    }
    const Eigen::VectorXd forces =
        out_of_balance_forces(net, net.unstressed_lengths(), net.nodes());
    Points of_nodes = Points::Zero(3, net.node_count());
    of_nodes(Eigen::all, net.free_nodes()) = forces.reshaped(3, net.free_node_count());
    const Points shifts = SupportStiffness(net).shifts_by(of_nodes);
    CableNetData data = net.data();
    for (ElasticSupport& support : data.elastic_supports) {
        support.place += shifts.col(support.node);
    }
    return CableNet(std::move(data));
}

Eigen::SparseMatrix<double> tangent_stiffness(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
    const Eigen::Ref<const Points>& form) {
    const LocalNet local = number_naturally(net);
    StiffnessMatrix matrix(local);
    matrix.assemble(local, edge_states(net, unstressed_lengths, form));
    return matrix.to_sparse();
}

}  // namespace taut
