// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Surveys and forms.

#include "fuzz.hpp"
#include "taut/io/survey_csv.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace taut;
    return fuzz::refuse_or_read([&] {
        for (const SurveyPoint& point :
             parse_survey_points(fuzz::text_of(data, size), "survey.csv")) {
            fuzz::require(point.position.allFinite());
        }
    });
}
