// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "taut/export/core.hpp"

/// What the standard library does not offer: one source a platform, posix.cpp for Linux and macOS,
/// windows.cpp, and wasi.cpp for WebAssembly.
namespace taut::platform {

/// Of the machine [bytes].
[[nodiscard]] TAUT_CORE_EXPORT double physical_memory();

/// Whether so much more can be mapped. True where the address space of the process has no limit.
[[nodiscard]] TAUT_CORE_EXPORT bool can_map(double bytes);

/// Asks for large pages behind an aligned part of memory that was not touched yet, where the system
/// has them.
TAUT_CORE_EXPORT void prefer_large_pages(void* memory, std::size_t bytes);

[[nodiscard]] TAUT_CORE_EXPORT long process_id();

/// Whether there is a process of that number on this machine.
[[nodiscard]] TAUT_CORE_EXPORT bool process_runs(long process);

/// As std::fopen(), whatever characters names have on the system.
[[nodiscard]] TAUT_CORE_EXPORT std::FILE* open_stream(const std::filesystem::path& path,
                                                      const char* mode);

/// Makes an empty file with the mode that any new file gets.
/// @return the error, such as std::errc::file_exists
[[nodiscard]] TAUT_CORE_EXPORT std::error_code make_new_file(const std::filesystem::path& path);

/// Whether a file may be written to, by its mode. Without any write bit not even by the superuser,
/// although the system would allow that.
[[nodiscard]] TAUT_CORE_EXPORT bool is_writable(const std::filesystem::path& path);

/// Gives a file the access rights of another: its mode and, where the system allows that, its
/// owner, group and access control list. Where the group cannot be kept, the group's rights are cut
/// down to those of all others.
[[nodiscard]] TAUT_CORE_EXPORT std::error_code copy_access(const std::filesystem::path& from,
                                                           const std::filesystem::path& to);

/// A file in a directory's file system that has no name until it is given one: a process that ends
/// leaves nothing of it behind.
class TAUT_CORE_EXPORT NamelessFile {
public:
    /// Makes one, where the system and the file system can: see valid(). It has the mode that any
    /// new file gets.
    explicit NamelessFile(const std::filesystem::path& directory);
    ~NamelessFile();
    NamelessFile(const NamelessFile&) = delete;
    NamelessFile& operator=(const NamelessFile&) = delete;
    NamelessFile(NamelessFile&&) = delete;
    NamelessFile& operator=(NamelessFile&&) = delete;

    [[nodiscard]] bool valid() const { return m_descriptor >= 0; }
    /// A name by which it can be opened as long as this object lives.
    [[nodiscard]] std::filesystem::path path() const;
    /// @param name in that directory, of no other file
    [[nodiscard]] std::error_code give_name(const std::filesystem::path& name) const;

private:
    int m_descriptor = -1;
};

/// Waits until a file's content, or a directory's entries, are on the disk.
[[nodiscard]] TAUT_CORE_EXPORT std::error_code flush_file(const std::filesystem::path& path);
[[nodiscard]] TAUT_CORE_EXPORT std::error_code flush_directory(const std::filesystem::path& path);

}  // namespace taut::platform
