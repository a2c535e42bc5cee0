// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/study/study.hpp"

namespace taut {

/// The data of the paper's plots as CSV files (name, content), all numbers in m:
///
///     edges.csv   per interior edge: ends, unstressed length; true, estimated, std and error of
///                 the first validation sample; mean and std of the error over all of them
///     errors.csv  per interior edge: its error in each validation sample
///     nodes.csv   per free node: nominal place, nominal and identified form error of this sample
[[nodiscard]] TAUT_IO_EXPORT std::vector<std::pair<std::string, std::string>> study_to_csv(
    const Study& study);

}  // namespace taut
