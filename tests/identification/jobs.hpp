// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <vector>

#include "identification/simulated_survey.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/epochs.hpp"

/// What the tests of several surveys share.
namespace taut::of_epochs {

using test::uncertain;

inline constexpr LengthPrior prior{LengthPrior::Kind::uniform, 0.005};
inline constexpr double noise = 0.5e-3;

inline const CableNet& net() {
    static const CableNet saddle = hypar(9, 9);
    return saddle;
}

/// A net as built, surveyed before and after some edges were turned.
struct Job {
    Eigen::VectorXd deviations;  ///< m_I, at first
    std::vector<Epoch> epochs;
};

inline std::vector<EdgeTurned> some_turns(std::uint64_t seed, double actuator_std = 0.0) {
    std::mt19937_64 random(seed);
    std::vector<EdgeTurned> turned;
    for (const int edge : net().adjustable_edges()) {
        if (random() % 2 == 0) {
            const double stroke = std::uniform_real_distribution<double>(-8e-3, 8e-3)(random);
            turned.push_back({.edge = edge, .stroke = stroke, .std_dev = actuator_std});
        }
    }
    return turned;
}

/// @param done what was turned in truth; by default as given
/// @param slip change of interior lengths in between (m_I); empty: none
/// @param built the net with its true supports
inline Job job_of(std::uint64_t seed, const std::vector<EdgeTurned>& given,
                  const std::vector<EdgeTurned>& done, const Eigen::VectorXd& slip = {},
                  const CableNet& built = net()) {
    const test::SimulatedSurvey first = test::simulate(built, prior, noise, seed);
    const CableNet after = turned_net(built, done);
    test::SimulatedSurvey second =
        test::simulate(after, prior, noise, seed, [&](Eigen::VectorXd& deviations) {
            if (slip.size() > 0) {
                deviations += slip;
            }
        });
    // simulate() draws the same noise for the same seed.
    return {.deviations = first.deviations,
            .epochs = {{.survey = first.survey, .turned = {}},
                       {.survey = test::surveyed_again(net(), second, noise, seed + 1000),
                        .turned = given}}};
}

/// @param turned what was turned and is given so
inline Job job_as_given(std::uint64_t seed, const std::vector<EdgeTurned>& turned) {
    return job_of(seed, turned, turned);
}

/// Two surveys of one net between which nothing was turned.
inline std::vector<Epoch> surveyed_twice(const CableNet& of, const test::SimulatedSurvey& first,
                                         std::uint64_t seed) {
    return {{.survey = first.survey, .turned = {}},
            {.survey = test::surveyed_again(of, first, noise, seed), .turned = {}}};
}

inline IdentifyOptions with_prior(std::vector<UncertainParameter> uncertain = {}) {
    return {.prior = prior, .uncertain = std::move(uncertain)};
}

/// The net with its supports a millimetre off.
inline CableNetData on_moved_supports(std::uint64_t seed) {
    CableNetData data = net().data();
    test::add_noise(data.nodes, net().supports(), 1e-3, seed);
    return data;
}

/// Loads on every so many nodes [N].
inline Points loads_on_every(int stride, double force) {
    Points loads = Points::Zero(3, net().node_count());
    for (const int node : net().free_nodes()) {
        loads(2, node) = node % stride == 0 ? -force : 0.0;
    }
    return loads;
}

/// How a load moves the net of given lengths.
inline Points move_under(const CableNetData& data, const CableNet& unloaded, std::uint64_t seed) {
    return test::simulate(CableNet(data), prior, noise, seed).truth.form -
           test::simulate(unloaded, prior, noise, seed).truth.form;
}

}  // namespace taut::of_epochs
