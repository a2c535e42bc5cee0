// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/energy.hpp"

#include <Eigen/Cholesky>

#include <utility>

#include "statics/edge_state.hpp"
#include "statics/local_net.hpp"
#include "statics/stiffness_matrix.hpp"

namespace taut {
double energy(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
              const Eigen::Ref<const Points>& form) {
    double total = 0.0;
    const auto states = edge_states(net, unstressed_lengths, form);
    for (int e = 0; e < net.edge_count(); ++e) {
        total += energy_of(states[e], unstressed_lengths(e), net.tension_law(e));
    }
    for (const int node : net.free_nodes()) {
        total -= net.loads().col(node).dot(form.col(node));
    }
    for (const ElasticSupport& support : net.elastic_supports()) {
        const Eigen::Vector3d shift = form.col(support.node) - support.place;
        total += 0.5 * shift.dot(support.stiffness * shift);
    }
    return total;
}

Points elastic_forces(const CableNet& net, const Eigen::Ref<const Points>& form) {
    Points forces = Points::Zero(3, net.node_count());
    for (const auto& [node, stiffness, place] : net.elastic_supports()) {
        forces.col(node) = stiffness * (form.col(node) - place);
    }
    return forces;
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
    CableNetData data = net.data();
    for (auto& [node, stiffness, place] : data.elastic_supports) {
        place += stiffness.llt().solve(forces.segment<3>(Eigen::Index{3} * net.free_index(node)));
    }
    return CableNet(std::move(data));
}

Eigen::SparseMatrix<double> stiffness(const CableNet& net,
                                      const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                      const Eigen::Ref<const Points>& form) {
    const LocalNet local = number_naturally(net);
    StiffnessMatrix matrix(local);
    matrix.assemble(local, edge_states(net, unstressed_lengths, form));
    return matrix.to_sparse();
}

}  // namespace taut
