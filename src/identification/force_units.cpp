// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/force_units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "net/check_index.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {

namespace {

/// Of the measurements of one kind; edges that the design leaves nearly slack show no unit.
std::string warning_of(ForceSource source, const std::vector<ForceMeasurement>& measurements,
                       const Eigen::VectorXd& designed) {
    constexpr double nearly_slack = 0.01;
    const double least = nearly_slack * designed.cwiseAbs().mean();
    std::vector<double> ratios;
    for (const ForceMeasurement& measurement : measurements) {
        const double tension = designed(measurement.edge);
        if (measurement.source == source && std::abs(tension) > least &&
            tension * measurement.tension > 0.0) {
            ratios.push_back(measurement.tension / tension);
        }
    }
    if (ratios.empty()) {
        return {};
    }
    std::ranges::sort(ratios);
    const double median = ratios[ratios.size() / 2];
    constexpr double far = 2.5;
    constexpr double impossible = 50.0;
    if (median >= 1.0 / far && median <= far) {
        return {};
    }
    constexpr double kilo = 1e3;
    const bool is_kilo = median * kilo > 1.0 / far && median * kilo < far;
    const char* const advice = source != ForceSource::load_cell
                                   ? "check the modes of frequencies, and the net's mass [kg/m]"
                               : is_kilo ? "most likely the unit is kN, give it"
                                         : "check the unit";
    std::string text = fmt::format(
        "the median measured tension is {:.2g} times the designed one: {}", median, advice);
    if (median < 1.0 / impossible || median > impossible) {
        throw std::invalid_argument(text);
    }
    return text;
}

}  // namespace

std::string force_unit_warning(const CableNet& net,
                               const std::vector<ForceMeasurement>& measurements) {
    if (measurements.empty()) {
        return {};
    }
    for (const ForceMeasurement& measurement : measurements) {
        check_index("edge", measurement.edge, net.edge_count());
    }
    // A net may be given far from its equilibrium.
    const Equilibrium design = solve_equilibrium(net);
    if (!design.balanced()) {
        return {};
    }
    const Eigen::VectorXd designed = tensions_of(net, design.unstressed_lengths, design.form);
    std::string all;
    for (const ForceSource source :
         {ForceSource::load_cell, ForceSource::frequency, ForceSource::sag}) {
        const std::string text = warning_of(source, measurements, designed);
        all += (all.empty() || text.empty() ? "" : "; ") + text;
    }
    return all;
}

}  // namespace taut
