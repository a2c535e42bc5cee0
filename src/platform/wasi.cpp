// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// WebAssembly: one process, whose files are in memory and gone with it.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "platform/platform.hpp"

namespace taut::platform {

double physical_memory() {
    return 4.0 * 1024.0 * 1024.0 * 1024.0;  // what 32 bits address
}

bool can_map(double /*bytes*/) {
    return true;
}

void prefer_large_pages(void* /*memory*/, size_t /*bytes*/) {}

long process_id() {
    return 1;
}

bool process_runs(long /*process*/) {
    return true;
}

std::FILE* open_stream(const std::filesystem::path& path, const char* mode) {
    return std::fopen(path.c_str(), mode);
}

std::error_code make_new_file(const std::filesystem::path& path) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0666);
    if (file < 0) {
        return {errno, std::generic_category()};
    }
    close(file);
    return {};
}

bool is_writable(const std::filesystem::path& /*path*/) {
    return true;
}

std::error_code copy_access(const std::filesystem::path& /*from*/,
                            const std::filesystem::path& /*to*/) {
    return {};
}

std::error_code flush_file(const std::filesystem::path& /*path*/) {
    return {};
}

std::error_code flush_directory(const std::filesystem::path& /*path*/) {
    return {};
}

}  // namespace taut::platform
