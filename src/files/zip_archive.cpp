// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/zip_archive.hpp"

#include <fmt/core.h>
#include <unzip.h>
#include <zip.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "taut/files/input_error.hpp"

namespace taut {
namespace {

constexpr size_t most_unpacked = size_t{32} << 20U;
constexpr size_t most_parts = 10'000;

/// Opens the bytes where minizip would open a file.
void* open_bytes(void* bytes, const void* /*name*/, int /*mode*/) {
    const auto& text = *static_cast<const std::string_view*>(bytes);
    return fmemopen(const_cast<char*>(text.data()), text.size(), "rb");
}

/// What is written instead of a file.
struct Written {
    char* data = nullptr;
    size_t size = 0;

    Written() = default;
    ~Written() { std::free(data); }
    Written(const Written&) = delete;
    Written& operator=(const Written&) = delete;
    Written(Written&&) = delete;
    Written& operator=(Written&&) = delete;
};

void* open_written(void* written, const void* /*name*/, int /*mode*/) {
    auto& into = *static_cast<Written*>(written);
    return open_memstream(&into.data, &into.size);
}

}  // namespace

void ZipArchive::Close::operator()(void* archive) const {
    unzClose(archive);
}

ZipArchive::ZipArchive(std::string_view bytes, const std::string& file_name)
    : m_bytes(bytes), m_file_name(file_name) {
    zlib_filefunc64_def functions;
    fill_fopen64_filefunc(&functions);
    functions.zopen64_file = open_bytes;
    functions.opaque = &m_bytes;
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
    Written written;
    zlib_filefunc64_def functions;
    fill_fopen64_filefunc(&functions);
    functions.zopen64_file = open_written;
    functions.opaque = &written;
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
    return {written.data, written.size};
}

void ZipArchive::fail(const std::string& what) const {
    throw InputError(m_file_name, "", what);
}

}  // namespace taut
