// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// The tension of an edge over its strain l/l_0 - 1: straight between points, the first of which is
/// (0, 0), and on with the last slope behind the last. It rises from the start and at the end and
/// never falls in between, so that the energy of a net stays convex. A flat part is a
/// constructional stretch. Below strain 0 an edge is slack; the first slope goes on there as
/// pressure for whoever needs a smooth law. A struct that anyone may fill: all functions ask for a
/// law that problem_of() finds nothing wrong with, as a CableNet holds no other. They check its
/// sizes alone, and throw std::invalid_argument for less than two points.
struct TAUT_CORE_EXPORT TensionLaw {
    std::string name;         ///< for people and files; may be empty
    Eigen::VectorXd strain;   ///< k >= 2, ascending from 0 [-]
    Eigen::VectorXd tension;  ///< k, from 0 [N]

    /// The law near a strain.
    struct Tangent {
        double tension;  ///< [N]
        double slope;    ///< dT/d strain, at a corner that behind it [N]
    };
    /// Tension and slope at a strain; at a corner the slope behind it.
    [[nodiscard]] Tangent at(double strain_there) const;

    /// The law as a strain sees it that is known with a standard deviation: the mean of the tension
    /// over N(strain, std^2), and the slope of that mean.
    /// @param std 0 or less: at()
    [[nodiscard]] Tangent blurred(double strain_there, double std) const;
    /// The variance of what that tangent misses of the law over the same distribution, by 40
    /// equally probable points of it [N2].
    /// @param std positive
    [[nodiscard]] double missed_by_blurred(double strain_there, double std) const;

    /// The least strain with this tension.
    [[nodiscard]] double strain_at(double tension_there) const;

    /// The least and the greatest strain with this tension, to a millionth of it: two where the law
    /// is flat there.
    [[nodiscard]] std::pair<double, double> strains_at(double tension_there) const;

    /// The greatest slope [N].
    [[nodiscard]] double steepest() const;

    /// Integral of the tension from strain a to b [N]: the trapezoid less corner_energy(), which is
    /// exact also where a and b almost agree.
    [[nodiscard]] double energy_between(double a, double b) const;

    /// What the corners from strain a to b take off the trapezoid under the law [N].
    [[nodiscard]] double corner_energy(double a, double b) const;

private:
    /// The part of the law, from point i to i + 1, that holds at a strain.
    [[nodiscard]] Eigen::Index part_of(double strain_there) const;
    [[nodiscard]] double slope_of(Eigen::Index part) const;
};

/// The first rule that a law breaks, "falls from ...", or nothing.
[[nodiscard]] TAUT_CORE_EXPORT std::string problem_of(const TensionLaw& law);

}  // namespace taut
