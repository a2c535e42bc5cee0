// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/lengths_csv.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "files/csv_field.hpp"

namespace taut {

std::string lengths_to_csv(const CableNet& nominal, const CableNet& built) {
    if (nominal.interior_edges() != built.interior_edges()) {
        throw std::invalid_argument("the built net has other interior edges than the nominal one");
    }
    std::string result = "edge,nominal,length_deviation\n";
    for (const int edge : nominal.interior_edges()) {
        const double length = nominal.unstressed_lengths()(edge);
        result += fmt::format("{},{},{}\n", csv_field(nominal.edge_id(edge)), length,
                              built.unstressed_lengths()(edge) - length);
    }
    return result;
}

}  // namespace taut
