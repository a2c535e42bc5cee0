// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against observations that are turned into other places or covariances than least squares
// gives: compared with SciPy's (tests/data/make_station_reference.py), differences and simulation.

#include "taut/survey/station_adjustment.hpp"

#include <gmock/gmock.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "support/finite_differences.hpp"
#include "survey/covariance.hpp"
#include "survey/polar_residual.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/survey/registration.hpp"
#include "taut/survey/simulation.hpp"

namespace taut {
namespace {

using nlohmann::json;

PolarSurvey survey_of(const json& reference) {
    PolarSurvey survey;
    for (const json& one : reference["readings"]) {
        const int station = one["station"];
        while (std::ssize(survey.stations) <= station) {
            survey.stations.push_back({.name = std::to_string(survey.stations.size())});
        }
        survey.observations.push_back({.station = station,
                                       .target = one["target"],
                                       .direction = one["direction"],
                                       .zenith = one["zenith"],
                                       .distance = one["distance"],
                                       .target_height = one["target_height"],
                                       .angle_std = one["angle_std"],
                                       .distance_std = one["distance_std"]});
    }
    return survey;
}

Eigen::Matrix3d covariance_of_point(const SurveyPoint& point) {
    return covariance_of({.std_dev = *point.noise_std, .correlations = point.noise_correlations});
}

TEST(StationAdjustment, GivesThePlacesAndCovariancesOfAnIndependentSolver) {
    const json reference = json::parse(std::ifstream(TAUT_TEST_DATA_DIR "/station_reference.json"));
    const StationAdjustment found = adjust_stations(survey_of(reference));
    EXPECT_EQ(found.datum, reference["datum"].get<int>());
    EXPECT_EQ(found.redundancy, reference["redundancy"].get<int>());
    EXPECT_NEAR(found.noise_ratio, reference["noise_ratio"].get<double>(), 1e-4);
    ASSERT_EQ(found.points.size(), reference["points"].size());
    for (size_t i = 0; i < found.points.size(); ++i) {
        const json& expected = reference["points"][i];
        EXPECT_EQ(found.points[i].id, expected["target"].get<std::string>());
        const std::vector<double> place = expected["place"];
        EXPECT_LT((found.points[i].position - Eigen::Vector3d::Map(place.data())).norm(), 3e-7)
            << i;
        const std::vector<double> flat = expected["covariance"];
        const Eigen::Matrix3d covariance = Eigen::Matrix3d::Map(flat.data());
        EXPECT_LT((covariance_of_point(found.points[i]) - covariance).norm(),
                  1e-3 * covariance.norm())
            << i;
    }
    for (size_t s = 0; s < found.poses.size(); ++s) {
        const std::vector<double> pose = reference["poses"][s];
        EXPECT_LT((found.poses[s].place - Eigen::Vector3d::Map(pose.data())).norm(), 3e-7);
        EXPECT_NEAR(std::remainder(found.poses[s].orientation - pose[3], 2.0 * std::numbers::pi),
                    0.0, 1e-7);
    }
}

TEST(StationAdjustment, HasTheDerivativesOfItsResiduals) {
    const PolarObservation observation{.direction = 1.1,
                                       .zenith = 0.7,
                                       .distance = 8.0,
                                       .target_height = 0.1,
                                       .angle_std = 5e-6,
                                       .distance_std = 1e-3};
    Eigen::VectorXd x(7);
    x << 5.0, 1.9, 6.3, 0.4, -0.2, 0.3, 0.25;
    const auto at = [&](const Eigen::VectorXd& u) {
        const StationPose pose{.place = u.segment<3>(3), .orientation = u(6)};
        return polar_residual(observation, pose, u.head<3>());
    };
    const Eigen::MatrixXd expected = test::finite_differences(
        [&](const auto& u) -> Eigen::VectorXd { return at(u).value; }, x, 1e-6);
    const PolarResidual found = at(x);
    EXPECT_LT((found.by_target - expected.leftCols<3>()).norm(), 1e-7 * expected.norm());
    EXPECT_LT((found.by_pose - expected.rightCols<4>()).norm(), 1e-7 * expected.norm());
}

class SimulatedStations : public testing::Test {
protected:
    /// Observations whose noise is that of the precision times a part.
    [[nodiscard]] PolarSurvey survey(double part, std::uint64_t seed) const {
        PolarSimulation simulation = m_simulation;
        simulation.seed = seed;
        simulation.angle_std *= part;
        simulation.distance.std_dev *= part;
        simulation.distance.part *= part;
        return simulate_polar_survey(m_net, m_net.nodes(), simulation);
    }

