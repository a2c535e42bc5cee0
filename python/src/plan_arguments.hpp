// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Arguments of plan() that may be one value, or values by group, edge or name.
#pragma once

#include <nanobind/nanobind.h>

#include <optional>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "taut/adjustment/form_target.hpp"
#include "taut/adjustment/plan_turns.hpp"
#include "taut/net/cable_net.hpp"

namespace taut::python {

/// A form, the name of a file, or a surface of vertices and triangles.
class TargetLike : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(TargetLike, nb::object,
              "numpy.typing.ArrayLike | str | os.PathLike | tuple[numpy.typing.ArrayLike, "
              "numpy.typing.ArrayLike]",
              is_any)
};

/// Least and most, either of which may be left out; of all edges, or by group.
class RangeLike : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(
        RangeLike, nb::object,
        "tuple[float | str | None, float | str | None] | dict[str | None, tuple[float | str | "
        "None, float | str | None]]",
        is_any)
};

/// The longest stroke, or the shortest and longest by edge.
class StrokeLike : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(StrokeLike, nb::object, "float | str | dict[int, tuple[float | str, float | str]]",
              is_any)
};

/// A force of all supports, or by group.
class ForceLike : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(ForceLike, nb::object, "float | str | dict[str | None, float | str]", is_any)
};

/// A tension, or tension and tolerance, of all edges, or by group or edge; or a tension of each
/// edge.
class TensionLike : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(
        TensionLike, nb::object,
        "float | str | tuple[float | str, float | str] | numpy.typing.NDArray | dict[str | int "
        "| None, float | str | tuple[float | str, float | str]]",
        is_any)
};

/// Arrays by their names.
class ArraysByName : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(ArraysByName, nb::object, "dict[str, numpy.typing.ArrayLike]", is_any)
};

/// Each adds what is given to the request; nothing where nothing is.
/// @throws nb::type_error, nb::value_error, RequestError naming the argument
/// @param is_part whether bounds are parts of the breaking load
void add_tension(PlanRequest& request, const std::optional<RangeLike>& given, const char* name,
                 bool is_part);
void add_strokes(PlanRequest& request, const std::optional<StrokeLike>& given);
void add_target_tensions(PlanRequest& request, const CableNet& net,
                         const std::optional<TensionLike>& given);
void add_reactions(PlanRequest& request, const std::optional<ForceLike>& given);
void add_load_cases(PlanRequest& request, const CableNet& net,
                    const std::optional<ArraysByName>& given);

/// @param unit_name of a surface
[[nodiscard]] GivenTarget target_argument(const CableNet& net,
                                          const std::optional<TargetLike>& given,
                                          const std::string& unit_name);

/// One number for all nodes or one of each, along the normal and across it.
[[nodiscard]] std::vector<NodeWeights> node_weights(const CableNet& net,
                                                    const ArrayLike& along_normal,
                                                    const ArrayLike& across);

[[nodiscard]] FormObjective objective_named(const std::string& name);

}  // namespace taut::python
