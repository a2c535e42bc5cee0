// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace taut::python {

/// A message of the library as it is said in Python: where it names an option of the program, the
/// argument of that name, "--force-unit kN" as "force_unit kN".
[[nodiscard]] std::string in_python(std::string_view message);

[[nodiscard]] std::vector<std::string> in_python(const std::vector<std::string>& messages);

}  // namespace taut::python
