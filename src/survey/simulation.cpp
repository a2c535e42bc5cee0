// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/simulation.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "numerics/boost_random.hpp"
#include "taut/survey/registration.hpp"
#include "taut/survey/target_offsets.hpp"

namespace taut {
namespace {

RigidMotion random_motion(BoostRandom& dice) {
    // A normal quaternion, normalised, is uniform over all rotations.
    const Eigen::Vector3d imaginary = dice.normals();
    const Eigen::Quaterniond turn(dice.normal(), imaginary.x(), imaginary.y(), imaginary.z());
    constexpr double grid = 1e6;  // m
    return {.rotation = turn.normalized().toRotationMatrix(), .to = grid * dice.normals()};
}

void check_simulated(const CableNet& net, const Points& form, double dropped_part) {
    if (form.cols() != net.node_count() || !form.allFinite()) {
        throw std::invalid_argument(
            fmt::format("a form of {} nodes, expected {} as in the net, all finite", form.cols(),
                        net.node_count()));
    }
    if (!(dropped_part >= 0.0 && dropped_part < 1.0)) {
        throw std::invalid_argument(
            fmt::format("the dropped part is {}, expected at least 0 and below 1", dropped_part));
    }
}

/// Free nodes without a part of them, in any order.
std::vector<int> seen_nodes(const CableNet& net, double dropped_part, BoostRandom& dice) {
    std::vector<int> nodes = net.free_nodes();
    dice.shuffle(nodes);
    const auto dropped =
        static_cast<std::ptrdiff_t>(std::llround(dropped_part * static_cast<double>(nodes.size())));
    nodes.erase(nodes.begin(), nodes.begin() + dropped);
    return nodes;
}

void check_stations(const PolarSimulation& simulation) {
    if (simulation.stations.empty()) {
        throw std::invalid_argument("there is no station, expected at least one");
    }
    if (!(simulation.angle_std > 0.0) || !(simulation.distance.std_at(0.0) > 0.0)) {
        throw std::invalid_argument(
            fmt::format("the standard deviations of angles and distances are {} rad and {} m, "
                        "expected more than 0",
                        simulation.angle_std, simulation.distance.std_dev));
    }
}

/// Of a place in the net's frame by an instrument whose circle is turned by `orientation`.
PolarObservation observation_of(const Eigen::Vector3d& place, const Eigen::Vector3d& station,
                                double orientation) {
    const Eigen::Vector3d away = place - station;
    return {.direction = std::atan2(away.x(), away.y()) + orientation,
            .zenith = std::acos(std::clamp(away.z() / away.norm(), -1.0, 1.0)),
            .distance = away.norm()};
}

}  // namespace

std::vector<SurveyPoint> simulate_survey(const CableNet& net, const Points& form,
                                         const SurveySimulation& simulation) {
    check_simulated(net, form, simulation.dropped_part);
    if (!(simulation.noise_std >= 0.0) || !std::isfinite(simulation.noise_std)) {
        throw std::invalid_argument(
            fmt::format("noise is {} m, expected at least 0 and finite", simulation.noise_std));
    }
    if (!(simulation.offset_std >= 0.0) || !std::isfinite(simulation.offset_std) ||
        !std::isfinite(simulation.offset)) {
        throw std::invalid_argument(fmt::format(
            "offsets are {} m with a standard deviation of {} m, expected finite ones, the latter "
            "at least 0",
            simulation.offset, simulation.offset_std));
    }
    BoostRandom dice(simulation.seed);
    std::vector<int> free_nodes = seen_nodes(net, simulation.dropped_part, dice);
    if (!simulation.shuffled) {
        std::ranges::sort(free_nodes);
    }

    const bool has_offsets = simulation.offset != 0.0 || simulation.offset_std > 0.0;
    const Points normals = has_offsets ? node_normals(net, form) : Points();
    std::vector<SurveyPoint> points;
    const auto survey = [&](int node, bool named) {
        SurveyPoint point{.id = named ? net.node_id(node) : "", .position = form.col(node)};
        if (has_offsets && !net.is_support(node)) {
            const double own = simulation.offset_std > 0.0 ? dice.normal() : 0.0;
            point.position += (simulation.offset + simulation.offset_std * own) * normals.col(node);
        }
        if (simulation.noise_std > 0.0) {
            point.position += simulation.noise_std * dice.normals();
        }
        points.push_back(point);
    };
    for (const int node : net.supports()) {
        survey(node, true);
    }
    for (const int node : free_nodes) {
        survey(node, !simulation.shuffled);
    }
    if (simulation.random_frame) {
        points = moved(std::move(points), random_motion(dice));
    }
    if (simulation.noise_std > 0.0) {  // the same in every direction, and so in every frame
        for (SurveyPoint& point : points) {
            point.noise_std = Eigen::Vector3d::Constant(simulation.noise_std);
        }
    }
    return points;
}

PolarSurvey simulate_polar_survey(const CableNet& net, const Points& form,
                                  const PolarSimulation& simulation) {
    check_simulated(net, form, simulation.dropped_part);
    check_stations(simulation);
    BoostRandom dice(simulation.seed);
    std::vector<int> free_nodes = seen_nodes(net, simulation.dropped_part, dice);
    if (!simulation.shuffled) {
        std::ranges::sort(free_nodes);
    }
    std::vector<std::pair<int, std::string>> targets;
    for (const int node : net.supports()) {
        targets.emplace_back(node, net.node_id(node));
    }
    for (const int node : free_nodes) {
        targets.emplace_back(node,
                             simulation.shuffled
                                 ? fmt::format("t{}", targets.size() + 1 - net.supports().size())
                                 : net.node_id(node));
    }
    PolarSurvey survey;
    for (const Eigen::Vector3d& station : simulation.stations) {
        const auto number = static_cast<int>(survey.stations.size());
        survey.stations.push_back({.name = std::to_string(number + 1)});
        const double orientation = dice.angle();
        for (const auto& [node, name] : targets) {
            const double distance = (form.col(node) - station).norm();
            constexpr double nearest = 0.01;
            if (!(distance > nearest)) {
                throw std::invalid_argument(
                    fmt::format("station {} stands at node '{}', expected it away from all targets",
                                number + 1, net.node_id(node)));
            }
            PolarObservation observation = observation_of(form.col(node), station, orientation);
            observation.station = number;
            observation.target = name;
            observation.angle_std = simulation.angle_std;
            observation.distance_std = simulation.distance.std_at(distance);
            constexpr double full = 2.0 * std::numbers::pi;
            observation.direction = std::fmod(
                observation.direction + observation.angle_std * dice.normal() + 2.0 * full, full);
            observation.zenith =
                std::abs(observation.zenith + observation.angle_std * dice.normal());
            observation.distance += observation.distance_std * dice.normal();
            survey.observations.push_back(std::move(observation));
        }
    }
    return survey;
}

}  // namespace taut
