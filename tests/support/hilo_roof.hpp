// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "support/real_data.hpp"
#include "taut/files/file.hpp"
#include "taut/interchange/compas_json.hpp"
#include "taut/interchange/net_import.hpp"

namespace taut::test {

/// The real cable net of the HiLo roof, under the weight of its concrete: see docs/real-nets.md.
inline CableNet hilo_roof() {
    const std::string file = real_file("hilo/cablenet.json").string();
    return import_net(parse_compas(read_file(file), file),
                      {.young = 205e9,
                       .diameter_attribute = "size",
                       .force_unit = 1e3,
                       .loads = ImportSettings::Loads::balance})
        .net;
}

}  // namespace taut::test

/// Skips the test if its file does not exist.
#define TAUT_NEEDS_HILO_ROOF() TAUT_NEEDS_REAL_FILE("hilo/cablenet.json")
