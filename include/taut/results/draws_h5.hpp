// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "taut/export/io.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Whether taut was built with HDF5, so that draws_bytes() and read_draws() work.
[[nodiscard]] TAUT_IO_EXPORT bool keeps_draws();

/// The posterior samples of an identification as an HDF5 file, "taut-draws", one sample per row:
///
///     length_deviation [draws, m_I]   m, of the edges in `edge`
///     form             [draws, 3 n_I] m, x1,y1,z1,x2,... of the nodes in `node`
///     tension          [draws, m]     N, of all edges
///
/// and, where these are uncertain, adjustable_deviation [draws, m_A], stiffness_perturbation and
/// thermal_perturbation [draws, m], support_perturbation [draws, 3 n_S], load_perturbation
/// [draws, 3 n_I], as in PosteriorDraws. Attributes hold the fingerprint of the net, the prior, the
/// seed and how they were drawn. Not for two threads at the same time, as all that uses HDF5.
/// @param identification of this net, which is not checked
/// @throws std::invalid_argument where the identification has no samples
[[nodiscard]] TAUT_IO_EXPORT std::string draws_bytes(const CableNet& net,
                                                     const Identification& identification);

/// The file of the samples of a result: beside it, "result_draws.h5" of "result.json".
[[nodiscard]] TAUT_IO_EXPORT std::filesystem::path draws_path(const std::filesystem::path& result);

/// Hash of the samples, 16 hexadecimal digits. A result holds it, so that samples of another are
/// not taken for its own.
[[nodiscard]] TAUT_IO_EXPORT std::string fingerprint_of(const PosteriorDraws& draws);

/// Reads what draws_bytes() wrote, or version 1 of it. Not for two threads at the same time.
/// @throws InputError as all readers of HDF5, for samples of another net, for lengths that are not
///   positive, and for perturbations larger than any uncertainty
[[nodiscard]] TAUT_IO_EXPORT PosteriorDraws read_draws(const CableNet& net,
                                                       const std::filesystem::path& path);

}  // namespace taut
