// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/forces.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

namespace taut {
namespace {

/// Marks an edge.
/// @throws std::invalid_argument where it is out of range or marked already
void mark(const CableNet& net, std::vector<bool>& marked, int edge, const char* what) {
    if (edge < 0 || edge >= net.edge_count()) {
        throw std::invalid_argument(
            fmt::format("{} edge {}, expected 0 to {}", what, edge, net.edge_count() - 1));
    }
    if (marked[edge]) {
        throw std::invalid_argument(fmt::format("{} edge '{}' twice", what, net.edge_id(edge)));
    }
    marked[edge] = true;
}

}  // namespace

void check_forces(const CableNet& net, const Forces& forces) {
    std::vector<bool> taut(net.edge_count(), false);
    std::vector<bool> slack(net.edge_count(), false);
    std::vector<bool> read(net.edge_count(), false);
    for (const int edge : forces.taut) {
        mark(net, taut, edge, "seen taut is");
    }
    for (const int edge : forces.slack) {
        mark(net, slack, edge, "seen slack is");
        if (taut[edge]) {
            throw std::invalid_argument(
                fmt::format("edge '{}' is seen both taut and slack", net.edge_id(edge)));
        }
    }
    for (const ForceMeasurement& reading : forces.readings) {
        mark(net, read, reading.edge, "the tension is read of");
        if (!(reading.tension >= 0.0) || !std::isfinite(reading.tension)) {
            throw std::invalid_argument(
                fmt::format("the tension of edge '{}' is read as {} N, expected 0 or more",
                            net.edge_id(reading.edge), reading.tension));
        }
        if (!(reading.std > 0.0) || !std::isfinite(reading.std)) {
            throw std::invalid_argument(fmt::format(
                "the reading of edge '{}' has the standard deviation {} N, expected a positive one",
                net.edge_id(reading.edge), reading.std));
        }
        if (slack[reading.edge]) {
            throw std::invalid_argument(
                fmt::format("the tension of edge '{}' is read, and it is told slack",
                            net.edge_id(reading.edge)));
        }
    }
}

}  // namespace taut
