// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/adjustment/turn_order.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "adjustment/check_plan.hpp"
#include "adjustment/drawn_forces.hpp"
#include "adjustment/force_ranges.hpp"
#include "adjustment/order_work.hpp"
#include "adjustment/station_tour.hpp"
#include "adjustment/work_stages.hpp"

namespace taut {
namespace {

constexpr int most_passes = 8;

/// Where a crew stands to turn an edge: its support, else its middle.
Eigen::Vector3d station_of(const CableNet& net, int edge) {
    const auto [s, t] = net.edges()[edge];
    if (net.is_support(s)) {
        return net.nodes().col(s);
    }
    if (net.is_support(t)) {
        return net.nodes().col(t);
    }
    return 0.5 * (net.nodes().col(s) + net.nodes().col(t));
}

/// The tour cut into one stretch per crew.
std::vector<std::vector<int>> stretches(const std::vector<int>& tour, int crews) {
    std::vector<std::vector<int>> result(static_cast<size_t>(crews));
    for (size_t i = 0; i < tour.size(); ++i) {
        result[i * result.size() / tour.size()].push_back(tour[i]);
    }
    return result;
}

/// Strokes done after each step, and the forces of the estimate then.
using States = std::vector<std::pair<Eigen::VectorXd, Eigen::VectorXd>>;

struct PassAttempt {
    TurnOrder order;
    States states;
    double excess = 0.0;    ///< of the estimate, the most at any step [mean tensions]
    int first_broken = -1;  ///< step at which the estimate breaks a limit first
    int kept = 0;           ///< samples in which no step breaks a limit, predicted until judged
    bool is_judged = false;
    [[nodiscard]] bool is_better_than(const PassAttempt& other) const {
        return std::tuple(excess, -kept) < std::tuple(other.excess, -other.kept);
    }
};

/// The station that a crew turns next, and its effect.
struct NextStation {
    size_t at = 0;  ///< among those that are left
    Harm harm;
    StrokedNet net;
};

/// The first of the remaining stations that breaks no limit now, else the one with the least harm:
/// tangents rank them, exact equilibrium decides.
/// @param net at `strokes`
NextStation next_station(OrderWork& work, const Eigen::VectorXd& strokes, const StrokedNet& net,
                         const std::vector<int>& left, const auto& goal) {
    constexpr size_t tries = 3;
    using Ranked = std::pair<Harm, size_t>;
    std::vector<Ranked> ranked;
    size_t harmless = 0;
    for (size_t i = 0; i < left.size() && harmless < tries; ++i) {
        ranked.emplace_back(work.predicted_harm(strokes, net, left[i], goal(left[i])), i);
        harmless += ranked.back().first.is_none() ? 1 : 0;
    }
    std::ranges::stable_sort(ranked, {}, &Ranked::first);
    NextStation best;
    for (size_t i = 0; i < std::min(tries, ranked.size()); ++i) {
        const size_t at = ranked[i].second;
        Eigen::VectorXd tried = strokes;
        tried(left[at]) = goal(left[at]);
        StrokedNet there = work.at(tried);
        const Harm harm = work.harm(tried, there);
        if (i == 0 || harm < best.harm) {
            best = {.at = at, .harm = harm, .net = std::move(there)};
        }
        if (harm.is_none()) {
            break;
        }
    }
    return best;
}

void add_stage_end(const OrderWork& work, const std::vector<WorkStage>& stages, int stage,
                   int last_step, TurnOrder& order) {
    if (stages.empty()) {
        return;
    }
    const bool is_rest = stage == std::ssize(stages);
    const WorkStage given =
        is_rest ? WorkStage{.name = "rest"} : stages[static_cast<size_t>(stage)];
    const Eigen::VectorXd tensions = carried_tensions(work.net(), work.now().forces);
    order.stages.push_back({.name = given.name,
                            .part = given.part,
                            .step = last_step,
                            .least_tension = tensions.minCoeff(),
                            .most_tension = tensions.maxCoeff()});
}

/// Passes over the net, each crew along its stretch. A station that would break a limit now is put
/// off; one that always would is turned where it does least harm.
PassAttempt try_passes(OrderWork& work, const Plan& plan,
                       const std::vector<std::vector<int>>& crews, int passes,
                       const TurnOrderOptions& options, const Progress& progress) {
    PassAttempt result;
    const std::vector<Pass> all_passes = passes_of(plan, options.stages, passes, options.turn_step);
    result.order.passes = static_cast<int>(all_passes.size());
    work.restart();
    int step = 0;
    for (int pass = 1; pass <= result.order.passes; ++pass) {
        const Pass& now = all_passes[static_cast<size_t>(pass) - 1];
        std::vector<std::vector<int>> left = crews;
        const auto goal = [&](int j) { return now.strokes(j); };
        for (std::vector<int>& stations : left) {
            std::erase_if(stations, [&](int j) {
                return std::abs(goal(j) - work.strokes()(j)) < negligible_stroke;
            });
        }
        while (std::ranges::any_of(left, [](const auto& stations) { return !stations.empty(); })) {
            progress("ordering", 0, 0);
            Eigen::VectorXd strokes = work.strokes();
            NextStation next{.net = work.now()};
            for (size_t crew = 0; crew < left.size(); ++crew) {
                if (left[crew].empty()) {
                    continue;
                }
                next = next_station(work, strokes, next.net, left[crew], goal);
                const int j = left[crew][next.at];
                result.order.turnings.push_back({.edge = plan.strokes[static_cast<size_t>(j)].edge,
                                                 .stroke = goal(j) - work.strokes()(j),
                                                 .pass = pass,
                                                 .crew = static_cast<int>(crew) + 1,
                                                 .step = step});
                strokes(j) = goal(j);
                left[crew].erase(left[crew].begin() + static_cast<std::ptrdiff_t>(next.at));
            }
            if (next.harm.excess > 0.0 && result.first_broken < 0) {
                result.first_broken = step;
            }
            if (next.harm.excess > result.excess) {
                result.excess = next.harm.excess;
                result.order.worst = {.step = step, .breach = work.worst_breach(next.net)};
            }
            for (Turning& turning : result.order.turnings) {
                if (turning.step == step) {
                    turning.tension =
                        carried(work.net(), turning.edge, next.net.forces(turning.edge));
                    const auto [s, t] = work.net().edges()[turning.edge];
                    const Points& form = next.net.equilibrium.form;
                    turning.length = (form.col(s) - form.col(t)).norm();
                }
            }
            result.states.emplace_back(strokes, next.net.forces);
            work.accept(std::move(strokes), std::move(next.net));
            ++step;
        }
        if (pass == result.order.passes ||
            all_passes[static_cast<size_t>(pass)].stage != now.stage) {
            add_stage_end(work, options.stages, now.stage, step - 1, result.order);
        }
    }
    result.kept = work.predicted_kept();
    return result;
}

/// Computes the probability that an order is safe, and the worst step where it is not.
void judge(const OrderWork& work, const TurnOrderOptions& options, PassAttempt& attempt) {
    TurnOrder& order = attempt.order;
    attempt.is_judged = true;
    if (attempt.excess == 0.0 && work.breach_at_end()) {
        order.worst = {.step = static_cast<int>(attempt.states.size()) - 1,
                       .breach = *work.breach_at_end()};
    }
    order.is_safe = order.worst.step < 0;
    order.safe_probability = order.is_safe ? 1.0 : 0.0;
    if (work.draws() == 0) {
        for (StageEnd& stage : order.stages) {
            const bool is_kept = attempt.first_broken < 0 || attempt.first_broken > stage.step;
            stage.safe_probability = order.is_safe || is_kept ? 1.0 : 0.0;
        }
        return;
    }
    const DrawnWork drawn = work.drawn(attempt.states);
    for (StageEnd& stage : order.stages) {
        const auto broken = std::ranges::count_if(
            drawn.first_broken, [&](int step) { return step >= 0 && step <= stage.step; });
        stage.safe_probability =
            1.0 - static_cast<double>(broken) / static_cast<double>(work.draws());
    }
    attempt.kept = drawn.kept;
    order.safe_probability = static_cast<double>(drawn.kept) / static_cast<double>(work.draws());
    if (order.is_safe && drawn.kept < draws_needed(options.confidence, work.draws())) {
        order.is_safe = false;
        order.worst = drawn.worst.value_or(
            WorstStep{.step = static_cast<int>(attempt.states.size()) - 1, .breach = {}});
    }
}

double walk_of(const CableNet& net, const TurnOrder& order, int crews) {
    double sum = 0.0;
    for (int crew = 1; crew <= crews; ++crew) {
        const Turning* before = nullptr;
        for (const Turning& turning : order.turnings) {
            if (turning.crew != crew) {
                continue;
            }
            if (before != nullptr) {
                sum += (station_of(net, turning.edge) - station_of(net, before->edge)).norm();
            }
            before = &turning;
        }
    }
    return sum;
}

}  // namespace

TurnOrder order_turns(const BuiltNet& built, const Limits& limits, const Plan& plan,
                      const TurnOrderOptions& options, const Progress& progress) {
    constexpr int most_crews = 100;
    if (options.crews < 1 || options.crews > most_crews) {
        throw std::invalid_argument(
            fmt::format("{} crews, expected 1 to {}", options.crews, most_crews));
    }
    if (!(options.turn_step >= 0.0) || std::isinf(options.turn_step)) {
        throw std::invalid_argument(
            fmt::format("the smallest turn is {:g} m, expected at least 0", options.turn_step));
    }
    if (!(options.confidence > 0.0 && options.confidence < 1.0)) {
        throw std::invalid_argument(fmt::format(
            "the confidence is {:g}, expected more than 0 and less than 1", options.confidence));
    }
    if (!(options.actuator_std >= 0.0) || std::isinf(options.actuator_std)) {
        throw std::invalid_argument(
            fmt::format("the actuator std is {:g} m, expected at least 0", options.actuator_std));
    }
    check_stages(built.net, options.stages);
    check_force_limits(built.net, limits);
    check_plan(built.net, limits, plan);
    if (plan.strokes.empty()) {
        return {.turnings = {}, .safe_probability = 1.0, .is_safe = true, .worst = {}};
    }
    Points places(3, static_cast<Eigen::Index>(plan.strokes.size()));
    for (size_t j = 0; j < plan.strokes.size(); ++j) {
        places.col(static_cast<Eigen::Index>(j)) = station_of(built.net, plan.strokes[j].edge);
    }
    const auto crews = stretches(short_tour(places), options.crews);
    OrderWork work(built, limits, plan, options);
    const int needed = draws_needed(options.confidence, work.draws());
    PassAttempt best;
    for (int passes = 1; passes <= most_passes; passes *= 2) {
        PassAttempt tried = try_passes(work, plan, crews, passes, options, progress);
        if (tried.excess == 0.0 && tried.kept >= needed) {
            judge(work, options, tried);
        }
        // An order that was judged is replaced by a judged one alone.
        if (passes > 1 && best.is_judged && !tried.is_judged && tried.is_better_than(best)) {
            judge(work, options, tried);
        }
        if (passes == 1 || tried.is_better_than(best)) {
            best = std::move(tried);
        }
        // Limits broken at the end are broken by every order.
        if (best.order.is_safe || (best.excess == 0.0 && best.kept >= work.kept_at_end())) {
            break;
        }
    }
    if (!best.is_judged) {
        judge(work, options, best);
    }
    best.order.walk = walk_of(built.net, best.order, options.crews);
    return best.order;
}

}  // namespace taut
