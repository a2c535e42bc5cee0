// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/identification/model.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/statics/cone_program.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/version.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <iostream>
#include <string_view>
#include <utility>

double bystander_norm(int size);

namespace {

// Uses what needs every library that taut links: sparse solves, threads, LAPACK, the conic solver.
bool trains_and_solves(const taut::CableNet& net) {
    const taut::Sampler sampler(net, {.scale = 0.002}, 1);
    taut::DataSet data = sampler.no_samples();
    sampler.extend_to(data, 40);
    const taut::LengthModel model = taut::train_model(net, data, data.converged_in(0, data.size()));
    std::cout << model.processes.processes.size() << " processes\n";
    return static_cast<int>(model.processes.processes.size()) == net.interior_edge_count() &&
           (!taut::cone_solver_available() ||
            taut::solve_cone_program(net, net.unstressed_lengths()).solved());
}

// Matrices and containers made here are freed by taut and the reverse. They are grown and assigned
// on both sides, with the instructions that this program is compiled for.
bool identifies(const taut::CableNet& net) {
    taut::CableNetData data = net.data();
    data.unstressed_lengths *= 1.0 + 1e-4;
    const taut::CableNet built(std::move(data));
    for (int round = 0; round < 20; ++round) {
        taut::Equilibrium equilibrium = taut::solve_equilibrium(built);
        taut::Survey survey;
        survey.form = std::move(equilibrium.form);
        survey.noise_std = taut::Points::Constant(3, net.node_count(), 1e-4);
        survey.surveyed = net.free_nodes();
        survey.surveyed.shrink_to_fit();
        taut::Identification found = taut::identify(net, survey, {.draws = 50});
        if (found.status != taut::IdentificationStatus::converged || !found.draws) {
            return false;
        }
        Eigen::MatrixXd& draws = found.draws->length_deviations;
        const Eigen::VectorXd mean = draws.rowwise().mean();
        draws = (draws.colwise() - mean).eval();
        draws.conservativeResize(draws.rows(), draws.cols() - 1);
        const Eigen::MatrixXd covariance =
            draws * draws.transpose() / static_cast<double>(draws.cols()) +
            1e-12 * Eigen::MatrixXd::Identity(draws.rows(), draws.rows());
        if (covariance.llt().info() != Eigen::Success) {
            return false;
        }
        found.edges.resize(found.edges.size() / 2);
        found.message += std::string(100, 'x');
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view expected = argc > 1 ? argv[1] : "";
    const taut::CableNet net = taut::hypar(3, 3);
    std::cout << "taut " << taut::version() << ", headers of " << TAUT_VERSION_NUMBER << '\n';
    return taut::version() == expected && bystander_norm(32) > 7.9 && trains_and_solves(net) &&
                   identifies(net)
               ? 0
               : 1;
}
