// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards the way from observations of angles and distances to lengths: intervals that do not hold
// because a pose, a frame or a covariance between was wrong.

#include <gtest/gtest.h>

#include <cmath>

#include "simulated_survey.hpp"
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

/// Of 15 surveys, with each target's covariance and with its diagonal alone.
std::pair<Tally, Tally> identify_surveys(const std::vector<Eigen::Vector3d>& stations) {
    const CableNet net = hypar(5, 6);
    const LengthPrior prior{LengthPrior::Kind::uniform, 4e-3};
    constexpr int surveys = 15;
    std::pair<Tally, Tally> result;
    for (std::uint64_t seed = 1; seed <= surveys; ++seed) {
        const test::SimulatedSurvey built = test::simulate(net, prior, 0.0, seed);
        Survey survey = survey_of(net, simulate_polar_survey(net, built.truth.form,
                                                             {.stations = stations,
                                                              .distance = {.std = 1.5e-3},
                                                              .dropped_part = 0.1,
                                                              .seed = seed}));
        result.first.add(identify(net, survey, {.prior = prior}), built.deviations);
        survey.noise_correlations.resize(3, 0);
        result.second.add(identify(net, survey, {.prior = prior}), built.deviations);
    }
    result.first.noise_ratio /= surveys;
    return result;
}

// 15 surveys of 71 lengths: a coverage of 95 % varies by some 1 %.
void expect_honest_and_better(const std::pair<Tally, Tally>& tallies) {
    const auto& [whole, diagonal] = tallies;
    EXPECT_NEAR(whole.coverage(), 0.95, 0.025);
    EXPECT_NEAR(whole.noise_ratio, 1.0, 0.06);
    EXPECT_LT(whole.rms(), 0.95 * diagonal.rms());
}

TEST(PolarSurvey, OfOneStationGivesIntervalsThatHold) {
    expect_honest_and_better(identify_surveys({{-3.0, -4.0, 1.0}}));
}

TEST(PolarSurvey, OfTwoStationsGivesIntervalsThatHold) {
    const auto tallies = identify_surveys({{-3.0, -4.0, 1.0}, {9.0, 3.0, -0.5}});
    EXPECT_NEAR(tallies.first.coverage(), 0.95, 0.025);
    EXPECT_NEAR(tallies.first.noise_ratio, 1.0, 0.06);
}

}  // namespace
}  // namespace taut
