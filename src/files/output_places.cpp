// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/output_places.hpp"

#include <set>
#include <system_error>

#include "taut/files/file.hpp"

namespace taut {
namespace {

// A program can end without memory before its own objects are made, and after: so one that is made
// by the compiler, and a pointer that leads to nothing until there is something.
std::recursive_mutex places_mutex;
std::set<std::filesystem::path>* temporaries = nullptr;

}  // namespace

std::filesystem::path follow_links(std::filesystem::path path) {
    constexpr int most_links = 40;  // as Linux
    std::error_code error;
    for (int i = 0; i < most_links && is_symlink(path, error); ++i) {
        // Of a relative link the directory of the link counts; an absolute one takes its place.
        path = path.parent_path() / read_symlink(path, error);
    }
    return path;
}

std::unique_lock<std::recursive_mutex> lock_output_places() {
    return std::unique_lock(places_mutex);
}

void remember_temporary(const std::filesystem::path& path) {
    if (temporaries == nullptr) {
        temporaries = new std::set<std::filesystem::path>;
    }
    temporaries->insert(path);
}

void forget_temporary(const std::filesystem::path& path) {
    if (temporaries != nullptr) {
        temporaries->erase(path);
    }
}

void remove_temporary_files() {
    // Not unlocked again: who waits for it to put an output in its place waits for the end.
    static_cast<void>(lock_output_places().release());
    if (temporaries == nullptr) {
        return;
    }
    std::error_code ignored;
    for (const std::filesystem::path& path : *temporaries) {
        std::filesystem::remove(path, ignored);
    }
}

}  // namespace taut
