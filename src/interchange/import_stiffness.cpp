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
    if (settings.young.has_value() != has_diameter) {
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

ImportedStiffness from_young(const ImportedStructure& structure, const ImportSettings& settings) {
    const auto m = static_cast<Eigen::Index>(structure.edges.size());
    const std::string young = fmt::format("{:.6g} GPa", *settings.young / 1e9);
    if (settings.diameter) {
        const Eigen::ArrayXd radii = Eigen::ArrayXd::Constant(m, *settings.diameter / 2);
        return {.values = stiffness(Eigen::ArrayXd::Constant(m, *settings.young), radii),
                .source = fmt::format("Young's modulus {}, diameter {:.4g} mm", young,
                                      1e3 * *settings.diameter)};
    }
    const std::string& name = settings.diameter_attribute;
    Eigen::VectorXd diameters(m);
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
    const Eigen::ArrayXd radii = diameters.array() / 2000.0;
    return {
        .values = stiffness(Eigen::ArrayXd::Constant(m, *settings.young), radii),
        .source = fmt::format("Young's modulus {}, diameter by the attribute {} taken in mm: {}",
                              young, quote(name), diameters_text(diameters))};
}

}  // namespace

ImportedStiffness stiffness_of(const ImportedStructure& structure, const ImportSettings& settings) {
    check(settings);
    const auto m = static_cast<Eigen::Index>(structure.edges.size());
    if (settings.axial_stiffness) {
        return {.values = Eigen::VectorXd::Constant(m, *settings.axial_stiffness),
                .source = fmt::format("{:.6g} kN for all edges", *settings.axial_stiffness / 1e3)};
    }
    if (settings.young) {
        return from_young(structure, settings);
    }
    if (const auto EA = numbers_of(structure, {"EA"})) {
        return {.values = *EA, .in_force_unit = true, .source = "the file's EA"};
    }
    const auto E = numbers_of(structure, {"E"});
    const auto r = numbers_of(structure, {"r"});
    if (!E || !r) {
        throw InputError(structure.file, "",
                         "gives no axial stiffness (EA, or E and r): name it with "
                         "--axial-stiffness, or --young and --diameter");
    }
    return {.values = stiffness(1e9 * E->array(), r->array()),
            .source = "the file's E and r, taken in GPa and in m"};
}

}  // namespace taut
