// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "files/hdf5_memory_file.hpp"

namespace taut::hdf5 {

/// Makes an HDF5 file in memory. The same calls give the same bytes: no times are stored. Arrays
/// carry checksums (Fletcher), which every reader of HDF5 looks at, and most metadata (the format
/// of HDF5 1.8); a line behind the end of what HDF5 reads holds the digest of all before it, which
/// Reader looks at. All members throw std::runtime_error where HDF5 fails, which leaves it to
/// running out of memory.
class Writer {
public:
    Writer();

    /// Attributes of the root.
    void attribute(const std::string& name, const std::string& text);
    void attribute(const std::string& name, std::uint64_t number);

    void group(const std::string& name);
    /// A single text.
    void text(const std::string& name, const std::string& text);
    /// A single number. Units "1" where it has none, here and below.
    void number(const std::string& name, double value, const std::string& units);
    /// [n]
    void vector(const std::string& name, const Eigen::VectorXd& values, const std::string& units);
    /// [cols, rows]: a column of ours, which lies together in memory, is a row of the file.
    void matrix(const std::string& name, const Eigen::MatrixXd& values, const std::string& units);
    /// [n]
    void integers(const std::string& name, const std::vector<int>& values);
    /// [n], one byte each, with an attribute that says what each code means.
    void codes(const std::string& name, const std::vector<std::uint8_t>& codes,
               const std::string& meaning);

    /// Ends the writing, and gives the file's bytes.
    [[nodiscard]] Image finish();

private:
    Handle dataset(const std::string& name, const std::vector<hsize_t>& shape, hid_t stored_type,
                   hid_t memory_type, const void* data);
    static void write_attribute(hid_t object, const std::string& name, const std::string& text);

    MemoryFile m_file;
};

}  // namespace taut::hdf5
