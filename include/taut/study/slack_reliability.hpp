// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "taut/abi.hpp"
#include "taut/export/adjustment.hpp"

namespace taut {

/// How often edges are slack for which a probability of it was told: the numbers of a reliability
/// diagram (Murphy and Winkler, Applied Statistics 26, 1977).
class TAUT_ADJUSTMENT_EXPORT SlackReliability {
public:
    /// Edges of like probability.
    struct Bin {
        double above = 0.0;  ///< the probabilities of the bin: above < p <= up_to
        double up_to = 0.0;  ///< upper end, within the bin
        int edges = 0;       ///< of these probabilities
        int slack = 0;       ///< of these
        double told = 0.0;   ///< sum of the probabilities told
    };
    /// Number of bins.
    static constexpr int bin_count = 8;

    /// Without edges.
    SlackReliability();

    /// Adds an edge.
    /// @param probability that was told, 0 to 1: not checked
    /// @param is_slack whether the edge is
    void add(double probability, bool is_slack);
    /// Adds the edges of another.
    void add(const SlackReliability& other);
    /// The first bin is that of probability 0.
    [[nodiscard]] const std::array<Bin, bin_count>& bins() const { return m_bins; }

private:
    std::array<Bin, bin_count> m_bins;
};

}  // namespace taut
