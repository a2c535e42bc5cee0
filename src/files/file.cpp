// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/files/file.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <deque>
#include <system_error>

#include "files/message.hpp"
#include "files/open_file.hpp"
#include "files/output_places.hpp"
#include "platform/platform.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

void write_content(AtomicFile& file, const std::filesystem::path& name, std::string_view content) {
    const File stream(platform::open_stream(file.temporary(), "wb"));
    if (!stream || std::fwrite(content.data(), 1, content.size(), stream.get()) < content.size() ||
        std::fflush(stream.get()) != 0) {
        throw OutputError(name, "cannot be written: " + error_text(errno));
    }
    file.flush();
}

/// Makes a directory and those above it, and removes again those it made, as far as they are empty,
/// unless they are to be kept.
class NewDirectories {
public:
    explicit NewDirectories(const std::filesystem::path& directory) {
        std::error_code error;
        for (std::filesystem::path path = follow_links(directory);
             !path.empty() && !exists(path, error) && path != path.parent_path();
             path = follow_links(path.parent_path())) {
            m_made.push_back(path);
        }
        for (auto path = m_made.rbegin(); path != m_made.rend() && !error; ++path) {
            create_directory(*path, error);
        }
        if (error || !is_directory(directory, error)) {
            remove();
            throw OutputError(directory, "cannot be made as a directory: " +
                                             (error ? error.message() : "it is a file"));
        }
    }
    ~NewDirectories() { remove(); }
    NewDirectories(const NewDirectories&) = delete;
    NewDirectories& operator=(const NewDirectories&) = delete;
    NewDirectories(NewDirectories&&) = delete;
    NewDirectories& operator=(NewDirectories&&) = delete;

    void keep() { m_made.clear(); }

private:
    void remove() {
        std::error_code ignored;
        for (const std::filesystem::path& path : m_made) {
            std::filesystem::remove(path, ignored);
        }
    }
    std::vector<std::filesystem::path> m_made;  ///< deepest first
};

}  // namespace

File open_file(const std::filesystem::path& path) {
    std::error_code error;
    if (is_directory(path, error)) {
        throw InputError(path.string(), "", "is a directory, expected a file");
    }
    File file(platform::open_stream(path, "rb"));
    if (!file) {
        const int failure = errno;
        const std::string problem = "cannot be read: " + error_text(failure);
        if (failure == ENOENT) {
            throw MissingInputError(path.string(), "", problem);
        }
        throw InputError(path.string(), "", problem);
    }
    return file;
}

std::string read_file(const std::filesystem::path& path) {
    constexpr size_t largest = size_t{1} << 28U;
    const File file = open_file(path);
    std::string content;
    std::string buffer(size_t{1} << 16U, '\0');
    while (const size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
        content.append(buffer, 0, count);
        if (content.size() > largest) {
            throw InputError(path.string(), "", "is larger than 256 MiB");
        }
    }
    if (std::ferror(file.get()) != 0) {
        throw InputError(path.string(), "", "cannot be read: " + error_text(errno));
    }
    return content;
}

bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code error;
    if (std::filesystem::equivalent(a, b, error)) {
        return true;
    }
    // Neither needs to be there yet, nor what a link leads to. Made absolute first: else "a" and
    // "./a" stay two names.
    const auto place = [&error](const std::filesystem::path& path) {
        return std::filesystem::weakly_canonical(
            std::filesystem::absolute(follow_links(path), error), error);
    };
    const std::filesystem::path place_of_a = place(a);
    return !place_of_a.empty() && place_of_a == place(b);
}

void write_file(const std::filesystem::path& path, std::string_view content) {
    AtomicFile file(path);
    write_content(file, path, content);
    file.commit();
}

void write_files(const std::vector<std::pair<std::filesystem::path, std::string>>& files) {
    for (size_t i = 0; i < files.size(); ++i) {
        for (size_t k = 0; k < i; ++k) {
            if (is_same_file(files[i].first, files[k].first)) {
                throw std::invalid_argument("file " + quote(files[i].first.string()) +
                                            " comes twice, expected each to be written once");
            }
        }
    }
    std::deque<AtomicFile> outputs;
    for (const auto& [path, content] : files) {
        write_content(outputs.emplace_back(path), path, content);
    }
    const auto lock = lock_output_places();
    for (size_t i = 0; i < outputs.size(); ++i) {
        try {
            outputs[i].commit();
        } catch (const OutputError& error) {
            if (i == 0) {
                throw;
            }
            throw OutputError(error, fmt::format("{} of {} outputs are new", i, outputs.size()));
        }
    }
}

void write_files(const std::filesystem::path& directory,
                 const std::vector<std::pair<std::string, std::string>>& files) {
    std::vector<std::pair<std::filesystem::path, std::string>> paths;
    for (const auto& [name, content] : files) {
        if (name.empty() || std::filesystem::path(name).filename() != name || name == "." ||
            name == "..") {
            throw std::invalid_argument("file name " + quote(name) +
                                        ", expected a name without path");
        }
        paths.emplace_back(directory / name, content);
    }
    NewDirectories made(directory);
    write_files(paths);
    made.keep();
}

}  // namespace taut
