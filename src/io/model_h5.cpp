// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/model_h5.hpp"

#include <fmt/core.h>

#include <array>
#include <optional>
#include <stdexcept>

#include "files/message.hpp"
#include "identification/form_prior.hpp"
#include "io/h5_head.hpp"
#include "io/kernel_spectra_h5.hpp"
#include "taut/files/file.hpp"

namespace taut {
namespace {

using gp::FitStatus;
using gp::FittedProcesses;
using gp::KernelSpectrum;
using gp::Process;

const std::string model_format = "taut-model";
constexpr std::uint64_t model_version = 4;
/// Its spectra are whole, its approximation errors 0.
constexpr std::uint64_t version_without_form_prior = 2;
constexpr std::uint64_t version_with_approximation_error = 3;

/// The code of each in a file is its place in the enumeration, which is therefore fixed.
constexpr std::array mean_functions{MeanFunction::zero, MeanFunction::geometry};
constexpr std::array kernel_metrics{KernelMetric::isotropic, KernelMetric::direction,
                                    KernelMetric::node};
constexpr std::array fit_statuses{FitStatus::fitted, FitStatus::constant_output,
                                  FitStatus::non_finite_output};

/// The numbers of a process, each a dataset [m_I].
struct Column {
    const char* name;
    const char* units;
    double& (*of)(Process&);
    std::uint64_t since = version_without_form_prior;  ///< files of this version have it
};
constexpr std::array process_columns{
    Column{"inverse_length_scale", "1/m",
           [](Process& p) -> double& { return p.hyperparameters.inverse_length_scale; }},
    Column{"signal_std", "m", [](Process& p) -> double& { return p.hyperparameters.signal_std; }},
    Column{"noise_std", "m", [](Process& p) -> double& { return p.hyperparameters.noise_std; }},
    Column{"negative_log_likelihood", "1",
           [](Process& p) -> double& { return p.negative_log_likelihood; }},
    Column{"leave_one_out_rmse", "m", [](Process& p) -> double& { return p.leave_one_out_rmse; }},
    Column{"approximation_error", "m", [](Process& p) -> double& { return p.approximation_error; },
           version_with_approximation_error}};

/// The one of all settings whose name an attribute holds.
template <typename Setting, size_t N>
Setting read_name(const hdf5::Reader& reader, const char* attribute,
                  const std::array<Setting, N>& all) {
    const std::string name = reader.text_attribute(attribute);
    for (const Setting setting : all) {
        if (name == to_string(setting)) {
            return setting;
        }
    }
    reader.fail(attribute, fmt::format("is {}, which this taut does not know", quote(name)));
}

/// Files of taut 0.1.0 do not say so: there the mean function and kernel show it.
bool read_as_in_paper(const hdf5::Reader& reader, MeanFunction mean, KernelMetric metric) {
    const bool has_settings = mean == MeanFunction::zero && metric == KernelMetric::isotropic;
    if (!reader.has_attribute("as_in_paper")) {
        return has_settings;
    }
    const std::string as_in_paper = reader.text_attribute("as_in_paper");
    if (as_in_paper == "no") {
        return false;
    }
    if (as_in_paper != "yes" || !has_settings) {
        reader.fail("as_in_paper",
                    fmt::format("is {} of mean function {} and kernel {}, expected \"no\", or "
                                "\"yes\" of zero and isotropic",
                                quote(as_in_paper), to_string(mean), to_string(metric)));
    }
    return true;
}

/// @param spectrum that of the process, or null
std::optional<std::string> contradiction_of(const Process& process,
                                            const KernelSpectrum* spectrum) {
    const double error = process.approximation_error;
    if (error < 0.0) {
        return "is negative";
    }
    if (error > 0.0 && (spectrum == nullptr || spectrum->is_whole())) {
        return fmt::format("is {}, expected 0: it has no spectrum that leaves directions out",
                           error);
    }
    return std::nullopt;
}

void check(const LengthModel& model, const CableNet& net) {
    const FittedProcesses& processes = model.processes;
    const Eigen::Index n = processes.inputs.cols();
    const Eigen::Index m = net.interior_edge_count();
    require_matrix("inputs", processes.inputs, 3 * net.free_node_count(), n);
    require_matrix("weights", processes.weights, n, m);
    require_matrix("input_scales", model.input_scales, 3 * net.free_node_count(), 1);
    require_matrix("length_deviations", model.length_deviations, m, n);
    if (static_cast<Eigen::Index>(processes.processes.size()) != m) {
        throw std::invalid_argument(fmt::format("{} processes, expected {}, one an interior edge",
                                                processes.processes.size(), m));
    }
    if (!model.as_in_paper && (keeps_form_prior(net) || model.form_prior.mean.size() > 0)) {
        require_matrix("form_prior.mean", model.form_prior.mean, model.nominal_form.size(), 1);
        require_matrix("form_prior.variances", model.form_prior.variances,
                       model.nominal_form.size(), 1);
        require_matrix("form_prior.directions", model.form_prior.directions,
                       model.nominal_form.size(), model.nominal_form.size());
    }
    for (const KernelSpectrum& spectrum : processes.spectra) {
        check_spectrum(spectrum, n);
    }
    for (const Process& process : processes.processes) {
        const bool has_spectrum =
            process.spectrum >= 0 && process.spectrum < std::ssize(processes.spectra);
        if (const auto found = contradiction_of(
                process, has_spectrum ? &processes.spectra[process.spectrum] : nullptr)) {
            throw std::invalid_argument(fmt::format("approximation_error {}", *found));
        }
    }
}

void write_processes(hdf5::Writer& writer, std::vector<Process> processes) {
    for (const Column& column : process_columns) {
        Eigen::VectorXd values(static_cast<Eigen::Index>(processes.size()));
        for (size_t j = 0; j < processes.size(); ++j) {
            values(static_cast<Eigen::Index>(j)) = column.of(processes[j]);
        }
        require_matrix(column.name, values, values.size(), 1);
        writer.vector(column.name, values, column.units);
    }
    std::vector<std::uint8_t> codes;
    std::vector<int> spectra;
    for (const Process& process : processes) {
        codes.push_back(static_cast<std::uint8_t>(process.status));
        spectra.push_back(process.spectrum);
    }
    writer.codes("fit_status", codes, meaning_of_codes(fit_statuses));
    writer.integers("spectrum", spectra);
}

std::vector<Process> read_processes(const hdf5::Reader& reader, std::uint64_t version,
                                    Eigen::Index m, int spectrum_count) {
    std::vector<Process> processes(m);
    for (const Column& column : process_columns) {
        if (column.since > version) {
            continue;
        }
        const Eigen::VectorXd values = reader.vector(column.name, m);
        for (size_t j = 0; j < processes.size(); ++j) {
            column.of(processes[j]) = values(static_cast<Eigen::Index>(j));
        }
    }
    const int highest = static_cast<int>(fit_statuses.size()) - 1;
    const std::vector<int> codes = reader.integers("fit_status", m, 0, highest);
    const std::vector<int> spectra = reader.integers("spectrum", m, -1, spectrum_count - 1);
    for (size_t j = 0; j < processes.size(); ++j) {
        processes[j].status = static_cast<FitStatus>(codes[j]);
        processes[j].spectrum = spectra[j];
    }
    return processes;
}

/// What prediction relies on: a fitted process divides by its signal std and uses a spectrum of its
/// own length scale; another one has no spectrum.
void check_processes(const hdf5::Reader& reader, const FittedProcesses& fitted) {
    for (size_t j = 0; j < fitted.processes.size(); ++j) {
        const Process& process = fitted.processes[j];
        const gp::Hyperparameters& theta = process.hyperparameters;
        const bool is_fitted = process.status == FitStatus::fitted;
        if (is_fitted != (process.spectrum >= 0)) {
            reader.fail("spectrum", fmt::format("of process {} is {}, but it is marked as {}", j,
                                                process.spectrum, to_string(process.status)));
        }
        const KernelSpectrum* const spectrum =
            is_fitted ? &fitted.spectra[static_cast<size_t>(process.spectrum)] : nullptr;
        if (const auto found = contradiction_of(process, spectrum)) {
            reader.fail("approximation_error", fmt::format("of process {} {}", j, *found));
        }
        if (!is_fitted) {
            continue;
        }
        if (!(theta.signal_std > 0.0) || !(theta.noise_std > 0.0)) {
            reader.fail(theta.signal_std > 0.0 ? "noise_std" : "signal_std",
                        fmt::format("of process {} is not positive", j));
        }
        if (theta.inverse_length_scale != spectrum->inverse_length_scale) {
            reader.fail("inverse_length_scale",
                        fmt::format("of process {} is {}, expected {} as in its spectrum {}", j,
                                    theta.inverse_length_scale, spectrum->inverse_length_scale,
                                    process.spectrum));
        }
    }
}

/// As it stands in the file, or made anew where that is older.
FormPrior read_form_prior(const hdf5::Reader& reader, std::uint64_t version, const CableNet& net,
                          const LengthModel& model) {
    if (version == version_without_form_prior) {
        return form_prior_of(net, model, model.form_deviations());
    }
    const Eigen::Index coordinates = model.nominal_form.size();
    FormPrior prior{
        .mean = reader.vector("form_prior/mean", coordinates),
        .variances = reader.vector("form_prior/variances", coordinates),
        .directions = reader.matrix("form_prior/directions", coordinates, coordinates).transpose(),
        .inputs = {}};
    if (coordinates > 0 && prior.variances.minCoeff() < 0.0) {
        reader.fail("form_prior/variances", "holds a negative number");
    }
    if (!has_orthonormal_directions(prior)) {
        reader.fail("form_prior/directions", "are not orthonormal");
    }
    return prior;
}

hdf5::Image model_image(const LengthModel& model, const NetFile& net) {
    const FittedProcesses& fitted = model.processes;
    check(model, net.net);
    hdf5::Writer writer;
    write_head(writer,
               {.format = model_format,
                .version = model_version,
                .net_fingerprint = model.net_fingerprint,
                .prior = model.prior,
                .seed = model.seed,
                .uncertain = model.uncertain,
                .nominal_form = model.nominal_form},
               net);
    writer.attribute("mean_function", std::string(to_string(model.mean)));
    writer.attribute("kernel_metric", std::string(to_string(model.metric)));
    writer.attribute("as_in_paper", std::string(model.as_in_paper ? "yes" : "no"));
    writer.vector("input_scales", model.input_scales, "1");
    writer.matrix("training_inputs", fitted.inputs, "m");
    writer.matrix("training_outputs", model.length_deviations, "m");
    writer.matrix("weights", fitted.weights, "m");
    write_processes(writer, fitted.processes);
    if (model.form_prior.mean.size() > 0) {
        writer.group("form_prior");
        writer.vector("form_prior/mean", model.form_prior.mean, "m");
        writer.vector("form_prior/variances", model.form_prior.variances, "m2");
        writer.matrix("form_prior/directions", model.form_prior.directions.transpose(), "1");
    }
    write_spectra(writer, fitted.spectra);
    return writer.finish();
}

}  // namespace

std::string model_bytes(const LengthModel& model, const NetFile& net) {
    return std::string(model_image(model, net).view());
}

void write_model(const std::filesystem::path& path, const LengthModel& model, const NetFile& net) {
    write_file(path, model_image(model, net).view());
}

StoredModel read_model(const std::filesystem::path& path) {
    const hdf5::Reader reader(path, model_format);
    auto [head, file] =
        read_head(reader, model_format, {version_without_form_prior, model_version, model_version});
    const Eigen::Index m = file.net.interior_edge_count();
    const Eigen::Index coordinates = 3 * file.net.free_node_count();
    const Eigen::Index n = reader.row_count("training_inputs", coordinates);
    const bool are_whole = head.version == version_without_form_prior;
    FittedProcesses fitted{.inputs = reader.matrix("training_inputs", coordinates, n),
                           .spectra = read_spectra(reader, n, are_whole),
                           .processes = {},
                           .weights = reader.matrix("weights", n, m)};
    fitted.processes =
        read_processes(reader, head.version, m, static_cast<int>(fitted.spectra.size()));
    check_processes(reader, fitted);
    Eigen::VectorXd scales = reader.vector("input_scales", coordinates);
    if (scales.size() > 0 && !(scales.minCoeff() > 0.0)) {
        reader.fail("input_scales", "holds a number that is not positive");
    }
    const MeanFunction mean = read_name(reader, "mean_function", mean_functions);
    const KernelMetric metric = read_name(reader, "kernel_metric", kernel_metrics);
    LengthModel model{.net_fingerprint = head.net_fingerprint,
                      .prior = head.prior,
                      .seed = head.seed,
                      .uncertain = std::move(head.uncertain),
                      .mean = mean,
                      .metric = metric,
                      .as_in_paper = read_as_in_paper(reader, mean, metric),
                      .nominal_form = std::move(head.nominal_form),
                      .input_scales = std::move(scales),
                      .length_deviations = reader.matrix("training_outputs", m, n),
                      .processes = std::move(fitted),
                      .form_prior = {}};
    if (!model.as_in_paper && keeps_form_prior(file.net)) {
        model.form_prior = read_form_prior(reader, head.version, file.net, model);
        model.form_prior.inputs = inputs_along_directions(model, model.form_prior);
    }
    return {.model = std::move(model), .net = std::move(file), .has_digest = reader.has_digest()};
}

}  // namespace taut
