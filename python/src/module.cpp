// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/variant.h>

#include <exception>
#include <stdexcept>
#include <string>

#include "bindings.hpp"
#include "calls.hpp"
#include "taut/adjustment/request_error.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/progress.hpp"
#include "taut/survey/survey.hpp"
#include "taut/version.hpp"
#include "words.hpp"

namespace taut::python {
namespace {

/// Exceptions of taut as those of Python. Their messages name arguments in place of options.
void bind_exceptions(nb::module_& module) {
    static PyObject* input_error = nullptr;
    static PyObject* missing_input_error = nullptr;
    static PyObject* net_error = nullptr;
    static PyObject* survey_error = nullptr;
    const auto bind = [&module](PyObject*& type, const char* name, const char* doc,
                                PyObject* bases = PyExc_ValueError) {
        const std::string full =
            fmt::format("{}.{}", nb::cast<std::string>(module.attr("__name__")), name);
        type = PyErr_NewExceptionWithDoc(full.c_str(), doc, bases, nullptr);
        module.attr(name) = nb::handle(type);
    };
    bind(input_error, "InputError", "A file that cannot be read: 'file:place: what is wrong'.");
    const nb::tuple of_missing =
        nb::make_tuple(nb::handle(input_error), nb::handle(PyExc_FileNotFoundError));
    bind(missing_input_error, "MissingInputError", "A file that is not there.", of_missing.ptr());
    bind(net_error, "NetError",
         "A cable net that breaks a rule: 'edges[3]: connects node 7 to itself'.");
    bind(survey_error, "SurveyError", "A survey that cannot be one of the net.");
    nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
        const auto raise = [](PyObject* type, const std::exception& error) {
            PyErr_SetString(type, in_python(error.what()).c_str());
        };
        const auto raise_of_file = [](PyObject* type, const std::exception& error) {
            PyErr_SetString(type, of_file_in_python(error.what()).c_str());
        };
        try {
            std::rethrow_exception(thrown);
        } catch (const Interrupted&) {
            PyErr_SetNone(PyExc_KeyboardInterrupt);
        } catch (const OutputError& error) {
            raise_of_file(PyExc_OSError, error);
        } catch (const MissingInputError& error) {
            raise_of_file(missing_input_error, error);
        } catch (const InputError& error) {
            raise_of_file(input_error, error);
        } catch (const NetError& error) {
            raise(net_error, error);
        } catch (const SurveyError& error) {
            raise(survey_error, error);
        } catch (const RequestError& error) {
            PyErr_SetString(PyExc_ValueError, (error.field() + ": " + error.problem()).c_str());
        } catch (const std::invalid_argument& error) {
            raise(PyExc_ValueError, error);
        }
    });
}

}  // namespace

NB_MODULE(_taut, module) {
    nb::set_leak_warnings(false);  // threads that live when Python ends keep what they hold
    module.doc() = "The compiled part of taut: import taut instead.";
    module.attr("__version__") = std::string(version());
    bind_exceptions(module);
    module.def(
        "set_threads", &set_threads, nb::arg("threads"),
        "Sets how many threads each call of taut uses from now on, 0 for all of the machine. NumPy "
        "keeps its own.");
    module.def("threads", &threads,
               "Number of threads that each call uses; 0: all of the machine.");
    module.def("set_memory_limit", &set_memory_limit, nb::arg("limit").none(),
               "Sets how much memory each call of taut may take from now on for its large arrays: "
               "matrices, data sets and posterior samples. A call that needs more raises "
               "MemoryError.\n\nArgs:\n    limit: bytes, or text such as \"8GiB\"; None: no limit");
    module.def("memory_limit", &memory_limit, "Bytes that each call may take; None: no limit.");
    bind_net(module);
    bind_statics(module);
    bind_design(module);
    bind_survey(module);
    bind_frequency(module);
    bind_sampling(module);
    bind_gp(module);
    bind_identification(module);
    bind_precision(module);
    bind_adjustment(module);
    bind_study(module);
    bind_interchange(module);
}

}  // namespace taut::python
