// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/net/cable_net.hpp"

/// Peak memory of the work [bytes], by its largest arrays. benchmarks/memory.py measures it, and
/// docs/performance.md shows the outcome.
namespace taut::app {

/// A data set in memory, and again as the bytes of its file while that is written.
[[nodiscard]] double sampling_memory(const CableNet& net, double samples);

/// Training on so many samples: the data set, copies of its forms, and the decompositions.
[[nodiscard]] double training_memory(const CableNet& net, double samples);

}  // namespace taut::app
