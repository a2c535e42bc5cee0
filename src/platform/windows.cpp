// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <aclapi.h>
#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <cerrno>
#include <codecvt>
#include <locale>
#include <memory>
#include <string>
#include <type_traits>

#include "platform/platform.hpp"

// std::filesystem::path takes narrow names by this facet of libstdc++, whose own knows no character
// beyond those of one byte here: Windows' first C library has no UTF-8. These functions stand in
// their place.
namespace std {
namespace {

constexpr int longest = 4;  // of a character in UTF-8 [bytes]

const codecvt_utf8_utf16<wchar_t>& utf8() {
    static const codecvt_utf8_utf16<wchar_t> facet(1);
    return facet;
}

}  // namespace

using WideNames = codecvt<wchar_t, char, mbstate_t>;

codecvt_base::result WideNames::do_out(state_type& state, const intern_type* from,
                                       const intern_type* from_end, const intern_type*& from_next,
                                       extern_type* to, extern_type* to_end,
                                       extern_type*& to_next) const {
    return utf8().out(state, from, from_end, from_next, to, to_end, to_next);
}

codecvt_base::result WideNames::do_in(state_type& state, const extern_type* from,
                                      const extern_type* from_end, const extern_type*& from_next,
                                      intern_type* to, intern_type* to_end,
                                      intern_type*& to_next) const {
    return utf8().in(state, from, from_end, from_next, to, to_end, to_next);
}

int WideNames::do_length(state_type& state, const extern_type* from, const extern_type* end,
                         size_t most) const {
    return utf8().length(state, from, end, most);
}

int WideNames::do_encoding() const noexcept {
    return 0;  // of several lengths
}

int WideNames::do_max_length() const noexcept {
    return longest;
}

}  // namespace std

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

/// A file that is written may be removed meanwhile, as when the program is interrupted.
std::FILE* open_stream(const std::filesystem::path& path, const char* mode) {
    if (*mode == 'r') {
        return _wfopen(path.c_str(), std::filesystem::path(mode).c_str());
    }
    Handle file = open(path, GENERIC_WRITE, CREATE_ALWAYS);
    if (!file) {
        errno = error_of(GetLastError()).default_error_condition().value();
        return nullptr;
    }
    const int number = _open_osfhandle(reinterpret_cast<intptr_t>(file.get()), _O_BINARY);
    if (number < 0) {
        return nullptr;
    }
    static_cast<void>(file.release());
    return _fdopen(number, mode);
}

std::error_code make_new_file(const std::filesystem::path& path) {
    return open(path, GENERIC_WRITE, CREATE_NEW) ? std::error_code() : error_of(GetLastError());
}

bool is_writable(const std::filesystem::path& path) {
    const DWORD attributes = GetFileAttributesW(path.c_str());
    if (attributes == INVALID_FILE_ATTRIBUTES || (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0) {
        return attributes != INVALID_FILE_ATTRIBUTES;
    }
    return (attributes & FILE_ATTRIBUTE_READONLY) == 0 &&
           (open(path, GENERIC_WRITE, OPEN_EXISTING) || GetLastError() == ERROR_SHARING_VIOLATION);
}

namespace {

/// Whether a list of access rights has any that a new file in that folder would not inherit.
bool has_own_rights(PSECURITY_DESCRIPTOR descriptor, PACL list) {
    SECURITY_DESCRIPTOR_CONTROL control = 0;
    DWORD revision = 0;
    if (GetSecurityDescriptorControl(descriptor, &control, &revision) != 0 &&
        (control & SE_DACL_PROTECTED) != 0) {
        return true;
    }
    for (DWORD i = 0; list != nullptr && i < list->AceCount; ++i) {
        void* entry = nullptr;
        if (GetAce(list, i, &entry) != 0 &&
            (static_cast<ACE_HEADER*>(entry)->AceFlags & INHERITED_ACE) == 0) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::error_code copy_access(const std::filesystem::path& from, const std::filesystem::path& to) {
    PACL list = nullptr;
    PSECURITY_DESCRIPTOR descriptor = nullptr;
    DWORD error = GetNamedSecurityInfoW(from.c_str(), SE_FILE_OBJECT, DACL_SECURITY_INFORMATION,
                                        nullptr, nullptr, &list, nullptr, &descriptor);
    if (error == ERROR_SUCCESS) {
        if (has_own_rights(descriptor, list)) {
            std::wstring name = to.native();
            error = SetNamedSecurityInfoW(name.data(), SE_FILE_OBJECT, DACL_SECURITY_INFORMATION,
                                          nullptr, nullptr, list, nullptr);
        }
        LocalFree(descriptor);
    }
    // Not every file system keeps such lists.
    return error == ERROR_SUCCESS || error == ERROR_NOT_SUPPORTED ? std::error_code()
                                                                  : error_of(error);
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
