// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/form_prior.hpp"

#include "numerics/dense.hpp"
#include "numerics/shrunk_covariance.hpp"
#include "taut/statics/form_sensitivity.hpp"

namespace taut {

FormPrior form_prior_of(const CableNet& net, const LengthModel& model,
                        const Eigen::Ref<const Eigen::MatrixXd>& form_deviations) {
    const Eigen::MatrixXd J = FormSensitivity(net, net.unstressed_lengths(),
                                              with_free_coordinates(net, model.nominal_form))
                                  .columns(net.interior_edges());
    Eigen::MatrixXd remainder = form_deviations - product(J, model.length_deviations);
    FormPrior prior{
        .mean = remainder.rowwise().mean(), .variances = {}, .directions = {}, .inputs = {}};
    remainder.colwise() -= prior.mean;
    const Eigen::MatrixXd by_law = gram(model.law.std() * J.transpose());
    SymmetricEigen eigen = symmetric_eigen(shrunk_covariance(remainder) + by_law);
    prior.variances = eigen.values.cwiseMax(0.0);  // what is below zero is rounding
    prior.directions = eigen.vectors.transpose();
    return prior;
}

bool has_orthonormal_directions(const FormPrior& prior) {
    constexpr double rounding = 1e-8;
    return gram(prior.directions).isIdentity(rounding);
}

Eigen::MatrixXd inputs_along_directions(const LengthModel& model) {
    return product(model.form_prior.directions * model.input_scales.asDiagonal(),
                   model.processes.inputs);
}

}  // namespace taut
