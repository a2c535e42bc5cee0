// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/hamiltonian_chain.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "estimation/form_of_model.hpp"
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

/// What the prior means have in common, (length-trend), in the metric.
struct CommonMeans {
    Eigen::MatrixXd pulls;                  ///< P G (m_I x r) [1/m]
    Eigen::LLT<Eigen::MatrixXd> precision;  ///< I + G' P G
    std::vector<Iterate> responses;         ///< A^-1 P G, one a column
    Eigen::LLT<Eigen::MatrixXd> shared;     ///< I + G' P G - G' P A^-1 P G
};

/// Where a chain is, with what a trajectory needs there.
struct ChainState {
    Iterate iterate;
    double potential = 0.0;
    Iterate force;  ///< A^-1 (- dU/dx)
};

class Chain {
public:
    Chain(const StaticsModel& model, const Observations& observations, std::span<const int> taut,
          const Iterate& start, const Linearisation& metric, double tolerance);

    [[nodiscard]] std::optional<ChainState> state_at(Iterate iterate);
    /// Whether all edges are taut that were seen to be.
    [[nodiscard]] bool is_as_seen(const Iterate& iterate) const;
    /// Somewhere about as far from the centre as the posterior is wide, or farther, so that chains
    /// that agree have seen it.
    [[nodiscard]] std::optional<ChainState> far_from(const Iterate& centre, RandomNumbers& random);
    /// One trajectory, taken or not; its probability of being taken by its energy.
    double advance(ChainState& state, double step, int steps, RandomNumbers& random);
    /// Draws the lengths of slack edges anew, which hardly moves the form: trajectories would take
    /// long to cross what the prior leaves them.
    void renew_slack_lengths(ChainState& state, RandomNumbers& random);

private:
    struct SlackLength {
        int interior;  ///< index of the edge among the interior ones
        double from;   ///< least length that is slack, in standard deviations of the prior
        friend bool operator==(const SlackLength& a, const SlackLength& b) {
            return a.interior == b.interior;
        }
    };
    [[nodiscard]] std::vector<SlackLength> slack_lengths(const Iterate& iterate) const;
    [[nodiscard]] double standardised(const Iterate& iterate, int i) const {
        return (iterate.deviations(i) - m_observations.mean(i)) / std::sqrt(m_variances(i));
    }
    [[nodiscard]] Iterate step_to(const Observations& observations) const {
        return m_metric.step(m_start, observations).moved(m_rest_step, -1.0);
    }
    [[nodiscard]] Iterate with_common_means(Iterate change) const;
    [[nodiscard]] Iterate drawn_velocity(RandomNumbers& random) const;
    [[nodiscard]] double kinetic_energy(const Iterate& velocity) const;
    [[nodiscard]] Observations pulled(const Iterate& at) const;

    const StaticsModel& m_model;
    const Observations& m_observations;
    std::span<const int> m_taut;
    const Iterate& m_start;
    const Linearisation& m_metric;
    double m_tolerance;
    FormOfModel m_form;
    Eigen::VectorXd m_variances;  ///< of the lengths, blur included (m_I) [m2]
    Observations m_rest;          ///< to which nothing moves from the start
    Iterate m_rest_step;
    CommonMeans m_means;
};

Chain::Chain(const StaticsModel& model, const Observations& observations, std::span<const int> taut,
             const Iterate& start, const Linearisation& metric, double tolerance)
    : m_model(model),
      m_observations(observations),
      m_taut(taut),
      m_start(start),
      m_metric(metric),
      m_tolerance(tolerance),
      m_form(model),
      m_variances(model.prior_variances(observations)),
      m_rest(satisfied(model, observations, start)),
      m_rest_step(metric.step(start, m_rest)) {
    const Eigen::MatrixXd root = observations.mean_root.size() > 0
                                     ? observations.mean_root
                                     : Eigen::MatrixXd(m_variances.size(), 0);
    m_means.pulls = m_variances.cwiseInverse().asDiagonal() * root;
    Eigen::MatrixXd precision =
        Eigen::MatrixXd::Identity(root.cols(), root.cols()) + root.transpose() * m_means.pulls;
    m_means.precision.compute(precision);
    for (Eigen::Index k = 0; k < root.cols(); ++k) {
        Observations moved = m_rest;
        moved.mean += root.col(k);
        m_means.responses.push_back(step_to(moved));
        precision.col(k) -= m_means.pulls.transpose() * m_means.responses.back().deviations;
    }
    m_means.shared.compute(0.5 * (precision + precision.transpose()));
}

