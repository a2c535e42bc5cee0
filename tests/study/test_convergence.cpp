// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against searches that give up on hard surveys: stiff nets with slack edges, hidden nodes
// and gross errors at once. benchmarks/convergence.py counts the same over a thousand surveys.

#include <gtest/gtest.h>

#include "identification/simulated_survey.hpp"
#include "support/identify_lengths.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"

namespace {

using namespace taut;

/// A tenth of the free nodes hidden, a twentieth of the targets 8 mm off.
test::SimulatedSurvey hard_survey(const CableNet& net, const LengthPrior& prior,
                                  std::uint64_t seed) {
    test::SimulatedSurvey s = test::simulate(net, prior, 0.3e-3, seed);
    for (size_t i = seed % 10; i < net.free_nodes().size(); i += 10) {
        test::hide(net, s.survey, net.free_nodes()[i]);
    }
    for (size_t i = seed % 20; i < s.survey.surveyed.size(); i += 20) {
        s.survey.form(2, s.survey.surveyed[i]) += 8e-3;
    }
    return s;
}

TEST(MaximumAPosteriori, ConvergesOnHardSurveys) {
    constexpr LengthPrior prior{LengthPrior::Kind::uniform, 0.005};
    const CableNet middle = hypar(7, 7);
    for (const CableNet& net :
         {hilo_quarter(), test::stiffened(middle, 10.0), test::stiffened(middle, 50.0)}) {
        int converged = 0;
        int inside = 0;
        int lengths = 0;
        for (const std::uint64_t seed : {1, 2}) {
            const test::SimulatedSurvey s = hard_survey(net, prior, seed);
            ASSERT_TRUE(s.truth.balanced());
            const Identification found =
                test::identify_lengths(net, s.survey,
                                       {.method = IdentificationMethod::map,
                                        .prior = prior,
                                        .prior_exact = true,
                                        .draws = 0});
            converged += found.status == IdentificationStatus::converged ? 1 : 0;
            for (size_t i = 0; i < found.edges.size(); ++i) {
                const double truth = s.deviations(static_cast<Eigen::Index>(i));
                const IdentifiedEdge& edge = found.edges[i];
                inside += edge.lower <= truth && truth <= edge.upper ? 1 : 0;
                ++lengths;
            }
        }
        EXPECT_EQ(converged, 2) << net.name();
        EXPECT_GE(inside, 0.8 * lengths) << net.name();  // without samples: linearised intervals
    }
}

}  // namespace
