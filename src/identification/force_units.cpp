// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/force_units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "net/check_index.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {

std::string force_unit_warning(const CableNet& net,
                               const std::vector<ForceMeasurement>& measurements) {
    const Eigen::VectorXd designed = tensions(net, net.unstressed_lengths(), net.nodes());
    std::vector<double> ratios;
    for (const ForceMeasurement& measurement : measurements) {
        check_index("edge", measurement.edge, net.edge_count());
        if (designed(measurement.edge) * measurement.tension > 0.0) {
            ratios.push_back(measurement.tension / designed(measurement.edge));
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
    const char* const advice = measurements[0].is_by_mass()
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

}  // namespace taut
