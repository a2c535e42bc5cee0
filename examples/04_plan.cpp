// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// From one survey of a built net to turns: identify, plan, order.
#include <iostream>

#include "taut/adjustment/plan.hpp"
#include "taut/adjustment/turn_order.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/sampling/built_net.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/survey/simulation.hpp"

int main() {
    const taut::CableNet net = taut::hilo_quarter();
    const taut::LengthPrior prior{.kind = taut::LengthPrior::Kind::uniform, .scale = 0.005};  // m

    // The net on site, with unknown lengths, and a survey of it.
    const taut::CableNet site = taut::built_net(net, prior, 1);
    const taut::Survey survey = taut::match_to_nodes(
        net, taut::simulate_survey(net, taut::solve_equilibrium(site).form,
                                   {.noise_std = 0.5e-3, .dropped_part = 0.1}));

    const taut::Identification found = taut::identify(net, survey, {.prior = prior});
    if (found.trust.verdict() != taut::Trust::Verdict::passed) {
        std::cerr << found.trust.findings.front().reason << '\n';
        return 1;
    }

    // Back to the design, by quarter turns of 5 mm; between 1.5 and 12 kN in every cable.
    const taut::BuiltNet built = taut::built_net_of(net, found);
    taut::Limits limits = taut::stroke_limits(net, net.adjustable_edges(), 0.015);
    limits.tension.lower.setConstant(1.5e3);
    limits.tension.upper.setConstant(12e3);
    const taut::TurnSize turn{.pitch = 0.005, .smallest = 0.25};
    const taut::Plan plan =
        taut::plan_strokes(built, taut::FormTarget(net, net.nodes()), limits,
                           {.edges = {}, .turn = turn, .tolerance = {}, .survey_noise = {}});
    const taut::TurnOrder order =
        taut::order_turns(built, limits, plan, {.crews = 2, .turn_step = turn.step()});

    const taut::Turning& first = order.turnings.front();
    std::cout << "normal deviation " << 1e3 * plan.as_built.normal_mean << " -> "
              << 1e3 * plan.planned.normal_mean << " mm in the mean, all limits kept with "
              << 100.0 * plan.limit_probability.value_or(0.0) << " %\n"
              << order.turnings.size() << " turnings, first edge " << net.edge_id(first.edge)
              << " by " << first.stroke / turn.pitch << " turns; on the way "
              << (order.is_safe ? "no limit is broken" : "a limit is broken") << '\n';
    return plan.is_feasible && order.is_safe ? 0 : 1;
}
