// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// The tension of an edge as a function of its strain l/l_0 - 1: straight between points, the first
/// of which is (0, 0), and continued with the last slope beyond the last point. It rises at the
/// start and at the end and never falls, so that the energy of a net is convex. A flat part is a
/// constructional stretch. At negative strain an edge is slack; there the first slope is continued
/// as pressure, for users that need a smooth law. All functions require a law that
/// problem_of() accepts, as every law of a CableNet is. They check only its sizes, and throw
/// std::invalid_argument for less than two points.
struct TAUT_CORE_EXPORT TensionLaw {
    std::string name;         ///< for people and files; may be empty
    Eigen::VectorXd strain;   ///< k >= 2, ascending from 0 [-]
    Eigen::VectorXd tension;  ///< k, from 0 [N]
    /// S = w l_0 / sqrt(24) of a cable that sags by a weight w across its chord: the arc is longer
    /// than the chord by (S/T)^2 of it, so that T = EA (strain of the chord + S^2 / T^2), smooth
    /// and positive at every strain; docs/theory.md, (sagging-law). Such a law has two points,
    /// which give EA. 0: the edge is straight [N]
    double sag = 0.0;
    /// Whether the edge sags: it carries tension at every strain.
    [[nodiscard]] bool sags() const { return sag > 0.0; }

    /// Value and slope of the law at a strain.
    struct Tangent {
        double tension;          ///< [N]
        double slope;            ///< dT/d strain; at a corner the slope beyond it [N]
        double curvature = 0.0;  ///< d2T/d strain2, 0 but of a cable that sags [N]
    };
    [[nodiscard]] Tangent at(double strain_there) const;  ///< of the segment there

    /// The law blurred by an uncertain strain: the mean of the tension over N(strain, std_dev^2),
    /// and the slope of this mean with respect to the strain. That of a cable that sags is smooth,
    /// and stays as it is.
    /// @param std_dev 0 or less: as at()
    [[nodiscard]] Tangent blurred(double strain_there, double std_dev) const;
    /// The variance over N(strain, std_dev^2) of the difference between the law and the tangent
    /// blurred(), by 40 equally probable points [N2].
    /// @param std_dev positive
    [[nodiscard]] double missed_by_blurred(double strain_there, double std_dev) const;

    /// The least strain with this tension; of a cable that sags without any it is infinite.
    [[nodiscard]] double strain_at(double tension_there) const;

    /// The least and the greatest strain with this tension, to a millionth of it. They differ if
    /// the law is flat there.
    [[nodiscard]] std::pair<double, double> strains_at(double tension_there) const;

    /// The law of an edge whose axial stiffness is this factor times as large. Its sag stays.
    [[nodiscard]] TensionLaw stiffened(double factor) const;

    /// The greatest slope [N].
    [[nodiscard]] double steepest() const;

    /// Integral of the tension from strain a to b: the trapezoid less corner_energy(), accurate
    /// also if a and b almost agree [N].
    [[nodiscard]] double energy_between(double a, double b) const;

    /// What the corners, or the curve of a sagging cable, between the strains a and b subtract from
    /// the trapezoid under the law [N].
    [[nodiscard]] double corner_energy(double a, double b) const;

private:
    /// Index of the straight part that contains a strain: i for points i to i + 1.
    [[nodiscard]] Eigen::Index part_of(double strain_there) const;
    [[nodiscard]] double slope_of(Eigen::Index part) const;
};

/// Tension, slope and curvature of a cable that sags, (sagging-law) of docs/theory.md.
/// @param axial_stiffness EA, positive [N]
/// @param sag S, positive [N]
[[nodiscard]] TAUT_CORE_EXPORT TensionLaw::Tangent sagging_tangent(double axial_stiffness,
                                                                   double sag, double strain);

/// The first rule that a law breaks, for example "falls from ..."; empty if there is none.
[[nodiscard]] TAUT_CORE_EXPORT std::string problem_of(const TensionLaw& law);

}  // namespace taut
