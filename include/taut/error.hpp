// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <string_view>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// What went wrong, for a program to branch on; what() of the exception says it to people.
enum class ErrorCode {
    argument,               ///< a wrong argument: std::invalid_argument, std::out_of_range
    net,                    ///< NetError
    survey,                 ///< SurveyError, EpochError
    request,                ///< RequestError, of a plan
    failed_identification,  ///< FailedIdentification: no plan is made from it
    input_file,             ///< InputError
    missing_file,           ///< MissingInputError
    output_file,            ///< OutputError
    no_solution,            ///< NumericalError: no equilibrium, or singular statics
    interrupted,            ///< Interrupted: a stop was requested
    out_of_memory,          ///< std::bad_alloc
    peer,                   ///< PeerFailed: another process of the group
    other,                  ///< none of these
};

/// "argument", "net", "survey", "request", "failed_identification", "input_file", "missing_file",
/// "output_file", "no_solution", "interrupted", "out_of_memory", "peer", "other".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(ErrorCode code);

/// What all exceptions of taut's own have besides what they are of the standard library.
class TAUT_CORE_EXPORT Error {
public:
    virtual ~Error();
    [[nodiscard]] virtual ErrorCode code() const noexcept = 0;  ///< which it is

protected:
    Error() = default;
    Error(const Error&) = default;             ///< as exceptions are
    Error& operator=(const Error&) = default;  ///< likewise
};

/// The code of any exception that a call of taut throws.
[[nodiscard]] TAUT_CORE_EXPORT ErrorCode error_code(const std::exception& error) noexcept;

}  // namespace taut
