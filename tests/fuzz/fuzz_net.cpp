// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// The native JSON format: whatever is read must be written and read back as the same net.

#include "fuzz.hpp"
#include "taut/io/net_json.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace taut;
    return fuzz::refuse_or_read([&] {
        const NetFile file = parse_net(fuzz::text_of(data, size), "net.json");
        const NetFile again = parse_net(net_to_json(file.net, file.unknown_keys), "again.json");
        fuzz::require(again.net.fingerprint() == file.net.fingerprint());
    });
}
