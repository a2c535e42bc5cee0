// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <memory>
#include <string>

#include "files/hdf5.hpp"

namespace taut::hdf5 {

/// Throws std::runtime_error where HDF5 fails at an object in memory: there is no room for it.
Handle checked(hid_t id, Handle::Close close);
void check(herr_t status);

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
    [[nodiscard]] std::string finish();

private:
    struct Free {
        void operator()(void* memory) const { std::free(memory); }
    };
    /// What HDF5 leaves behind when it closes the file.
    std::unique_ptr<unsigned char, Free> m_bytes;
    Handle m_file;

    friend struct ImageCallbacks;
};

}  // namespace taut::hdf5
