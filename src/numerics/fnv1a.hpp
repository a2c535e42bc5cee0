// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/core.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace taut {

/// FNV-1a, 64 bit (Fowler, Noll, Vo; parameters of the reference page).
class Fnv1a {
public:
    template <typename T>
    void add(const T* values, size_t count) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(values);
        for (size_t i = 0; i < count * sizeof(T); ++i) {
            m_hash = (m_hash ^ bytes[i]) * 0x100000001b3ULL;
        }
    }

    /// The sizes go in too, so that values cannot move from one list to the next unnoticed.
    template <typename List>
    void add_list(const List& list) {
        const auto size = static_cast<std::uint64_t>(list.size());
        add(&size, 1);
        add(list.data(), list.size());
    }

    /// 16 hexadecimal digits.
    [[nodiscard]] std::string text() const { return fmt::format("{:016x}", m_hash); }

private:
    std::uint64_t m_hash = 0xcbf29ce484222325ULL;
};

}  // namespace taut
