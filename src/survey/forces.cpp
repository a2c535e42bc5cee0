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

std::string_view to_string(ForceSource source) {
    switch (source) {
        case ForceSource::load_cell:
            return "load_cell";
        case ForceSource::frequency:
            return "frequency";
        case ForceSource::sag:
            return "sag";
    }
    return "";
}

void check_forces(const CableNet& net, const Forces& forces) {
    std::vector<bool> taut(net.edge_count(), false);
    std::vector<bool> slack(net.edge_count(), false);
    std::vector<bool> measured(net.edge_count(), false);
    for (const int edge : forces.taut) {
        mark(net, taut, edge, "seen taut is");
        if (net.is_strut(edge)) {
            throw std::invalid_argument(
                fmt::format("edge '{}' is seen taut, but it is a strut", net.edge_id(edge)));
        }
    }
    for (const int edge : forces.slack) {
        mark(net, slack, edge, "seen slack is");
        if (!net.can_be_slack(edge)) {
            throw std::invalid_argument(fmt::format("edge '{}' is seen slack, but {}",
                                                    net.edge_id(edge),
                                                    net.is_strut(edge) ? "it is a strut"
                                                                       : "as a cable that sags it "
                                                                         "carries tension"));
        }
        if (taut[edge]) {
            throw std::invalid_argument(
                fmt::format("edge '{}' is seen both taut and slack", net.edge_id(edge)));
        }
    }
    for (const ForceMeasurement& measurement : forces.measurements) {
        mark(net, measured, measurement.edge, "the tension is measured of");
        const bool is_strut = net.is_strut(measurement.edge);
        if (is_strut && measurement.is_by_mass()) {
            throw std::invalid_argument(fmt::format(
                "edge '{}' is a strut, expected a load cell: frequency and sag show the "
                "tension of cables",
                net.edge_id(measurement.edge)));
        }
        if (!(measurement.tension >= 0.0 || is_strut) || !std::isfinite(measurement.tension)) {
            throw std::invalid_argument(
                fmt::format("the tension of edge '{}' is measured as {} N, expected 0 or more",
                            net.edge_id(measurement.edge), measurement.tension));
        }
        if (!(measurement.std_dev > 0.0) || !std::isfinite(measurement.std_dev)) {
            throw std::invalid_argument(
                fmt::format("the force measurement of edge '{}' has the standard deviation {} N, "
                            "expected a positive "
                            "one",
                            net.edge_id(measurement.edge), measurement.std_dev));
        }
        if (measurement.mode < 0) {
            throw std::invalid_argument(
                fmt::format("the force measurement of edge '{}' is of the mode {}, expected 0 or "
                            "more",
                            net.edge_id(measurement.edge), measurement.mode));
        }
        if (!(measurement.shared_std >= 0.0) || !std::isfinite(measurement.shared_std)) {
            throw std::invalid_argument(
                fmt::format("the force measurement of edge '{}' has the shared standard deviation "
                            "{} N, expected 0 or more",
                            net.edge_id(measurement.edge), measurement.shared_std));
        }
        if (slack[measurement.edge]) {
            throw std::invalid_argument(
                fmt::format("the tension of edge '{}' is measured, but the edge is given as slack",
                            net.edge_id(measurement.edge)));
        }
    }
}

}  // namespace taut
