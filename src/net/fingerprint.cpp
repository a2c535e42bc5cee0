// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "net/fingerprint.hpp"

#include <fmt/core.h>

namespace taut {
namespace {

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

    [[nodiscard]] std::uint64_t value() const { return m_hash; }

private:
    std::uint64_t m_hash = 0xcbf29ce484222325ULL;
};

}  // namespace

std::string compute_fingerprint(const CableNetData& data) {
    Fnv1a hash;
    hash.add_list(data.nodes);
    hash.add_list(data.supports);
    hash.add_list(data.edges);
    hash.add_list(data.axial_stiffness);
    hash.add_list(data.unstressed_lengths);
    hash.add_list(data.adjustable);
    hash.add_list(data.loads);
    if (!data.tension_law.empty()) {
        hash.add_list(data.tension_law);
        for (const TensionLaw& law : data.tension_laws) {
            hash.add_list(law.strain);
            hash.add_list(law.tension);
        }
    }
    if (data.mass.size() > 0) {
        hash.add_list(data.mass);
    }
    return fmt::format("{:016x}", hash.value());
}

}  // namespace taut
