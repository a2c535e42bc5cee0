// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against an error that energy, forces, stiffness and solver share: the forms were found by
// SciPy from formulas written down apart from these (tests/data/make_statics_reference.py).
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "taut/statics/energy.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using Json = nlohmann::json;

Points points(const Json& json) {
    Points result(3, static_cast<Eigen::Index>(json.size()));
    for (size_t i = 0; i < json.size(); ++i) {
        for (size_t k = 0; k < 3; ++k) {
            result(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) =
                json.at(i).at(k).get<double>();
        }
    }
    return result;
}

Eigen::VectorXd vector(const Json& json) {
    const auto values = json.get<std::vector<double>>();
    return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
}

Json reference_net(const std::string& name) {
    std::ifstream file(TAUT_TEST_DATA_DIR "/statics_reference.json");
    const Json reference = Json::parse(file);
    for (const Json& net : reference.at("nets")) {
        if (net.at("name") == name) {
            return net;
        }
    }
    throw std::runtime_error("statics_reference.json has no net " + name);
}

class ReferenceNet : public ::testing::TestWithParam<const char*> {};

TEST_P(ReferenceNet, TakesTheFormThatScipyFinds) {
    const Json json = reference_net(GetParam());
    CableNetData data;
    data.nodes = points(json.at("nodes"));
    data.supports = json.at("supports").get<std::vector<int>>();
    data.edges = json.at("edges").get<std::vector<Edge>>();
    data.axial_stiffness = vector(json.at("axial_stiffness"));
    data.unstressed_lengths = vector(json.at("unstressed_lengths"));
    data.loads = points(json.at("loads"));
    const CableNet net(std::move(data));

    const Equilibrium e = solve_equilibrium(net);
    EXPECT_EQ(e.status, EquilibriumStatus::converged);
    EXPECT_LT((e.form - points(json.at("form"))).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_EQ(e.slack_edges, json.at("slack_edges").get<std::vector<int>>());
    const Eigen::VectorXd expected = vector(json.at("tensions"));
    const Eigen::VectorXd tension = tensions(net, net.unstressed_lengths(), e.form);
    EXPECT_LT((tension - expected).cwiseAbs().maxCoeff(), 1e-10 * expected.maxCoeff());
    const double lowest = json.at("energy").get<double>();
    EXPECT_NEAR(energy(net, net.unstressed_lengths(), e.form), lowest, 1e-12 * std::abs(lowest));
}

INSTANTIATE_TEST_SUITE_P(Scipy, ReferenceNet, ::testing::Values("grid", "chain", "tripod"),
                         [](const auto& param) { return std::string(param.param); });

}  // namespace
}  // namespace taut
