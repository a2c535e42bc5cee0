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

/// A function of one of the package's own files, imported when it is first called.
inline nb::object of_package(const char* module, const char* function) {
    return nb::module_::import_(module).attr(function);
}

}  // namespace taut::python
