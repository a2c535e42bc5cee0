// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/interchange/net_import.hpp"

namespace taut {

/// The cables of a net that run on through nodes, each sliding at all free nodes on its way, but
/// for that where it closes a ring.
/// @param by names: edges of one name but for the number at its end; straight: as cable_runs() of a
///   net that gives none
[[nodiscard]] std::vector<CableRun> sliding_runs(const CableNet& net, ImportSettings::Slides by);

/// The net with these cables, where the settings ask for them, or with the runs that the file
/// names, and a line about them; else a line about what slides in many structures, and how to ask
/// for it.
/// @param structure that the net was made of, edge by edge
[[nodiscard]] CableNet with_sliding_runs(const CableNet& net, ImportSettings::Slides by,
                                         const ImportedStructure& structure, ImportReport& report);

}  // namespace taut
