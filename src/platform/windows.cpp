// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#define NOMINMAX
#define WIN32_LEAN_AND_MEAN
#include <aclapi.h>
#include <windows.h>

#include <memory>
#include <type_traits>

#include "platform/platform.hpp"

namespace taut::platform {
namespace {

std::error_code error_of(DWORD number) {
    return {static_cast<int>(number), std::system_category()};
}

struct CloseHandleOnce {
    void operator()(HANDLE handle) const { CloseHandle(handle); }
};
using Handle = std::unique_ptr<std::remove_pointer_t<HANDLE>, CloseHandleOnce>;

/// Null where it cannot be opened; others may read, write and delete it meanwhile.
Handle open(const std::filesystem::path& path, DWORD access, DWORD disposition) {
    constexpr DWORD shared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
    const HANDLE file = CreateFileW(path.c_str(), access, shared, nullptr, disposition,
                                    FILE_ATTRIBUTE_NORMAL, nullptr);
    return Handle(file == INVALID_HANDLE_VALUE ? nullptr : file);
}

}  // namespace

double physical_memory() {
    MEMORYSTATUSEX status{};
    status.dwLength = sizeof status;
    GlobalMemoryStatusEx(&status);
    return static_cast<double>(status.ullTotalPhys);
}

bool can_map(double /*bytes*/) {
    return true;
}

void prefer_large_pages(void* /*memory*/, size_t /*bytes*/) {}

long process_id() {
    return static_cast<long>(GetCurrentProcessId());
}

bool process_runs(long process) {
    const Handle handle(
        OpenProcess(PROCESS_QUERY_LIMITED_INFORMATION, FALSE, static_cast<DWORD>(process)));
    if (!handle) {
        return GetLastError() == ERROR_ACCESS_DENIED;
    }
    DWORD code = 0;
    return GetExitCodeProcess(handle.get(), &code) != 0 && code == STILL_ACTIVE;
}

std::FILE* open_stream(const std::filesystem::path& path, const char* mode) {
    return _wfopen(path.c_str(), std::filesystem::path(mode).c_str());
}

std::error_code make_new_file(const std::filesystem::path& path) {
    return open(path, GENERIC_WRITE, CREATE_NEW) ? std::error_code() : error_of(GetLastError());
}

bool is_writable(const std::filesystem::path& path) {
    const DWORD attributes = GetFileAttributesW(path.c_str());
    return attributes != INVALID_FILE_ATTRIBUTES && ((attributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ||
                                                     ((attributes & FILE_ATTRIBUTE_READONLY) == 0 &&
                                                      open(path, GENERIC_WRITE, OPEN_EXISTING)));
}

std::error_code copy_access(const std::filesystem::path& from, const std::filesystem::path& to) {
    PACL list = nullptr;
    PSECURITY_DESCRIPTOR descriptor = nullptr;
    DWORD error = GetNamedSecurityInfoW(from.c_str(), SE_FILE_OBJECT, DACL_SECURITY_INFORMATION,
                                        nullptr, nullptr, &list, nullptr, &descriptor);
    if (error == ERROR_SUCCESS) {
        std::wstring name = to.native();
        error = SetNamedSecurityInfoW(name.data(), SE_FILE_OBJECT, DACL_SECURITY_INFORMATION,
                                      nullptr, nullptr, list, nullptr);
        LocalFree(descriptor);
    }
    // Not every file system keeps such lists.
    return error == ERROR_SUCCESS || error == ERROR_NOT_SUPPORTED ? std::error_code()
                                                                  : error_of(error);
}

NamelessFile::NamelessFile(const std::filesystem::path& /*directory*/) {}

NamelessFile::~NamelessFile() = default;

std::filesystem::path NamelessFile::path() const {
    return {};
}

std::error_code NamelessFile::give_name(const std::filesystem::path& /*name*/) const {
    return std::make_error_code(std::errc::function_not_supported);
}

std::error_code flush_file(const std::filesystem::path& path) {
    const Handle file = open(path, GENERIC_WRITE, OPEN_EXISTING);
    return file && FlushFileBuffers(file.get()) != 0 ? std::error_code() : error_of(GetLastError());
}

/// The system keeps the order of changes of a directory itself.
std::error_code flush_directory(const std::filesystem::path& /*path*/) {
    return {};
}

}  // namespace taut::platform
