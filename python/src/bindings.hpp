// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// What each room shows to Python, in the order of the rooms. All go into one module.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>

namespace taut::python {

namespace nb = nanobind;

void bind_net(nb::module_& module);
void bind_statics(nb::module_& module);
void bind_design(nb::module_& module);
void bind_survey(nb::module_& module);
void bind_frequency(nb::module_& module);
void bind_sampling(nb::module_& module);
void bind_gp(nb::module_& module);
void bind_identification(nb::module_& module);
void bind_identification_result(nb::module_& module);  ///< for bind_identification()
void bind_precision(nb::module_& module);
void bind_adjustment(nb::module_& module);
void bind_plan(nb::module_& module);  ///< for bind_adjustment()
void bind_study(nb::module_& module);
void bind_interchange(nb::module_& module);

/// An argument that fits nothing until nanobind converts arguments, and then its default: so an
/// overload that has it is tried after all others, with conversions, too.
struct TriedLast {};

/// What a constructor says to arguments that none of its overloads takes: one line.
template <class T>
void refuse_other_arguments(nb::class_<T>& of) {
    of.def(
        "__init__",
        [](T* /*self*/, const nb::args& args, TriedLast /*last*/, const nb::kwargs& kwargs) {
            nb::module_::import_("taut.calls").attr("refuse")(nb::type<T>(), args, kwargs);
        },
        nb::arg("args"), nb::arg("_") = nb::none(), nb::arg("kwargs"));
}

/// A function of one of the package's own files, imported when it is first called.
inline nb::object of_package(const char* module, const char* function) {
    return nb::module_::import_(module).attr(function);
}

}  // namespace taut::python

namespace nanobind::detail {

template <>
struct type_caster<taut::python::TriedLast> {
    NB_TYPE_CASTER(taut::python::TriedLast, const_name("None"))

    template <class Flags>
    bool from_python(handle /*value*/, Flags flags, cleanup_list* /*cleanup*/) noexcept {
        return (flags & static_cast<Flags>(cast_flags::convert)) != 0;
    }
};

}  // namespace nanobind::detail
