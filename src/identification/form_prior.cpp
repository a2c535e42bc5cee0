// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/form_prior.hpp"

#include "numerics/dense.hpp"
#include "numerics/memory_budget.hpp"
#include "numerics/shrunk_covariance.hpp"
#include "taut/statics/form_sensitivity.hpp"

namespace taut {

FormPrior form_prior_of(const CableNet& net, const LengthModel& model,
                        const Eigen::Ref<const Eigen::MatrixXd>& form_deviations) {
    const auto coordinates = static_cast<double>(form_deviations.rows());
    const auto lengths = static_cast<double>(net.interior_edge_count());
    const auto samples = static_cast<double>(form_deviations.cols());
    // Two covariances, their sum, its eigenvectors and as much room; J twice; the remainder.
    const MemoryCharge charge =
        charge_numbers(coordinates * (5.0 * coordinates + 2.0 * lengths + samples));
    const Eigen::MatrixXd J = FormSensitivity(net, net.unstressed_lengths(),
                                              with_free_coordinates(net, model.nominal_form))
                                  .columns(net.interior_edges());
    Eigen::MatrixXd remainder = form_deviations - product(J, model.length_deviations);
    FormPrior prior{
        .mean = remainder.rowwise().mean(), .variances = {}, .directions = {}, .inputs = {}};
    remainder.colwise() -= prior.mean;
    const Eigen::MatrixXd by_prior = gram(model.prior.std_dev() * J.transpose());
    SymmetricEigen eigen = symmetric_eigen(shrunk_covariance(remainder) + by_prior);
    prior.variances = eigen.values.cwiseMax(0.0);  // what is below zero is rounding
    prior.directions = eigen.vectors.transpose();
    return prior;
}

bool has_orthonormal_directions(const FormPrior& prior) {
    constexpr double rounding = 1e-8;
    return gram(prior.directions).isIdentity(rounding);
}

bool keeps_form_prior(const CableNet& net) {
    constexpr int most_free_nodes = 1000;
    return net.free_node_count() <= most_free_nodes;
}

void make_form_prior(const CableNet& net, LengthModel& model) {
    if (model.form_prior.mean.size() == 0) {
        model.form_prior = form_prior_of(net, model, model.form_deviations());
        model.form_prior.inputs = inputs_along_directions(model, model.form_prior);
    }
}

Eigen::MatrixXd inputs_along_directions(const LengthModel& model, const FormPrior& prior) {
    return product(prior.directions * model.input_scales.asDiagonal(), model.processes.inputs);
}

}  // namespace taut
