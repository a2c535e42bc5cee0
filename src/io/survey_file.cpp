// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "io/survey_file.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <exception>
#include <iterator>
#include <optional>
#include <utility>

#include "files/csv_table.hpp"
#include "io/polar_survey.hpp"
#include "survey/rounding.hpp"
#include "survey/unit_guess.hpp"
#include "taut/files/input_error.hpp"
#include "taut/files/table_file.hpp"
#include "taut/io/polar_csv.hpp"
#include "taut/io/survey_csv.hpp"

namespace taut {
namespace {

/// Whether the header is that of taut's own CSV, as taut writes it. What the strict reader refuses
/// must then not go to the lenient one of foreign tables, which leaves out lines and guesses units.
bool has_own_header(const std::string& text, const std::string& file_name) {
    try {
        const std::vector<std::string> first = first_fields(text, file_name);
        const std::string header = fmt::format("{}", fmt::join(first, ","));
        const bool has_commas = text.find(header) != std::string::npos;
        return std::ranges::find(first, "rxy") != first.end() ||
               (has_commas && (header == "id,x,y,z" || header == "id,x,y,z,sx,sy,sz"));
    } catch (const InputError&) {
        return false;
    }
}

/// Whether the first line is text, and not the header of taut's own CSV: an error of such a file is
/// reported in the words of a foreign table.
bool starts_with_foreign_header(const std::string& text, const std::string& file_name) {
    try {
        const std::vector<std::string> first = first_fields(text, file_name);
        const auto may_be_number = [](const std::string& field) {
            const auto is_letter = [](char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; };
            return field.find_first_of("0123456789") != std::string::npos &&
                   std::ranges::none_of(field, is_letter);
        };
        constexpr std::array own{"id", "ID", "x", "X"};
        const auto has_unit = [](const std::string& field) {
            return field.find_first_of("[(") != std::string::npos;
        };
        return !first.empty() && std::ranges::none_of(first, may_be_number) &&
               (std::ranges::find(own, first.front()) == own.end() ||
                std::ranges::any_of(first, has_unit));
    } catch (const InputError&) {
        return true;
    }
}

/// Left out lines, the first of them one by one.
void add_left_out(const std::vector<LeftOutLine>& left_out, std::vector<std::string>& notes) {
    constexpr size_t shown = 6;
    for (size_t i = 0; i < std::min(shown, left_out.size()); ++i) {
        notes.push_back(left_out[i].line > 0 ? fmt::format("left out, line {}: {}",
                                                           left_out[i].line, left_out[i].reason)
                                             : fmt::format("left out: {}", left_out[i].reason));
    }
    if (left_out.size() > shown) {
        notes.push_back(fmt::format("left out: {} more lines", left_out.size() - shown));
    }
}

void scale_points(std::vector<SurveyPoint>& points, double unit, double std_unit) {
    for (SurveyPoint& point : points) {
        point.position *= unit;
        if (point.noise_std) {
            *point.noise_std *= std_unit;
        }
    }
}

/// "mm", for people.
std::string unit_text(double length) {
    for (const char* const name : {"m", "mm", "cm", "ft", "us-ft", "in"}) {
        if (length_of_unit(name) == length) {
            return name;
        }
    }
    return fmt::format("units of {:g} m", length);
}

SurveyFile from_own(const CableNet& net, std::vector<SurveyPoint> points,
                    const ReadSurveyOptions& options) {
    SurveyFile file{.points = std::move(points), .is_own = true};
    file.unit = options.unit.value_or(1.0);
    file.rounding = rounding_step(file.points, file.unit);
    if (options.unit) {
        scale_points(file.points, *options.unit, *options.unit);
    } else if (const auto guess = guess_unit(net, file.points); guess && guess->length != 1.0) {
        file.unit_hint = fmt::format("; its extent fits the unit {}, give it", guess->name);
    }
    return file;
}

SurveyFile from_foreign(const CableNet& net, ForeignSurvey survey, const std::string& file_name,
                        const ReadSurveyOptions& options) {
    if (!survey.polar.observations.empty()) {
        SurveyFile file = targets_of_observations(net, std::move(survey.polar), options,
                                                  survey.format, file_name);
        std::ranges::move(survey.notes, std::back_inserter(file.notes));
        add_left_out(survey.left_out, file.notes);
        return file;
    }
    SurveyFile file{.points = std::move(survey.points),
                    .warnings = std::move(survey.guesses),
                    .has_known_points = survey.has_known_points};
    double unit = options.unit.value_or(survey.unit.value_or(0.0));
    file.notes.push_back(fmt::format("read as {}, {}", survey.format,
                                     options.unit ? fmt::format("in {} as given", unit_text(unit))
                                     : survey.unit
                                         ? fmt::format("in {} by the file", unit_text(unit))
                                         : "without a unit"));
    if (unit == 0.0) {
        const auto guess = guess_unit(net, file.points);
        if (!guess) {
            throw InputError(file_name, "",
                             fmt::format("gives no unit, and in none of m, mm and ft its points "
                                         "extend as the net does ({}): give the unit",
                                         extents_text(net, file.points)));
        }
        unit = guess->length;
        const std::string text = fmt::format(
            "the unit is taken as {}: the median distance of points from their middle is {:.4g}, "
            "of "
            "the net's nodes {:.4g} m",
            guess->name, guess->points, guess->nodes);
        (unit == 1.0 ? file.notes : file.warnings).push_back(text);
    }
    file.unit = unit;
    file.rounding = rounding_step(file.points, unit);
    scale_points(file.points, unit, survey.std_unit.value_or(unit));
    std::ranges::move(survey.notes, std::back_inserter(file.notes));
    add_left_out(survey.left_out, file.notes);
    return file;
}

SurveyFile survey_of_text(const CableNet& net, const std::string& text, const std::string& name,
                          const ReadSurveyOptions& options) {
    if (!options.file.format && is_polar_csv(text)) {
        return targets_of_observations(net, parse_polar_csv(text, name, options.file.angle_unit),
                                       options, "observations of angles and distances", name);
    }
    std::exception_ptr own_error;
    const auto is_table = [&] { return detect_survey_format(text, name) == SurveyFormat::table; };
    if (options.file == SurveyFileOptions{} && is_table()) {
        try {
            return from_own(net, parse_survey_points(text, name), options);
        } catch (const InputError&) {
            own_error = std::current_exception();
        }
    }
    if (own_error && has_own_header(text, name)) {
        std::rethrow_exception(own_error);
    }
    std::optional<ForeignSurvey> survey;
    try {
        survey = read_foreign_survey(text, name, options.file);
    } catch (const InputError&) {
        if (own_error && !starts_with_foreign_header(text, name)) {
            std::rethrow_exception(own_error);
        }
        throw;
    }
    return from_foreign(net, std::move(*survey), name, options);
}

/// What a text file has and a sheet has not.
void check_sheet(const SurveyFileOptions& options, const std::string& file_name) {
    if (options.separator || options.encoding) {
        throw InputError(file_name, "",
                         fmt::format("is an Excel file, which has no {}: leave it out",
                                     options.separator ? "separator" : "encoding"));
    }
}

}  // namespace

SurveyFile read_survey_file(const CableNet& net, const std::filesystem::path& path,
                            const ReadSurveyOptions& options) {
    const TableFile table = read_table_file(path);
    if (table.sheet.empty()) {
        return survey_of_text(net, table.text, path.string(), options);
    }
    check_sheet(options.file, path.string());
    SurveyFile file = survey_of_text(net, table.text, path.string(), options);
    // Not in the words of the CSV that it was read through.
    std::erase_if(file.notes,
                  [](const std::string& note) { return note.starts_with("separator:"); });
    constexpr std::string_view as_text = "read as text table";
    const std::string as_sheet = fmt::format("read as Excel sheet '{}'", table.sheet);
    if (!file.notes.empty() && file.notes.front().starts_with(as_text)) {
        file.notes.front().replace(0, as_text.size(), as_sheet);
    } else {
        file.notes.insert(file.notes.begin(), as_sheet);
    }
    return file;
}

}  // namespace taut
