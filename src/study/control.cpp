// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/study/control.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "net/weight_as_load.hpp"
#include "numerics/random_numbers.hpp"
#include "sampling/uncertain_widths.hpp"
#include "shared_work.hpp"
#include "taut/identification/identify.hpp"
#include "taut/numerical_error.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/sampling/model_perturbation.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"
#include "taut/survey/simulation.hpp"

namespace taut {
namespace {

constexpr std::array strategies{ControlStrategy::truth, ControlStrategy::identified,
                                ControlStrategy::nominal, ControlStrategy::once};

void check_control(const CableNet& net, const ControlSettings& settings) {
    check_prior(net, settings.prior);
    check_for_one_survey(net, settings.uncertain);
    const auto require = [](bool holds, const char* field, double value, const char* rule) {
        if (!holds) {
            throw std::invalid_argument(fmt::format("{} is {:g}, expected {}", field, value, rule));
        }
    };
    require(settings.noise_std > 0.0 && std::isfinite(settings.noise_std), "the noise",
            settings.noise_std, "above 0 m");
    require(settings.hidden_part >= 0.0 && settings.hidden_part < 1.0, "the hidden part",
            settings.hidden_part, "at least 0 and below 1");
    require(settings.actuator_std >= 0.0 && std::isfinite(settings.actuator_std),
            "the actuator std", settings.actuator_std, "at least 0 m");
    require(settings.stroke > 0.0 && std::isfinite(settings.stroke), "the stroke", settings.stroke,
            "above 0 m");
    require(settings.rounds >= 1 && settings.rounds <= 100, "the number of rounds", settings.rounds,
            "1 to 100");
    require(settings.trials >= 1 && settings.trials <= 100000, "the number of trials",
            settings.trials, "1 to 100,000");
    require(settings.least_tension >= 0.0 && std::isfinite(settings.least_tension),
            "the least tension", settings.least_tension, "at least 0 N");
    require(settings.most_tension == 0.0 || (settings.most_tension > settings.least_tension &&
                                             std::isfinite(settings.most_tension)),
            "the largest tension", settings.most_tension, "above the least tension");
    require(settings.confidence > 0.0 && settings.confidence < 1.0, "the confidence",
            settings.confidence, "above 0 and below 1");
    require(settings.draws == 0 || settings.draws * (1.0 - settings.confidence) > 1.0 - 1e-9,
            "the number of draws", settings.draws,
            "0, or so many that limits may break in one of them with this confidence");
    check_draws(net, settings.draws);
    const std::vector<int>& edges = net.adjustable_edges();
    check_limits(net, edges, stroke_limits(net, edges, settings.stroke));
}

/// The net with these lengths in equilibrium, its runs after sliding.
CableNet with_lengths(const CableNet& net, const Eigen::VectorXd& lengths, const Points& start) {
    CableNetData data = with_weight_as_load(net);
    const Equilibrium equilibrium = EquilibriumSolver(net).solve(lengths, start);
    if (!equilibrium.balanced()) {
        throw NumericalError("a simulated net finds no equilibrium");
    }
    data.unstressed_lengths = equilibrium.unstressed_lengths;
    data.nodes = equilibrium.form;
    return CableNet(std::move(data));
}

/// The net as it is built in a trial: lengths, all else that is uncertain, and friction.
CableNet built_in_trial(const CableNet& net, const ControlSettings& settings, int trial) {
    const auto stream = static_cast<std::uint64_t>(trial);
    Eigen::VectorXd lengths = with_length_deviations(
        net,
        draw_length_deviations(settings.prior, settings.seed, stream, net.interior_edge_count()));
    CableNetData data = net.data();
    if (!settings.uncertain.empty()) {
        data = net_under(net, draw_perturbation(net, settings.uncertain, settings.seed, stream),
                         lengths)
                   .data();
        lengths = data.unstressed_lengths;
    }
    constexpr std::uint32_t of_friction = 2;
    RandomNumbers random(settings.seed + stream, of_friction);
    for (CableRun& run : data.runs) {
        run.friction = run.friction.value_or(
            random.uniform() * (CableRun::likely_friction + CableRun::uncertain_friction));
    }
    return with_lengths(CableNet(std::move(data)), lengths, net.nodes());
}

/// One trial under one strategy.
class Job {
public:
    Job(const CableNet& net, const ControlSettings& settings, const FormTarget& target, int trial)
        : m_net(net),
          m_settings(settings),
          m_target(target),
          m_trial(trial),
          m_true(built_in_trial(net, settings, trial)),
          m_planned_strokes(
              Eigen::VectorXd::Zero(static_cast<Eigen::Index>(net.adjustable_edges().size()))) {}

