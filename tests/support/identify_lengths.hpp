// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>

#include "taut/identification/epochs.hpp"
#include "taut/identification/identify.hpp"

namespace taut::test {

/// identify() with what is given, and nothing else uncertain, and without posterior samples unless
/// they are asked for: tests of lengths alone then take a tenth of the time.
inline Identification identify_lengths(const CableNet& net, const Survey& survey,
                                       IdentifyOptions options = {},
                                       const Progress& progress = {}) {
    options.assume_site = options.assume_site.value_or(false);
    options.draws = options.draws.value_or(0);
    return identify(net, survey, options, progress);
}

/// The same of several surveys.
inline Identification identify_lengths(const CableNet& net, std::span<const Epoch> epochs,
                                       IdentifyOptions options = {},
                                       const Progress& progress = {}) {
    options.assume_site = options.assume_site.value_or(false);
    options.draws = options.draws.value_or(0);
    return identify_epochs(net, epochs, options, progress);
}

}  // namespace taut::test
