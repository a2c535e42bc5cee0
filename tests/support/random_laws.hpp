// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/random_nets.hpp"
#include "taut/net/tension_law.hpp"
#include "taut/statics/tensions.hpp"

/// Random piecewise linear tension laws.
namespace taut::test {

/// A law of 2 to 4 straight parts, some of those in the middle flat; slopes of 0.2 to 2 times the
/// axial stiffness, corners at strains up to 0.06.
inline TensionLaw random_law(Random& random, double axial_stiffness) {
    const int parts = uniform_int(random, 2, 4);
    TensionLaw law{.name = "random",
                   .strain = Eigen::VectorXd::Zero(parts + 1),
                   .tension = Eigen::VectorXd::Zero(parts + 1)};
    for (int k = 1; k <= parts; ++k) {
        const bool is_flat = k > 1 && k < parts && uniform_int(random, 0, 2) == 0;
        const double slope = is_flat ? 0.0 : axial_stiffness * uniform(random, 0.2, 2.0);
        const double width = uniform(random, 0.002, 0.02);
        law.strain(k) = law.strain(k - 1) + width;
        law.tension(k) = law.tension(k - 1) + slope * width;
    }
    return law;
}

/// A law of 2 to 5 straight parts, half of those in the middle flat; slopes of a hundredth to a
/// hundred times the axial stiffness, corners at strains up to 0.25.
inline TensionLaw wild_law(Random& random, double axial_stiffness) {
    const int parts = uniform_int(random, 2, 5);
    TensionLaw law{.name = "wild",
                   .strain = Eigen::VectorXd::Zero(parts + 1),
                   .tension = Eigen::VectorXd::Zero(parts + 1)};
    for (int k = 1; k <= parts; ++k) {
        const bool is_flat = k > 1 && k < parts && uniform_int(random, 0, 1) == 0;
        const double slope =
            is_flat ? 0.0 : axial_stiffness * std::pow(10.0, uniform(random, -2.0, 2.0));
        const double width = std::pow(10.0, uniform(random, -3.5, -1.3));
        law.strain(k) = law.strain(k - 1) + width;
        law.tension(k) = law.tension(k - 1) + slope * width;
    }
    return law;
}

/// The net with an individual law for most edges.
inline CableNetData with_random_laws(Random& random, CableNetData data,
                                     TensionLaw (*law)(Random&, double) = random_law) {
    for (Eigen::Index e = 0; e < data.axial_stiffness.size(); ++e) {
        const bool is_linear = uniform_int(random, 0, 3) == 0;
        data.tension_law.push_back(is_linear ? -1 : static_cast<int>(data.tension_laws.size()));
        if (!is_linear) {
            data.tension_laws.push_back(law(random, data.axial_stiffness(e)));
        }
    }
    return data;
}

/// The net with tension laws that equal its axial stiffnesses, by several points on a line.
inline CableNetData with_straight_laws(CableNetData data) {
    for (const double stiffness : data.axial_stiffness) {
        const Eigen::VectorXd strain{{0.0, 0.001, 0.004, 0.01, 0.02}};
        data.tension_law.push_back(static_cast<int>(data.tension_laws.size()));
        data.tension_laws.push_back(
            {.name = "straight", .strain = strain, .tension = stiffness * strain});
    }
    return data;
}

/// Least distance of an edge's strain from a corner of its law, and from 0.
inline double distance_from_corners(const CableNet& net, const Points& form) {
    const Eigen::VectorXd lengths = edge_lengths(net, form);
    double least = 1.0;
    for (int e = 0; e < net.edge_count(); ++e) {
        const double strain = lengths(e) / net.unstressed_lengths()(e) - 1.0;
        least = std::min(least, std::abs(strain));
        if (const TensionLaw* law = net.tension_law(e); law != nullptr) {
            least = std::min(least, (law->strain.array() - strain).abs().minCoeff());
        }
    }
    return least;
}

}  // namespace taut::test