    [[nodiscard]] ControlState state(int round, double turned, bool has_failed) const {
        ControlState state{.trial = m_trial,
                           .round = round,
                           .deviation = deviation_from(m_target, m_net, m_true.nodes()),
                           .turned = turned,
                           .has_failed = has_failed};
        const Eigen::VectorXd tension =
            tensions_of(m_true, m_true.unstressed_lengths(), m_true.nodes());
        state.least_tension = tension.minCoeff();
        state.most_tension = tension.maxCoeff();
        // A plan may lead right up to a limit, and forms are as exact as their equilibrium.
        constexpr double rounding = 1e-6;
        const Eigen::VectorXd& buckling = m_net.data().buckling_load;
        for (int e = 0; e < tension.size(); ++e) {
            const double t = tension(e);
            if (m_net.is_strut(e)) {
                if (buckling.size() > 0 && -t > (1.0 + rounding) * buckling(e)) {
                    ++state.broken;
                    state.worst_excess = std::max(state.worst_excess, -t / buckling(e) - 1.0);
                }
                continue;
            }
            const double low = m_settings.least_tension - t;
            const double high = m_settings.most_tension > 0.0 ? t - m_settings.most_tension : -1.0;
            // An edge without tension is slack, which always breaks a limit.
            if (low > rounding * m_settings.least_tension || t <= 0.0) {
                ++state.broken;
                state.worst_excess =
                    std::max(state.worst_excess,
                             m_settings.least_tension > 0.0 ? low / m_settings.least_tension : 1.0);
            } else if (high > rounding * m_settings.most_tension) {
                ++state.broken;
                state.worst_excess = std::max(state.worst_excess, high / m_settings.most_tension);
            }
        }
        return state;
    }

    /// One round: plans, turns, and returns the state after it.
    ControlState work(ControlStrategy strategy, int round) {
        double turned = 0.0;
        bool has_failed = false;
        if (strategy != ControlStrategy::once || round == 1) {
            try {
                turned = turn(plan(strategy, round), round);
            } catch (const NumericalError&) {
                has_failed = true;  // counted; nothing is turned in this round
            } catch (
                const std::invalid_argument&) {  // the result is no valid net, or allows no plan
                has_failed = true;
            }
        }
        return state(round, turned, has_failed);
    }

private:
    [[nodiscard]] std::uint64_t seed_of(int round) const {
        constexpr std::uint64_t trials = 100003;
        return (m_settings.seed * trials + static_cast<std::uint64_t>(m_trial)) * 128 +
               static_cast<std::uint64_t>(round);
    }

    /// The design with the planned strokes so far.
    [[nodiscard]] CableNet planned_net() const {
        Eigen::VectorXd lengths = m_net.unstressed_lengths();
        lengths(m_net.adjustable_edges()) += m_planned_strokes;
        return CableNet(with_lengths_of_same_weight(m_net, lengths));
    }

    [[nodiscard]] Survey survey(const CableNet& planned, int round) const {
        return match_to_nodes(planned, simulate_survey(planned, m_true.nodes(),
                                                       {.noise_std = m_settings.noise_std,
                                                        .dropped_part = m_settings.hidden_part,
                                                        .seed = seed_of(round)}));
    }

    [[nodiscard]] Limits limits() const {
        Limits limits = stroke_limits(m_net, m_net.adjustable_edges(), m_settings.stroke);
        limits.shortest_stroke -= m_planned_strokes;
        limits.longest_stroke -= m_planned_strokes;
        limits.shortest_stroke = limits.shortest_stroke.cwiseMin(0.0);
        limits.longest_stroke = limits.longest_stroke.cwiseMax(0.0);
        for (int e = 0; e < m_net.edge_count(); ++e) {
            if (!m_net.is_strut(e)) {
                limits.tension.lower(e) = m_settings.least_tension;
                if (m_settings.most_tension > 0.0) {
                    limits.tension.upper(e) = m_settings.most_tension;
                }
            }
        }
        return limits;
    }

