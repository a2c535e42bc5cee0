// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// What is not known exactly of a net besides its lengths (a nuisance parameter): numbers with
/// independent normal distributions around the design.
struct TAUT_CORE_EXPORT UncertainParameter {
    /// What is uncertain.
    enum class Kind {
        stiffness,       ///< logarithm of one factor of EA, or of the tension law, common to edges
        stiffness_each,  ///< one such factor per edge
        temperature,     ///< one deviation from the design temperature, common to edges [K]
        supports,        ///< each coordinate of each support, of elastic ones without load [m]
        adjustable,      ///< the unstressed length of each adjustable edge [m]
        loads,           ///< one relative deviation of all loads but an uncertain self-weight
        loads_each,      ///< each coordinate of the load on each free node [N]
        forces,          ///< one relative error of all load cells
        mass,            ///< one relative error of the mass of all edges: of their self-weight, and
                         ///< of tensions found from frequencies and sags
        test_loads,      ///< one relative error of the known loads of a survey, Epoch::loads
        support_stiffness,  ///< logarithm of one factor of the stiffness of all elastic supports
        creep,              ///< strain that edges gain in common from one survey to the next
        slip,               ///< length that has passed at each node where a run slides [m]
    };
    Kind kind = Kind::stiffness;  ///< what the numbers are
    double std_dev = 0.0;         ///< standard deviation, in the unit of the kind
    std::string group;            ///< of edges, of the net; empty: all

    /// Of std_dev: "1" for a part, "K", "m" or "N".
    [[nodiscard]] std::string_view unit() const;

    friend bool operator==(const UncertainParameter&,
                           const UncertainParameter&) = default;  ///< by all members
};

/// "stiffness", "stiffness-each", "temperature", "supports", "adjustable", "loads", "forces",
/// "mass", "test-loads", "support-stiffness", "creep", "slip".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(UncertainParameter::Kind kind);
/// "stiffness:5%@ridge"; parse_uncertain_parameter() reads it back.
[[nodiscard]] TAUT_CORE_EXPORT std::string to_string(const UncertainParameter& parameter);
/// "stiffness:5%, supports:1mm", or "none".
[[nodiscard]] TAUT_CORE_EXPORT std::string to_string(
    const std::vector<UncertainParameter>& uncertain);

/// "stiffness:5%", "stiffness:5%@GROUP", "stiffness-each:3%", "temperature:10K", "supports:1mm",
/// "adjustable:0.5mm", "loads:20N", "loads:10%", "forces:1%", "mass:3%",
/// "test-loads:1%", "support-stiffness:10%", "creep:0.01%@GROUP", "slip:50mm".
/// @throws std::invalid_argument for another name or unit, a width that is not positive and finite,
///   a relative one of 30 % or more (of the stiffness of supports 70 %), and a group where the
///   kind has none
[[nodiscard]] TAUT_CORE_EXPORT UncertainParameter parse_uncertain_parameter(std::string_view text);

/// Checks that these parameters can be uncertain of a net.
/// @throws std::invalid_argument for two of one name and group (of loads: of one kind), a group
///   that the net does not have, a temperature where no edge of it expands, adjustable lengths
///   where the net has none, or wider than a third of the shortest, supports wider than a third of
///   the shortest edge, common loads where there are none, a mass where no edge has any, a
///   stiffness of supports where none is elastic
TAUT_CORE_EXPORT void check_uncertain_parameters(const CableNet& net,
                                                 const std::vector<UncertainParameter>& uncertain);

/// The greatest standard deviation of a creep, until the last survey.
inline constexpr double most_creep = 0.01;

/// What is known of forces.
struct KnownForces {
    bool by_cells = false;  ///< load cells or tension meters
    bool by_loads = false;  ///< known loads of a survey
};

/// Adds the default assumptions for a site: stiffness 5 % in common and 2 % of each edge; 5 K where
/// edges expand; lengths of adjustable edges 0.5 mm; places of supports 1 mm. Lengths and places at
/// most a tenth of the shortest edge concerned. Stiffness of elastic supports 25 %. Loads 5 % in
/// common, where there are any. The mass, and with it the self-weight, 3 % where edges have one. Of
/// forces, where measured: 1 % in common of load cells; of known loads that hung on the net at one
/// survey, 2 %. Where runs slide, what has slid: 0.1 m, at most a tenth of the shortest edge that
/// slides, so that nothing is assumed of it.
/// @param given takes precedence: nothing is assumed of a parameter with a name in it
/// @return `given`, then the assumptions
[[nodiscard]] TAUT_CORE_EXPORT std::vector<UncertainParameter> with_site_assumptions(
    const CableNet& net, std::vector<UncertainParameter> given, KnownForces forces = {});

}  // namespace taut
