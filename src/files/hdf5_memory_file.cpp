// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/hdf5_memory_file.hpp"

#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>
#include <utility>

namespace taut::hdf5 {
namespace {

/// The address where the file ends, out of a superblock of version 2 (HDF5 file format, II.A.).
size_t end_of_file(const unsigned char* bytes) {
    constexpr int offset = 28;
    std::uint64_t end = 0;
    for (int k = 7; k >= 0; --k) {
        end = end << 8U | bytes[offset + k];
    }
    return end;
}

}  // namespace

void Image::append(std::string_view more) {
    void* longer = std::realloc(m_bytes.get(), m_size + more.size());
    if (longer == nullptr) {
        throw std::bad_alloc();
    }
    static_cast<void>(m_bytes.release());
    m_bytes.reset(static_cast<unsigned char*>(longer));
    std::memcpy(m_bytes.get() + m_size, more.data(), more.size());
    m_size += more.size();
}

/// What HDF5 asks for its memory. The image that H5Fget_file_image() gives of an open file has a
/// superblock whose checksum is wrong (1.10.8), so the bytes are taken over when the file is
/// closed.
struct ImageCallbacks {
    static void* allocate(size_t size, H5FD_file_image_op_t /*op*/, void* /*file*/) {
        return std::malloc(size);
    }
    static void* copy(void* to, const void* from, size_t size, H5FD_file_image_op_t /*op*/,
                      void* /*file*/) {
        return std::memcpy(to, from, size);
    }
    static void* reallocate(void* memory, size_t size, H5FD_file_image_op_t /*op*/,
                            void* /*file*/) {
        return std::realloc(memory, size);
    }
    static herr_t release(void* memory, H5FD_file_image_op_t op, void* file) {
        if (op == H5FD_FILE_IMAGE_OP_FILE_CLOSE) {
            auto* bytes = static_cast<unsigned char*>(memory);
            static_cast<MemoryFile*>(file)->m_left = Image(bytes, end_of_file(bytes));
        } else {
            std::free(memory);
        }
        return 0;
    }
    static void* share(void* file) { return file; }
    static herr_t unshare(void* /*file*/) { return 0; }

    static H5FD_file_image_callbacks_t all(MemoryFile* file) {
        return {.image_malloc = allocate,
                .image_memcpy = copy,
                .image_realloc = reallocate,
                .image_free = release,
                .udata_copy = share,
                .udata_free = unshare,
                .udata = file};
    }
};

Handle checked(hid_t id, Handle::Close close) {
    if (id < 0) {
        throw std::runtime_error("HDF5 cannot make an object in memory");
    }
    return {id, close};
}

void check(herr_t status) {
    if (status < 0) {
        throw std::runtime_error("HDF5 cannot store data in memory");
    }
}

namespace {

Handle create(const Handle& creation, MemoryFile* file) {
    silence_errors();
    constexpr size_t growth = size_t{1} << 20U;
    const Handle access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    check(H5Pset_fapl_core(access.get(), growth, /*backing_store=*/0));
    H5FD_file_image_callbacks_t callbacks = ImageCallbacks::all(file);
    check(H5Pset_file_image_callbacks(access.get(), &callbacks));
    check(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V18, H5F_LIBVER_V18));
    return checked(H5Fcreate("taut", H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose);
}

}  // namespace

MemoryFile::MemoryFile(const Handle& creation) : m_file(create(creation, this)) {}

Image MemoryFile::finish() {
    check(m_file.close());
    return std::move(m_left);
}

}  // namespace taut::hdf5
