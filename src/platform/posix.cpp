// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/xattr.h>
#endif

#include <cerrno>
#include <csignal>
#include <string>
#include <utility>
#include <vector>

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

#if defined(__linux__)
/// Extended attribute that holds the access control list of a file.
constexpr const char* access_list = "system.posix_acl_access";

/// A new file inherits a list from its directory, which may let in more.
void remove_access_list(const char* file) {
    removexattr(file, access_list);
}

std::error_code copy_access_list(const char* from, const char* to) {
    const ssize_t size = getxattr(from, access_list, nullptr, 0);
    if (size <= 0) {
        remove_access_list(to);
        return {};
    }
    std::vector<char> list(static_cast<size_t>(size));
    const ssize_t read = getxattr(from, access_list, list.data(), list.size());
    if (read < 0 || setxattr(to, access_list, list.data(), static_cast<size_t>(read), 0) != 0) {
        return last_error();
    }
    return {};
}
#else
void remove_access_list(const char* /*file*/) {}

std::error_code copy_access_list(const char* /*from*/, const char* /*to*/) {
    return {};
}
#endif

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

std::FILE* open_stream(const std::filesystem::path& path, const char* mode) {
    return std::fopen(path.c_str(), mode);
}

std::error_code make_new_file(const std::filesystem::path& path) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0) {
        return last_error();
    }
    close(file);
    return {};
}

bool is_writable(const std::filesystem::path& path) {
    struct stat status{};
    return stat(path.c_str(), &status) == 0 &&
           (status.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) != 0 && access(path.c_str(), W_OK) == 0;
}

std::error_code copy_access(const std::filesystem::path& from, const std::filesystem::path& to) {
    struct stat wanted{};
    struct stat found{};
    if (stat(from.c_str(), &wanted) != 0 || stat(to.c_str(), &found) != 0) {
        return last_error();
    }
    mode_t mode = wanted.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
    const bool has_owner = wanted.st_uid == found.st_uid && wanted.st_gid == found.st_gid;
    if (!has_owner && chown(to.c_str(), wanted.st_uid, wanted.st_gid) != 0 &&
        wanted.st_gid != found.st_gid &&
        chown(to.c_str(), static_cast<uid_t>(-1), wanted.st_gid) != 0) {
        remove_access_list(to.c_str());
        const mode_t of_others = (mode & S_IRWXO) << 3U;
        mode &= ~static_cast<mode_t>(S_IRWXG) | of_others;
        return chmod(to.c_str(), mode) == 0 ? std::error_code() : last_error();
    }
    if (const std::error_code error = copy_access_list(from.c_str(), to.c_str())) {
        return error;
    }
    if (stat(to.c_str(), &found) == 0 && (found.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO)) == mode) {
        return {};  // some file systems have one mode for all files, and refuse to set it
    }
    return chmod(to.c_str(), mode) == 0 ? std::error_code() : last_error();
}

#ifdef O_TMPFILE
NamelessFile::NamelessFile(const std::filesystem::path& directory)
    : m_descriptor(open(directory.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666)) {
    // give_name() needs /proc.
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
    return flush(path, O_WRONLY);
}

std::error_code flush_directory(const std::filesystem::path& path) {
    return flush(path, O_RDONLY | O_DIRECTORY);
}

}  // namespace taut::platform
