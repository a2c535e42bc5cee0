// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

#include <utility>

/// The little of HDF5's C interface that taut needs, with owners for its identifiers.
namespace taut::hdf5 {

/// Owns an identifier of HDF5, and closes it as its kind is closed.
class Handle {
public:
    using Close = herr_t (*)(hid_t);
    Handle(hid_t id, Close close_id) : m_id(id), m_close(close_id) {}
    ~Handle() { close(); }
    Handle(Handle&& other) noexcept
        : m_id(std::exchange(other.m_id, H5I_INVALID_HID)), m_close(other.m_close) {}
    Handle& operator=(Handle&&) = delete;
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    /// Closes it before its time, to see whether that fails.
    herr_t close() { return valid() ? m_close(std::exchange(m_id, H5I_INVALID_HID)) : 0; }

    [[nodiscard]] bool valid() const { return m_id >= 0; }
    [[nodiscard]] hid_t get() const { return m_id; }

private:
    hid_t m_id;
    Close m_close;
};

/// Of the root of a file that Writer made: its last line is a digest.
inline constexpr const char* digest_attribute = "digest";

/// Keeps HDF5 from printing errors of its own, from now on. The printing is not switched on again:
/// where a damaged file was met, the exit handler of HDF5 1.10 would then find no end, and say so.
inline void silence_errors() {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace taut::hdf5