    [[nodiscard]] Plan plan(ControlStrategy strategy, int round) const {
        PlanOptions options{.confidence = m_settings.confidence,
                            .actuator_std = m_settings.actuator_std,
                            .turn = m_settings.turn,
                            .seed = seed_of(round)};
        if (strategy == ControlStrategy::truth) {
            const BuiltNet built{.net = m_true,
                                 .length_draws = {},
                                 .perturbations = {},
                                 .no_draws_because = "the net is known"};
            return plan_strokes(built, m_target, limits(), options);
        }
        const CableNet planned = planned_net();
        const Survey seen = survey(planned, round);
        if (strategy == ControlStrategy::identified) {
            const Identification found = identify(planned, seen,
                                                  {.method = IdentificationMethod::map,
                                                   .prior = m_settings.prior,
                                                   .prior_exact = true,
                                                   .uncertain = m_settings.uncertain,
                                                   .assume_site = false,
                                                   .draws = m_settings.draws,
                                                   .seed = seed_of(round)});
            if (found.status != IdentificationStatus::converged) {
                throw NumericalError(found.message);
            }
            return plan_strokes(built_net_of(planned, found), m_target, limits(), options);
        }
        // The surveyed deviations are transferred to the design, whose sensitivities are used.
        // Nodes that were not surveyed have no weight.
        const BuiltNet built{
            .net = with_lengths(m_net, planned.unstressed_lengths(), m_net.nodes()),
            .length_draws = {},
            .perturbations = {},
            .no_draws_because = "nothing was identified"};
        Points places = m_target.places();
        places(Eigen::all, seen.surveyed) -=
            (seen.form - built.net.nodes())(Eigen::all, seen.surveyed);
        FormTarget target = m_target;
        target.move_to(places);
        Eigen::VectorXd normal = Eigen::VectorXd::Ones(m_net.node_count());
        Eigen::VectorXd tangential =
            Eigen::VectorXd::Constant(m_net.node_count(), DeviationWeights{}.tangential);
        for (const int node : seen.missing) {
            normal(node) = tangential(node) = 0.0;
        }
        target.set_weights(normal, tangential);
        return plan_strokes(built, target, limits(), options);
    }

    double turn(const Plan& plan, int round) {
        RandomNumbers errors(seed_of(round), 1);
        Eigen::VectorXd lengths = m_true.unstressed_lengths();
        double sum = 0.0;
        for (const PlannedStroke& stroke : plan.strokes) {
            const auto& edges = m_net.adjustable_edges();
            const auto k = std::ranges::lower_bound(edges, stroke.edge) - edges.begin();
            m_planned_strokes(k) += stroke.stroke;
            lengths(stroke.edge) += stroke.stroke + m_settings.actuator_std * errors.normal();
            sum += std::abs(stroke.stroke);
        }
        m_true = with_lengths(m_true, lengths, m_true.nodes());
        return sum;
    }

    const CableNet& m_net;
    const ControlSettings& m_settings;
    const FormTarget& m_target;
    int m_trial;
    CableNet m_true;                    ///< as built and turned, in equilibrium
    Eigen::VectorXd m_planned_strokes;  ///< of the adjustable edges, in all [m]
};

}  // namespace

std::string_view to_string(ControlStrategy strategy) {
    switch (strategy) {
        case ControlStrategy::truth:
            return "true lengths";
        case ControlStrategy::identified:
            return "identified";
        case ControlStrategy::nominal:
            return "design";
        case ControlStrategy::once:
            return "design, once";
    }
    return "unknown";
}

ControlRecord::Round ControlRecord::after(int round) const {
    Round result{.least_tension = std::numeric_limits<double>::infinity()};
    double count = 0.0;
    for (const ControlState& state : states) {
        if (state.round != round) {
            continue;
        }
        count += 1.0;
        result.normal_rmse += state.deviation.normal_rmse * state.deviation.normal_rmse;
        result.normal_mean += state.deviation.normal_mean;
        result.normal_max = std::max(result.normal_max, state.deviation.normal_max);
        result.mean += state.deviation.mean;
        result.max = std::max(result.max, state.deviation.max);
        result.least_tension = std::min(result.least_tension, state.least_tension);
        result.most_tension = std::max(result.most_tension, state.most_tension);
        result.turned += state.turned;
        result.broken_trials += state.broken > 0 ? 1 : 0;
        result.worst_excess = std::max(result.worst_excess, state.worst_excess);
        result.failed += state.has_failed ? 1 : 0;
    }
    result.normal_rmse = std::sqrt(result.normal_rmse / count);
    result.normal_mean /= count;
    result.mean /= count;
    result.turned /= count;
    return result;
}

std::vector<ControlRecord> simulate_control(const CableNet& net, const ControlSettings& settings,
                                            const Progress& progress) {
    check_control(net, settings);
    require_same("net", net.fingerprint());
    const FormTarget target(net, net.nodes());
    const auto total = static_cast<int>(strategies.size()) * settings.trials;
    std::vector<std::vector<ControlState>> jobs;  // of this process: each with all its rounds
    for (const size_t k : share_of(total)) {
        progress("control", static_cast<int>(k), total);
        Job job(net, settings, target, static_cast<int>(k) % settings.trials);
        jobs.push_back({job.state(0, 0.0, false)});
        for (int round = 1; round <= settings.rounds; ++round) {
            jobs.back().push_back(job.work(strategies[k / settings.trials], round));
        }
    }
    jobs = all_gather(total, std::move(jobs));
    std::vector<ControlRecord> records;
    for (size_t k = 0; k < jobs.size(); ++k) {
        if (k % settings.trials == 0) {
            records.push_back({.strategy = strategies[k / settings.trials], .states = {}});
        }
        std::ranges::copy(jobs[k], std::back_inserter(records.back().states));
    }
    progress("control", total, total);
    return records;
}

}  // namespace taut
