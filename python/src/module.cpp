// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <exception>
#include <string>

#include "bindings.hpp"
#include "calls.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/progress.hpp"
#include "taut/survey/survey.hpp"
#include "taut/version.hpp"

namespace taut::python {
namespace {

/// Exceptions of taut as those of Python: the same words.
void bind_exceptions(nb::module_& module) {
    nb::exception<InputError>(module, "InputError", PyExc_ValueError).doc() =
        "A file that cannot be read as what it should be: 'file:place: what is wrong'.";
    nb::exception<NetError>(module, "NetError", PyExc_ValueError).doc() =
        "A rule of a cable net that is broken: 'edges[3]: connects node 7 to itself'.";
    nb::exception<SurveyError>(module, "SurveyError", PyExc_ValueError).doc() =
        "A survey that cannot be one of the net.";
    nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
        try {
            std::rethrow_exception(thrown);
        } catch (const Interrupted&) {
            PyErr_SetNone(PyExc_KeyboardInterrupt);
        } catch (const OutputError& error) {
            PyErr_SetString(PyExc_OSError, error.what());
        }
    });
}

}  // namespace

NB_MODULE(_taut, module) {
    module.doc() = "The rooms of taut, bound: import taut instead.";
    module.attr("__version__") = std::string(version());
    bind_exceptions(module);
    module.def(
        "set_threads", &set_threads, nb::arg("threads"),
        "Sets how many threads each call of taut uses from now on, 0 for all of the machine. "
        "NumPy's own are not touched.");
    module.def("threads", &threads, "How many threads each call uses; 0: all of the machine.");
    bind_net(module);
    bind_statics(module);
    bind_design(module);
    bind_survey(module);
    bind_sampling(module);
    bind_gp(module);
    bind_identification(module);
    bind_adjustment(module);
    bind_study(module);
    bind_interchange(module);
}

}  // namespace taut::python
