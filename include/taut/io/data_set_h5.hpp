// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "taut/export/io.hpp"
#include "taut/io/net_json.hpp"
#include "taut/sampling/data_set.hpp"

namespace taut {

/// A data set and the net it was drawn from, as they stand in one file.
struct StoredDataSet {
    DataSet data;  ///< drawn from `net`
    NetFile net;   ///< with the keys that taut does not know
    /// Whether the file holds a digest of its content, which was checked. Files up to taut 0.2.0 do
    /// not: of these damage may go unnoticed.
    bool has_digest = true;
};

/// Writes a data set as HDF5, whole or not at all; the same data give the same bytes. Attributes of
/// the root: format "taut-data-set", version 2, prior, seed, net_fingerprint. Datasets (n samples):
///
///     net                           the net as JSON text (net_to_json())
///     free_nodes, interior_edges    [n_I], [m_I]: node and edge of each point and deviation
///     nominal_form                  [3 n_I] [m]
///     form_deviation                [n, 3 n_I] [m]: a row a sample, x1, y1, z1, x2, ...
///     length_deviation              [n, m_I] [m]
///     status                        [n]: code of the EquilibriumStatus
///     slack_edges                   [n]: number of slack edges
///
/// Not for two threads at the same time, as all that uses HDF5.
/// @throws std::invalid_argument where data and net do not belong together (both fingerprints are
///   named), their sizes differ or a number is not finite
/// @throws OutputError where the file cannot be written
TAUT_IO_EXPORT void write_data_set(const std::filesystem::path& path, const DataSet& data,
                                   const NetFile& net);

/// The content of such a file. Not for two threads at the same time, likewise.
/// @throws std::invalid_argument as write_data_set()
/// @throws std::runtime_error where there is no memory for it
[[nodiscard]] TAUT_IO_EXPORT std::string data_set_bytes(const DataSet& data, const NetFile& net);

/// Reads what write_data_set() wrote, to the last bit. Every size is checked against the net inside
/// and the size of the file before anything is allocated. Not for two threads at the same time,
/// likewise.
/// @throws InputError naming the file and the HDF5 object
[[nodiscard]] TAUT_IO_EXPORT StoredDataSet read_data_set(const std::filesystem::path& path);

}  // namespace taut
