// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string>
#include <utility>

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

bool can_map(double bytes) {
    const auto is_limited = [](auto resource) {
        rlimit limit{};
        return getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    };
    if (!is_limited(RLIMIT_AS) && !is_limited(RLIMIT_DATA)) {
        return true;
    }
    const auto size = static_cast<size_t>(bytes);
    void* const place =
        mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (place == MAP_FAILED) {
        return false;
    }
    munmap(place, size);
    return true;
}

void prefer_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] size_t bytes) {
#if defined(MADV_HUGEPAGE)
    madvise(memory, bytes, MADV_HUGEPAGE);
#endif
}

long process_id() {
    return getpid();
}

bool process_runs(long process) {
    return kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM;
}

std::error_code make_new_file(const std::filesystem::path& path) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0) {
        return last_error();
    }
    close(file);
    return {};
}

#ifdef O_TMPFILE
NamelessFile::NamelessFile(const std::filesystem::path& directory)
    : m_descriptor(open(directory.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666)) {
    // Without /proc it could be given no name.
    if (valid() && access(path().c_str(), W_OK) != 0) {
        close(std::exchange(m_descriptor, -1));
    }
}
#else
NamelessFile::NamelessFile(const std::filesystem::path& /*directory*/) {}
#endif

NamelessFile::~NamelessFile() {
    if (valid()) {
        close(m_descriptor);
    }
}

std::filesystem::path NamelessFile::path() const {
    return "/proc/self/fd/" + std::to_string(m_descriptor);
}

std::error_code NamelessFile::give_name(const std::filesystem::path& name) const {
    return linkat(AT_FDCWD, path().c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0
               ? std::error_code()
               : last_error();
}

std::error_code flush_file(const std::filesystem::path& path) {
    return flush(path, O_RDWR);
}

std::error_code flush_directory(const std::filesystem::path& path) {
    return flush(path, O_RDONLY | O_DIRECTORY);
}

}  // namespace taut::platform
