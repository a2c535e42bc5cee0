// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

#include "files/message.hpp"
#include "files/output_places.hpp"
#include "platform/platform.hpp"
#include "taut/files/file.hpp"
#include "taut/files/printable.hpp"

namespace taut {
namespace {

/// The file that a target stands for: where it is a symbolic link, what that leads to.
std::filesystem::path resolve_target(const std::filesystem::path& target) {
    std::error_code error;
    std::filesystem::path resolved = follow_links(target);
    const std::filesystem::file_status status = std::filesystem::status(resolved, error);
    if (is_symlink(resolved, error)) {
        throw OutputError(target, "is a symbolic link that leads to itself");
    }
    if (is_directory(status)) {
        throw OutputError(target, "is a directory, expected a file");
    }
    if (exists(status) && !is_regular_file(status)) {
        throw OutputError(target, "is a device or pipe, expected a file that can be replaced");
    }
    if (!resolved.has_filename()) {
        throw OutputError(target, "has no file name");
    }
    if (exists(status) && !platform::is_writable(resolved)) {
        throw OutputError(target, "is read-only, expected a file that may be replaced");
    }
    return resolved;
}

std::filesystem::path directory_of(const std::filesystem::path& file) {
    const std::filesystem::path directory = file.parent_path();
    return directory.empty() ? "." : directory;
}

/// How the names of a target's temporary files begin. The name of a file has at most 255 bytes; no
/// character is cut.
std::string temporary_prefix(const std::filesystem::path& target) {
    const std::string name = target.filename().string();
    size_t length = std::min<size_t>(name.size(), 200);
    const auto goes_on = [&](char byte) { return (static_cast<unsigned>(byte) & 0xC0U) == 0x80U; };
    while (length > 0 && length < name.size() && goes_on(name[length])) {
        --length;
    }
    return fmt::format(".{}.", name.substr(0, length));
}

/// The process of "PROCESS-NUMBER.tmp"; 0 of any other text.
long process_of_temporary(std::string_view text) {
    const char* const end = text.data() + text.size();
    long process = 0;
    unsigned number = 0;
    const auto [dash, no_process] = std::from_chars(text.data(), end, process);
    if (no_process != std::errc() || dash == end || *dash != '-') {
        return 0;
    }
    const auto [rest, no_number] = std::from_chars(dash + 1, end, number);
    return no_number == std::errc() && std::string_view(rest, end) == ".tmp" ? process : 0;
}

/// Makes a file beside the target, of a name that no other process or thread uses, which is removed
/// with those of remember_temporary().
/// @param make makes a file of a name, or returns why it cannot
template <class Make>
std::filesystem::path make_beside(const std::filesystem::path& target,
                                  const std::filesystem::path& given, const Make& make) {
    static std::atomic<unsigned> counter{0};
    const auto lock = lock_output_places();
    for (;;) {
        std::filesystem::path name = target;
        name.replace_filename(fmt::format("{}{}-{}.tmp", temporary_prefix(target),
                                          platform::process_id(), counter++));
        remember_temporary(name);  // before it is there: this asks for memory
        const std::error_code error = make(name);
        if (!error) {
            return name;
        }
        forget_temporary(name);
        if (error != std::errc::file_exists) {
            throw OutputError(given, "cannot be written: " + error.message());
        }
    }
}

}  // namespace

OutputError::OutputError(const std::filesystem::path& file, const std::string& what)
    : std::runtime_error(printable(fmt::format("{}: {}", file.string(), what))) {}
OutputError::OutputError(const OutputError& error, const std::string& note)
    : std::runtime_error(printable(fmt::format("{}; {}", error.what(), note))) {}

struct AtomicFile::State {
    explicit State(const std::filesystem::path& directory) : nameless(directory) {}

    platform::NamelessFile nameless;
    bool has_name = false;    ///< m_temporary is to be removed
    bool is_flushed = false;  ///< and nothing was written since
};

AtomicFile::AtomicFile(const std::filesystem::path& target)
    : m_given(target),
      m_target(resolve_target(target)),
      m_state(std::make_unique<State>(directory_of(m_target))) {
    if (m_state->nameless.valid()) {
        m_temporary = m_state->nameless.path();
    } else {
        m_temporary = make_beside(m_target, m_given, platform::make_new_file);
        m_state->has_name = true;
    }
    // While it is empty: what nobody else may read was never to be read.
    std::error_code none;
    if (exists(m_target, none)) {
        if (const std::error_code error = platform::copy_access(m_target, m_temporary)) {
            remove_temporary();
            throw OutputError(target,
                              "cannot be replaced with its access rights: " + error.message());
        }
    }
}

AtomicFile::~AtomicFile() {
    remove_temporary();
}

void AtomicFile::remove_temporary() {
    if (m_state->has_name) {
        const auto lock = lock_output_places();
        std::error_code ignored;
        std::filesystem::remove(m_temporary, ignored);
        forget_temporary(m_temporary);
    }
}

void AtomicFile::flush() {
    if (const std::error_code error = platform::flush_file(m_temporary)) {
        throw OutputError(m_given, "cannot be flushed to the disk: " + error.message());
    }
    m_state->is_flushed = true;
}

void AtomicFile::commit() {
    if (!m_state->is_flushed) {
        flush();
    }
    const auto lock = lock_output_places();
    std::error_code error;
    if (m_state->nameless.valid()) {
        // A name that is not taken yet is given at once; what is there can be replaced by a file
        // with a name alone.
        const auto give = [this](const std::filesystem::path& name) {
            return m_state->nameless.give_name(name);
        };
        if (!exists(symlink_status(m_target, error)) && !give(m_target)) {
            error = platform::flush_directory(directory_of(m_target));
            return;
        }
        m_temporary = make_beside(m_target, m_given, give);
        m_state->has_name = true;
    }
    std::filesystem::rename(m_temporary, m_target, error);
    if (error) {
        throw OutputError(m_given, "cannot be put in its place: " + error.message());
    }
    forget_temporary(m_temporary);
    m_state->has_name = false;
    // The file is whole and in its place by now. Some file systems cannot flush a directory; what
    // is at stake is only which of the two whole files a power cut leaves.
    error = platform::flush_directory(directory_of(m_target));
}

std::vector<std::filesystem::path> left_temporary_files(const std::filesystem::path& target) {
    const std::filesystem::path file = follow_links(target);
    const std::string prefix = temporary_prefix(file);
    const std::filesystem::path beginning(prefix);
    std::vector<std::filesystem::path> left;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(directory_of(file), error), end;
         !error && entry != end; entry.increment(error)) {
        // Windows has names that are no text: those of others are not asked for it.
        if (!entry->path().filename().native().starts_with(beginning.native())) {
            continue;
        }
        const std::string name = entry->path().filename().string();
        const long process = process_of_temporary(std::string_view(name).substr(prefix.size()));
        if (process > 0 && !platform::process_runs(process)) {
            left.push_back(entry->path());
        }
    }
    std::ranges::sort(left);
    return left;
}

}  // namespace taut
