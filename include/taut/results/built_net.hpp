// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "taut/adjustment/plan.hpp"
#include "taut/export/io.hpp"
#include "taut/identification/trust.hpp"

namespace taut {

/// What a saved identification tells of the net as it stands.
struct IdentifiedNet {
    /// In the frame of the net that was identified, whatever that of the survey: its lengths as
    /// identified, those of adjustable edges as told unless the survey contradicts them, supports
    /// and all else as identified, its nodes in equilibrium. With the draws kept beside the result.
    BuiltNet built;
    Trust trust;  ///< of the identification; empty where an older version saved it
};

/// Reads a saved identification as the net that turning begins with. Not for two threads at the
/// same time, as all that uses HDF5.
/// @param net as designed
/// @throws InputError as read_result() and read_draws(), for a result that is no identification,
///   one of another net (both fingerprints are named), and one whose lengths find no equilibrium
[[nodiscard]] TAUT_IO_EXPORT IdentifiedNet
read_identified_net(const CableNet& net, const std::filesystem::path& result_path);

}  // namespace taut
