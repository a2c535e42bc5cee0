// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against nets that only our own examples resemble: files that other people published, as
// they are. They are no part of this repository; the tests are skipped where they are not there.
// A file of our own in the same units stands in for the first of them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/errors.hpp"
#include "support/real_data.hpp"
#include "support/steel_roof.hpp"
#include "taut/files/file.hpp"
#include "taut/interchange/compas_json.hpp"
#include "taut/interchange/net_import.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {
namespace {

using test::input_error_of;
using test::real_file;
using testing::Contains;
using testing::HasSubstr;

ImportedStructure real_net(const std::string& name) {
    return parse_compas(read_file(real_file(name)), name);
}

const ImportSettings hilo_settings{.young = 205e9,
                                   .diameter_attribute = "size",
                                   .force_unit = 1e3,
                                   .loads = ImportSettings::Loads::balance};

/// Equilibrium found from another form, so that it has to be found.
Points form_from_elsewhere(const CableNet& net) {
    Points start = net.nodes();
    for (const int node : net.free_nodes()) {
        start.col(node) += 0.01 * Eigen::Vector3d(std::sin(node), std::cos(3.0 * node), 0.5);
    }
    const Equilibrium equilibrium = EquilibriumSolver(net).solve(net.unstressed_lengths(), start);
    EXPECT_EQ(equilibrium.status, EquilibriumStatus::converged);
    return equilibrium.form;
}

double largest_move(const CableNet& net) {
    return (form_from_elsewhere(net) - net.nodes()).colwise().norm().maxCoeff();
}

TEST(SteelRoofsFile, GivesBackTheNetWithItsLoadsAndItsForm) {
    const CableNet expected = test::steel_lattice();
    const ImportedNet roof =
        import_net(parse_compas(test::steel_roof_compas().dump(), "roof.json"), hilo_settings);
    EXPECT_EQ(roof.net.free_node_count(), 300);
    EXPECT_EQ(roof.net.interior_edge_count(), 536);
    EXPECT_EQ(roof.net.adjustable_edges().size(), 128U);
    EXPECT_TRUE(roof.net.axial_stiffness().isApprox(expected.axial_stiffness(), 1e-12));
    EXPECT_TRUE(roof.net.unstressed_lengths().isApprox(expected.unstressed_lengths(), 1e-12));
    EXPECT_LT((roof.net.loads() - expected.loads())(Eigen::all, expected.free_nodes())
                  .cwiseAbs()
                  .maxCoeff(),
              1e-8);
    EXPECT_LT(roof.report.largest_out_of_balance, 1e-9 * roof.report.mean_tension);
    EXPECT_NEAR(roof.report.load_sum.z(), -300 * test::steel_node_weight, 1e-6);
    EXPECT_LT(roof.report.largest_horizontal_load, 1e-8);
    EXPECT_LT(largest_move(roof.net), 1e-9);
}

TEST(RealNets, HiloIsReadWholeAndInEquilibrium) {
    TAUT_NEEDS_REAL_FILE("hilo/cablenet.json");
    const ImportedNet hilo = import_net(real_net("hilo/cablenet.json"), hilo_settings);
    EXPECT_EQ(hilo.net.free_node_count(), 800);
    EXPECT_EQ(hilo.net.interior_edge_count(), 1511);
    EXPECT_EQ(hilo.net.adjustable_edges().size(), 186U);
    EXPECT_EQ(hilo.report.isolated_nodes, 12);
    EXPECT_EQ(hilo.report.inactive_edges, 198);
    // 205 GPa on 10, 8 and 6 mm.
    EXPECT_NEAR(hilo.net.axial_stiffness().maxCoeff(), 16.1007e6, 1e2);
    EXPECT_NEAR(hilo.net.axial_stiffness().minCoeff(), 5.79624e6, 1e2);
    EXPECT_LT(hilo.report.largest_out_of_balance, 1e-9 * hilo.report.mean_tension);
    // Concrete: 114.7 kN down, and horizontally no more than the residual its designers left.
    EXPECT_NEAR(hilo.report.load_sum.z(), -114.738e3, 1.0);
    EXPECT_LT(hilo.report.largest_horizontal_load, 0.5552 * std::sqrt(2.0));
    EXPECT_LT(largest_move(hilo.net), 1e-9);
}

TEST(RealNets, TexasGivesBackItsOwnForm) {
    TAUT_NEEDS_REAL_FILE("texas/texas.fofin");
    const ImportedNet texas = import_net(real_net("texas/texas.fofin"), {});
    EXPECT_EQ(texas.net.free_node_count(), 144);
    EXPECT_EQ(texas.net.edge_count(), 314);
    EXPECT_LT(largest_move(texas.net), 1e-9);
    EXPECT_THAT(texas.report.read, Contains("COMPAS mesh at the key 'cablenet'"));
    EXPECT_THAT(texas.report.read,
                Contains("axial stiffness: the file's E and r, taken in GPa and in m"));
    EXPECT_THAT(texas.report.assumed, Contains(HasSubstr("forces of the file are in kN")));
}

TEST(RealNets, NetsOfJaxFdmAreReadWithTheirBoundaryAsSupports) {
    TAUT_NEEDS_REAL_FILE("formats/jax_fdm_network_creased_shell.json");
    ImportedStructure shell = real_net("formats/jax_fdm_network_creased_shell.json");
    EXPECT_EQ(shell.format, "JAX FDM network");
    EXPECT_THAT(input_error_of([&] { return import_net(shell, {.axial_stiffness = 1e5}); }),
                HasSubstr("marks no supports"));
    support_boundary(shell);
    const CableNet net = import_net(shell, {.axial_stiffness = 1e5}).net;
    EXPECT_EQ(net.free_node_count(), 156);
    EXPECT_EQ(net.edge_count(), 324);

    ImportedStructure saddle = real_net("formats/jax_fdm_mesh_monkey_saddle.json");
    support_boundary(saddle);
    EXPECT_EQ(import_net(saddle, {.axial_stiffness = 1e5}).net.free_node_count(), 1);
}

}  // namespace
}  // namespace taut
