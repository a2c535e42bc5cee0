// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "taut/identification/trust.hpp"

namespace taut::python {

/// A message of the library with arguments of Python in place of options of the program: for
/// "--prior uniform:5mm" "prior='uniform:5mm'", for "--noise 0.5mm" "noise=0.0005".
[[nodiscard]] std::string in_python(std::string_view message);

/// The same for "file:place: what is wrong", in which the name of the file stays as it is.
[[nodiscard]] std::string of_file_in_python(std::string_view message);

[[nodiscard]] std::vector<std::string> in_python(const std::vector<std::string>& messages);

/// What to do about a finding, with its remedy as an argument.
[[nodiscard]] std::string advice_in_python(const Trust::Finding& finding);

}  // namespace taut::python
