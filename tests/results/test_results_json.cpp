// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a result without the prior that it was computed with, or without the frame that
// the survey was moved into.

#include "taut/results/results_json.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <nlohmann/json.hpp>

#include "support/identify_lengths.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/results/result_file.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {
namespace {

using nlohmann::json;

/// A survey of the net as designed.
Survey whole_survey(const CableNet& net, double noise) {
    const Points form = EquilibriumSolver(net).solve(net.unstressed_lengths(), net.nodes()).form;
    return {.form = form,
            .noise_std = Points::Constant(3, net.node_count(), noise),
            .surveyed = net.free_nodes()};
}

json written(const CableNet& net, const Survey& survey, const Identification& identification) {
    const std::string text = identification_to_json(net, survey, identification);
    EXPECT_NO_THROW(static_cast<void>(parse_result(text, "result.json")));
    return json::parse(text);
}

TEST(IdentificationJson, HasThePriorOfEachMethod) {
    const CableNet net = hypar(3, 4);
    const LengthPrior prior = parse_length_prior("normal:2mm");
    for (const double noise : {0.0, 1e-4}) {
        const Survey survey = whole_survey(net, noise);
        for (const auto method : {IdentificationMethod::balance, IdentificationMethod::map}) {
            const Identification result = test::identify_lengths(
                net, survey, {.method = method, .prior = prior, .prior_exact = true});
            EXPECT_EQ(written(net, survey, result)["length_prior"], "normal:2mm")
                << result.method << noise;
        }
    }
}

TEST(IdentificationJson, HasTheCovarianceOfEachPlaceThatTheMethodGives) {
    const CableNet net = hypar(3, 4);
    Survey survey = whole_survey(net, 1e-4);
    const LengthPrior prior = parse_length_prior("normal:2mm");
    const Identification result =
        test::identify_lengths(net, survey, {.method = IdentificationMethod::map, .prior = prior});
    const json saved = written(net, survey, result)["form_covariance"];
    ASSERT_EQ(saved.size(), static_cast<size_t>(net.node_count()));
    for (int node = 0; node < net.node_count(); ++node) {
        const Eigen::Matrix3d& C = result.form_covariance[node];
        const double largest = C.cwiseAbs().maxCoeff();
        // 0 of known supports, of a mixture of priors, too.
        EXPECT_EQ(largest > 0.0, net.free_index(node) >= 0);
        const std::array numbers{C(0, 0), C(0, 1), C(0, 2), C(1, 1), C(1, 2), C(2, 2)};
        for (size_t k = 0; k < numbers.size(); ++k) {
            EXPECT_NEAR(saved[node][k].get<double>(), numbers[k], 1e-5 * largest);
        }
    }
    survey.noise_std.setZero();
    const Identification exact = test::identify_lengths(
        net, survey, {.method = IdentificationMethod::balance, .prior = prior});
    EXPECT_TRUE(written(net, survey, exact)["form_covariance"].is_null());
}

TEST(IdentificationJson, HasTheFrameThatTheSurveyWasMovedInto) {
    const CableNet net = hypar(3, 4);
    Survey survey = whole_survey(net, 1e-4);
    const Identification result =
        test::identify_lengths(net, survey, {.prior = parse_length_prior("uniform:5mm")});
    EXPECT_TRUE(written(net, survey, result)["frame"].is_null());
    EXPECT_TRUE(written(net, survey, result)["survey"]["control"].empty());

    Registration frame;
    frame.motion.rotation =
        Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    frame.motion.from = {1e6, 2e6, 400.0};
    frame.motion.to = {1.0, 2.0, 3.0};
    frame.residuals = {{.id = "P1", .residual = {3e-3, 0.0, 4e-3}},
                       {.id = "P2", .residual = {0.0, 0.0, 1e-3}}};
    survey.frame = frame;
    const json document = written(net, survey, result);
    const json& saved = document["frame"];
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(saved["from"][i], frame.motion.from(i));
        EXPECT_EQ(saved["to"][i], frame.motion.to(i));
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(saved["rotation"][i][k], frame.motion.rotation(i, k));
        }
    }
    EXPECT_EQ(saved["fit"]["count"], 2);
    EXPECT_NEAR(saved["fit"]["rms"].get<double>(), std::sqrt(26e-6 / 2.0), 1e-12);
    EXPECT_EQ(saved["control"][0], (json{{"id", "P1"}, {"dx", 3e-3}, {"dy", 0.0}, {"dz", 4e-3}}));
    EXPECT_EQ(saved["control"], document["survey"]["control"]);
}

}  // namespace
}  // namespace taut
