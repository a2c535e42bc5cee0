// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards the way from a file of observations to a survey: a precision that is assumed without a
// word, angles in another unit than given.

#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <functional>

#include "support/errors.hpp"
#include "support/scratch.hpp"
#include "survey/covariance.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/io/polar_csv.hpp"
#include "taut/io/read_survey.hpp"
#include "taut/survey/simulation.hpp"

namespace taut {
namespace {

using test::input_error_of;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class PolarFile : public testing::Test {
protected:
    [[nodiscard]] PolarSurvey polar(std::uint64_t seed = 1, bool shuffled = false) const {
        return simulate_polar_survey(
            m_net, m_net.nodes(),
            {.stations = {{0, -6, 1}, {8, 1, 0}}, .shuffled = shuffled, .seed = seed});
    }

    [[nodiscard]] Survey read(const std::string& text,
                              const ReadSurveyOptions& options = {}) const {
        test::put_bytes(m_scratch / "observations.csv", text);
        return read_survey(m_net, m_scratch / "observations.csv", options);
    }

    [[nodiscard]] std::string refusal(const std::string& text,
                                      const ReadSurveyOptions& options = {}) const {
        return input_error_of([&] { return read(text, options); })
            .substr(m_scratch.path().string().size() + 1);
    }

    /// Without its precision.
    [[nodiscard]] static std::string without_std(PolarSurvey survey) {
        for (PolarObservation& observation : survey.observations) {
            observation.angle_std = 0.0;
            observation.distance_std = 0.0;
        }
        return polar_to_csv(survey);
    }

    [[nodiscard]] static PolarSurvey altered(PolarSurvey survey,
                                             const std::function<void(PolarObservation&)>& alter) {
        std::ranges::for_each(survey.observations, alter);
        return survey;
    }

    const CableNet m_net = hypar(4, 5);
    test::ScratchDirectory m_scratch;
};

TEST_F(PolarFile, GivesEveryNodeWithItsCovarianceInTheNetsFrame) {
    const Survey survey = read(polar_to_csv(polar()));
    EXPECT_TRUE(survey.is_whole());
    EXPECT_TRUE(survey.frame_is_unknown);
    EXPECT_EQ(survey.supports.size(), m_net.supports().size());
    EXPECT_THAT(survey.warnings, IsEmpty());
    EXPECT_THAT(survey.notes,
                Contains("76 observations of 38 targets from 2 stations; angles as in the file, "
                         "distances as in the file"));
    for (const int node : survey.surveyed) {
        EXPECT_LT((survey.form.col(node) - m_net.nodes().col(node)).norm(), 0.003);
        // Two stations: no direction is known by the distances alone, of 1 mm, and the best is by
        // angles, of 0.3 mgon at 3 to 9 m.
        const Eigen::Vector3d variances =
            covariance_of({.std_dev = survey.noise_std.col(node),
                           .correlations = survey.correlations_of(node)})
                .selfadjointView<Eigen::Lower>()
                .eigenvalues();
        EXPECT_LT(std::sqrt(variances.minCoeff()), 0.045e-3);
        EXPECT_LT(std::sqrt(variances.maxCoeff()), 0.8e-3);
    }
}

TEST_F(PolarFile, TakesTheGivenPrecisionElseSaysWhichIsAssumed) {
    const std::string text = without_std(polar());
    const Survey assumed = read(text);
    EXPECT_THAT(
        assumed.warnings,
        Contains(
            "gives no precision of its observations: that of a common total station is assumed, "
            "angles 0.3 mgon, distances 1 mm + 1.5 ppm"));
    const Survey given = read(text, {.angle_std = 0.6e-3 * gon,
                                     .distance = DistancePrecision{.std_dev = 2e-3, .part = 3e-6}});
    EXPECT_THAT(given.warnings, IsEmpty());
    EXPECT_THAT(given.notes, Contains(HasSubstr("angles 0.6 mgon, distances 2 mm + 3 ppm")));
    // Twice as large, all of it.
    EXPECT_TRUE(given.noise_std.isApprox(2.0 * assumed.noise_std, 1e-4));
}

TEST_F(PolarFile, MatchesNamesOfItsOwnByPlace) {
    const Survey survey = read(polar_to_csv(polar(3, true)));
    EXPECT_TRUE(survey.is_whole());
    EXPECT_THAT(survey.warnings, Contains(HasSubstr("matched by place")));
}

TEST_F(PolarFile, OfDegreesUnderAHeaderOfGonIsRefused) {
    // The numbers of degrees below a header that says gon.
    PolarSurvey degrees = altered(polar(), [](PolarObservation& observation) {
        observation.direction *= gon / degree;
        observation.zenith *= gon / degree;
    });
    const char* const message =
        "observations.csv:2: its angles are most likely in degrees, not in gon: then the "
        "targets have the shape of the net";
    EXPECT_EQ(refusal(polar_to_csv(degrees)), message);
    degrees.stations.resize(1);
    std::erase_if(degrees.observations,
                  [](const PolarObservation& one) { return one.station == 1; });
    EXPECT_EQ(refusal(polar_to_csv(degrees)), message);
}

TEST_F(PolarFile, WarnsOfReadingsThatContradictEachOther) {
    PolarSurvey wrong = polar();
    wrong.observations[12].distance += 0.03;
    EXPECT_THAT(read(polar_to_csv(wrong)).warnings,
                Contains(HasSubstr("target '32' from station '1', line 14")));
}

}  // namespace
}  // namespace taut
