// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "files/csv_reader.hpp"
#include "files/message.hpp"
#include "files/parse_number.hpp"
#include "interchange/surveys/survey_reader.hpp"
#include "taut/files/input_error.hpp"

namespace taut {

ForeignSurvey read_pts(const std::string& text, const std::string& file_name) {
    CsvReader reader(text, file_name);
    const auto head = reader.next();
    const auto announced =
        head && head->fields.size() == 1 ? parse_number(head->fields[0]) : std::nullopt;
    if (!announced || *announced < 1.0 || *announced != std::floor(*announced)) {
        throw InputError(file_name, "1", "is not the number of points that a PTS file starts with");
    }
    ForeignSurvey survey{.format = "PTS points"};
    while (const auto record = reader.next()) {
        const auto fail = [&](const std::string& what) {
            throw InputError(file_name, std::to_string(record->line), what);
        };
        constexpr size_t coordinates = 3;
        if (record->fields.size() < coordinates) {
            fail(
                fmt::format("has {} fields, expected x y z, with or without intensity and colour "
                            "behind",
                            record->fields.size()));
        }
        SurveyPoint point{.line = record->line};
        for (size_t k = 0; k < coordinates; ++k) {
            const auto value = parse_number(record->fields[k]);
            if (!value) {
                fail(fmt::format("{} is {}, expected a {}", "xyz"[k], quote(record->fields[k]),
                                 record -> fields[k].find(',') != std::string::npos
                                               ? "number with a decimal point, not a comma"
                                               : "finite number"));
            }
            point.position(static_cast<Eigen::Index>(k)) = *value;
        }
        survey.points.push_back(std::move(point));
    }
    if (static_cast<double>(survey.points.size()) != *announced) {
        throw InputError(file_name, "",
                         fmt::format("holds {} points, expected {} as its first line says",
                                     survey.points.size(), *announced));
    }
    return survey;
}

}  // namespace taut
