// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "files/json_value.hpp"

namespace taut {

/// A mesh or network inside a JSON file.
struct CompasStructure {
    JsonValue data;     ///< the object with "vertex" or "node"
    std::string key;    ///< keys from the root to it, with slashes; empty for the root
    std::string dtype;  ///< "compas.datastructures/Mesh"; empty in the old layout
};

/// Finds the one structure of a file, or the one of that key.
/// @param select last part or whole of its key; empty for the only one
/// @throws InputError where there is none, or more than one
[[nodiscard]] CompasStructure find_compas_structure(const JsonValue& root,
                                                    const std::string& select);

}  // namespace taut
