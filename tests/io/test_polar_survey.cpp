// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards the way from a file of readings to a survey: a precision that is assumed without a word,
// angles in another unit than told, a station that nothing ties to the others.

#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <functional>

#include "support/errors.hpp"
#include "support/scratch.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/io/polar_csv.hpp"
#include "taut/io/read_survey.hpp"
#include "taut/survey/covariance.hpp"
#include "taut/survey/simulation.hpp"

namespace taut {
namespace {

using test::input_error_of;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class PolarFile : public testing::Test {
protected:
    [[nodiscard]] PolarSurvey readings(std::uint64_t seed = 1, bool shuffled = false) const {
        return simulate_polar_survey(
            m_net, m_net.nodes(),
            {.stations = {{0, -6, 1}, {8, 1, 0}}, .shuffled = shuffled, .seed = seed});
    }

    [[nodiscard]] Survey read(const std::string& text,
                              const ReadSurveyOptions& options = {}) const {
        test::put_bytes(m_scratch / "readings.csv", text);
        return read_survey(m_net, m_scratch / "readings.csv", options);
    }

    [[nodiscard]] std::string refusal(const std::string& text,
                                      const ReadSurveyOptions& options = {}) const {
        return input_error_of([&] { return read(text, options); })
            .substr(m_scratch.path().string().size() + 1);
    }

    /// Without what is told of the precision.
    [[nodiscard]] static std::string untold(PolarSurvey survey) {
        for (PolarObservation& reading : survey.readings) {
            reading.angle_std = 0.0;
            reading.distance_std = 0.0;
        }
        return polar_to_csv(survey);
    }

    [[nodiscard]] static PolarSurvey altered(PolarSurvey survey,
                                             const std::function<void(PolarObservation&)>& alter) {
        std::ranges::for_each(survey.readings, alter);
        return survey;
    }

    const CableNet m_net = hypar(4, 5);
    test::ScratchDirectory m_scratch;
};

TEST_F(PolarFile, GivesEveryNodeWithItsCovarianceInTheNetsFrame) {
    const Survey survey = read(polar_to_csv(readings()));
    EXPECT_TRUE(survey.is_whole());
    EXPECT_TRUE(survey.frame_is_unknown);
    EXPECT_EQ(survey.supports.size(), m_net.supports().size());
    EXPECT_THAT(survey.warnings, IsEmpty());
    EXPECT_THAT(survey.notes,
                Contains("76 readings of 38 targets from 2 stations; angles as the file tells, "
                         "distances as the file tells"));
    for (const int node : survey.surveyed) {
        EXPECT_LT((survey.form.col(node) - m_net.nodes().col(node)).norm(), 0.003);
        // Two stations: no direction is known by the distances alone, of 1 mm, and the best is by
        // angles, of 0.3 mgon at 3 to 9 m.
        const Eigen::Vector3d variances =
            covariance_of(
                {.std = survey.noise_std.col(node), .correlations = survey.correlations_of(node)})
                .selfadjointView<Eigen::Lower>()
                .eigenvalues();
        EXPECT_LT(std::sqrt(variances.minCoeff()), 0.045e-3);
        EXPECT_LT(std::sqrt(variances.maxCoeff()), 0.8e-3);
    }
}

TEST_F(PolarFile, TakesThePrecisionThatIsToldElseSaysWhichIsAssumed) {
    const std::string text = untold(readings());
    const Survey assumed = read(text);
    EXPECT_THAT(assumed.warnings,
                Contains("tells no precision of its readings: a common total station's is taken, "
                         "angles 0.3 mgon, distances 1 mm + 1.5 ppm (--angle, --range)"));
    const Survey told = read(text, {.angle_std = 0.6e-3 * gon,
                                    .distance = DistancePrecision{.std = 2e-3, .part = 3e-6}});
    EXPECT_THAT(told.warnings, IsEmpty());
    EXPECT_THAT(told.notes, Contains(HasSubstr("angles 0.6 mgon, distances 2 mm + 3 ppm")));
    // Twice as large, all of it.
    EXPECT_TRUE(told.noise_std.isApprox(2.0 * assumed.noise_std, 1e-4));
}

TEST_F(PolarFile, MatchesNamesOfItsOwnByPlace) {
    const Survey survey = read(polar_to_csv(readings(3, true)));
    EXPECT_TRUE(survey.is_whole());
    EXPECT_THAT(survey.warnings, Contains(HasSubstr("matched by their place")));
}

TEST_F(PolarFile, OfDegreesWhereGonWasToldIsRefused) {
    // The numbers of degrees below a header that says gon.
    PolarSurvey degrees = altered(readings(), [](PolarObservation& reading) {
        reading.direction *= gon / degree;
        reading.zenith *= gon / degree;
    });
    const char* const message =
        "readings.csv:2: its angles are most likely in degrees, where gon was told: read so, the "
        "targets have the shape of the net";
    EXPECT_EQ(refusal(polar_to_csv(degrees)), message);
    degrees.stations.resize(1);
    std::erase_if(degrees.readings, [](const PolarObservation& one) { return one.station == 1; });
    EXPECT_EQ(refusal(polar_to_csv(degrees)), message);
}

TEST_F(PolarFile, OfAStationThatNothingTiesToTheOthersIsRefused) {
    const PolarSurvey untied = altered(readings(), [](PolarObservation& reading) {
        reading.target += reading.station == 1 && reading.target != "7" ? "b" : "";
    });
    EXPECT_EQ(refusal(polar_to_csv(untied)),
              "readings.csv:40: station '2' has 1 targets in common with the other stations, "
              "expected at least 2: it has no orientation");
}

TEST_F(PolarFile, WarnsOfReadingsThatContradictEachOther) {
    PolarSurvey wrong = readings();
    wrong.readings[12].distance += 0.03;
    EXPECT_THAT(read(polar_to_csv(wrong)).warnings,
                Contains(HasSubstr("target '32' from station '1', line 14")));
}

TEST_F(PolarFile, IsAskedForInVainOfCoordinates) {
    EXPECT_THAT(refusal("id,x,y,z\n0,1,2,3\n", {.file = {.takes_readings = true}}),
                HasSubstr("readings.csv: holds no readings of angles and distances"));
}

}  // namespace
}  // namespace taut
