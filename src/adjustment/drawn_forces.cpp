// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/drawn_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/memory_budget.hpp"
#include "numerics/parallel.hpp"
#include "numerics/random_numbers.hpp"

namespace taut {
namespace {

/// Standard deviations below this part of the mean tension are rounding errors.
constexpr double smallest_std = 1e-9;

}  // namespace

Eigen::VectorXd strokes_with_errors(Eigen::VectorXd strokes, double actuator_std,
                                    std::uint64_t seed, Eigen::Index draw) {
    RandomNumbers random(seed, static_cast<std::uint32_t>(draw));
    for (double& stroke : strokes) {
        const double error = actuator_std * random.normal();
        stroke += std::abs(stroke) >= negligible_stroke ? error : 0.0;
    }
    return strokes;
}

int draws_needed(double confidence, Eigen::Index draws) {
    // Another sample lies below the value of rank p (N + 1) with probability p.
    return static_cast<int>(std::min(static_cast<double>(draws),
                                     std::ceil(confidence * (static_cast<double>(draws) + 1.0))));
}

DrawnResponse::DrawnResponse(const BuiltNet& built, Eigen::Index draw, StrokeResponse& shared)
    : m_response(&shared), m_lengths(built.length_draws.col(draw)) {
    if (!built.perturbations.empty()) {
        m_net = net_under(shared.net(), built.perturbations[static_cast<size_t>(draw)], m_lengths);
        m_own = shared.of(*m_net);
        m_response = &*m_own;
    }
}

StrokedNet DrawnResponse::at(const Eigen::VectorXd& strokes, const Points& start) {
    return m_response->at(m_lengths, strokes, start);
}

DrawnStrokes draw_strokes(const BuiltNet& built, const std::vector<LimitedResponse>& responses,
                          const StrokedState& state, double actuator_std, std::uint64_t seed,
                          const Progress& progress) {
    const Eigen::Index count = built.length_draws.cols();
    double numbers = 3.0 * built.net.free_node_count();
    for (const StrokedNet& net : state.nets) {
        numbers += static_cast<double>(net.forces.size());
    }
    const MemoryCharge charge = charge_numbers(numbers * static_cast<double>(count));
    DrawnStrokes result;
    for (const StrokedNet& net : state.nets) {
        result.forces.emplace_back(net.forces.size(), count);
    }
    result.forms.resize(Eigen::Index{3} * built.net.free_node_count(), count);
    result.unbalanced.assign(static_cast<size_t>(count), 0);
    PerThread<std::vector<StrokeResponse>> workspaces([&] {
        std::vector<StrokeResponse> copies;
        copies.reserve(responses.size());
        for (const LimitedResponse& limited : responses) {
            copies.push_back(limited.response.fresh());
        }
        return copies;
    });
    parallel_for(Eigen::Index{0}, count, [&](Eigen::Index d) {
        progress.throw_if_stopped();
        const Eigen::VectorXd strokes = strokes_with_errors(state.strokes, actuator_std, seed, d);
        std::vector<StrokeResponse>& local = workspaces.local();
        for (size_t i = 0; i < local.size(); ++i) {
            const StrokedNet drawn =
                DrawnResponse(built, d, local[i]).at(strokes, state.nets[i].equilibrium.form);
            result.forces[i].col(d) = drawn.forces;
            if (!drawn.equilibrium.balanced()) {
                result.unbalanced[static_cast<size_t>(d)] = 1;
            }
            if (i == 0) {
                result.forms.col(d) = free_coordinates(built.net, drawn.equilibrium.form);
            }
        }
    });
    return result;
}

LimitMargins::LimitMargins(std::vector<ForceRange> given, const StrokedState& state,
                           const DrawnStrokes& draws)
    : m_given(std::move(given)) {
    const Eigen::Index count = draws.forms.cols();
    m_kept = std::numeric_limits<double>::infinity();
    m_worst.assign(static_cast<size_t>(count), -std::numeric_limits<double>::infinity());
    for (size_t i = 0; i < m_given.size(); ++i) {
        const Eigen::MatrixXd& forces = draws.forces[i];
        const double least = smallest_std * std::max(1e-9, state.nets[i].equilibrium.mean_tension);
        const Eigen::VectorXd mean = forces.rowwise().mean();
        m_std.emplace_back(
            ((forces.colwise() - mean).rowwise().squaredNorm() / static_cast<double>(count))
                .cwiseSqrt()
                .cwiseMax(least));
        m_bias.emplace_back(mean - state.nets[i].forces);
        m_kept = std::min(m_kept, (mean - m_given[i].lower)
                                      .cwiseMin(m_given[i].upper - mean)
                                      .cwiseQuotient(m_std.back())
                                      .minCoeff());
        for (Eigen::Index d = 0; d < count; ++d) {
            const Eigen::ArrayXd excess = (m_given[i].lower - forces.col(d))
                                              .cwiseMax(forces.col(d) - m_given[i].upper)
                                              .array() /
                                          m_std.back().array();
            double& worst = m_worst[static_cast<size_t>(d)];
            worst = std::max(worst, excess.maxCoeff());
        }
    }
    for (size_t d = 0; d < m_worst.size(); ++d) {
        if (draws.unbalanced[d] != 0) {  // without equilibrium no limit is kept
            m_worst[d] = std::numeric_limits<double>::infinity();
        }
    }
    std::ranges::sort(m_worst);
}

double LimitMargins::probability() const {
    const auto kept = std::ranges::upper_bound(m_worst, 0.0) - m_worst.begin();
    return static_cast<double>(kept) / static_cast<double>(m_worst.size());
}

double LimitMargins::shortfall(double confidence) const {
    return m_worst[static_cast<size_t>(draws_needed(confidence, std::ssize(m_worst))) - 1];
}

std::vector<ForceRange> LimitMargins::narrowed(double factor) const {
    std::vector<ForceRange> result = m_given;
    for (size_t i = 0; i < result.size(); ++i) {
        result[i].lower += factor * m_std[i] - m_bias[i];
        result[i].upper -= factor * m_std[i] + m_bias[i];
    }
    return result;
}

}  // namespace taut
