// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/import_stiffness.hpp"

#include <fmt/core.h>

#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "files/message.hpp"
#include "interchange/import_numbers.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

void require_positive(const std::optional<double>& value, const char* name) {
    if (value && !(std::isfinite(*value) && *value > 0.0)) {
        throw std::invalid_argument(
            fmt::format("{} is {}, expected a positive and finite number", name, *value));
    }
}

void check(const ImportSettings& settings) {
    require_positive(settings.axial_stiffness, "the axial stiffness");
    require_positive(settings.young, "Young's modulus");
    require_positive(settings.diameter, "the diameter");
    require_positive(settings.force_unit, "the unit of force");
    const bool has_diameter = settings.diameter || !settings.diameter_attribute.empty();
    if (settings.diameter && !settings.diameter_attribute.empty()) {
        throw std::invalid_argument("a diameter and an attribute for it: expected one of them");
    }
    if (settings.axial_stiffness && (settings.young || has_diameter)) {
        throw std::invalid_argument(
            "an axial stiffness and Young's modulus or a diameter: expected one or the other");
    }
    if (settings.stress_strain && (settings.young || settings.axial_stiffness)) {
        throw std::invalid_argument(
            "a table of stress over strain and an axial stiffness or Young's modulus: expected one "
            "of them");
    }
    if (!settings.stress_strain && settings.young.has_value() != has_diameter) {
        throw std::invalid_argument(
            "Young's modulus and the diameter give the axial stiffness together: expected both");
    }
}

/// EA = E pi r^2
Eigen::VectorXd stiffness(const Eigen::ArrayXd& young, const Eigen::ArrayXd& radii) {
    return young * std::numbers::pi * radii.square();
}

/// "6 mm (1520 edges), 8 mm (122)": how many edges have each diameter.
std::string diameters_text(const Eigen::VectorXd& diameters) {
    std::map<double, int> counts;
    for (const double diameter : diameters) {
        ++counts[diameter];
    }
    constexpr size_t most = 6;
    if (counts.size() > most) {
        return fmt::format("{} diameters of {:.4g} to {:.4g} mm", counts.size(),
                           counts.begin()->first, counts.rbegin()->first);
    }
    std::string text;
    for (const auto& [diameter, count] : counts) {
        text += fmt::format("{}{:.4g} mm ({})", text.empty() ? "" : ", ", diameter, count);
    }
    return text;
}

/// Diameters of the edges, and how they came about.
struct Diameters {
    Eigen::VectorXd values;  ///< [m]
    std::string source;
};

Diameters diameters_by_attribute(const ImportedStructure& structure, const std::string& name) {
    const auto m = static_cast<Eigen::Index>(structure.edges.size());
    Eigen::VectorXd diameters(m);  // mm
    for (Eigen::Index e = 0; e < m; ++e) {
        const ImportedEdge& edge = structure.edges[e];
        const auto found = edge.numbers.find(name);
        if (found == edge.numbers.end()) {
            fail_at(structure, edge,
                    fmt::format("has no attribute {} that is a number, expected its diameter in mm",
                                quote(name)));
        }
        if (!(found->second > 0.0)) {
            fail_at(structure, edge,
                    fmt::format("has {} = {}, expected a positive diameter in mm", quote(name),
                                found->second));
        }
        diameters(e) = found->second;
    }
    return {.values = 1e-3 * diameters,
            .source = fmt::format("diameter by the attribute {} taken in mm: {}", quote(name),
                                  diameters_text(diameters))};
}

/// The diameter of the settings for all edges, else that of the attribute.
Diameters diameters_of(const ImportedStructure& structure, const ImportSettings& settings) {
    const auto m = static_cast<Eigen::Index>(structure.edges.size());
    if (settings.diameter) {
        return {.values = Eigen::VectorXd::Constant(m, *settings.diameter),
                .source = fmt::format("diameter {:.4g} mm", 1e3 * *settings.diameter)};
    }
    return diameters_by_attribute(structure, settings.diameter_attribute);
}

