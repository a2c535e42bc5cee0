// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// What can go wrong, and how each is told: wrong values throw, with field and rule; wrong files
// with their place; numbers that did not come out are a status; and what the survey contradicts is
// in `trust`.
#include <iostream>
#include <utility>

#include "taut/design/builtin_nets.hpp"
#include "taut/files/input_error.hpp"
#include "taut/identification/identify.hpp"
#include "taut/io/net_json.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/statics/equilibrium.hpp"

int main() {
    int told = 0;
    const taut::CableNet net = taut::hypar(5, 5);
    try {
        taut::CableNetData data = net.data();
        data.unstressed_lengths(3) = -1.0;
        const taut::CableNet broken(std::move(data));
    } catch (const taut::NetError& error) {
        std::cout << "net: " << error.what() << " (field " << error.field() << ")\n";
        ++told;
    }
    try {
        static_cast<void>(taut::parse_net(R"({"format": "taut-net", "version": 1})", "net.json"));
    } catch (const taut::InputError& error) {
        std::cout << "file: " << error.what() << '\n';
        ++told;
    }

    // Noise of 0.01 mm is told, but the places are off by 2 mm.
    taut::Survey survey;
    survey.form =
        taut::solve_equilibrium(net).form + 2e-3 * taut::Points::Random(3, net.node_count());
    survey.noise_std = taut::Points::Constant(3, net.node_count(), 1e-5);
    survey.surveyed = net.free_nodes();
    const taut::Identification found = taut::identify(net, survey);
    std::cout << "survey: " << to_string(found.status) << ", trust "
              << to_string(found.trust.verdict()) << '\n';
    for (const taut::Trust::Finding& finding : found.trust.findings) {
        std::cout << "  " << finding.reason << '\n';
    }
    told += found.trust.verdict() == taut::Trust::Verdict::failed ? 1 : 0;
    return told == 3 ? 0 : 1;
}
