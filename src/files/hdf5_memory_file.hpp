// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <memory>
#include <string_view>

#include "files/hdf5.hpp"

namespace taut::hdf5 {

/// Throws std::runtime_error where HDF5 fails at an object in memory: there is no room for it.
Handle checked(hid_t id, Handle::Close close);
void check(herr_t status);

/// The bytes of a file, where HDF5 left them: a data set may take most of the memory there is.
class Image {
public:
    /// @param bytes of malloc()
    Image(unsigned char* bytes, size_t size) : m_bytes(bytes), m_size(size) {}

    /// @throws std::bad_alloc
    void append(std::string_view more);

    [[nodiscard]] std::string_view view() const {
        return {reinterpret_cast<const char*>(m_bytes.get()), m_size};
    }

private:
    struct Free {
        void operator()(void* memory) const { std::free(memory); }
    };
    std::unique_ptr<unsigned char, Free> m_bytes;
    size_t m_size;
};

/// An HDF5 file in memory. Not on the disk, because HDF5 1.10 crashes where a write fails (a full
/// disk): this way it never gets to see that.
class MemoryFile {
public:
    /// @param creation properties of the file
    explicit MemoryFile(const Handle& creation);
    ~MemoryFile() = default;
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    MemoryFile(MemoryFile&&) = delete;
    MemoryFile& operator=(MemoryFile&&) = delete;

    [[nodiscard]] hid_t get() const { return m_file.get(); }

    /// Closes the file, whose objects must be closed before, and gives its bytes.
    [[nodiscard]] Image finish();

private:
    Image m_left{nullptr, 0};  ///< by HDF5 when it closes the file
    Handle m_file;

    friend struct ImageCallbacks;
};

}  // namespace taut::hdf5