/// From A^-1 to the inverse with what the prior means have in common.
Iterate Chain::with_common_means(Iterate change) const {
    const Eigen::VectorXd parts =
        m_means.shared.solve(m_means.pulls.transpose() * change.deviations);
    for (Eigen::Index k = 0; k < parts.size(); ++k) {
        change = change.moved(m_means.responses[static_cast<size_t>(k)], parts(k));
    }
    return change;
}

Iterate Chain::drawn_velocity(RandomNumbers& random) const {
    const Eigen::VectorXd blur = m_variances - m_observations.variance;
    Iterate result = step_to(perturbed(m_model.net(), m_rest, blur, random));
    Eigen::VectorXd parts(m_means.pulls.cols());
    for (double& of_one : parts) {
        of_one = random.normal();
    }
    parts = m_means.shared.matrixU().solve(parts);
    for (Eigen::Index k = 0; k < parts.size(); ++k) {
        result = result.moved(m_means.responses[static_cast<size_t>(k)], parts(k));
    }
    return result;
}

double Chain::kinetic_energy(const Iterate& velocity) const {
    const Eigen::VectorXd shared = m_means.pulls.transpose() * velocity.deviations;
    return 0.5 * (m_metric.squared_norm(m_observations, velocity) -
                  shared.dot(m_means.precision.solve(shared)));
}

std::optional<ChainState> Chain::state_at(Iterate iterate) {
    for (int e = 0; e < m_model.net().edge_count(); ++e) {
        if (!(m_model.unstressed_length(e, iterate) > 0.0)) {
            return std::nullopt;
        }
    }
    if (!m_form.converge(iterate, m_tolerance)) {
        return std::nullopt;
    }
    const Eigen::VectorXd shared =
        m_means.pulls.transpose() * (iterate.deviations - m_observations.mean);
    const double potential = m_model.objective(m_observations, iterate) -
                             0.5 * shared.dot(m_means.precision.solve(shared));
    Iterate force = with_common_means(step_to(pulled(iterate)));
    return ChainState{std::move(iterate), potential, std::move(force)};
}

std::optional<ChainState> Chain::far_from(const Iterate& centre, RandomNumbers& random) {
    constexpr double farther = 2.0;
    constexpr double least = 0.1;
    const Iterate direction = drawn_velocity(random);
    for (double distance = farther; distance > least; distance *= 0.5) {
        std::optional<ChainState> state = state_at(centre.moved(direction, distance));
        if (state && is_as_seen(state->iterate)) {
            return state;
        }
    }
    return state_at(centre);
}

bool Chain::is_as_seen(const Iterate& iterate) const {
    return std::ranges::all_of(m_taut, [&](int e) {
        const auto [s, t] = m_model.net().edges()[e];
        return (iterate.form.col(s) - iterate.form.col(t)).norm() >
               m_model.unstressed_length(e, iterate);
    });
}

