// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/error.hpp"

#include <new>
#include <stdexcept>

namespace taut {

Error::~Error() = default;

std::string_view to_string(ErrorCode code) {
    switch (code) {
        case ErrorCode::argument:
            return "argument";
        case ErrorCode::net:
            return "net";
        case ErrorCode::survey:
            return "survey";
        case ErrorCode::request:
            return "request";
        case ErrorCode::failed_identification:
            return "failed_identification";
        case ErrorCode::input_file:
            return "input_file";
        case ErrorCode::missing_file:
            return "missing_file";
        case ErrorCode::output_file:
            return "output_file";
        case ErrorCode::no_solution:
            return "no_solution";
        case ErrorCode::interrupted:
            return "interrupted";
        case ErrorCode::out_of_memory:
            return "out_of_memory";
        case ErrorCode::peer:
            return "peer";
        case ErrorCode::other:
            break;
    }
    return "other";
}

ErrorCode error_code(const std::exception& error) noexcept {
    if (const auto* own = dynamic_cast<const Error*>(&error)) {
        return own->code();
    }
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
        return ErrorCode::out_of_memory;
    }
    return dynamic_cast<const std::logic_error*>(&error) != nullptr ? ErrorCode::argument
                                                                    : ErrorCode::other;
}

}  // namespace taut
