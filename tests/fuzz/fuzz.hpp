// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "taut/files/input_error.hpp"
#include "taut/interchange/net_import.hpp"

/// What libFuzzer calls with each input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace taut::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Runs a reader, which may refuse its input with an InputError and nothing else: any other
/// exception ends the fuzzer.
template <typename Action>
int refuse_or_read(const Action& action) {
    try {
        action();
    } catch (const InputError&) {
        return 0;
    }
    return 0;
}

/// Ends the fuzzer where something is not as it must be.
inline void require(bool condition) {
    if (!condition) {
        std::abort();
    }
}

/// Makes a net of what was read, with its boundary as further supports.
inline void import(ImportedStructure structure) {
    using Loads = ImportSettings::Loads;
    const ImportSettings from_file{.loads = Loads::file};
    const ImportSettings chosen{.axial_stiffness = 1e5, .force_unit = 1e3, .loads = Loads::balance};
    refuse_or_read([&] { static_cast<void>(import_net(structure, from_file)); });
    support_boundary(structure);
    refuse_or_read([&] { static_cast<void>(import_net(structure, chosen)); });
}

}  // namespace taut::fuzz
