// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/math/special_functions/erf.hpp>
#include <cstdint>
#include <numbers>
#include <random>

namespace taut {

/// Random numbers that are the same for a seed on every platform. The standard fixes the output of
/// the engine and of the seed sequence, but not that of its distributions. One stream a draw.
class RandomNumbers {
public:
    RandomNumbers(std::uint64_t seed, std::uint32_t stream) {
        std::seed_seq sequence{static_cast<std::uint32_t>(seed),
                               static_cast<std::uint32_t>(seed >> 32U), stream};
        m_engine.seed(sequence);
    }
    /// In (0, 1), at the middle of one of 2^52 cells: with 2^53 the last middle would round to 1.
    double uniform() { return (static_cast<double>(m_engine() >> 12U) + 0.5) * 0x1p-52; }
    /// Standard normal.
    double normal() { return -std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * uniform()); }

private:
    std::mt19937_64 m_engine;
};

}  // namespace taut
