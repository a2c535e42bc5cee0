// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "taut/adjustment/plan.hpp"
#include "taut/export/io.hpp"
#include "taut/identification/trust.hpp"

namespace taut {

/// The net as it stands by a saved identification.
struct IdentifiedNet {
    BuiltNet built;  ///< as built_net_of(), with the posterior samples kept beside the result
    Trust trust;     ///< of the identification; empty where an older version saved it
};

/// Reads a saved identification as the net that a plan starts from. Not for two threads at the same
/// time, as all that uses HDF5.
/// @param net as designed
/// @throws InputError as read_result() and read_draws(), for a result that is no identification,
///   one of another net (both fingerprints are named), and one whose lengths find no equilibrium
[[nodiscard]] TAUT_IO_EXPORT IdentifiedNet
read_identified_net(const CableNet& net, const std::filesystem::path& result_path);

}  // namespace taut
