// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// JSON as dicts of Python.
#pragma once

#include <nanobind/nanobind.h>

#include <string>

namespace taut::python {

namespace nb = nanobind;

/// The keys of a JSON document, by Python's own reader.
[[nodiscard]] nb::dict dict_of(const std::string& json);

}  // namespace taut::python
