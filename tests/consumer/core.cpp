// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// From a net to its lengths with taut::core alone.
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/statics/equilibrium.hpp"

#include <iostream>
#include <stdexcept>

int main() {
    const taut::CableNet net = taut::hypar(4, 4);
    taut::Survey survey;
    survey.form = taut::solve_equilibrium(net).form;
    survey.noise_std = taut::Points::Constant(3, net.node_count(), 1e-4);
    survey.surveyed = net.free_nodes();
    taut::IdentifyOptions options;
    options.draws = 20;
    const taut::Identification found = taut::identify(net, survey, options);
    std::cout << to_string(found.status) << ", trust: " << to_string(found.trust.verdict()) << '\n';
    try {  // exception classes match on both sides
        survey.surveyed.clear();
        static_cast<void>(taut::identify(net, survey, options));
    } catch (const taut::SurveyError& error) {
        std::cout << error.what() << '\n';
        return found.status == taut::IdentificationStatus::converged ? 0 : 1;
    }
    return 1;
}
