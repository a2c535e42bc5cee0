// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/hamiltonian_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <utility>

#include "estimation/chain_moves.hpp"
#include "estimation/chain_target.hpp"
#include "estimation/imagined_observations.hpp"
#include "numerics/parallel.hpp"
#include "numerics/random_numbers.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

constexpr int chains = 4;
constexpr int warm_up_trajectories = 40;  ///< of a chain: they find its step
constexpr int fewest_kept = 50;       ///< trajectories after them, which show whether chains agree
constexpr double duration = 2.4;      ///< mean of a trajectory: a normal direction swings with 2 pi
constexpr int most_steps = 150;       ///< of a trajectory
constexpr double least_step = 0.005;  ///< with smaller ones a chain makes no way
constexpr double wanted_acceptance = 0.8;
constexpr double hopeless = 2.0;  ///< disagreement

/// R-hat of half chains.
/// @param values of each chain
double disagreement(const std::vector<std::vector<double>>& values) {
    std::vector<double> means;
    double within = 0.0;
    double length = 0.0;
    for (const std::vector<double>& chain : values) {
        const auto half = static_cast<Eigen::Index>(chain.size() / 2);
        const Eigen::Map<const Eigen::ArrayXd> all(chain.data(), std::ssize(chain));
        for (const Eigen::ArrayXd& part :
             {Eigen::ArrayXd(all.head(half)), Eigen::ArrayXd(all.tail(half))}) {
            means.push_back(part.mean());
            length = static_cast<double>(half);
            within += (part - part.mean()).square().sum() / (length - 1.0);
        }
    }
    const Eigen::Map<const Eigen::ArrayXd> of_parts(means.data(), std::ssize(means));
    const auto parts = static_cast<double>(means.size());
    within /= parts;
    const double between = (of_parts - of_parts.mean()).square().sum() / (parts - 1.0);
    const double ratio = std::sqrt((length - 1.0) / length + between / within);
    return std::isfinite(ratio) ? ratio : std::numeric_limits<double>::infinity();
}

using Tick = std::function<void()>;

/// What a chain has gone through.
struct Sampled {
    std::vector<Iterate> iterates;
    std::vector<double> mean_tensions;  ///< of all samples [N]
    std::vector<double> potentials;
    double acceptance = 0.0;
    double step = 0.0;
};

/// A walk through the posterior, with its step.
class Chain {
public:
    Chain(const StaticsModel& model, const Observations& observations, std::span<const int> taut,
          const Iterate& centre, const Linearisation& metric, double tolerance,
          const RandomNumbers& random)
        : m_target(model, observations, taut, centre, metric, tolerance),
          m_random(random),
          m_state(start_of_chain(m_target, m_random)) {}

    /// Finds the step, by H. Robbins & S. Monro 1951; false where none makes any way.
    /// @param tick called before each trajectory
    [[nodiscard]] bool warm_up(const Tick& tick);
    /// Goes on.
    /// @param thinned how many iterates of the samples are kept
    [[nodiscard]] Sampled sample(std::int64_t count, std::int64_t thinned, const Tick& tick);

private:
    double advance() {
        const double time = duration * (0.6 + 0.8 * m_random.uniform());
        const int steps = std::clamp(static_cast<int>(time / m_step), 1, most_steps);
        const double taken = follow_trajectory(m_target, *m_state, m_step, steps, m_random);
        renew_slack_lengths(m_target, *m_state, m_random);
        return taken;
    }

    ChainTarget m_target;
    RandomNumbers m_random;
    std::optional<ChainState> m_state;
    double m_step = 0.05;
};

bool Chain::warm_up(const Tick& tick) {
    if (!m_state) {
        return false;
    }
    for (int k = 0; k < warm_up_trajectories; ++k) {
        tick();
        m_step *= std::exp((advance() - wanted_acceptance) / std::pow(k + 1.0, 0.6));
        if (2 * k > warm_up_trajectories && m_step < least_step) {
            return false;
        }
    }
    return true;
}

Sampled Chain::sample(std::int64_t count, std::int64_t thinned, const Tick& tick) {
    const Eigen::VectorXd weights = mean_weights(m_target.model().net());
    Sampled result{.step = m_step};
    for (std::int64_t k = 0; k < count; ++k) {
        tick();
        result.acceptance += advance() / static_cast<double>(count);
        result.mean_tensions.push_back(weights.dot(m_target.model().tensions(m_state->iterate)));
        result.potentials.push_back(m_state->potential);
        if ((k + 1) * thinned / count > k * thinned / count) {
            result.iterates.push_back(m_state->iterate);
        }
    }
    return result;
}

ChainSamples together(const std::array<Sampled, chains>& sampled) {
    ChainSamples result{.step = std::numeric_limits<double>::infinity()};
    std::vector<std::vector<double>> tensions;
    std::vector<std::vector<double>> potentials;
    for (size_t k = 0; k < sampled[0].iterates.size(); ++k) {  // the first few are of all chains
        for (const Sampled& chain : sampled) {
            result.iterates.push_back(chain.iterates[k]);
        }
    }
    for (const Sampled& chain : sampled) {
        result.step = std::min(result.step, chain.step);
        result.acceptance += chain.acceptance / chains;
        tensions.push_back(chain.mean_tensions);
        potentials.push_back(chain.potentials);
    }
    result.disagreement = std::max(disagreement(tensions), disagreement(potentials));
    return result;
}

}  // namespace

std::optional<ChainSamples> hamiltonian_samples(const StaticsModel& model,
                                                const Observations& observations,
                                                std::span<const int> taut, const Iterate& centre,
                                                int count, std::uint64_t seed,
                                                const Progress& progress) {
    constexpr std::uint32_t first_stream = 0x20000000U;
    constexpr int most_rounds = 3;
    const std::optional<Linearisation> metric =
        linearise(model, centre, satisfied(model, observations, centre));
    if (!metric) {
        return std::nullopt;
    }
    const int of_each = (count + chains - 1) / chains;
    const int kept = std::max(fewest_kept, of_each);
    const double tolerance =
        1e-3 / std::sqrt(observations.weights(Eigen::all, model.net().free_nodes()).maxCoeff());
    std::deque<Chain> all;  // which stay where they are
    for (int c = 0; c < chains; ++c) {
        all.emplace_back(model, observations, taut, centre, *metric, tolerance,
                         RandomNumbers(seed, first_stream + static_cast<std::uint32_t>(c)));
    }
    std::array<bool, chains> make_way{};
    int done = 0;
    const auto tick = [&](size_t c) -> Tick {
        if (c > 0) {
            return [&] { progress.throw_if_stopped(); };
        }
        return [&] {  // of one thread, and as far as the others
            progress("posterior samples", done++, warm_up_trajectories + most_rounds * kept);
        };
    };
    const auto each = [&](const auto& act) {
        parallel_for(size_t{0}, all.size(), [&](size_t c) { isolate([&] { act(c); }); });
    };
    each([&](size_t c) { make_way[c] = all[c].warm_up(tick(c)); });
    if (!std::ranges::all_of(make_way, std::identity())) {
        return std::nullopt;
    }
    ChainSamples result;
    std::array<Sampled, chains> sampled;
    for (int round = 0; round < most_rounds; ++round) {
        each([&](size_t c) { sampled[c] = all[c].sample(kept, of_each, tick(c)); });
        result = together(sampled);
        if (result.disagreement < ChainSamples::agreed || !(result.disagreement < hopeless)) {
            break;
        }
    }
    result.iterates.resize(static_cast<size_t>(count));
    return result;
}

}  // namespace taut
