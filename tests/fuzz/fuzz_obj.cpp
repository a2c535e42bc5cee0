// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#include "fuzz.hpp"
#include "taut/interchange/obj.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace taut;
    return fuzz::refuse_or_read(
        [&] { fuzz::import(parse_obj(fuzz::text_of(data, size), "net.obj")); });
}
