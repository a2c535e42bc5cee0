// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "packed.hpp"
#include "taut/export/core.hpp"
#include "taut/team.hpp"

/// How calls share their work among a team.
namespace taut {

/// Which of the indices from 0 to count - 1 are this process's: every size()th, so that work
/// that grows with the index is spread.
[[nodiscard]] TAUT_CORE_EXPORT std::vector<size_t> share_of(size_t count);

/// What all processes made of their shares, in the order of the indices, on each of them.
/// @param mine of each index of share_of(count), in their order
template <typename Result>
std::vector<Result> gathered(size_t count, std::vector<Result> mine) {
    if (team().size() == 1) {
        return mine;
    }
    Packer packer;
    for (Result& result : mine) {
        packer(result);
    }
    const std::vector<std::string> parts = team().gather(packer.take(), Receivers::all);
    std::vector<Unpacker> unpackers(parts.begin(), parts.end());
    std::vector<Result> all(count);
    for (size_t k = 0; k < count; ++k) {
        unpackers[k % unpackers.size()](all[k]);
    }
    return all;
}

/// The first process's value, on all: of what may differ between them, as times do.
template <typename Value>
Value broadcast_from_first(Value value) {
    if (team().size() == 1) {
        return value;
    }
    Packer packer;
    if (team().is_first()) {
        packer(value);
    }
    const std::vector<std::string> parts = team().gather(packer.take(), Receivers::all);
    Unpacker{parts.front()}(value);
    return value;
}

/// Makes sure that all processes work on the same: a file that is another one on another machine
/// would spoil the outcome unnoticed.
/// @param what in words
/// @throws std::runtime_error on all processes where a fingerprint is not the first's
TAUT_CORE_EXPORT void require_same(std::string_view what, const std::string& fingerprint);

}  // namespace taut
