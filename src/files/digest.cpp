// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/digest.hpp"

#include <algorithm>

#include "files/open_file.hpp"
#include "numerics/fnv1a.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

constexpr std::string_view label = "\ndigest fnv1a64 ";
constexpr size_t digits = 16;
constexpr size_t line_size = label.size() + digits + 1;

std::string line_of(const Fnv1a& hash) {
    return std::string(label) + hash.text() + "\n";
}

}  // namespace

std::string digest_line(std::string_view content) {
    Fnv1a hash;
    hash.add(content.data(), content.size());
    return line_of(hash);
}

bool check_digest(const std::filesystem::path& path) {
    const File file = open_file(path);
    if (!std::filesystem::is_regular_file(path)) {
        throw InputError(path.string(), "", "is a device or pipe, expected a file");
    }
    Fnv1a hash;
    // What was read and is not hashed yet: its end may be the line.
    std::string pending;
    std::string buffer(size_t{1} << 20U, '\0');
    while (const size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
        pending.append(buffer, 0, count);
        const size_t certain = pending.size() - std::min(pending.size(), line_size);
        hash.add(pending.data(), certain);
        pending.erase(0, certain);
    }
    if (std::ferror(file.get()) != 0) {
        throw InputError(path.string(), "", "cannot be read");
    }
    if (!pending.starts_with(label) || pending.size() != line_size || !pending.ends_with('\n')) {
        return false;
    }
    if (pending != line_of(hash)) {
        throw InputError(path.string(), "",
                         "is damaged: its content does not match the digest in its last line");
    }
    return true;
}

}  // namespace taut
