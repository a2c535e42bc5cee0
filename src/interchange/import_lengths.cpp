// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/import_lengths.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "interchange/import_numbers.hpp"
#include "interchange/import_stiffness.hpp"
#include "taut/design/unstressed_lengths.hpp"

namespace taut {
namespace {

/// A stored l_0 is consistent where its tensions differ from those of q or f by no more than this
/// part of their mean.
constexpr double consistent_within = 1e-2;
/// A cable that is stretched further than this is not one, or a unit is wrong.
constexpr double largest_strain = 0.10;

/// All that the file says of the edges' forces, and l_0 if it is stored.
struct Stored {
    Eigen::VectorXd lengths;  ///< in the given form [m]
    ImportedForces forces;
    ImportedStiffness stiffness;
    std::optional<Eigen::VectorXd> unstressed;  ///< positive [m]
    Eigen::VectorXd sag_weights;  ///< 0 of a straight cable, in the file's unit of force per metre
};

/// The law of a cable that sags, (sagging-law) of docs/theory.md.
TensionLaw sagging_law(const Stored& stored, Eigen::Index edge, double unstressed,
                       double force_unit) {
    const double EA = stored.stiffness.tension(edge, 1.0, force_unit);
    return {.name = "",
            .strain = Eigen::Vector2d(0.0, 1.0),
            .tension = Eigen::Vector2d(0.0, EA),
            .sag = force_unit * stored.sag_weights(edge) * unstressed / std::sqrt(24.0)};
}

/// Tension of an edge of an unstressed length between its nodes [N].
double tension_of(const Stored& stored, Eigen::Index edge, double unstressed, double force_unit,
                  bool is_pressed) {
    const double strain = stored.lengths(edge) / unstressed - 1.0;
    if (stored.sag_weights(edge) > 0.0) {
        return sagging_law(stored, edge, unstressed, force_unit).at(strain).tension;
    }
    return stored.stiffness.tension(edge, is_pressed ? strain : std::max(0.0, strain), force_unit);
}

/// l_0 of an edge under a tension: l / (1 + strain), where that of a cable that sags depends on
/// l_0. NaN where a cable that sags so much cannot have this tension.
double unstressed_length(const Stored& stored, Eigen::Index edge, double tension,
                         double force_unit) {
    const double length = stored.lengths(edge);
    if (stored.sag_weights(edge) == 0.0) {
        return length / (1.0 + stored.stiffness.strain(edge, tension, force_unit));
    }
    constexpr int most_iterations = 100;
    constexpr double converged = 1e-14;
    double result = length;
    for (int k = 0; tension > 0.0 && k < most_iterations; ++k) {
        const TensionLaw law = sagging_law(stored, edge, result, force_unit);
        const double next = length / (1.0 + law.strain_at(tension));
        if (std::abs(next - result) <= converged * length) {
            return next;
        }
        result = next;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

Stored collect(const ImportedStructure& structure, const ImportSettings& settings,
               ImportReport& report) {
    Stored stored{.lengths = lengths_of(structure)};
    stored.forces = forces_of(structure, stored.lengths, report.warnings);
    stored.stiffness = stiffness_of(structure, settings);
    stored.unstressed = numbers_of(structure, {"l0"});
    if (stored.unstressed && !(stored.unstressed->array() > 0.0).all()) {
        report.warnings.emplace_back("l0 is not positive at every edge: it is not used");
        stored.unstressed.reset();
    }
    stored.sag_weights.setZero(stored.lengths.size());
    for (Eigen::Index e = 0; e < stored.lengths.size(); ++e) {
        const auto& numbers = structure.edges[e].numbers;
        if (const auto found = numbers.find("sag_weight"); found != numbers.end()) {
            stored.sag_weights(e) = found->second;
            if (!(found->second >= 0.0)) {
                fail_at(structure, structure.edges[e],
                        fmt::format("has the sag_weight {}, expected 0 or more", found->second));
            }
            if (found->second > 0.0 && !stored.stiffness.laws.empty()) {
                fail_at(structure, structure.edges[e],
                        "has a sag_weight, but a stress-strain curve, too: expected an axial "
                        "stiffness or a modulus");
            }
        }
    }
    return stored;
}

Eigen::VectorXd stiffness_in(const Stored& stored, double force_unit) {
    return (stored.stiffness.in_force_unit ? force_unit : 1.0) * stored.stiffness.values;
}

Eigen::VectorXd tensions_in(const Stored& stored, double force_unit) {
    return force_unit * stored.forces.force_densities.cwiseProduct(stored.lengths);
}

/// Whether the tension laws of the edges, as EA max(0, l / l_0 - 1), of struts without the maximum,
/// give the tensions of q.
bool is_consistent(const Stored& stored, double force_unit) {
    const Eigen::VectorXd expected = tensions_in(stored, force_unit);
    double largest = 0.0;
    for (Eigen::Index e = 0; e < expected.size(); ++e) {
        const double found =
            tension_of(stored, e, (*stored.unstressed)(e), force_unit, expected(e) < 0.0);
        largest = std::max(largest, std::abs(found - expected(e)));
    }
    return largest <= consistent_within * expected.cwiseAbs().mean();
}

Eigen::VectorXd lengths_from_tensions(const ImportedStructure& structure, const Stored& stored,
                                      const Eigen::VectorXd& tensions, double force_unit) {
    Eigen::VectorXd result(tensions.size());
    for (Eigen::Index e = 0; e < tensions.size(); ++e) {
        result(e) = unstressed_length(stored, e, tensions(e), force_unit);
        if (std::isnan(result(e)) && stored.sag_weights(e) > 0.0) {
            fail_at(structure, structure.edges[e],
                    fmt::format("has a tension of {:.3g} N, which cannot carry its sag_weight",
                                tensions(e)));
        }
    }
    return result;
}

std::string unit_text(double force_unit) {
    return force_unit == 1e3 ? "kN" : force_unit == 1.0 ? "N" : fmt::format("{} N", force_unit);
}

/// From the settings, else the file, else the one in which a stored l_0 fits, else N.
double force_unit_of(const Stored& stored, const ImportedStructure& structure,
                     const ImportSettings& settings, ImportReport& report) {
    if (settings.force_unit) {
        report.assumed.push_back(
            fmt::format("forces of the file are in {}, as given", unit_text(*settings.force_unit)));
        return *settings.force_unit;
    }
    if (structure.force_unit) {
        report.read.push_back("forces are in " + unit_text(*structure.force_unit));
        return *structure.force_unit;
    }
    // A stiffness in the same unit agrees in every one.
    if (stored.unstressed && !stored.forces.source.empty() && !stored.stiffness.in_force_unit) {
        for (const double unit : {1.0, 1e3}) {
            if (is_consistent(stored, unit)) {
                report.assumed.push_back(fmt::format(
                    "forces of the file are in {}: with this, {} agrees with l0 and the axial "
                    "stiffness",
                    unit_text(unit), stored.forces.source));
                return unit;
            }
        }
    }
    const bool has_loads = std::ranges::any_of(
        structure.nodes, [](const ImportedNode& node) { return !node.load.isZero(0.0); });
    if (stored.forces.source.empty() && !stored.stiffness.in_force_unit && !has_loads) {
        return 1.0;
    }
    report.assumed.emplace_back("forces of the file are in N, as no unit is given");
    return 1.0;
}

bool takes_stored_lengths(const Stored& stored, double force_unit, ImportReport& report) {
    if (!stored.unstressed) {
        return false;
    }
    if (stored.forces.source.empty() || is_consistent(stored, force_unit)) {
        report.read.emplace_back(stored.forces.source.empty()
                                     ? "unstressed lengths: the file's l0"
                                     : "unstressed lengths: the file's l0, which agrees with its " +
                                           stored.forces.source);
        return true;
    }
    report.warnings.push_back(
        fmt::format("l0 does not agree with {} and the {}: it is not used", stored.forces.source,
                    stored.stiffness.laws.empty() ? "axial stiffness" : "tension laws"));
    return false;
}

/// Refuses strains that no cable has, and warns of slack edges.
void check_strains(const ImportedStructure& structure, const Stored& stored,
                   const Eigen::VectorXd& unstressed, ImportReport& report) {
    const Eigen::ArrayXd strains = stored.lengths.array() / unstressed.array() - 1.0;
    // A cable that is slack beside edges in tension may be so by any length.
    const auto is_pressed = stored.forces.force_densities.array() < 0.0;
    Eigen::ArrayXd sizes = strains.abs();
    if (!stored.forces.source.empty()) {
        sizes = is_pressed.select(sizes, strains);
    }
    Eigen::Index worst = 0;
    const double largest = sizes.maxCoeff(&worst);
    const ImportedEdge& edge = structure.edges[worst];
    // Written so that NaN is refused.
    if (!(largest <= largest_strain)) {
        fail_at(
            structure, edge,
            fmt::format("has a strain of {:.3g} %, expected at most {:.3g} %: check the units of "
                        "forces and stiffness",
                        100.0 * strains(worst), 100.0 * largest_strain));
    }
    int slack = 0;
    for (Eigen::Index e = 0; e < strains.size(); ++e) {
        const auto& numbers = structure.edges[e].numbers;
        const auto strut = numbers.find("is_strut");
        const bool is_strut = is_pressed(e) || (strut != numbers.end() && strut->second != 0.0);
        slack += strains(e) <= 0.0 && !is_strut && stored.sag_weights(e) == 0.0 ? 1 : 0;
    }
    if (slack > 0 && stored.unstressed) {
        report.warnings.push_back(fmt::format("{} edges are slack in the given form", slack));
    }
}

}  // namespace

ImportedLengths import_lengths(const ImportedStructure& structure, const ImportSettings& settings,
                               ImportReport& report) {
    const Stored stored = collect(structure, settings, report);
    const double force_unit = force_unit_of(stored, structure, settings, report);
    report.read.push_back("axial stiffness: " + stored.stiffness.source);
    ImportedLengths result{.axial_stiffness = stiffness_in(stored, force_unit),
                           .tension_laws = stored.stiffness.laws,
                           .tension_law = stored.stiffness.law_of_edge,
                           .unstressed = {},
                           .force_unit = force_unit,
                           .is_pressed = {}};
    const Eigen::VectorXd tensions = tensions_in(stored, force_unit);
    for (Eigen::Index e = 0; e < tensions.size(); ++e) {
        const ImportedEdge& edge = structure.edges[e];
        if (!(std::isfinite(result.axial_stiffness(e)) && result.axial_stiffness(e) > 0.0)) {
            fail_at(structure, edge,
                    fmt::format("has the axial stiffness {} N, expected a positive and finite one",
                                result.axial_stiffness(e)));
        }
        if (!std::isfinite(tensions(e))) {
            fail_at(structure, edge,
                    fmt::format("has the tension {} N, expected a finite one", tensions(e)));
        }
        if (!(tensions(e) > -result.axial_stiffness(e))) {
            fail_at(
                structure, edge,
                fmt::format("has the tension {:.6g} N, expected one above {:.6g} N, its negative "
                            "axial stiffness: check the units of forces and stiffness",
                            tensions(e), -result.axial_stiffness(e)));
        }
        // Less is a rounding error of a program that balances forces.
        constexpr double negligible = 1e-9;
        result.is_pressed.push_back(tensions(e) < -negligible * tensions.cwiseAbs().mean());
        if (result.is_pressed.back() && !result.tension_law.empty() && result.tension_law[e] >= 0) {
            fail_at(
                structure, edge,
                fmt::format("is in compression ({:.6g} N), but has a stress-strain curve, which "
                            "is for cables: expected an axial stiffness or a modulus",
                            tensions(e)));
        }
    }
    if (takes_stored_lengths(stored, force_unit, report)) {
        result.unstressed = *stored.unstressed;
    } else if (stored.forces.source.empty()) {
        report.warnings.emplace_back(
            "the file gives no forces: unstressed lengths are the lengths, no edge is in tension");
        result.unstressed = stored.lengths;
    } else {
        const bool are_linear = stored.stiffness.laws.empty() && stored.sag_weights.isZero(0.0);
        report.read.push_back(fmt::format("unstressed lengths: l / (1 + {}), tensions T by {}",
                                          are_linear ? "T/EA" : "strain at T",
                                          stored.forces.source == "q" ? "q l" : "f"));
        result.unstressed =
            are_linear ? unstressed_lengths_for(stored.lengths, tensions, result.axial_stiffness)
                       : lengths_from_tensions(structure, stored, tensions, force_unit);
    }
    if (!stored.sag_weights.isZero(0.0)) {
        result.sag_weight = force_unit * stored.sag_weights;
        report.read.push_back(fmt::format("{} cables sag, by sag_weight",
                                          (stored.sag_weights.array() > 0.0).count()));
    }
    check_strains(structure, stored, result.unstressed, report);
    return result;
}

}  // namespace taut
