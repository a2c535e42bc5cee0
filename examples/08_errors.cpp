// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// Errors and how they are reported. Wrong values throw, with field and rule. Wrong files throw,
// with the place. Numerical failures are a status. Contradictions of the survey are in `trust`.
#include <iostream>
#include <utility>

#include "taut/design/builtin_nets.hpp"
#include "taut/files/input_error.hpp"
#include "taut/identification/identify.hpp"
#include "taut/io/net_json.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/statics/equilibrium.hpp"

int main() {
    int reported = 0;
    const taut::CableNet net = taut::hypar(5, 5);
    try {
        taut::CableNetData data = net.data();
        data.unstressed_lengths(3) = -1.0;
        const taut::CableNet broken(std::move(data));
    } catch (const taut::NetError& error) {
        std::cout << "net: " << error.what() << " (field " << error.field() << ")\n";
        ++reported;
    }
    try {
        static_cast<void>(taut::parse_net(R"({"format": "taut-net", "version": 1})", "net.json"));
    } catch (const taut::InputError& error) {
        std::cout << "file: " << error.what() << '\n';
        ++reported;
    }

    // A noise of 0.01 mm is given, but the points are off by 2 mm.
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
    reported += found.trust.verdict() == taut::Trust::Verdict::failed ? 1 : 0;
    return reported == 3 ? 0 : 1;
}
