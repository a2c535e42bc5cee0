// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Surveys of other programs: what is no XML, GSI or DXF is a table or a cloud of points.

#include "fuzz.hpp"
#include "taut/interchange/foreign_survey.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace taut;
    const auto bytes = fuzz::text_of(data, size);
    for (const char* const name : {"survey.txt", "survey.xyz"}) {
        fuzz::refuse_or_read([&] {
            const ForeignSurvey survey = read_foreign_survey(bytes, name);
            fuzz::require(!survey.points.empty() || !survey.polar.observations.empty());
            for (const PolarObservation& observation : survey.polar.observations) {
                fuzz::require(observation.station < std::ssize(survey.polar.stations));
            }
            for (const SurveyPoint& point : survey.points) {
                fuzz::require(point.position.allFinite());
                fuzz::require(!point.noise_std || point.noise_std->minCoeff() >= 0.0);
            }
        });
    }
    return 0;
}
