// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "taut/interchange/foreign_survey.hpp"

/// One reader a format. All take text as UTF-8 and the file's name for messages, and give points in
/// the order of the file, not yet checked for being any.
namespace taut {

[[nodiscard]] ForeignSurvey read_survey_table(const std::string& text, const std::string& file_name,
                                              const SurveyFileOptions& options, bool is_cloud);
[[nodiscard]] ForeignSurvey read_pts(const std::string& text, const std::string& file_name);
[[nodiscard]] ForeignSurvey read_gsi(const std::string& text, const std::string& file_name,
                                     const SurveyFileOptions& options);
[[nodiscard]] ForeignSurvey read_landxml(const std::string& text, const std::string& file_name);
[[nodiscard]] ForeignSurvey read_jobxml(const std::string& text, const std::string& file_name);
[[nodiscard]] ForeignSurvey read_gama(const std::string& text, const std::string& file_name);
[[nodiscard]] ForeignSurvey read_dxf(const std::string& text, const std::string& file_name);

/// A line of a text, without its end, counted from 1.
struct TextLine {
    int number = 0;
    std::string_view text;
};

/// The lines of a text: ended by LF, CR LF or CR.
/// @throws InputError for more than 4 million
[[nodiscard]] std::vector<TextLine> lines_of(std::string_view text, const std::string& file_name);

/// Without blanks and tabs at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// ASCII letters in lower case.
[[nodiscard]] std::string in_lower_case(std::string_view text);

}  // namespace taut