    /// The points beside the nodes of their names, all of the net.
    [[nodiscard]] Registration fit_of(const StationAdjustment& found) const {
        std::vector<ControlPoint> pairs;
        for (const SurveyPoint& point : found.points) {
            pairs.push_back({.id = point.id,
                             .known = m_net.nodes().col(std::stoi(point.id)),
                             .measured = point.position});
        }
        EXPECT_EQ(std::ssize(pairs), m_net.node_count());
        return register_rigidly(pairs);
    }

    const CableNet m_net = hypar(4, 4);
    PolarSimulation m_simulation{
        .stations = {{1.0, -4.0, 0.5}, {6.0, 1.0, -0.3}, {-2.0, 5.0, 1.0}}};
};

TEST_F(SimulatedStations, WithoutNoiseGiveTheShapeOfTheNetThoughNoneSeesItAll) {
    PolarSurvey polar = survey(1e-6, 3);
    const auto seen = [](const PolarObservation& one) {
        const int target = std::stoi(one.target);
        return one.station == 0 ? target < 25 : one.station == 1 ? target > 20 : target % 3 == 0;
    };
    std::erase_if(polar.observations, [&](const PolarObservation& one) { return !seen(one); });
    const StationAdjustment found = adjust_stations(polar);
    const Registration fit = fit_of(found);
    EXPECT_LT(root_mean_square(fit.residuals), 1e-8);
    // Levelled: nothing but a rotation about the vertical is left.
    EXPECT_NEAR(fit.motion.rotation(2, 2), 1.0, 1e-12);
    // And the stations stand where they do.
    const Eigen::Vector3d datum = m_simulation.stations[found.datum];
    for (size_t s = 0; s < found.poses.size(); ++s) {
        EXPECT_NEAR((found.poses[s].place - found.poses[found.datum].place).norm(),
                    (m_simulation.stations[s] - datum).norm(), 1e-8);
    }
}

/// Least sum of squared standardised errors over motions of all points.
double squares_after_a_motion(const std::vector<SurveyPoint>& points,
                              const std::vector<SurveyPoint>& truth) {
    Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Vector<double, 6> b = Eigen::Vector<double, 6>::Zero();
    double squares = 0.0;
    for (size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3d error = points[i].position - truth[i].position;
        const Eigen::Matrix3d weight = covariance_of_point(points[i]).inverse();
        Eigen::Matrix<double, 3, 6> H;
        for (int k = 0; k < 3; ++k) {
            H.col(k) = Eigen::Vector3d::Unit(k);
            H.col(3 + k) = Eigen::Vector3d::Unit(k).cross(truth[i].position);
        }
        A += H.transpose() * weight * H;
        b += H.transpose() * weight * error;
        squares += error.dot(weight * error);
    }
    return squares - b.dot(A.llt().solve(b));
}

// Errors of targets over many surveys have the covariances of the adjustments, but for a common
// motion.
TEST_F(SimulatedStations, HaveTheCovarianceOfTheirErrors) {
    m_simulation.stations.resize(2);
    double squares = 0.0;
    double count = 0.0;
    double ratio = 0.0;
    constexpr int surveys = 300;
    for (int seed = 1; seed <= surveys; ++seed) {
        const StationAdjustment found = adjust_stations(survey(1.0, seed));
        // The same seed, next to no noise: the same frame.
        const StationAdjustment exact = adjust_stations(survey(1e-6, seed));
        ratio += found.noise_ratio / surveys;
        squares += squares_after_a_motion(found.points, exact.points);
        count += 3.0 * static_cast<double>(found.points.size()) - 6.0;
    }
    EXPECT_NEAR(squares / count, 1.0, 0.05);
    EXPECT_NEAR(ratio, 1.0, 0.02);
}

TEST_F(SimulatedStations, AreAsPreciseAsTheObservationsOfTheOnlyOne) {
    m_simulation.stations.resize(1);
    const PolarSurvey polar = survey(1.0, 5);
    const StationAdjustment found = adjust_stations(polar);
    EXPECT_EQ(found.redundancy, 0);
    EXPECT_EQ(found.noise_ratio, 0.0);
    for (size_t i = 0; i < found.points.size(); ++i) {
        const PolarObservation& observation = polar.observations[i];
        EXPECT_NEAR(found.points[i].position.norm(), observation.distance, 1e-12);
        // Along the line of sight, and up.
        const Eigen::Vector3d u = found.points[i].position.normalized();
        const Eigen::Vector3d up = (Eigen::Vector3d::UnitZ() - u.z() * u).normalized();
        const Eigen::Matrix3d covariance = covariance_of_point(found.points[i]);
        EXPECT_NEAR(std::sqrt(u.dot(covariance * u)), observation.distance_std, 1e-9);
        EXPECT_NEAR(std::sqrt(up.dot(covariance * up)),
                    observation.distance * observation.angle_std, 1e-9);
    }
}

TEST_F(SimulatedStations, NameTheObservationThatContradictsTheOthersMost) {
    PolarSurvey polar = survey(1.0, 11);
    polar.observations[60].distance += 0.05;
    const StationAdjustment found = adjust_stations(polar);
    EXPECT_EQ(found.worst, 60);
    EXPECT_GT(found.worst_residual, 20.0);
}

std::string refusal_of(const PolarSurvey& survey, int line) {
    try {
        static_cast<void>(adjust_stations(survey));
    } catch (const SurveyError& error) {
        EXPECT_EQ(error.line(), line);
        return error.what();
    }
    return "";
}

TEST_F(SimulatedStations, AreRefusedWithoutOrientation) {
    PolarSurvey polar = survey(1.0, 13);
    polar.stations[2].line = 77;
    PolarSurvey untied = polar;
    std::erase_if(untied.observations, [](const PolarObservation& one) {
        return one.station == 2 && one.target != "10";
    });
    EXPECT_EQ(
        refusal_of(untied, 77),
        "station '3' has 1 targets in common with the other stations, expected at least 2: it "
        "has no orientation");
    // Two above each other.
    PolarSurvey above = polar;
    std::erase_if(above.observations, [](const PolarObservation& one) { return one.station == 2; });
    for (const double zenith : {1.0, 2.0}) {
        const std::string name = zenith < 1.5 ? "up" : "down";
        for (const int station : {0, 2}) {
            above.observations.push_back({.station = station,
                                          .target = name,
                                          .direction = 0.3,
                                          .zenith = zenith,
                                          .distance = 5.0 / std::sin(zenith),
                                          .angle_std = 1e-5,
                                          .distance_std = 1e-3});
        }
    }
    EXPECT_THAT(refusal_of(above, 77),
                testing::HasSubstr("station '3' has only targets in common "
                                   "with the other stations that are above"));
}

TEST_F(SimulatedStations, AreRefusedWithObservationsThatMakeNoSense) {
    const PolarSurvey good = survey(1.0, 17);
    const auto refusal = [&](const std::function<void(PolarObservation&)>& alter) {
        PolarSurvey bad = good;
        bad.observations[4].line = 9;
        alter(bad.observations[4]);
        return refusal_of(bad, 9);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal([&](PolarObservation& r) { r.zenith = nan; }),
              "has an observation that is not finite");
    EXPECT_EQ(refusal([](PolarObservation& r) { r.distance = 0.0; }),
              "has the distance 0, expected more than 0");
    EXPECT_THAT(refusal([](PolarObservation& r) { r.angle_std = 0.0; }),
                testing::HasSubstr("has the standard deviations 0 rad"));
    EXPECT_EQ(refusal([](PolarObservation& r) { r.station = 3; }),
              "is of station 3, expected 0 to 2");
    PolarSurvey idle = good;
    idle.stations.push_back({.name = "idle", .line = 12});
    EXPECT_EQ(refusal_of(idle, 12), "station 'idle' has no observation");
}

TEST(PolarObservation, InTheSecondFaceIsThatOfTheFirst) {
    const PolarObservation first = in_first_face(
        {.direction = 0.3 + std::numbers::pi, .zenith = 2.0 * std::numbers::pi - 1.2});
    EXPECT_NEAR(first.direction, 0.3, 1e-15);
    EXPECT_NEAR(first.zenith, 1.2, 1e-15);
    EXPECT_EQ(in_first_face({.direction = 0.3, .zenith = 1.2}).zenith, 1.2);
}

}  // namespace
}  // namespace taut
