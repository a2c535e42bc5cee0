// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include "taut/abi.hpp"
#include "taut/error.hpp"
#include "taut/export/io.hpp"

namespace taut {

/// A file that cannot be read as what it should be. The message is one line, `file: what` or
/// `file:place: what`, whatever bytes the file holds.
class TAUT_IO_EXPORT InputError : public std::runtime_error, public Error {
public:
    [[nodiscard]] ErrorCode code() const noexcept override {
        return ErrorCode::input_file;
    }  ///< Error
    /// @param file its name, as the user knows it
    /// @param place line ("12"), line and column ("12:5"), JSON pointer ("/edges/3") or HDF5 object
    ///   ("form_deviation"); may be empty
    /// @param what is wrong, and what was expected
    InputError(const std::string& file, const std::string& place, const std::string& what);
};

/// A file that is not there.
class TAUT_IO_EXPORT MissingInputError : public InputError {
public:
    using InputError::InputError;
    [[nodiscard]] ErrorCode code() const noexcept override {
        return ErrorCode::missing_file;
    }  ///< Error
};

}  // namespace taut
