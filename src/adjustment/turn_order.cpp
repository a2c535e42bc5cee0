// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/adjustment/turn_order.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "adjustment/check_plan.hpp"
#include "adjustment/force_ranges.hpp"
#include "adjustment/station_tour.hpp"
#include "adjustment/stroke_search.hpp"

namespace taut {
namespace {

constexpr double negligible_excess = 1e-5;  ///< of the mean tension
constexpr int most_passes = 8;

/// Of the margin that a plan keeps for what is not known, this part is kept on the way.
constexpr double margin_on_the_way = 0.9;

/// Where a crew stands to turn an edge: its support, else its middle.
Eigen::Vector3d station_of(const CableNet& net, int edge) {
    const auto [s, t] = net.edges()[edge];
    if (net.free_index(s) < 0) {
        return net.nodes().col(s);
    }
    if (net.free_index(t) < 0) {
        return net.nodes().col(t);
    }
    return 0.5 * (net.nodes().col(s) + net.nodes().col(t));
}

ForceRange range_on_the_way(ForceRange told, const Plan& plan) {
    const auto between = [](double from, double to) {
        return std::isinf(from) ? from : from + margin_on_the_way * (to - from);
    };
    told.lower = told.lower.binaryExpr(plan.held.front().lower, between).eval();
    told.upper = told.upper.binaryExpr(plan.held.front().upper, between).eval();
    return told;
}

/// Work under way: the strokes done, and how much worse than before the work forces are beyond.
class Work {
public:
    Work(const BuiltNet& built, const Limits& limits, const Plan& plan)
        : m_net(&built.net), m_limits(&limits) {
        std::vector<int> edges;
        edges.reserve(plan.strokes.size());
        for (const PlannedStroke& stroke : plan.strokes) {
            edges.push_back(stroke.edge);
        }
        // Later loads do not act yet while the crews turn.
        m_response.emplace_back(LimitedResponse{
            .response = StrokeResponse(built.net, edges, supports_of(limits.reactions)),
            .range = range_on_the_way(range_of(built.net, limits.tension, limits.reactions), plan),
            .start = built.net.nodes()});
        m_strokes = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(edges.size()));
        m_now = at(m_strokes);
        Eigen::VectorXd all = m_strokes;
        for (Eigen::Index k = 0; k < all.size(); ++k) {
            all(k) = plan.strokes[static_cast<size_t>(k)].stroke;
        }
        // Where the plan ends it was accepted, though the limits that it held may be missed by
        // little there.
        const StrokedNet end = at(all);
        m_allowed = beyond(m_now).cwiseMax(beyond(end)).cwiseMax(0.0);
        m_unit = std::max(1e-9, m_now.equilibrium.mean_tension);
        const ForceRange told = range_of(built.net, limits.tension, limits.reactions);
        const auto beyond_told = [&](const StrokedNet& net) -> Eigen::VectorXd {
            return (told.lower - net.forces).cwiseMax(net.forces - told.upper).cwiseMax(0.0);
        };
        const Eigen::VectorXd worse = beyond_told(end) - beyond_told(m_now);
        if (worse.maxCoeff() > negligible_excess * m_unit) {
            m_breach_at_end = breach(end, worse, told);
        }
    }

    [[nodiscard]] StrokedNet at(const Eigen::VectorXd& strokes) {
        const Points& near =
            m_now.equilibrium.form.cols() > 0 ? m_now.equilibrium.form : m_response.front().start;
        return m_response.front().response.at(m_net->unstressed_lengths(), strokes, near);
    }

    /// How far the forces are beyond their limits, the most of what is more than before the work,
    /// in mean tensions; infinite where there is no equilibrium.
    [[nodiscard]] double excess(const StrokedNet& net) const {
        return net.equilibrium.balanced() ? (beyond(net) - m_allowed).maxCoeff() / m_unit
                                          : std::numeric_limits<double>::infinity();
    }

    /// The worst limit that all strokes together break and that was kept before, or by more.
    [[nodiscard]] const std::optional<LimitBreach>& breach_at_end() const {
        return m_breach_at_end;
    }

    [[nodiscard]] const Eigen::VectorXd& strokes() const { return m_strokes; }
    void accept(Eigen::VectorXd strokes, StrokedNet net) {
        m_strokes = std::move(strokes);
        m_now = std::move(net);
    }
    void restart() {
        m_strokes.setZero();
        m_now = at(m_strokes);
    }

    [[nodiscard]] LimitBreach worst_breach(const StrokedNet& net) const {
        return breach(net, beyond(net) - m_allowed, m_response.front().range);
    }

private:
    /// The one of the largest excess.
    [[nodiscard]] LimitBreach breach(const StrokedNet& net, const Eigen::VectorXd& excess,
                                     const ForceRange& range) const {
        Eigen::Index row = 0;
        excess.maxCoeff(&row);
        const bool is_edge = row < m_net->edge_count();
        return {
            .kind = is_edge ? LimitBreach::Kind::tension : LimitBreach::Kind::reaction,
            .index = is_edge
                         ? static_cast<int>(row)
                         : supports_of(
                               m_limits->reactions)[static_cast<size_t>(row - m_net->edge_count())],
            .load_case = "",
            .value = is_edge ? std::max(0.0, net.forces(row)) : net.forces(row),
            .limit = net.forces(row) < range.lower(row) ? range.lower(row) : range.upper(row),
            .probability = 0.0};
    }

