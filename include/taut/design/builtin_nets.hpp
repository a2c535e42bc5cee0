// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// A net with the counts of the paper's prototype (section 5): 300 free nodes, 536 interior and 128
/// adjustable edges. A square lattice of 132 mm, turned by 45 degrees, in a rectangle of 4.26 m x
/// 1.96 m, less five circles: the touch-downs, where the net meets the ground. EA = 200 kN;
/// form-found with equal force densities, at a mean strain of some 2 %.
[[nodiscard]] TAUT_CORE_EXPORT CableNet hilo_quarter();

/// A hyperbolic paraboloid of rows x columns free nodes, 132 mm apart in plan, with straight
/// borders: corners alternately high and low. EA = 200 kN.
/// @param rows, columns 1 to 1000 each
/// @throws std::invalid_argument outside that range
[[nodiscard]] TAUT_CORE_EXPORT CableNet hypar(int rows, int columns);

/// A roof of spiral strands on an elliptic ring of 36 m x 24 m in plan, with cables 2 m apart.
/// Those along it carry cladding of 0.3 kN/m2 and the self-weight, those across brace them. Strands
/// of 16 and 12 mm follow two slopes, 50 GPa up to 110 MPa and 72.5 GPa above, with 0.066 % of
/// constructional stretch between. They stretch by 2 to 9 mm. Groups "carrying" and "bracing".
[[nodiscard]] TAUT_CORE_EXPORT CableNet steel_roof();

/// A dome of D. Geiger's kind, 21 m across: 12 ridges of cables over two rings of flying struts and
/// one in the middle, hung from a ring beam by diagonals, with two hoops. Turnbuckles at the ring
/// beam. Groups "ridge", "diagonal", "hoop" and "strut".
[[nodiscard]] TAUT_CORE_EXPORT CableNet cable_dome();

/// A roof like a bicycle wheel, 30 m across: 24 upper and 24 lower cables between a flying mast and
/// a rim of struts, on columns that lean (elastic supports). Turnbuckles in the lower cables.
/// Groups "upper", "lower", "rim" and "mast".
[[nodiscard]] TAUT_CORE_EXPORT CableNet spoke_wheel();

/// The tensegrity simplex of a laboratory: three struts, six horizontal and three vertical cables,
/// the last with turnbuckles. It stands on the floor, one foot held, one sliding along x, one free
/// to slide (elastic supports). Dimensions and stiffnesses of J. Feron, L. Rhode-Barbarigos and P.
/// Latteur, Experimental testing of a tensegrity simplex, J. Struct. Eng. 149 (2023). Groups
/// "strut", "horizontal" and "vertical".
[[nodiscard]] TAUT_CORE_EXPORT CableNet tensegrity_simplex();

/// A tent's frame of cables, 16 m long: a ridge that runs over two masts and through the clamps of
/// seven cross cables and slides in all of them, with friction, and a valley on either side.
/// Turnbuckles at the ends of the ridge and in the hold-downs. Groups "ridge", "valley", "cross"
/// and "hold-down".
[[nodiscard]] TAUT_CORE_EXPORT CableNet sliding_ridge();

/// The built-in net of a name: "hilo-quarter", "steel-roof", "cable-dome", "spoke-wheel",
/// "tensegrity-simplex", "sliding-ridge", or "hypar:RxC".
/// @throws std::invalid_argument listing these names, for any other
[[nodiscard]] TAUT_CORE_EXPORT CableNet builtin_net(std::string_view name);

}  // namespace taut
