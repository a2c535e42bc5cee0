// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "platform/platform.hpp"

namespace taut::platform {
namespace {

std::error_code last_error() {
    return {errno, std::generic_category()};
}

std::error_code flush(const std::filesystem::path& path, int flags) {
    const int file = open(path.c_str(), flags | O_CLOEXEC);
    if (file < 0) {
        return last_error();
    }
    const std::error_code error = fsync(file) == 0 ? std::error_code() : last_error();
    close(file);
    return error;
}

}  // namespace

double physical_memory() {
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
           static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

long process_id() {
    return getpid();
}

std::error_code make_new_file(const std::filesystem::path& path) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0) {
        return last_error();
    }
    close(file);
    return {};
}

std::error_code flush_file(const std::filesystem::path& path) {
    return flush(path, O_RDWR);
}

std::error_code flush_directory(const std::filesystem::path& path) {
    return flush(path, O_RDONLY | O_DIRECTORY);
}

}  // namespace taut::platform