    [[nodiscard]] Eigen::VectorXd beyond(const StrokedNet& net) const {
        const ForceRange& range = m_response.front().range;
        return (range.lower - net.forces).cwiseMax(net.forces - range.upper);
    }

    const CableNet* m_net;
    const Limits* m_limits;
    std::vector<LimitedResponse> m_response;
    Eigen::VectorXd m_strokes;
    StrokedNet m_now;
    Eigen::VectorXd m_allowed;
    std::optional<LimitBreach> m_breach_at_end;
    double m_unit = 1.0;
};

/// The tour cut into as many stretches as there are crews, each with its stations in order.
std::vector<std::vector<int>> stretches(const std::vector<int>& tour, int crews) {
    std::vector<std::vector<int>> result(static_cast<size_t>(crews));
    for (size_t i = 0; i < tour.size(); ++i) {
        result[i * result.size() / tour.size()].push_back(tour[i]);
    }
    return result;
}

struct PassAttempt {
    TurnOrder order;
    double excess = 0.0;  ///< the most at any moment
};

/// Passes over the net, each crew along its stretch; a station that would break a limit now is
/// left for later, and one that always does is turned where it does least harm.
PassAttempt try_passes(Work& work, const Plan& plan, const std::vector<std::vector<int>>& crews,
                       int passes, double step, const Progress& progress) {
    PassAttempt result;
    result.order.passes = passes;
    work.restart();
    int moment = 0;
    for (int pass = 1; pass <= passes; ++pass) {
        std::vector<std::vector<int>> left = crews;
        const auto goal = [&](int j) {
            const double part = plan.strokes[static_cast<size_t>(j)].stroke * pass / passes;
            return pass == passes || step == 0.0 ? part : step * std::round(part / step);
        };
        for (std::vector<int>& stations : left) {
            std::erase_if(stations, [&](int j) {
                return std::abs(goal(j) - work.strokes()(j)) < negligible_stroke;
            });
        }
        while (std::ranges::any_of(left, [](const auto& stations) { return !stations.empty(); })) {
            progress("ordering", 0, 0);
            Eigen::VectorXd strokes = work.strokes();
            StrokedNet net;
            double excess = 0.0;
            for (size_t crew = 0; crew < left.size(); ++crew) {
                if (left[crew].empty()) {
                    continue;
                }
                size_t best = 0;
                double least = std::numeric_limits<double>::infinity();
                StrokedNet best_net;
                constexpr size_t tries = 12;
                for (size_t i = 0; i < std::min(tries, left[crew].size()); ++i) {
                    Eigen::VectorXd tried = strokes;
                    tried(left[crew][i]) = goal(left[crew][i]);
                    StrokedNet there = work.at(tried);
                    const double harm = work.excess(there);
                    if (harm < least || i == 0) {
                        least = harm;
                        best = i;
                        best_net = std::move(there);
                    }
                    if (harm <= negligible_excess) {
                        break;
                    }
                }
                const int j = left[crew][best];
                result.order.turnings.push_back({.edge = plan.strokes[static_cast<size_t>(j)].edge,
                                                 .stroke = goal(j) - work.strokes()(j),
                                                 .pass = pass,
                                                 .crew = static_cast<int>(crew) + 1,
                                                 .moment = moment});
                strokes(j) = goal(j);
                left[crew].erase(left[crew].begin() + static_cast<std::ptrdiff_t>(best));
                net = std::move(best_net);
                excess = least;
            }
            if (excess > std::max(result.excess, negligible_excess)) {
                result.excess = excess;
                result.order.worst = {.moment = moment, .breach = work.worst_breach(net)};
            }
            work.accept(std::move(strokes), std::move(net));
            ++moment;
        }
    }
    if (result.excess <= negligible_excess && work.breach_at_end()) {
        result.order.worst = {.moment = moment - 1, .breach = *work.breach_at_end()};
    }
    result.order.is_safe = result.excess <= negligible_excess && !work.breach_at_end();
    return result;
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
    if (!(options.step >= 0.0) || std::isinf(options.step)) {
        throw std::invalid_argument(
            fmt::format("a step of {:g} m, expected at least 0", options.step));
    }
    check_force_limits(built.net, limits);
    check_plan(built.net, limits, plan);
    if (plan.strokes.empty()) {
        return {.turnings = {}, .is_safe = true, .worst = {}};
    }
    Points places(3, static_cast<Eigen::Index>(plan.strokes.size()));
    for (size_t j = 0; j < plan.strokes.size(); ++j) {
        places.col(static_cast<Eigen::Index>(j)) = station_of(built.net, plan.strokes[j].edge);
    }
    const auto crews = stretches(short_tour(places), options.crews);
    Work work(built, limits, plan);
    PassAttempt best;
    for (int passes = 1; passes <= most_passes; passes *= 2) {
        PassAttempt tried = try_passes(work, plan, crews, passes, options.step, progress);
        if (passes == 1 || tried.excess < best.excess) {
            best = std::move(tried);
        }
        if (best.excess <= negligible_excess) {
            break;
        }
    }
    best.order.walk = walk_of(built.net, best.order, options.crews);
    return best.order;
}

}  // namespace taut
