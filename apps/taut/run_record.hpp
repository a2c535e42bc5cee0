// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/results/results_json.hpp"

namespace taut::app {

/// Keeps the command line for the results that this run writes.
void remember_command_line(int argc, const char* const* argv);

/// The command line, quoted where a shell would need it, and the time now.
[[nodiscard]] RunRecord run_record();

}  // namespace taut::app
