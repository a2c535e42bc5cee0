// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards the way from observations of angles and distances to lengths: intervals that do not hold
// because a pose, a frame or a covariance between was wrong.

#include <gtest/gtest.h>

#include <cmath>

#include "simulated_survey.hpp"
#include "support/identify_lengths.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/survey/registration.hpp"
#include "taut/survey/simulation.hpp"
#include "taut/survey/station_adjustment.hpp"

namespace taut {
namespace {

struct Tally {
    double inside = 0.0;
    double count = 0.0;
    double squares = 0.0;
    double noise_ratio = 0.0;

    void add(const Identification& found, const Eigen::VectorXd& truth) {
        inside += test::coverage(found, truth);
        squares += test::squared_error(found, truth);
        count += 1.0;
        noise_ratio += found.noise_ratio;
    }
    [[nodiscard]] double coverage() const { return inside / count; }
    [[nodiscard]] double rms() const { return std::sqrt(squares / count); }
};

/// As read_survey() does.
Survey survey_of(const CableNet& net, const PolarSurvey& observations) {
    std::vector<SurveyPoint> points = adjust_stations(observations).points;
    const Registration frame = register_rigidly(support_control_points(net, points));
    Survey survey = match_to_nodes(net, moved(std::move(points), frame.motion));
    survey.frame_is_unknown = true;
    return survey;
}

/// Of 15 surveys, with each target's covariance or with its diagonal alone.
Tally identify_surveys(const std::vector<Eigen::Vector3d>& stations, bool diagonal = false) {
    const CableNet net = hypar(5, 6);
    const LengthPrior prior{LengthPrior::Kind::uniform, 4e-3};
    constexpr int surveys = 15;
    Tally result;
    for (std::uint64_t seed = 1; seed <= surveys; ++seed) {
        const test::SimulatedSurvey built = test::simulate(net, prior, 0.0, seed);
        Survey survey = survey_of(net, simulate_polar_survey(net, built.truth.form,
                                                             {.stations = stations,
                                                              .distance = {.std_dev = 1.5e-3},
                                                              .dropped_part = 0.1,
                                                              .seed = seed}));
        if (diagonal) {
            survey.noise_correlations.resize(3, 0);
        }
        result.add(test::identify_lengths(net, survey, {.prior = prior}), built.deviations);
    }
    result.noise_ratio /= surveys;
    return result;
}

// 15 surveys of 71 lengths: a coverage of 95 % varies by some 1 %.
void expect_honest(const Tally& tally) {
    EXPECT_NEAR(tally.coverage(), 0.95, 0.025);
    EXPECT_NEAR(tally.noise_ratio, 1.0, 0.06);
}

TEST(PolarSurvey, OfOneStationGivesIntervalsThatHold) {
    const std::vector<Eigen::Vector3d> station{{-3.0, -4.0, 1.0}};
    const Tally whole = identify_surveys(station);
    expect_honest(whole);
    EXPECT_LT(whole.rms(), 0.95 * identify_surveys(station, true).rms());
}

TEST(PolarSurvey, OfTwoStationsGivesIntervalsThatHold) {
    expect_honest(identify_surveys({{-3.0, -4.0, 1.0}, {9.0, 3.0, -0.5}}));
}

}  // namespace
}  // namespace taut