/// (hamiltonian): observations to which one step from the start is A^-1 (- dU/dx).
Observations Chain::pulled(const Iterate& at) const {
    const CableNet& net = m_model.net();
    const CommonParameters& common = m_model.common;
    const Observations& y = m_observations;
    const Points measured = y.weighted(y.form - at.form);
    const Points of_supports =
        y.support_weights.cwiseProduct(y.support_mean - m_model.support_deviations(at));
    Points places = measured + of_supports;
    Eigen::VectorXd lengths = Eigen::VectorXd::Zero(net.edge_count());
    Eigen::VectorXd of_common = y.common_mean - at.common;
    std::vector<EdgeRates> rates(net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        if (m_model.slack[e]) {
            continue;
        }
        const EdgeRates& edge = rates[e] = m_model.rates(e, at);
        if (!(y.tension_weights(e) > 0.0)) {
            continue;
        }
        const auto [s, t] = net.edges()[e];
        const double pull = y.tension_weights(e) *
                            (y.tension(e) - edge.tension - y.tension_bias.row(e).dot(at.common));
        places.col(s) += pull * edge.axial * edge.direction;
        places.col(t) -= pull * edge.axial * edge.direction;
        lengths(e) += pull * edge.by_length;
        for (int k = 0; k < common.count(); ++k) {
            of_common(k) +=
                pull * (edge.tension_by(m_model.common_variation(e, k, at)) + y.tension_bias(e, k));
        }
    }
    const Points multipliers = m_form.solve(places);
    for (int e = 0; e < net.edge_count(); ++e) {
        if (m_model.slack[e]) {
            continue;
        }
        const auto [s, t] = net.edges()[e];
        const Eigen::Vector3d relative = multipliers.col(s) - multipliers.col(t);
        lengths(e) -= rates[e].length_rate().dot(relative);
        const Eigen::Vector3d reaction = rates[e].stiffness() * relative;
        places.col(s) -= reaction;
        places.col(t) += reaction;
        for (int k = 0; k < common.count(); ++k) {
            of_common(k) -= rates[e].force_by(m_model.common_variation(e, k, at)).dot(relative);
        }
    }
    const Points& of_frame = m_model.are_supports_uncertain() ? Points(-of_supports) : measured;
    const double factor = common.support_factor(at.common);
    const Points springs = m_model.designed_elastic_forces(at) - at.loads;
    for (int k = 0; k < common.count(); ++k) {
        if (const Points& rate = common.load_rate(k); rate.cols() > 0) {
            of_common(k) += rate.cwiseProduct(multipliers).sum();
        }
        for (const int node : net.supports()) {
            of_common(k) += common.support_rate(k, node).dot(of_frame.col(node));
        }
        for (const ElasticSupport& support : net.elastic_supports()) {
            of_common(k) -= factor * (common.support_stiffness_rate(k) * springs.col(support.node) -
                                      common.frame_load_rate(k, support.node))
                                         .dot(multipliers.col(support.node));
        }
    }
    if (y.evidence) {
        const Eigen::VectorXd misfit =
            y.evidence_pull -
            y.evidence->information * at.lengths_and_common(y.evidence_pull.size());
        const auto count = std::ssize(net.interior_edges());
        lengths(net.interior_edges()) += misfit.head(count);
        of_common.head(misfit.size() - count) += misfit.tail(misfit.size() - count);
    }
    Observations result = m_rest;
    const Eigen::VectorXd off = y.mean - at.deviations;
    result.mean += off + m_variances.cwiseProduct(lengths(net.interior_edges()));
    if (y.mean_root.cols() > 0) {
        result.mean -=
            y.mean_root * m_means.precision.solve(m_means.pulls.transpose() * off).eval();
    }
    result.load_mean += y.load_mean - at.loads;
    const Eigen::VectorXd load_factors = m_model.load_factors(at);
    for (const int node : net.free_nodes()) {
        if (y.load_variance.col(node).maxCoeff() > 0.0) {
            result.load_mean.col(node) +=
                load_factors(node) * y.load_covariance(node) * multipliers.col(node);
        }
    }
    if (m_model.are_supports_uncertain()) {
        for (const int node : net.supports()) {
            for (int k = 0; k < common.count(); ++k) {  // that motion of the frame is in it already
                of_common(k) += common.support_rate(k, node).dot(places.col(node));
            }
            result.support_mean.col(node) +=
                places.col(node).cwiseQuotient(y.support_weights.col(node));
        }
    }
    result.common_mean += of_common;
    return result;
}

