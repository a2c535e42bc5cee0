// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/study/slack_reliability.hpp"

#include <algorithm>

namespace taut {

SlackReliability::SlackReliability() {
    constexpr std::array<double, bin_count> ends{0.0, 0.05, 0.2, 0.4, 0.6, 0.8, 0.95, 1.0};
    double above = -1.0;
    for (size_t i = 0; i < ends.size(); ++i) {
        m_bins[i] = {.above = above, .up_to = ends[i]};
        above = ends[i];
    }
}

void SlackReliability::add(double probability, bool is_slack) {
    Bin& bin = *std::ranges::find_if(m_bins, [&](const Bin& b) { return probability <= b.up_to; });
    bin.edges += 1;
    bin.slack += is_slack ? 1 : 0;
    bin.told += probability;
}

void SlackReliability::add(const SlackReliability& other) {
    for (size_t i = 0; i < m_bins.size(); ++i) {
        m_bins[i].edges += other.m_bins[i].edges;
        m_bins[i].slack += other.m_bins[i].slack;
        m_bins[i].told += other.m_bins[i].told;
    }
}

}  // namespace taut
