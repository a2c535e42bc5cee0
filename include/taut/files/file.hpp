// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "taut/abi.hpp"
#include "taut/error.hpp"
#include "taut/export/io.hpp"

namespace taut {

/// A file that cannot be written. The message is one line that names it.
class TAUT_IO_EXPORT OutputError : public std::runtime_error, public Error {
public:
    [[nodiscard]] ErrorCode code() const noexcept override {
        return ErrorCode::output_file;
    }  ///< Error
    /// @param what is wrong
    OutputError(const std::filesystem::path& file, const std::string& what);
    /// The same with what else is to be known.
    OutputError(const OutputError& error, const std::string& note);
};

/// The whole content of a file.
/// @throws InputError where it is missing, a directory, unreadable or larger than 256 MiB
[[nodiscard]] TAUT_IO_EXPORT std::string read_file(const std::filesystem::path& path);

/// Whether two names lead to one file, or would if it were there.
[[nodiscard]] TAUT_IO_EXPORT bool is_same_file(const std::filesystem::path& a,
                                               const std::filesystem::path& b);

/// An output that stands in its place whole or not at all: it is written to a temporary file in the
/// same directory, which commit() puts in the place of the target. The temporary file has no name
/// where the file system allows that, so that a process that is killed leaves nothing behind; else
/// it is called ".NAME.PROCESS-NUMBER.tmp". A target that is a symbolic link keeps being one, and
/// what it leads to is written. A target that is replaced keeps its access rights: its mode, and
/// its owner, group and access control list where the system allows that.
class TAUT_IO_EXPORT AtomicFile {
public:
    /// Makes the temporary file, empty.
    /// @throws OutputError where the target is anything but a regular file or nothing yet, is
    ///   read-only or cannot keep its access rights, or its directory does not exist or cannot be
    ///   written to
    explicit AtomicFile(const std::filesystem::path& target);
    /// Removes the temporary file if it was not committed.
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    AtomicFile(AtomicFile&&) = delete;
    AtomicFile& operator=(AtomicFile&&) = delete;

    /// Where to write, until commit(): a name by which this process can open the file.
    [[nodiscard]] const std::filesystem::path& temporary() const { return m_temporary; }

    /// Waits until the temporary file is on the disk. Nothing may be written to it after that.
    /// @throws OutputError where that fails
    void flush();

    /// Puts the temporary file in the place of the target, after flush() where that was not called.
    /// Once an object; what writes to the temporary file must be closed or flushed before.
    /// @throws OutputError where that fails; the target is then as it was
    void commit();

private:
    void remove_temporary();

    struct State;
    std::filesystem::path m_given;   ///< the target as given, for messages
    std::filesystem::path m_target;  ///< what it leads to
    std::filesystem::path m_temporary;
    std::unique_ptr<State> m_state;
};

/// Temporary files of a target that processes of this machine left behind which are no longer
/// there: a killed process leaves one where the file system needs a name, or if it was just
/// renaming. They hold nothing that anybody needs.
[[nodiscard]] TAUT_IO_EXPORT std::vector<std::filesystem::path> left_temporary_files(
    const std::filesystem::path& target);

/// Removes all temporary files of this process that have a name and were not committed, and lets no
/// output be put in its place from now on; where several are just being put in their places it
/// waits until all are. For a program that is to end at once, from any thread but not from a
/// signal's handler.
TAUT_IO_EXPORT void remove_temporary_files();

/// Writes a file whole or not at all.
/// @throws OutputError where that fails; the file is then as it was
TAUT_IO_EXPORT void write_file(const std::filesystem::path& path, std::string_view content);

/// Writes files (path, content). All of them are on the disk under temporary names before the first
/// takes its place, so that a failure until then leaves everything as it was.
/// @throws OutputError where one cannot be written or put in its place; in the second case those
///   before it are in theirs, which the message says
/// @throws std::invalid_argument for a path that comes twice
TAUT_IO_EXPORT void write_files(
    const std::vector<std::pair<std::filesystem::path, std::string>>& files);

/// The same for files (name, content) in a directory, which it makes if needed.
/// @throws OutputError where one cannot be written or put in its place, or the directory not be
///   made
/// @throws std::invalid_argument for a name that is empty, comes twice or leads out of the
///   directory
TAUT_IO_EXPORT void write_files(const std::filesystem::path& directory,
                                const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace taut