/// The leapfrog (R. M. Neal, MCMC using Hamiltonian dynamics, 2011).
double Chain::advance(ChainState& state, double step, int steps, RandomNumbers& random) {
    Iterate velocity = drawn_velocity(random);
    const double before = state.potential + kinetic_energy(velocity);
    const double chance = random.uniform();
    ChainState at = state;
    velocity = velocity.moved(at.force, 0.5 * step);
    for (int k = 1; k <= steps; ++k) {
        std::optional<ChainState> next = state_at(at.iterate.moved(velocity, step));
        if (!next) {
            return 0.0;
        }
        at = *std::move(next);
        velocity = velocity.moved(at.force, k < steps ? step : 0.5 * step);
    }
    const double after = at.potential + kinetic_energy(velocity);
    if (!std::isfinite(after)) {
        return 0.0;
    }
    const double taken = std::exp(std::min(0.0, before - after));
    if (taken <= chance || !is_as_seen(at.iterate)) {
        return taken;
    }
    state = std::move(at);
    return taken;
}

std::vector<Chain::SlackLength> Chain::slack_lengths(const Iterate& iterate) const {
    std::vector<SlackLength> result;
    const CableNet& net = m_model.net();
    for (int i = 0; i < net.interior_edge_count() && !net.sags(); ++i) {
        const int e = net.interior_edges()[i];
        const auto [s, t] = net.edges()[e];
        const double extension = (iterate.form.col(s) - iterate.form.col(t)).norm() -
                                 m_model.unstressed_length(e, iterate);
        if (extension < 0.0 && net.can_be_slack(e) && !m_model.slack[e]) {
            const double heated = 1.0 + m_model.common.thermal_strain(e, iterate.common);
            result.push_back({.interior = i,
                              .from = standardised(iterate, i) +
                                      extension / heated / std::sqrt(m_variances(i))});
        }
    }
    return result;
}

/// Metropolis' rule (W. K. Hastings 1970) for lengths of the prior beyond what the edges span.
void Chain::renew_slack_lengths(ChainState& state, RandomNumbers& random) {
    const std::vector<SlackLength> slack = slack_lengths(state.iterate);
    if (slack.empty()) {
        return;
    }
    const double root = std::numbers::sqrt2;
    const auto log_density = [root](double from, double z) {
        return z > from ? -0.5 * z * z - std::log(std::erfc(from / root))
                        : -std::numeric_limits<double>::infinity();
    };
    const double chance = random.uniform();
    Iterate drawn = state.iterate;
    for (const auto& [i, from] : slack) {
        const double z = root * boost::math::erfc_inv(random.uniform() * std::erfc(from / root));
        drawn.deviations(i) = m_observations.mean(i) + z * std::sqrt(m_variances(i));
    }
    std::optional<ChainState> next = state_at(std::move(drawn));
    if (!next || !is_as_seen(next->iterate)) {
        return;
    }
    const std::vector<SlackLength> back = slack_lengths(next->iterate);
    if (back != slack) {
        return;
    }
    double log_ratio = state.potential - next->potential;
    for (size_t k = 0; k < slack.size(); ++k) {
        const int i = slack[k].interior;
        log_ratio += log_density(back[k].from, standardised(state.iterate, i)) -
                     log_density(slack[k].from, standardised(next->iterate, i));
    }
    if (std::log(chance) < log_ratio) {
        state = *std::move(next);
    }
}

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

/// A chain with its samples so far.
class Run {
public:
    Run(const StaticsModel& model, const Observations& observations, std::span<const int> taut,
        const Iterate& centre, const Linearisation& metric, double tolerance,
        const RandomNumbers& random)
        : m_model(model),
          m_weights(mean_weights(model.net())),
          m_chain(model, observations, taut, centre, metric, tolerance),
          m_random(random),
          m_state(m_chain.far_from(centre, m_random)) {}

    /// Finds the step; false where none makes any way.
    /// @param tick called before each trajectory
    [[nodiscard]] bool warm_up(const Tick& tick);
    /// Forgets all samples and goes on.
    /// @param thinned how many iterates of them are kept
    void sample(std::int64_t count, std::int64_t thinned, const Tick& tick);

