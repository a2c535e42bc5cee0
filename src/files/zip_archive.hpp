// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taut {

/// A ZIP archive in memory. It unpacks 32 MiB in all, so that a small file stays small.
class ZipArchive {
public:
    /// @param bytes and @param file_name for messages; both outlive the archive
    /// @throws InputError for what is no whole archive
    ZipArchive(std::string_view bytes, const std::string& file_name);

    /// A file of the archive; nothing where it is not there.
    /// @throws InputError for one that is encrypted or damaged, and beyond 32 MiB
    [[nodiscard]] std::optional<std::string> part(const std::string& name);

private:
    struct Close {
        void operator()(void* archive) const;
    };

    [[noreturn]] void fail(const std::string& what) const;

    const std::string& m_file_name;
    std::shared_ptr<void> m_file;  ///< what minizip reads
    std::unique_ptr<void, Close> m_archive;
    size_t m_unpacked = 0;
};

/// A ZIP archive of files (name, content), the same for the same files.
[[nodiscard]] std::string zip_bytes(const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace taut
