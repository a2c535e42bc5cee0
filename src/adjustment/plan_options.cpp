// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/plan_options.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "taut/adjustment/request_error.hpp"
#include "taut/net/units.hpp"
#include "taut/survey/turned_net.hpp"

namespace taut {
namespace {

void check_turned_edges(const CableNet& net, const std::vector<int>& edges) {
    if (edges.empty()) {
        throw std::invalid_argument("no edge may be turned, expected at least one adjustable edge");
    }
    for (size_t k = 0; k < edges.size(); ++k) {
        if (edges[k] < 0 || edges[k] >= net.edge_count() || (k > 0 && edges[k] <= edges[k - 1])) {
            throw std::invalid_argument(
                fmt::format("the edges to turn contain edge {}, expected each of the {} edges at "
                            "most once, in ascending order",
                            edges[k], net.edge_count()));
        }
    }
}

void check_turn(const TurnSize& turn) {
    // Pitches of turnbuckles and jacks; a value outside is in another unit [m].
    constexpr double finest_pitch = 1e-5;
    constexpr double coarsest_pitch = 0.2;
    if (!(turn.pitch >= finest_pitch && turn.pitch <= coarsest_pitch)) {
        throw std::invalid_argument(fmt::format("a turn is {:g} m, expected {:g} to {:g} m",
                                                turn.pitch, finest_pitch, coarsest_pitch));
    }
    constexpr double smallest_part = 1e-3;
    if (turn.smallest != 0.0 && !(turn.smallest >= smallest_part && turn.smallest <= 1.0)) {
        throw RequestError("step", fmt::format("is {:g} of a turn, expected {:g} to 1",
                                               turn.smallest, smallest_part));
    }
}

void check_samples(const BuiltNet& built, double confidence) {
    constexpr double rounding = 1e-9;
    const CableNet& net = built.net;
    if (!(confidence > 0.0 && confidence < 1.0)) {
        throw std::invalid_argument(fmt::format(
            "the confidence is {:g}, expected more than 0 and less than 1", confidence));
    }
    const auto draws = static_cast<double>(built.length_draws.cols());
    if (draws > 0.0 && draws * (1.0 - confidence) < 1.0 - rounding) {
        throw std::invalid_argument(
            fmt::format("the confidence is {:g}, but {} posterior samples show at most {:.4g}: "
                        "draw more samples, or lower the confidence",
                        confidence, draws, 1.0 - 1.0 / draws));
    }
    if (built.length_draws.cols() > 0 &&
        (built.length_draws.rows() != net.edge_count() || !built.length_draws.allFinite() ||
         !(built.length_draws.minCoeff() > 0.0))) {
        throw std::invalid_argument(fmt::format(
            "the posterior samples of lengths are not {} positive numbers each, one per edge",
            net.edge_count()));
    }
}

}  // namespace

void check_plan_options(const BuiltNet& built, const PlanOptions& options,
                        const std::vector<int>& edges) {
    const CableNet& net = built.net;
    check_turned_edges(net, edges);
    check_samples(built, options.confidence);
    const double most_std = most_turned_part * net.unstressed_lengths()(edges).minCoeff();
    if (!(options.actuator_std >= 0.0 && options.actuator_std <= most_std)) {
        throw std::invalid_argument(
            fmt::format("the actuator std is {:g} m, expected 0 to {:.3g} m, a quarter of the "
                        "shortest edge to turn",
                        options.actuator_std, most_std));
    }
    if (options.tolerance && !(*options.tolerance > 0.0 && std::isfinite(*options.tolerance))) {
        throw std::invalid_argument(
            fmt::format("the tolerance is {:g} m, expected more than 0", *options.tolerance));
    }
    if (options.form_tolerance &&
        !(*options.form_tolerance > 0.0 && std::isfinite(*options.form_tolerance))) {
        throw RequestError("form_tolerance", fmt::format("is {}, expected more than 0",
                                                         format_length(*options.form_tolerance)));
    }
    if (options.survey_noise &&
        !(*options.survey_noise > 0.0 && std::isfinite(*options.survey_noise))) {
        throw std::invalid_argument(
            fmt::format("the standard deviation of suggested targets is {:g} m, expected above 0",
                        *options.survey_noise));
    }
    if (options.turn) {
        check_turn(*options.turn);
    }
}

}  // namespace taut
