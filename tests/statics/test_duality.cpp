// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a certificate that proves nothing: a bound above the lowest energy, a gap that is
// not the difference of the two energies, or one that misses a wrong form.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "support/not_finite.hpp"
#include "support/random_nets.hpp"
#include "support/small_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/duality.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {
namespace {

TEST(Certificate, OfOneEdgeIsThatComputedByHand) {
    // With c = EA/l_0 = 100 kN/m: at 1 m + x the edge's force after correction is the weight, so
    // V - D = c (x - 10 mm)^2 / 2.
    const CableNet net(test::hanging_node_data());
    for (const double x : {0.0, 0.004, 0.01, 0.05}) {
        Points form = net.nodes();
        form(2, 0) = -1.0 - x;
        const EnergyCertificate c = energy_certificate(net, net.unstressed_lengths(), form);
        EXPECT_NEAR(c.duality_gap, 0.5 * 100e3 * std::pow(x - 0.01, 2), 1e-9) << x;
        // D = -(T l_0 + T^2/(2c)) with the support at the origin.
        EXPECT_NEAR(c.complementary_energy, -(1000.0 + 5.0), 1e-9) << x;
    }
}

TEST(Certificate, OfAWhollySlackNetWithoutLoadsIsZero) {
    const CableNet net(test::cross_data(-0.05));
    const EnergyCertificate c = energy_certificate(net, net.unstressed_lengths(), net.nodes());
    EXPECT_EQ(c.energy, 0.0);
    EXPECT_EQ(c.duality_gap, 0.0);
    EXPECT_EQ(c.relative_gap, 0.0);
}

TEST(Certificate, ProvesTheBuiltInNetsForms) {
    for (const auto* name : {"hilo-quarter", "hypar:8x10"}) {
        const CableNet net = builtin_net(name);
        const Equilibrium e = solve_equilibrium(net);
        EXPECT_LT(energy_certificate(net, net.unstressed_lengths(), e.form).relative_gap, 1e-15)
            << name;
    }
}

TEST(Certificate, RefusesForcesThatDoNotFit) {
    const CableNet net(test::cross_data(0.02));
    const auto refused = [&](const Points& forces) {
        EXPECT_THROW(static_cast<void>(
                         energy_certificate(net, net.unstressed_lengths(), net.nodes(), forces)),
                     std::invalid_argument);
    };
    refused(Points::Zero(3, 3));
    Points forces = Points::Zero(3, 4);
    forces(1, 2) = test::nan;
    refused(forces);
}

/// Rounding errors of the energies of a form that lies within some metres, and of the forces [J].
double rounding_of_energies(const CableNet& net, const EnergyCertificate& c) {
    return 1e-12 * (std::abs(c.energy) + c.duality_gap + net.loads().cwiseAbs().sum());
}

RC_GTEST_PROP(CertificateOfARandomNet, BoundsTheLowestEnergyFromAnyFormAndForces, ()) {
    test::Random random = test::any_random();
    const CableNet net = test::random_net(random);
    const Eigen::VectorXd& lengths = net.unstressed_lengths();
    const Equilibrium e = solve_equilibrium(net);
    // The lowest energy lies between the two energies of this certificate.
    const EnergyCertificate lowest = energy_certificate(net, lengths, e.form);
    const Points form = with_free_coordinates(
        net, free_coordinates(net, e.form) +
                 test::uniform_vector(random, 3 * net.free_node_count(), 0.3));
    const Points forces = test::uniform_points(random, net.edge_count(), 3000.0);
    for (const EnergyCertificate& c :
         {energy_certificate(net, lengths, form), energy_certificate(net, lengths, form, forces),
          energy_certificate(net, lengths, e.form, forces)}) {
        const double rounding = rounding_of_energies(net, c);
        RC_ASSERT(c.duality_gap >= 0.0);
        RC_ASSERT(c.complementary_energy <= lowest.energy + rounding);
        RC_ASSERT(c.energy >= lowest.complementary_energy - rounding);
    }
}

}  // namespace
}  // namespace taut
