// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/order_work.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "adjustment/drawn_forces.hpp"
#include "adjustment/force_ranges.hpp"
#include "numerics/parallel.hpp"

namespace taut {
namespace {

/// Predicted forces of samples err by less than this part of the mean tension. Samples that keep
/// limits by more need no exact equilibrium.
constexpr double prediction_error = 0.05;

}  // namespace

OrderWork::OrderWork(const BuiltNet& built, const Limits& limits, const Plan& plan,
                     const TurnOrderOptions& options)
    : m_built(&built), m_limits(&limits), m_options(options) {
    std::vector<int> edges;
    m_all.resize(std::ssize(plan.strokes));
    for (Eigen::Index k = 0; k < m_all.size(); ++k) {
        edges.push_back(plan.strokes[static_cast<size_t>(k)].edge);
        m_all(k) = plan.strokes[static_cast<size_t>(k)].stroke;
    }
    m_response.push_back(
        {.response = StrokeResponse(built.net, edges, supports_of(limits.reactions)),
         .range = range_of(built.net, limits.tension, limits.reactions),
         .start = built.net.nodes()});
    m_strokes = Eigen::VectorXd::Zero(m_all.size());
    m_now = m_before = at(m_strokes);
    m_unit = std::max(1e-9, m_before.equilibrium.mean_tension);
    const StrokedNet end = at(m_all);
    const Eigen::VectorXd before = excess_of(m_before.forces).cwiseMax(0.0);
    const Eigen::VectorXd after = excess_of(end.forces).cwiseMax(0.0);
    // An excess at the end was accepted with the plan: no order can avoid it.
    m_allowed = before.cwiseMax(after);
    Eigen::Index row = 0;
    if ((after - before).maxCoeff(&row) > negligible_violation * m_unit) {
        m_breach_at_end = breach(row, end.forces(row), is_below(row, end.forces(row)));
    }
    m_rates_before = m_response.front().response.rates(m_before).forces;
    m_rates_end = m_response.front().response.rates(end).forces;
    if (draws() > 0) {
        draw(options, end);
    }
}

void OrderWork::draw(const TurnOrderOptions& options, const StrokedNet& end) {
    const auto drawn_at = [&](const Eigen::VectorXd& strokes, const StrokedNet& net) {
        return draw_strokes(*m_built, m_response, {.strokes = strokes, .nets = {net}},
                            options.actuator_std, options.seed);
    };
    const DrawnStrokes before = drawn_at(m_strokes, m_before);
    const DrawnStrokes after = drawn_at(m_all, end);
    m_offset_before = (before.forces.front().colwise() - m_before.forces).transpose();
    m_offset_end = (after.forces.front().colwise() - end.forces).transpose();
    m_least_offset = m_offset_before.cwiseMin(m_offset_end).colwise().minCoeff();
    m_most_offset = m_offset_before.cwiseMax(m_offset_end).colwise().maxCoeff();
    m_allowed_in_draws.resize(draws(), m_offset_before.cols());
    m_lost_at_end.assign(static_cast<size_t>(draws()), 0);
    m_has_no_form.assign(static_cast<size_t>(draws()), 0);
    for (Eigen::Index d = 0; d < draws(); ++d) {
        const Eigen::VectorXd allowed = excess_of(before.forces.front().col(d)).cwiseMax(0.0);
        m_allowed_in_draws.row(d) = allowed.transpose();
        const bool has_form = before.unbalanced[static_cast<size_t>(d)] == 0 &&
                              after.unbalanced[static_cast<size_t>(d)] == 0;
        m_has_no_form[static_cast<size_t>(d)] = has_form ? 0 : 1;
        const double excess = (excess_of(after.forces.front().col(d)) - allowed).maxCoeff();
        m_lost_at_end[static_cast<size_t>(d)] =
            has_form && excess <= negligible_violation * m_unit ? 0 : 1;
    }
    m_lost = m_lost_at_end;
}

void OrderWork::restart() {
    m_strokes.setZero();
    m_now = m_before;
    m_lost = m_lost_at_end;
}

StrokedNet OrderWork::at(const Eigen::VectorXd& strokes) {
    LimitedResponse& limited = m_response.front();
    const Points& near = m_now.equilibrium.form.cols() > 0 ? m_now.equilibrium.form : limited.start;
    return limited.response.at(m_built->net.unstressed_lengths(), strokes, near);
}

Harm OrderWork::harm(const Eigen::VectorXd& strokes, const StrokedNet& net) const {
    if (!net.equilibrium.balanced()) {
        return {.excess = std::numeric_limits<double>::infinity(),
                .broken = static_cast<int>(draws())};
    }
    return harm_of(strokes, net.forces);
}

Harm OrderWork::predicted_harm(const Eigen::VectorXd& strokes, const StrokedNet& net,
                               Eigen::Index j, double stroke) const {
    Eigen::VectorXd after = strokes;
    after(j) = stroke;
    const double part = part_of(strokes);
    return harm_of(
        after, net.forces + (stroke - strokes(j)) *
                                ((1.0 - part) * m_rates_before.col(j) + part * m_rates_end.col(j)));
}

Harm OrderWork::harm_of(const Eigen::VectorXd& strokes, const Eigen::VectorXd& forces) const {
    const double excess = (excess_of(forces) - m_allowed).maxCoeff() / m_unit;
    return {.excess = excess > negligible_violation ? excess : 0.0,
            .broken = static_cast<int>(std::ranges::count(broken_draws(strokes, forces), 1))};
}

void OrderWork::accept(Eigen::VectorXd strokes, StrokedNet net) {
    const std::vector<char> broken = broken_draws(strokes, net.forces);
    for (size_t d = 0; d < broken.size(); ++d) {
        m_lost[d] |= broken[d];
    }
    m_strokes = std::move(strokes);
    m_now = std::move(net);
}

LimitBreach OrderWork::worst_breach(const StrokedNet& net) const {
    Eigen::Index row = 0;
    (excess_of(net.forces) - m_allowed).maxCoeff(&row);
    return breach(row, net.forces(row), is_below(row, net.forces(row)));
}

int OrderWork::kept_at_end() const {
    return static_cast<int>(std::ranges::count(m_lost_at_end, 0));
}

int OrderWork::predicted_kept() const {
    return static_cast<int>(std::ranges::count(m_lost, 0));
}

DrawnWork OrderWork::drawn(
    const std::vector<std::pair<Eigen::VectorXd, Eigen::VectorXd>>& states) const {
    const ForceRange& range = m_response.front().range;
    Eigen::MatrixXd predicted(draws(), std::ssize(states));
    for (Eigen::Index i = 0; i < predicted.cols(); ++i) {
        const auto& [strokes, forces] = states[static_cast<size_t>(i)];
        predicted.col(i) = predicted_excess(strokes, forces, -prediction_error * m_unit);
    }
    PerThread<StrokeResponse> workspaces([&] { return m_response.front().response.fresh(); });
    using Break = std::tuple<int, Eigen::Index, bool>;  // step, force, whether it is too small
    std::vector<std::vector<Break>> breaks(static_cast<size_t>(draws()));
    // Step at which there is no form; -1: none. Without one before or after the work, no force is
    // predicted.
    std::vector<int> lost(static_cast<size_t>(draws()));
    std::ranges::transform(m_has_no_form, lost.begin(), [](char has) { return has != 0 ? 0 : -1; });
    parallel_for(Eigen::Index{0}, draws(), [&](Eigen::Index d) {
        DrawnResponse response(*m_built, d, workspaces.local());
        // A stroke that is done in part has that part of its error.
        const Eigen::VectorXd whole =
            strokes_with_errors(m_all, m_options.actuator_std, m_options.seed, d);
        const Eigen::VectorXd relative_error =
            (m_all.array().abs() >= negligible_stroke)
                .select((whole - m_all).array() / m_all.array(), 0.0);
        Points near = m_before.equilibrium.form;
        for (size_t i = 0; i < states.size(); ++i) {
            const Eigen::VectorXd& strokes = states[i].first;
            if (predicted(d, static_cast<Eigen::Index>(i)) < -prediction_error * m_unit) {
                continue;
            }
            const StrokedNet net =
                response.at(strokes + relative_error.cwiseProduct(strokes), near);
            if (!net.equilibrium.balanced()) {
                lost[static_cast<size_t>(d)] = static_cast<int>(i);
                break;
            }
            const Eigen::VectorXd excess =
                excess_of(net.forces) - m_allowed_in_draws.row(d).transpose();
            for (Eigen::Index row = 0; row < excess.size(); ++row) {
                if (excess(row) > negligible_violation * m_unit) {
                    breaks[static_cast<size_t>(d)].emplace_back(static_cast<int>(i), row,
                                                                net.forces(row) < range.lower(row));
                }
            }
            near = net.equilibrium.form;
        }
    });
    DrawnWork result;
    std::map<Break, int> count;
    for (size_t d = 0; d < breaks.size(); ++d) {
        int first = lost[d];
        if (!breaks[d].empty() && (first < 0 || std::get<0>(breaks[d].front()) < first)) {
            first = std::get<0>(breaks[d].front());
        }
        result.first_broken.push_back(first);
        result.kept += result.first_broken.back() < 0 ? 1 : 0;
        for (const Break& one : breaks[d]) {
            ++count[one];
        }
    }
    if (!count.empty()) {
        const auto [worst, broken] =
            *std::ranges::max_element(count, {}, &std::map<Break, int>::value_type::second);
        const auto [step, row, is_below] = worst;
        result.worst = {
            .step = step,
            .breach = breach(row, states[static_cast<size_t>(step)].second(row), is_below)};
        result.worst->breach.probability =
            1.0 - static_cast<double>(broken) / static_cast<double>(draws());
    }
    return result;
}

bool OrderWork::is_below(Eigen::Index row, double force) const {
    return force < m_response.front().range.lower(row);
}

LimitBreach OrderWork::breach(Eigen::Index row, double force, bool is_below) const {
    const CableNet& net = m_built->net;
    const ForceRange& range = m_response.front().range;
    const bool is_edge = row < net.edge_count();
    return {.kind = is_edge ? LimitBreach::Kind::tension : LimitBreach::Kind::reaction,
            .index =
                is_edge
                    ? static_cast<int>(row)
                    : supports_of(m_limits->reactions)[static_cast<size_t>(row - net.edge_count())],
            .load_case = "",
            .value = carried(net, row, force),
            .limit = is_below ? given_limit(net, range.lower(row)) : range.upper(row),
            .probability = 0.0};
}

Eigen::VectorXd OrderWork::excess_of(const Eigen::Ref<const Eigen::VectorXd>& forces) const {
    const ForceRange& range = m_response.front().range;
    return (range.lower - forces).cwiseMax(forces - range.upper);
}

double OrderWork::part_of(const Eigen::VectorXd& strokes) const {
    return strokes.lpNorm<1>() / std::max(m_all.lpNorm<1>(), negligible_stroke);
}

Eigen::VectorXd OrderWork::predicted_excess(const Eigen::VectorXd& strokes,
                                            const Eigen::VectorXd& forces, double least) const {
    const ForceRange& range = m_response.front().range;
    const double part = part_of(strokes);
    Eigen::ArrayXd excess =
        Eigen::ArrayXd::Constant(draws(), -std::numeric_limits<double>::infinity());
    for (Eigen::Index row = 0; row < forces.size(); ++row) {
        // Few limits have a sample near them; the others need no look at each sample.
        if (range.lower(row) - forces(row) - m_least_offset(row) <= least &&
            forces(row) + m_most_offset(row) - range.upper(row) <= least) {
            continue;
        }
        const Eigen::ArrayXd predicted = forces(row) +
                                         (1.0 - part) * m_offset_before.col(row).array() +
                                         part * m_offset_end.col(row).array();
        excess = excess.max((range.lower(row) - predicted).max(predicted - range.upper(row)) -
                            m_allowed_in_draws.col(row).array());
    }
    return excess;
}

std::vector<char> OrderWork::broken_draws(const Eigen::VectorXd& strokes,
                                          const Eigen::VectorXd& forces) const {
    std::vector<char> broken(static_cast<size_t>(draws()), 0);
    if (draws() == 0) {
        return broken;
    }
    const double negligible = negligible_violation * m_unit;
    const Eigen::VectorXd excess = predicted_excess(strokes, forces, negligible);
    for (size_t d = 0; d < broken.size(); ++d) {
        broken[d] = m_lost[d] == 0 && excess(static_cast<Eigen::Index>(d)) > negligible ? 1 : 0;
    }
    return broken;
}

}  // namespace taut
