// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <nanobind/nanobind.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "states.hpp"
#include "taut/gp/fit.hpp"

namespace taut::python {
namespace {

/// A number of each process (m,).
template <class Get>
auto of_processes(Get get) {
    return [get](const gp::FittedProcesses& self) { return array_of_each(self.processes, get); };
}

/// Of the latent function of one output.
/// @throws nb::index_error, nb::value_error
Eigen::MatrixXd covariance(const gp::FittedProcesses& fitted, int output,
                           const Eigen::MatrixXd& at) {
    if (output < 0 || std::cmp_greater_equal(output, fitted.processes.size())) {
        throw std::out_of_range(fmt::format("output: got {}, expected 0 to {}", output,
                                            std::ssize(fitted.processes) - 1));
    }
    if (at.rows() != fitted.inputs.rows()) {
        throw std::invalid_argument(
            fmt::format("inputs: got {} dimensions, expected {}", at.rows(), fitted.inputs.rows()));
    }
    const gp::Process& process = fitted.processes[static_cast<size_t>(output)];
    if (process.status != gp::FitStatus::fitted) {
        return Eigen::MatrixXd::Zero(at.cols(), at.cols());
    }
    // sigma_f^2 (R** - R*' Q (D + eta)^-1 Q' R*), with R = Q D Q'; what a spectrum leaves out
    // counts as noise, as in prediction (low-rank-variance).
    const auto& [lambda, signal, noise] = process.hyperparameters;
    const gp::KernelSpectrum& spectrum = fitted.spectra[static_cast<size_t>(process.spectrum)];
    const double ratio = std::pow(noise / signal, 2) + spectrum.tail_largest;
    const Eigen::MatrixXd k = gp::correlation(gp::squared_distances(fitted.inputs, at), lambda);
    const Eigen::MatrixXd along = spectrum.eigenvectors.transpose() * k;
    const Eigen::MatrixXd seen =
        (spectrum.eigenvalues.array() + ratio).rsqrt().matrix().asDiagonal() * along;
    Eigen::MatrixXd unexplained =
        gp::correlation(gp::squared_distances(at, at), lambda) - seen.transpose() * seen;
    if (!spectrum.is_whole()) {
        const Eigen::MatrixXd left_out = k - spectrum.eigenvectors * along;
        unexplained -= left_out.transpose() * left_out / ratio;
    }
    Eigen::MatrixXd result = signal * signal * unexplained;
    result.diagonal().array() += std::pow(process.approximation_error, 2);
    return result;
}

/// In blocks, between which Ctrl-C is noticed.
gp::Prediction predict(const gp::FittedProcesses& fitted, const Eigen::MatrixXd& at,
                       const Progress& reporter) {
    static constexpr Eigen::Index block = 1024;
    if (at.cols() <= block) {
        return fitted.predict(at);
    }
    const auto outputs = static_cast<Eigen::Index>(fitted.processes.size());
    gp::Prediction all{.mean = Eigen::MatrixXd(outputs, at.cols()),
                       .std_dev = Eigen::MatrixXd(outputs, at.cols())};
    for (Eigen::Index first = 0; first < at.cols(); first += block) {
        reporter.throw_if_stopped();
        const Eigen::Index count = std::min(block, at.cols() - first);
        const gp::Prediction part = fitted.predict(at.middleCols(first, count));
        all.mean.middleCols(first, count) = part.mean;
        all.std_dev.middleCols(first, count) = part.std_dev;
    }
    return all;
}

}  // namespace

void bind_gp(nb::module_& module) {
    nb::class_<gp::FittedProcesses> fitted(module, "FittedProcesses",
                                           "m processes with zero mean and an isotropic squared "
                                           "exponential kernel each, trained on the same inputs.");
    make_picklable(fitted);
    fitted
        .def_prop_ro("inverse_length_scale", of_processes([](const gp::Process& of) {
                         return of.hyperparameters.inverse_length_scale;
                     }),
                     "lambda (m,).")
        .def_prop_ro("signal_std", of_processes([](const gp::Process& of) {
                         return of.hyperparameters.signal_std;
                     }),
                     "sigma_f (m,).")
        .def_prop_ro("noise_std", of_processes([](const gp::Process& of) {
                         return of.hyperparameters.noise_std;
                     }),
                     "sigma_w (m,).")
        .def_prop_ro("negative_log_likelihood", of_processes(&gp::Process::negative_log_likelihood),
                     "(m,).")
        .def_prop_ro("leave_one_out_rmse", of_processes(&gp::Process::leave_one_out_rmse),
                     "Of the mean at each training input, trained without it (m,).")
        .def_prop_ro("approximation_error", of_processes(&gp::Process::approximation_error),
                     "By low rank: bound of what the mean is off from the exact one with the same "
                     "hyperparameters, root mean square over the training inputs; else 0 (m,). "
                     "Standard deviations and leave-one-out errors contain it.")
        .def_ro("decompositions", &gp::FittedProcesses::decompositions,
                "Made in the search for length scales; 0 of a model that was read.")
        .def_ro("is_converged", &gp::FittedProcesses::is_converged,
                "Whether that search ended before max_spectra.")
        .def_prop_ro("rank", &gp::FittedProcesses::rank,
                     "Directions of the kernel matrix that were kept; None where all are.")
        .def_prop_ro(
            "left_out", &gp::FittedProcesses::left_out,
            "Part of the kernel matrix, of its trace, that these directions leave out. Where it is "
            "larger than that of the noise, signal counts as noise: the rank is too low.")
        .def_prop_ro(
            "status",
            [](const gp::FittedProcesses& self) {
                nb::list list;
                for (const gp::Process& of : self.processes) {
                    list.append(to_string(of.status));
                }
                return list;
            },
            "'fitted', 'constant output' or 'non-finite output' of each.")
        .def(
            "predict",
            [](const gp::FittedProcesses& self, const ArrayLike& inputs) {
                const Eigen::MatrixXd at = columns_argument(inputs, "inputs");
                gp::Prediction made = interruptible(nb::none(), [&](const Progress& reporter) {
                    return predict(self, at, reporter);
                });
                return nb::make_tuple(array_of_columns(std::move(made.mean)),
                                      array_of_columns(std::move(made.std_dev)));
            },
            nb::arg("inputs"),
            "Mean and standard deviation of the latent functions at inputs (k, d): (k, m) each.")
        .def(
            "covariance",
            [](const gp::FittedProcesses& self, int output, const ArrayLike& inputs) {
                const Eigen::MatrixXd at = columns_argument(inputs, "inputs");
                return array_of_columns(without_lock([&] { return covariance(self, output, at); }));
            },
            nb::arg("output"), nb::arg("inputs"),
            "Posterior covariance of one latent function between inputs (k, d): (k, k).")
        .def("__repr__", [](const gp::FittedProcesses& self) {
            return fmt::format("FittedProcesses({} outputs, {} training inputs of {} dimensions)",
                               self.processes.size(), self.inputs.cols(), self.inputs.rows());
        });
    module.def(
        "_fit_processes",
        [](const ArrayLike& inputs, const ArrayLike& outputs, double relative_tolerance,
           int max_spectra, int most_decomposed, int rank, const nb::object& progress) {
            const Eigen::MatrixXd x = columns_argument(inputs, "inputs");
            const Eigen::MatrixXd y = columns_argument(outputs, "outputs").transpose();
            gp::FitSettings settings;
            settings.relative_tolerance = relative_tolerance;
            settings.max_spectra = max_spectra;
            settings.most_decomposed = most_decomposed;
            settings.rank = rank;
            return interruptible(progress, [&](const Progress& reporter) {
                return gp::fit(x, y, settings, reporter);
            });
        },
        nb::arg("inputs"), nb::arg("outputs"), nb::kw_only(),
        nb::arg("relative_tolerance") = gp::FitSettings().relative_tolerance,
        nb::arg("max_spectra") = gp::FitSettings().max_spectra,
        nb::arg("most_decomposed") = gp::FitSettings().most_decomposed,
        nb::arg("rank") = gp::FitSettings().rank, nb::arg("progress") = nb::none(),
        R"(Estimates each output's hyperparameters by maximum marginal likelihood.

Args:
    inputs: (n, d).
    outputs: (n, m).
    max_spectra: decompositions that all outputs share, at most.
    most_decomposed: inputs that are decomposed, at most; with more of them processes are fitted
        by low rank.
    rank: directions of the kernel matrix that are then kept.)");
}

}  // namespace taut::python
