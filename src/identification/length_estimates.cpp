// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/length_estimates.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "identification/mean_function.hpp"

namespace taut {

LengthEstimates estimate_lengths(const CableNet& net, const LengthModel& model,
                                 const Eigen::Ref<const Eigen::MatrixXd>& form_deviations) {
    if (form_deviations.rows() != model.input_scales.size()) {
        throw std::invalid_argument(fmt::format("form deviations of {} coordinates, expected {}",
                                                form_deviations.rows(), model.input_scales.size()));
    }
    gp::Prediction prediction =
        model.processes.predict(model.input_scales.asDiagonal() * form_deviations);
    const Eigen::MatrixXd means = mean_values(net, model.mean, model.nominal_form, form_deviations);
    for (Eigen::Index i = 0; i < prediction.std_dev.rows(); ++i) {
        const gp::Process& process = model.processes.processes[i];
        if (process.status != gp::FitStatus::fitted) {
            prediction.std_dev.row(i).setConstant(model.prior.std_dev());
            continue;
        }
        const double noise = process.hyperparameters.noise_std;
        prediction.mean.row(i) += means.row(i);
        prediction.std_dev.row(i) =
            (prediction.std_dev.row(i).array().square() + noise * noise).sqrt();
    }
    return {.mean = std::move(prediction.mean), .std_dev = std::move(prediction.std_dev)};
}

}  // namespace taut