ImportedStiffness from_young(const ImportedStructure& structure, const ImportSettings& settings) {
    const Diameters diameters = diameters_of(structure, settings);
    return {.values = stiffness(Eigen::ArrayXd::Constant(diameters.values.size(), *settings.young),
                                diameters.values.array() / 2.0),
            .source = fmt::format("Young's modulus {:.6g} GPa, {}", *settings.young / 1e9,
                                  diameters.source)};
}

/// A law for each diameter: stress times area.
ImportedStiffness from_stress_strain(const ImportedStructure& structure,
                                     const ImportSettings& settings) {
    Diameters diameters;
    if (settings.diameter || !settings.diameter_attribute.empty()) {
        diameters = diameters_of(structure, settings);
    } else if (const auto r = numbers_of(structure, {"r", "radius"});
               r && (r->array() > 0.0).all()) {
        diameters = {.values = 2.0 * *r, .source = "the file's r, taken in m"};
    } else {
        throw InputError(structure.file, "",
                         "gives no positive radius r of every edge: give a diameter");
    }
    const StressStrain& table = *settings.stress_strain;
    ImportedStiffness result{.values = Eigen::VectorXd(diameters.values.size()),
                             .source = fmt::format("stress over strain of {} points, {}",
                                                   table.strain.size(), diameters.source)};
    std::map<double, int> law_of_diameter;
    for (Eigen::Index e = 0; e < diameters.values.size(); ++e) {
        const double diameter = diameters.values(e);
        const double area = std::numbers::pi * diameter * diameter / 4.0;
        const auto [found, is_new] =
            law_of_diameter.emplace(diameter, static_cast<int>(result.laws.size()));
        if (is_new) {
            result.laws.push_back({.name = fmt::format("{:.4g} mm", 1e3 * diameter),
                                   .strain = table.strain,
                                   .tension = area * table.stress});
        }
        result.law_of_edge.push_back(found->second);
        result.values(e) = result.laws[found->second].steepest();
    }
    return result;
}

}  // namespace

double ImportedStiffness::tension(Eigen::Index edge, double strain, double force_unit) const {
    return laws.empty() ? (in_force_unit ? force_unit : 1.0) * values(edge) * strain
                        : laws[law_of_edge[edge]].at(strain).tension;
}

double ImportedStiffness::strain(Eigen::Index edge, double tension, double force_unit) const {
    return laws.empty() ? tension / ((in_force_unit ? force_unit : 1.0) * values(edge))
                        : laws[law_of_edge[edge]].strain_at(tension);
}

ImportedStiffness stiffness_of(const ImportedStructure& structure, const ImportSettings& settings) {
    check(settings);
    const auto m = static_cast<Eigen::Index>(structure.edges.size());
    if (settings.axial_stiffness) {
        return {.values = Eigen::VectorXd::Constant(m, *settings.axial_stiffness),
                .source = fmt::format("{:.6g} kN for all edges", *settings.axial_stiffness / 1e3)};
    }
    if (settings.stress_strain) {
        return from_stress_strain(structure, settings);
    }
    if (settings.young) {
        return from_young(structure, settings);
    }
    if (const auto EA = numbers_of(structure, {"EA"})) {
        return {.values = *EA, .in_force_unit = true, .source = "the file's EA"};
    }
    const auto E = numbers_of(structure, {"E"});
    const auto r = numbers_of(structure, {"r", "radius"});
    if (!E || !r) {
        throw InputError(
            structure.file, "",
            "gives no axial stiffness (EA, or E and r): give it, or Young's modulus and a "
            "diameter, or stress over strain");
    }
    return {.values = stiffness(1e9 * E->array(), r->array()),
            .source = "the file's E and r, taken in GPa and in m"};
}

}  // namespace taut
