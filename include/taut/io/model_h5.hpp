// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "taut/export/io.hpp"
#include "taut/identification/model.hpp"
#include "taut/io/net_json.hpp"

namespace taut {

/// A trained model and the net it was trained for, as they stand in one file.
struct StoredModel {
    LengthModel model;  ///< trained for `net`
    NetFile net;        ///< with the keys that taut does not know
    /// Whether the file holds a digest of its content, which was checked. Files up to taut 0.2.0 do
    /// not: of these damage may go unnoticed.
    bool has_digest = true;
};

/// Writes a model as HDF5, whole or not at all; the same model gives the same bytes. Attributes of
/// the root: format "taut-model", version 4, prior, seed, net_fingerprint. Datasets (n training
/// samples):
///
///     net                            the net as JSON text (net_to_json())
///     free_nodes, interior_edges     [n_I], [m_I]: node and edge of each point and process
///     nominal_form                   [3 n_I] [m]
///     training_inputs                [n, 3 n_I] [m]: form deviations, a row a sample
///     weights                        [m_I, n] [m]: gp::FittedProcesses::weights
///     inverse_length_scale           [m_I] [1/m]
///     signal_std, noise_std          [m_I] [m]
///     negative_log_likelihood        [m_I]
///     leave_one_out_rmse             [m_I] [m]
///     approximation_error            [m_I] [m]: gp::Process::approximation_error
///     fit_status                     [m_I]: code of the gp::FitStatus
///     spectrum                       [m_I]: k of the group spectra/k, or -1 where not fitted
///     form_prior/mean                [3 n_I] [m]: FormPrior; not of a model as in the
///                                    paper, nor of a net of more than 1,000 free nodes
///     form_prior/variances           [3 n_I] [m2]
///     form_prior/directions          [3 n_I, 3 n_I]: a row a direction
///     spectra/k/inverse_length_scale one number [1/m]
///     spectra/k/eigenvalues          [r], 1 <= r <= n
///     spectra/k/eigenvectors         [r, n]: a row an eigenvector
///     spectra/k/tail_mean            one number: gp::KernelSpectrum; 0 where r = n
///     spectra/k/tail_largest         one number, not below tail_mean; 0 where r = n
///
/// Not for two threads at the same time, as all that uses HDF5.
/// @throws std::invalid_argument where model and net do not belong together (both fingerprints are
///   named), their sizes differ or a number is not finite
/// @throws OutputError where the file cannot be written
TAUT_IO_EXPORT void write_model(const std::filesystem::path& path, const LengthModel& model,
                                const NetFile& net);

/// The content of such a file. Not for two threads at the same time, likewise.
/// @throws std::invalid_argument as write_model()
/// @throws std::runtime_error where there is no memory for it
[[nodiscard]] TAUT_IO_EXPORT std::string model_bytes(const LengthModel& model, const NetFile& net);

/// Reads what write_model() wrote: predicts to the last bit as before. Version 2 has no form prior,
/// which is then made anew, and whole spectra only. Every size is checked
/// against the net inside and the size of the file before anything is allocated. Not for two
/// threads at the same time, likewise.
/// @throws InputError naming the file and the HDF5 object
[[nodiscard]] TAUT_IO_EXPORT StoredModel read_model(const std::filesystem::path& path);

}  // namespace taut
