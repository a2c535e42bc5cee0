// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/error.hpp"

#include <array>
#include <new>
#include <stdexcept>

namespace taut {

Error::~Error() = default;

std::string_view to_string(ErrorCode code) {
    static constexpr auto names = std::to_array<std::string_view>(
        {"argument", "net", "survey", "request", "failed_identification", "input_file",
         "missing_file", "output_file", "no_solution", "interrupted", "out_of_memory", "peer",
         "other"});
    static_assert(names.size() == static_cast<size_t>(ErrorCode::other) + 1);
    return names.at(static_cast<size_t>(code));
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
