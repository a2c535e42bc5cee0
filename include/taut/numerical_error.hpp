// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

#include "taut/abi.hpp"
#include "taut/error.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// Valid numbers have no result: an equilibrium was not found, or the statics are singular. Trials
/// count it as an outcome. A lack of memory or threads is another exception, and ends them.
class TAUT_CORE_EXPORT NumericalError : public std::runtime_error, public Error {
public:
    using std::runtime_error::runtime_error;
    [[nodiscard]] ErrorCode code() const noexcept override {
        return ErrorCode::no_solution;
    }  ///< Error
};

}  // namespace taut
