// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/zip_archive.hpp"

#include <fmt/core.h>
#include <unzip.h>
#include <zip.h>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>

#include "taut/files/input_error.hpp"

namespace taut {
namespace {

constexpr size_t most_unpacked = size_t{32} << 20U;
constexpr size_t most_parts = 10'000;

/// What minizip reads, and writes, instead of a file.
struct MemoryFile {
    std::string_view content = {};
    std::string written = {};
    size_t at = 0;

    [[nodiscard]] size_t size() const { return std::max(content.size(), written.size()); }
};

MemoryFile& of_stream(void* stream) {
    return *static_cast<MemoryFile*>(stream);
}

// What minizip calls throws nothing through it.

void* opened(void* file, const void* /*name*/, int /*mode*/) {
    return file;
}

uLong read_stream(void* /*opaque*/, void* stream, void* into, uLong size) {
    MemoryFile& file = of_stream(stream);
    const size_t count = file.at < file.content.size()
                             ? file.content.copy(static_cast<char*>(into), size, file.at)
                             : 0;
    file.at += count;
    return static_cast<uLong>(count);
}

uLong write_stream(void* /*opaque*/, void* stream, const void* from, uLong size) {
    MemoryFile& file = of_stream(stream);
    try {
        file.written.replace(file.at, size, static_cast<const char*>(from), size);
    } catch (const std::bad_alloc&) {
        return 0;
    }
    file.at += size;
    return size;
}

ZPOS64_T place_in_stream(void* /*opaque*/, void* stream) {
    return of_stream(stream).at;
}

/// @return 0, or -1 for a place outside
long seek_in_stream(void* /*opaque*/, void* stream, ZPOS64_T offset, int origin) {
    MemoryFile& file = of_stream(stream);
    const ZPOS64_T start = origin == ZLIB_FILEFUNC_SEEK_CUR   ? file.at
                           : origin == ZLIB_FILEFUNC_SEEK_END ? file.size()
                                                              : 0;
    const ZPOS64_T place = start + offset;  // which wraps around where the offset is negative
    if (place > file.size()) {
        return -1;
    }
    file.at = static_cast<size_t>(place);
    return 0;
}

/// Nothing is to be closed, and no error is kept.
int succeed(void* /*opaque*/, void* /*stream*/) {
    return 0;
}

zlib_filefunc64_def functions_of(MemoryFile& file) {
    return {.zopen64_file = opened,
            .zread_file = read_stream,
            .zwrite_file = write_stream,
            .ztell64_file = place_in_stream,
            .zseek64_file = seek_in_stream,
            .zclose_file = succeed,
            .zerror_file = succeed,
            .opaque = &file};
}

}  // namespace

void ZipArchive::Close::operator()(void* archive) const {
    unzClose(archive);
}

ZipArchive::ZipArchive(std::string_view bytes, const std::string& file_name)
    : m_file_name(file_name) {
    const auto file = std::make_shared<MemoryFile>(MemoryFile{.content = bytes});
    m_file = file;
    zlib_filefunc64_def functions = functions_of(*file);
    m_archive.reset(unzOpen2_64("", &functions));
    unz_global_info64 info{};
    if (!m_archive || unzGetGlobalInfo64(m_archive.get(), &info) != UNZ_OK) {
        fail("is a ZIP archive, as xlsx files are, that is damaged: is the file whole?");
    }
    if (info.number_entry > most_parts) {
        fail(fmt::format("is a ZIP archive of more than {} files, expected an xlsx file",
                         most_parts));
    }
}

std::optional<std::string> ZipArchive::part(const std::string& name) {
    constexpr int with_case = 1;
    if (unzLocateFile(m_archive.get(), name.c_str(), with_case) != UNZ_OK) {
        return std::nullopt;
    }
    constexpr unsigned long encrypted = 1;
    unz_file_info64 info{};
    const int found =
        unzGetCurrentFileInfo64(m_archive.get(), &info, nullptr, 0, nullptr, 0, nullptr, 0);
    if (found == UNZ_OK && (info.flag & encrypted) != 0) {
        fail("is encrypted: save it without a password");
    }
    std::string content;
    std::string buffer(size_t{1} << 16U, '\0');
    int count = found == UNZ_OK ? unzOpenCurrentFile(m_archive.get()) : found;
    if (count == UNZ_OK) {
        while ((count = unzReadCurrentFile(m_archive.get(), buffer.data(),
                                           static_cast<unsigned>(buffer.size()))) > 0) {
            content.append(buffer, 0, static_cast<size_t>(count));
            m_unpacked += static_cast<size_t>(count);
            if (m_unpacked > most_unpacked) {
                fail(fmt::format("is larger than {} MiB when unpacked", most_unpacked >> 20U));
            }
        }
        const int closed = unzCloseCurrentFile(m_archive.get());
        count = count == UNZ_OK ? closed : count;
    }
    if (count != UNZ_OK) {
        fail(fmt::format("its part {} is damaged: is the file whole?", name));
    }
    return content;
}

std::string zip_bytes(const std::vector<std::pair<std::string, std::string>>& files) {
    MemoryFile file;
    zlib_filefunc64_def functions = functions_of(file);
    zipFile zip = zipOpen2_64("", APPEND_STATUS_CREATE, nullptr, &functions);
    bool is_good = zip != nullptr;
    for (const auto& [name, content] : files) {
        zip_fileinfo info{};
        info.dosDate = 0x00210000;  // 1980-01-01, the first
        is_good = is_good &&
                  zipOpenNewFileInZip64(zip, name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr,
                                        Z_DEFLATED, Z_DEFAULT_COMPRESSION, 0) == ZIP_OK &&
                  zipWriteInFileInZip(zip, content.data(), static_cast<unsigned>(content.size())) ==
                      ZIP_OK &&
                  zipCloseFileInZip(zip) == ZIP_OK;
    }
    if (zip != nullptr) {
        is_good = zipClose(zip, nullptr) == ZIP_OK && is_good;
    }
    if (!is_good) {
        throw std::runtime_error("a ZIP archive cannot be made in memory");
    }
    return std::move(file.written);
}

void ZipArchive::fail(const std::string& what) const {
    throw InputError(m_file_name, "", what);
}

}  // namespace taut
