// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <atomic>
#include <system_error>

#include "files/message.hpp"
#include "platform/platform.hpp"
#include "taut/files/file.hpp"

namespace taut {
namespace {

/// The file that a target stands for: where it is a symbolic link, what that leads to.
std::filesystem::path resolve_target(const std::filesystem::path& target) {
    std::error_code error;
    std::filesystem::path resolved =
        is_symlink(target, error) ? weakly_canonical(target, error) : target;
    const std::filesystem::file_status status = std::filesystem::status(resolved, error);
    if (is_directory(status)) {
        throw OutputError(target, "is a directory, expected a file");
    }
    if (exists(status) && !is_regular_file(status)) {
        throw OutputError(target, "is a device or pipe, expected a file that can be replaced");
    }
    if (!resolved.has_filename()) {
        throw OutputError(target, "has no file name");
    }
    return resolved;
}

/// Makes a file of a name that no other process or thread uses. Its mode is what any new file gets.
std::filesystem::path make_temporary(const std::filesystem::path& target) {
    static std::atomic<unsigned> counter{0};
    constexpr size_t longest = 200;  // of the 255 bytes that a name may have
    for (;;) {
        std::filesystem::path temporary = target;
        temporary.replace_filename(fmt::format(".{}.{}-{}.tmp",
                                               target.filename().string().substr(0, longest),
                                               platform::process_id(), counter++));
        const std::error_code error = platform::make_new_file(temporary);
        if (!error) {
            return temporary;
        }
        if (error != std::errc::file_exists) {
            throw OutputError(target, "cannot be written: " + error.message());
        }
    }
}

}  // namespace

OutputError::OutputError(const std::filesystem::path& file, const std::string& what)
    : std::runtime_error(printable(fmt::format("{}: {}", file.string(), what))) {}

AtomicFile::AtomicFile(const std::filesystem::path& target)
    : m_target(resolve_target(target)), m_temporary(make_temporary(m_target)) {}

AtomicFile::~AtomicFile() {
    if (!m_committed) {
        std::error_code ignored;
        std::filesystem::remove(m_temporary, ignored);
    }
}

void AtomicFile::commit() {
    std::error_code error = platform::flush_file(m_temporary);
    if (error) {
        throw OutputError(m_target, "cannot be flushed to the disk: " + error.message());
    }
    std::filesystem::rename(m_temporary, m_target, error);
    if (error) {
        throw OutputError(m_target, "cannot be put in its place: " + error.message());
    }
    m_committed = true;
    // The file is whole and in its place by now. Some file systems cannot flush a directory; what
    // is at stake is only which of the two whole files a power cut leaves.
    const std::filesystem::path directory = m_target.parent_path();
    error = platform::flush_directory(directory.empty() ? "." : directory);
}

}  // namespace taut
