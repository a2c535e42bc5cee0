// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// COMPAS and JAX FDM, as JSON.

#include "fuzz.hpp"
#include "taut/interchange/compas_json.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace taut;
    return fuzz::refuse_or_read(
        [&] { fuzz::import(parse_compas(fuzz::text_of(data, size), "net.json")); });
}
