// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/energy.hpp"

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
    return total;
}

Eigen::VectorXd out_of_balance_forces(const CableNet& net,
                                      const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                      const Eigen::Ref<const Points>& form) {
    Points forces = -net.loads();
    const auto states = edge_states(net, unstressed_lengths, form);
    for (size_t e = 0; e < states.size(); ++e) {
        const auto [s, t] = net.edges()[e];
        const Eigen::Vector3d force = states[e].tension * states[e].direction;
        forces.col(s) += force;
        forces.col(t) -= force;
    }
    return free_coordinates(net, forces);
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
