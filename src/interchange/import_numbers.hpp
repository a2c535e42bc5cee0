// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <optional>
#include <string>

#include "taut/interchange/imported_structure.hpp"

namespace taut {

/// An error at an edge of the file, in its names.
[[noreturn]] void fail_at(const ImportedStructure& structure, const ImportedEdge& edge,
                          const std::string& what);

/// Lengths of all edges between their nodes [m].
/// @throws InputError for an edge of no length
[[nodiscard]] Eigen::VectorXd lengths_of(const ImportedStructure& structure);

/// An attribute of all edges, by the first of the names that any edge has; none where no edge has
/// one, or all are zero.
/// @throws InputError where some edges have it and others not
[[nodiscard]] std::optional<Eigen::VectorXd> numbers_of(const ImportedStructure& structure,
                                                        std::initializer_list<const char*> names);

/// Force densities q = T / l of the edges, in the file's unit of force.
struct ImportedForces {
    Eigen::VectorXd force_densities;
    std::string source;  ///< "q", "f", or empty where the file gives neither
};

/// From q, or f and l. Warns where both are given and disagree.
/// @param lengths in the form [m]
/// @throws InputError naming an edge in compression
[[nodiscard]] ImportedForces forces_of(const ImportedStructure& structure,
                                       const Eigen::VectorXd& lengths,
                                       std::vector<std::string>& warnings);

}  // namespace taut
