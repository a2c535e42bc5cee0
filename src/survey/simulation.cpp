// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/simulation.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>

#include "taut/survey/registration.hpp"

namespace taut {
namespace {

/// Boost's distributions give the same numbers on every platform; the standard's need not.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : m_engine(seed) {}

    double normal() { return m_normal(m_engine); }
    Eigen::Vector3d normals() {
        const double x = normal();
        const double y = normal();
        return {x, y, normal()};
    }

    template <class T>
    void shuffle(std::vector<T>& values) {
        for (size_t i = values.size(); i > 1; --i) {
            const boost::random::uniform_int_distribution<size_t> below(0, i - 1);
            std::swap(values[i - 1], values[below(m_engine)]);
        }
    }

private:
    boost::random::mt19937_64 m_engine;
    boost::random::normal_distribution<double> m_normal;
};

RigidMotion random_motion(Dice& dice) {
    // A normal quaternion, normalised, is uniform over all rotations.
    const Eigen::Vector3d imaginary = dice.normals();
    const Eigen::Quaterniond turn(dice.normal(), imaginary.x(), imaginary.y(), imaginary.z());
    constexpr double grid = 1e6;  // m
    return {.rotation = turn.normalized().toRotationMatrix(), .to = grid * dice.normals()};
}

void check(const CableNet& net, const Points& form, const SurveySimulation& simulation) {
    if (form.cols() != net.node_count() || !form.allFinite()) {
        throw std::invalid_argument(
            fmt::format("a form of {} nodes, expected {} as in the net, all finite", form.cols(),
                        net.node_count()));
    }
    if (!(simulation.noise_std >= 0.0) || !std::isfinite(simulation.noise_std)) {
        throw std::invalid_argument(
            fmt::format("noise is {} m, expected at least 0 and finite", simulation.noise_std));
    }
    if (!(simulation.dropped_part >= 0.0 && simulation.dropped_part < 1.0)) {
        throw std::invalid_argument(fmt::format(
            "the dropped part is {}, expected at least 0 and below 1", simulation.dropped_part));
    }
}

}  // namespace

std::vector<SurveyPoint> simulate_survey(const CableNet& net, const Points& form,
                                         const SurveySimulation& simulation) {
    check(net, form, simulation);
    Dice dice(simulation.seed);
    std::vector<int> free_nodes = net.free_nodes();
    dice.shuffle(free_nodes);
    const auto dropped = static_cast<std::ptrdiff_t>(
        std::llround(simulation.dropped_part * static_cast<double>(free_nodes.size())));
    free_nodes.erase(free_nodes.begin(), free_nodes.begin() + dropped);
    if (!simulation.shuffled) {
        std::ranges::sort(free_nodes);
    }

    std::vector<SurveyPoint> points;
    const auto survey = [&](int node, bool named) {
        SurveyPoint point{.id = named ? net.node_id(node) : "", .position = form.col(node)};
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

}  // namespace taut
