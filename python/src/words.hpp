// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "taut/identification/trust.hpp"

namespace taut::python {

/// A message of the library as it is said in Python: where it names an option of the program, the
/// argument of that name, "--law uniform:5mm" as "prior='uniform:5mm'", "--noise 0.5mm" as
/// "noise=0.0005".
[[nodiscard]] std::string in_python(std::string_view message);

/// The same of "file:place: what is wrong": names of files stay as they are.
[[nodiscard]] std::string of_file_in_python(std::string_view message);

[[nodiscard]] std::vector<std::string> in_python(const std::vector<std::string>& messages);

/// What to do about a finding, with the argument that is its remedy.
[[nodiscard]] std::string advice_in_python(const Trust::Finding& finding);

}  // namespace taut::python
