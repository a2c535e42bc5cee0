// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stdexcept>

#include "files/open_file.hpp"
#include "taut/files/input_error.hpp"

/// In place of HDF5, where taut was built without it (TAUT_WITH_HDF5).
namespace taut::hdf5 {

[[noreturn]] inline void refuse_reading(const std::filesystem::path& path) {
    static_cast<void>(open_file(path));  // throws in the system's words where it cannot be opened
    throw InputError(path.string(), "", "cannot be read: this taut was built without HDF5");
}

[[noreturn]] inline void refuse_writing() {
    throw std::invalid_argument(
        "this taut was built without HDF5, which keeps data sets, models and posterior samples");
}

}  // namespace taut::hdf5