    std::vector<Iterate> iterates;
    std::vector<double> mean_tensions;  ///< of all samples
    std::vector<double> potentials;
    double acceptance = 0.0;
    double step = 0.0;

private:
    double advance() {
        const double time = duration * (0.6 + 0.8 * m_random.uniform());
        const int steps = std::clamp(static_cast<int>(time / step), 1, most_steps);
        const double taken = m_chain.advance(*m_state, step, steps, m_random);
        m_chain.renew_slack_lengths(*m_state, m_random);
        return taken;
    }

    const StaticsModel& m_model;
    Eigen::VectorXd m_weights;
    Chain m_chain;
    RandomNumbers m_random;
    std::optional<ChainState> m_state;
};

/// By H. Robbins & S. Monro 1951.
bool Run::warm_up(const Tick& tick) {
    constexpr double first_step = 0.05;
    if (!m_state) {
        return false;
    }
    step = first_step;
    for (int k = 0; k < warm_up_trajectories; ++k) {
        tick();
        step *= std::exp((advance() - wanted_acceptance) / std::pow(k + 1.0, 0.6));
        if (2 * k > warm_up_trajectories && step < least_step) {
            return false;
        }
    }
    return true;
}

void Run::sample(std::int64_t count, std::int64_t thinned, const Tick& tick) {
    iterates.clear();
    mean_tensions.clear();
    potentials.clear();
    acceptance = 0.0;
    for (std::int64_t k = 0; k < count; ++k) {
        tick();
        acceptance += advance() / static_cast<double>(count);
        mean_tensions.push_back(m_weights.dot(m_model.tensions(m_state->iterate)));
        potentials.push_back(m_state->potential);
        if ((k + 1) * thinned / count > k * thinned / count) {
            iterates.push_back(m_state->iterate);
        }
    }
}

ChainSamples together(const std::deque<Run>& runs) {
    ChainSamples result{.step = std::numeric_limits<double>::infinity()};
    std::vector<std::vector<double>> tensions;
    std::vector<std::vector<double>> potentials;
    for (size_t k = 0; k < runs.front().iterates.size(); ++k) {  // the first few are of all chains
        for (const Run& run : runs) {
            result.iterates.push_back(run.iterates[k]);
        }
    }
    for (const Run& run : runs) {
        result.step = std::min(result.step, run.step);
        result.acceptance += run.acceptance / chains;
        tensions.push_back(run.mean_tensions);
        potentials.push_back(run.potentials);
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
    std::deque<Run> runs;  // which stay where they are
    for (int c = 0; c < chains; ++c) {
        runs.emplace_back(model, observations, taut, centre, *metric, tolerance,
                          RandomNumbers(seed, first_stream + static_cast<std::uint32_t>(c)));
    }
    std::array<bool, chains> make_way{};
    int done = 0;
    const auto tick = [&](int c) -> Tick {
        if (c > 0) {
            return [&] { progress.throw_if_stopped(); };
        }
        return [&] {  // of one thread, and as far as the others
            progress("posterior samples", done++, warm_up_trajectories + most_rounds * kept);
        };
    };
    const auto each = [&](const auto& act) {
        parallel_for(0, chains,
                     [&](int c) { isolate([&] { act(c, runs[static_cast<size_t>(c)]); }); });
    };
    each([&](int c, Run& run) { make_way[static_cast<size_t>(c)] = run.warm_up(tick(c)); });
    if (!std::ranges::all_of(make_way, std::identity())) {
        return std::nullopt;
    }
    ChainSamples result;
    for (int round = 0; round < most_rounds; ++round) {
        each([&](int c, Run& run) { run.sample(kept, of_each, tick(c)); });
        result = together(runs);
        if (result.disagreement < ChainSamples::agreed || !(result.disagreement < hopeless)) {
            break;
        }
    }
    result.iterates.resize(static_cast<size_t>(count));
    return result;
}

}  // namespace taut
