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
#include "taut/process_group.hpp"

/// How calls share their work among the processes of a group.
namespace taut {

/// Which of the indices from 0 to count - 1 this process works on: every size()th, so that work
/// that grows with the index is shared evenly.
[[nodiscard]] TAUT_CORE_EXPORT std::vector<size_t> share_of(size_t count);

/// The results of all processes, in the order of the indices, on each process.
/// @param mine one result an index of share_of(count), in their order
template <typename Result>
std::vector<Result> all_gather(size_t count, std::vector<Result> mine) {
    if (process_group().size() == 1) {
        return mine;
    }
    Packer packer;
    for (Result& result : mine) {
        packer(result);
    }
    const std::vector<std::string> parts = process_group().gather(packer.take(), Receivers::all);
    std::vector<Unpacker> unpackers(parts.begin(), parts.end());
    std::vector<Result> all(count);
    for (size_t k = 0; k < count; ++k) {
        unpackers[k % unpackers.size()](all[k]);
    }
    return all;
}

/// The first process's value on all processes: for what may differ between them, such as times.
template <typename Value>
Value broadcast(Value value) {
    if (process_group().size() == 1) {
        return value;
    }
    Packer packer;
    if (process_group().is_first()) {
        packer(value);
    }
    const std::vector<std::string> parts = process_group().gather(packer.take(), Receivers::all);
    Unpacker{parts.front()}(value);
    return value;
}

/// Checks that all processes work on the same input: another file of the same name on one machine
/// would spoil the result unnoticed.
/// @param what name of the input, for the message
/// @throws std::runtime_error on all processes if a fingerprint differs from the first process's
TAUT_CORE_EXPORT void require_same(std::string_view what, const std::string& fingerprint);

}  // namespace taut
