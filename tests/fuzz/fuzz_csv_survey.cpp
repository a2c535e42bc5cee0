// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Surveys and forms; observations of angles and distances, force measurements, and lists of edges.

#include "fuzz.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/io/forces_csv.hpp"
#include "taut/io/frame_csv.hpp"
#include "taut/io/polar_csv.hpp"
#include "taut/io/survey_csv.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace taut;
    const auto text = fuzz::text_of(data, size);
    static const CableNet net = hypar(2, 3);
    fuzz::refuse_or_read([&] {
        for (const ForceMeasurement& measurement :
             parse_force_measurements(net, text, "forces.csv")) {
            fuzz::require(measurement.tension >= 0.0 && measurement.std_dev > 0.0);
        }
    });
    fuzz::refuse_or_read([&] {
        const FrameStiffness frame = parse_frame(net, text, "frame.csv");
        fuzz::require(!on_frame(net, frame).elastic_supports().empty());
    });
    fuzz::refuse_or_read([&] {
        for (const int edge : parse_edge_list(net, text, "edges.txt")) {
            fuzz::require(edge >= 0 && edge < net.edge_count());
        }
    });
    fuzz::refuse_or_read([&] {
        for (const PolarObservation& observation :
             parse_polar_csv(text, "polar.csv", 1.0).observations) {
            fuzz::require(observation.distance > 0.0 && observation.zenith >= 0.0);
        }
    });
    return fuzz::refuse_or_read([&] {
        for (const SurveyPoint& point : parse_survey_points(text, "survey.csv")) {
            fuzz::require(point.position.allFinite());
        }
    });
}
