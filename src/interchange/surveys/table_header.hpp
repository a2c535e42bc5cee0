// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interchange/surveys/table_columns.hpp"
#include "interchange/surveys/table_lines.hpp"
#include "taut/interchange/foreign_survey.hpp"

namespace taut {

/// What stands before the points of a table, and what follows from it.
struct TableHead {
    TableLayout layout;
    size_t first = 0;                   ///< index of the first line that holds a point
    std::optional<size_t> header;       ///< index of the line that names the columns
    std::vector<std::string> titles;    ///< of the columns; empty: none
    std::optional<double> unit;         ///< of x, y and z [m]
    std::optional<double> spread_unit;  ///< of sx, sy and sz [m]
    std::vector<std::string> guesses;
};

/// Finds the columns: those of the options, else of a header, which may be a comment, else by what
/// stands in them.
/// @param is_cloud points without names: x y z and what is behind
/// @throws InputError where no line holds three numbers, a header names too little or a column
///   twice, or the units of coordinates differ
[[nodiscard]] TableHead read_table_head(const std::vector<TextLine>& lines, char separator,
                                        const SurveyFileOptions& options, bool is_cloud,
                                        const std::string& file_name);

}  // namespace taut
