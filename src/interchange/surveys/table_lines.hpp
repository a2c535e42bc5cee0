// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interchange/surveys/survey_reader.hpp"

namespace taut {

/// A field that says a number, finite or not, and which decimal sign it has.
struct NumberField {
    std::optional<double> value;  ///< empty where it is not finite, as nan and 1e999
    char decimal = '\0';          ///< '.' or ',', or none
};

/// What a field says where it is written as a number, with a decimal point or a decimal comma.
[[nodiscard]] std::optional<NumberField> parse_number_field(std::string_view field);

/// An empty field, or a sign for one: -, --, * or ?.
[[nodiscard]] bool says_nothing(std::string_view field);

/// A line that starts with #, //, ! or %.
[[nodiscard]] bool is_comment(std::string_view line);

/// Splits a line at a separator, ' ' for runs of blanks and tabs. Fields may stand in quotes, "" in
/// them is a quote. Empty fields at the end are left out, blanks around fields, too.
/// @throws InputError for a quote that is not closed
[[nodiscard]] std::vector<std::string> split_fields(const TextLine& line, char separator,
                                                    const std::string& file_name);

/// Fields that are numbers.
[[nodiscard]] size_t count_numbers(const std::vector<std::string>& fields);

/// The separator by which most lines hold three numbers or more; the first of these four:
/// semicolon, tab, comma, blanks.
/// @return nothing where no line holds as many
[[nodiscard]] std::optional<char> detect_table_separator(const std::vector<TextLine>& lines);

/// "semicolon", "tab", "comma", "blanks".
[[nodiscard]] std::string_view name_of_separator(char separator);

}  // namespace taut
