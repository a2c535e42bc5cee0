// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// The pair of CSV files of JAX FDM, as one input: nodes, a line "----", edges.

#include <algorithm>
#include <string>

#include "fuzz.hpp"
#include "taut/interchange/net_csv.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace taut;
    constexpr std::string_view between = "----\n";
    const std::string_view text = fuzz::text_of(data, size);
    const std::size_t end = std::min(text.find(between), text.size());
    const NetCsv files{.nodes = std::string(text.substr(0, end)),
                       .edges = std::string(text.substr(std::min(end + between.size(), size)))};
    return fuzz::refuse_or_read(
        [&] { fuzz::import(parse_net_csv(files, "nodes.csv", "edges.csv")); });
}
