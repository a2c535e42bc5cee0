// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/net/cable_net.hpp"

/// What work holds in memory at its peak [bytes], by the arrays that it cannot do without. Measured
/// by benchmarks/memory.py, which docs/performance.md shows.
namespace taut::app {

/// A data set in memory, and as the bytes of its file while that is written.
[[nodiscard]] double sampling_memory(const CableNet& net, double samples);

/// Training on so many samples: the data set, the forms among it, and the decompositions.
[[nodiscard]] double training_memory(const CableNet& net, double samples);

}  // namespace taut::app
