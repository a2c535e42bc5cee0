// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// For systems on which each file has a name.
#include "platform/platform.hpp"

namespace taut::platform {

NamelessFile::NamelessFile(const std::filesystem::path& /*directory*/) {}

NamelessFile::~NamelessFile() = default;

std::filesystem::path NamelessFile::path() const {
    return {};
}

std::error_code NamelessFile::give_name(const std::filesystem::path& /*name*/) const {
    return std::make_error_code(std::errc::function_not_supported);
}

}  // namespace taut::platform
