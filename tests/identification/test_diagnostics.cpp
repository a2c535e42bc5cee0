// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against answers that are wrong and sure: a wrong prior, noise or frame without a finding,
// false alarms for sound cables and targets.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "identification/diagnostics.hpp"
#include "support/identify_lengths.hpp"

namespace of_diagnostics {

TEST(Diagnostics, PassesWhatIsTrue) {
    for (const std::uint64_t seed : {1, 2}) {
        const SimulatedSurvey s = survey_of(net(), prior, seed);
        const Identification result = identified(s.survey, prior);
        EXPECT_EQ(result.trust.verdict(), Verdict::passed) << result.trust.findings[0].reason;
        EXPECT_TRUE(result.length_outliers.empty());
        EXPECT_NEAR(result.scales.noise.ratio, 1.0, 4.0 * result.scales.noise.std_dev);
        EXPECT_NEAR(result.scales.lengths.ratio, 1.0, 4.0 * result.scales.lengths.std_dev);
        EXPECT_GT(coverage(result, s.deviations), 0.9);
    }
}

// Scaled together, noise and lengths are traded for one another: (held-noise).
TEST(Diagnostics, AccuseNoTrueNoise) {
    const CableNet saddle = hypar(9, 9);
    const SimulatedSurvey s = survey_of(saddle, {LengthPrior::Kind::uniform, 0.5e-3}, 48);
    const Identification result = identified_on_site(saddle, s.survey, std::nullopt);
    EXPECT_LT(result.scales.noise.ratio, 0.8);
    EXPECT_FALSE(finds(result, Kind::survey_noise));
    Survey too_large = s.survey;
    too_large.noise_std *= 3.0;
    EXPECT_TRUE(finds(identified_on_site(saddle, too_large, std::nullopt), Kind::survey_noise));
}

TEST(Diagnostics, IsDueWhereTargetsNextToEachOtherAreLeftOut) {
    // A gross error each on four nodes in a row: something there moved, rather than four targets.
    SimulatedSurvey s = survey_of(net(), prior, 4);
    std::vector<int> row{net().free_nodes()[100]};
    while (row.size() < 4) {
        for (const auto& [a, b] : net().edges()) {
            const int other = a == row.back() ? b : b == row.back() ? a : -1;
            if (other >= 0 && net().free_index(other) >= 0 &&
                std::ranges::find(row, other) == row.end()) {
                row.push_back(other);
                break;
            }
        }
    }
    for (size_t i = 0; i < row.size(); ++i) {
        s.survey.form.col(row[i]) += Eigen::Vector3d(0.03, 0.04, i % 2 == 0 ? 0.05 : -0.05);
    }
    const Identification result = identified(s.survey, prior);
    EXPECT_EQ(result.outliers.size(), 4u);
    EXPECT_TRUE(finds(result, Kind::adjacent_targets));
    EXPECT_NE(result.trust.verdict(), Verdict::passed);
}

TEST(Diagnostics, OfAPriorThatIsTooNarrowOrOfAnotherShapeNamesIt) {
    const LengthPrior normal{LengthPrior::Kind::normal, 0.0029};
    const LengthPrior wide{LengthPrior::Kind::uniform, 0.007};
    for (const LengthPrior& truth : {normal, wide}) {
        const SimulatedSurvey s = survey_of(net(), truth, 7);
        const Identification found = identified(s.survey, prior);
        EXPECT_NE(found.trust.verdict(), Verdict::passed) << to_string(truth);
        EXPECT_TRUE(says(found, "uniform:5mm"));
        ASSERT_TRUE(found.contradicted_prior.has_value());
        EXPECT_EQ(found.contradicted_prior->checked, prior);
        EXPECT_EQ(found.length_prior.kind, truth.kind);
        EXPECT_NEAR(found.length_prior.scale, truth.scale, 0.15 * truth.scale);
        EXPECT_GT(coverage(found, s.deviations), 0.92);
    }
}

TEST(Diagnostics, OfABimodalPriorThatWasNotGivenNamesItAndAssumesNone) {
    const LengthPrior bimodal{LengthPrior::Kind::bimodal, 0.004};
    const SimulatedSurvey s = survey_of(net(), bimodal, 8);
    const Identification without = identified(s.survey, prior);
    EXPECT_NE(without.trust.verdict(), Verdict::passed);
    EXPECT_TRUE(says(without, "bimodal"));
    for (const Trust::Finding& finding : without.trust.findings) {
        EXPECT_FALSE(finding.remedy && finding.remedy->value.starts_with("bimodal"));
    }
    for (const PriorNode& node : without.prior.nodes) {
        EXPECT_NE(node.prior.kind, LengthPrior::Kind::bimodal);
    }
    EXPECT_GT(coverage(without, s.deviations), 0.9);
    const Identification given = identified(s.survey, bimodal);
    EXPECT_EQ(given.trust.verdict(), Verdict::passed) << given.trust.findings[0].reason;
    EXPECT_EQ(given.length_prior.kind, LengthPrior::Kind::bimodal);
}

TEST(Diagnostics, OfAPriorThatIsTooWideIsNone) {
    const SimulatedSurvey s = survey_of(net(), {LengthPrior::Kind::uniform, 0.002}, 7);
    const Identification found = identified(s.survey, prior);
    EXPECT_FALSE(found.contradicted_prior.has_value());
    EXPECT_EQ(found.trust.verdict(), Verdict::passed);
    EXPECT_GT(coverage(found, s.deviations), 0.93);
    const Identification exact = test::identify_lengths(
        net(), s.survey,
        {.method = IdentificationMethod::map, .prior = prior, .prior_exact = true});
    EXPECT_TRUE(exact.prior.exact);
    EXPECT_EQ(exact.length_prior, prior);
    EXPECT_NE(exact.trust.verdict(), Verdict::passed);
}

TEST(Diagnostics, OfNamesOnOtherNodesNamesThem) {
    SimulatedSurvey s = survey_of(net(), prior, 7);
    s.survey.contradicted_names = 1;
    const int node = net().free_nodes().front();
    s.survey.placed = {{.name = "elsewhere", .node = node}};
    const Identification result = identified(s.survey, prior);
    EXPECT_EQ(result.trust.verdict(), Verdict::doubtful);
    EXPECT_TRUE(says(result, "elsewhere on node " + net().node_id(node)));
}

TEST(Diagnostics, OfATargetFarOffSaysWhatElseItMayBe) {
    SimulatedSurvey s = survey_of(net(), prior, 20);
    const int node = s.survey.surveyed[100];
    s.survey.form(2, node) += 0.02;
    const Identification result = identified(s.survey, prior);
    ASSERT_EQ(result.outliers.size(), 1U);
    EXPECT_THAT(result.trust.findings,
                testing::Contains(testing::Field(
                    &Trust::Finding::advice,
                    testing::HasSubstr("A cable, turnbuckle, support or load at it"))));
}

// The mode of all unknowns together is not that of what many edges share, (marginal-mode): of the
// smaller net their mean would seem 1.4 mm. Loads are among what they share.
TEST(Diagnostics, OfManyEdgesKeepWhatTheyShare) {
    const LengthPrior narrow{LengthPrior::Kind::uniform, 1e-3};
    const auto found = [&](const CableNet& saddle, std::uint64_t seed) {
        SCOPED_TRACE(saddle.node_count());
        const SimulatedSurvey s = survey_of(saddle, narrow, seed);
        const Identification result = identified_on_site(saddle, s.survey, narrow);
        EXPECT_FALSE(finds(result, Kind::uncertain_parameter));
        EXPECT_FALSE(finds(result, Kind::common_deviation)) << result.prior_check.mean;
        EXPECT_GT(coverage(result, s.deviations), 0.93);
        EXPECT_LT(std::abs((estimates(result) - s.deviations).mean()), 0.15e-3);
        return result;
    };
    found(hypar(30, 30), 2);
    EXPECT_GT(found(hypar(28, 28), 1).prior_check.mean_std, 0.0);
    CableNetData hung = hypar(30, 30).data();
    hung.loads = Points::Zero(3, hung.nodes.cols());
    hung.loads.row(2).setConstant(-50.0);
    const LoadCheck of_loads = found(CableNet(hung), 1).load_check;
    EXPECT_GT(of_loads.std_dev, 0.0);
    EXPECT_LT(std::abs(of_loads.force), 2.0 * of_loads.std_dev);
}

// Some 100 steps to the fit where many edges may be slack.
TEST(Diagnostics, AreOfAFitWhereManyEdgesMayBeSlack) {
    const LengthPrior wide{LengthPrior::Kind::uniform, 15e-3};
    const CableNet saddle = hypar(9, 9);
    SimulatedSurvey s = survey_of(saddle, wide, 52);
    for (size_t i = 2; i < saddle.free_nodes().size(); i += 5) {
        hide(saddle, s.survey, saddle.free_nodes()[i]);
    }
    const Identification result = identified_on_site(saddle, s.survey, wide);
    EXPECT_EQ(result.status, IdentificationStatus::converged);
    EXPECT_GT(coverage(result, s.deviations), 0.9);
}

// Steps that damping of the lengths alone does not shorten.
TEST(Diagnostics, ReportTensionsWhereEdgesMayBeSlack) {
    const LengthPrior wide{LengthPrior::Kind::uniform, 7e-3};
    for (const std::uint64_t seed : {4, 11, 14}) {
        SimulatedSurvey s = survey_of(net(), wide, seed);
        for (size_t i = seed; i < net().free_nodes().size(); i += 10) {
            hide(net(), s.survey, net().free_nodes()[i]);
        }
        const Identification result = identified_on_site(net(), s.survey, std::nullopt, 12);
        EXPECT_EQ(result.draws->reason, "") << seed;
    }
}

TEST(Diagnostics, OfTheScaleOrTheFrameNamesIt) {
    const SimulatedSurvey s = survey_of(net(), prior, 21);
    const Identification right = identified(s.survey, prior);
    EXPECT_FALSE(right.frame_check.is_scaled());
    EXPECT_FALSE(right.frame_check.is_moved());
    Survey larger = s.survey;
    larger.form *= 1.001;
    larger.frame_is_unknown = true;
    const Identification scaled = identified(larger, prior);
    EXPECT_EQ(scaled.trust.verdict(), Verdict::failed);
    EXPECT_TRUE(finds(scaled, Kind::survey_scale));
    EXPECT_NEAR(scaled.frame_check.scale, 0.001, 2e-4);
    Survey moved = s.survey;
    moved.form.row(1).array() += 0.003;
    const Identification shifted = identified(moved, prior);
    EXPECT_EQ(shifted.trust.verdict(), Verdict::failed);
    EXPECT_TRUE(finds(shifted, Kind::survey_frame));
    EXPECT_FALSE(shifted.frame_check.is_scaled());
    // Whatever the method.
    const Identification by_balance = identified(moved, prior, IdentificationMethod::balance);
    EXPECT_EQ(by_balance.trust.verdict(), Verdict::failed);
    EXPECT_TRUE(by_balance.frame_check.is_moved());
}

TEST(Diagnostics, FindsThePriorWhereNoneIsGiven) {
    const LengthPrior truth{LengthPrior::Kind::normal, 0.004};
    const SimulatedSurvey s = survey_of(net(), truth, 8);
    const Identification found = identified(s.survey, std::nullopt);
    EXPECT_FALSE(found.contradicted_prior.has_value());
    EXPECT_EQ(found.length_prior.kind, truth.kind);
    EXPECT_NEAR(found.prior.std_dev, truth.std_dev(), 4.0 * found.prior.std_std);
    EXPECT_LT(found.prior.uniform_probability, 0.01);
    EXPECT_GT(coverage(found, s.deviations), 0.92);
    const Identification same = identified(survey_of(net(), prior, 8).survey, std::nullopt);
    EXPECT_EQ(same.length_prior, LengthPrior());
}

/// Of few lengths, each survey shows another scale and shape; all are in the intervals.
TEST(Diagnostics, OfFewLengthsTheirPriorIsInTheirIntervals) {
    const CableNet small = hypar(5, 5);
    const LengthPrior truth{LengthPrior::Kind::uniform, 0.003};
    const auto covered = [&](const IdentifyOptions& options) {
        constexpr int surveys = 15;
        double sum = 0.0;
        for (std::uint64_t seed = 1; seed <= surveys; ++seed) {
            const SimulatedSurvey s = simulate(small, truth, noise, seed);
            sum +=
                coverage(test::identify_lengths(small, s.survey, options), s.deviations) / surveys;
        }
        return sum;
    };
    const LengthPrior narrow{LengthPrior::Kind::uniform, 0.002};
    EXPECT_GT(covered({.method = IdentificationMethod::map}), 0.93);
    EXPECT_GT(covered({.method = IdentificationMethod::map, .prior = narrow}), 0.92);
    // What is taken as exact, and is not, holds as little as this.
    EXPECT_LT(covered({.method = IdentificationMethod::map, .prior = narrow, .prior_exact = true}),
              0.8);
}

TEST(Diagnostics, OfAPriorFarTooNarrowNameItFirst) {
    const CableNet saddle = hypar(9, 9);
    const SimulatedSurvey s =
        simulate(saddle, LengthPrior{LengthPrior::Kind::uniform, 0.003}, noise, 7);
    const Identification found =
        test::identify_lengths(saddle, s.survey,
                               {.method = IdentificationMethod::map,
                                .prior = LengthPrior{LengthPrior::Kind::uniform, 0.0003},
                                .prior_exact = true});
    ASSERT_EQ(found.trust.verdict(), Verdict::failed);
    EXPECT_EQ(found.trust.findings.front().kind, Trust::Finding::Kind::prior);
    // The noise is right: nothing advises another.
    for (const Trust::Finding& finding : found.trust.findings) {
        EXPECT_FALSE(finding.remedy && finding.remedy->parameter == "noise");
    }
}

TEST(Diagnostics, OfWhatAllLengthsHaveInCommonNamesIt) {
    SimulatedSurvey s = simulate(net(), prior, noise, 9,
                                 [](Eigen::VectorXd& deviations) { deviations.array() += 0.003; });
    const Identification result = identified(s.survey, prior);
    EXPECT_EQ(result.trust.verdict(), Verdict::failed);
    EXPECT_TRUE(result.prior_check.has_mean());
    EXPECT_NEAR(result.prior_check.mean, 0.003, 4.0 * result.prior_check.mean_std + 0.0005);
}

TEST(Diagnostics, OfNoiseNamesTheNoiseThatFits) {
    SimulatedSurvey s = survey_of(net(), prior, 10);
    s.survey.noise_std /= 3.0;
    const Identification result = identified(s.survey, prior);
    EXPECT_EQ(result.trust.verdict(), Verdict::failed);
    EXPECT_TRUE(finds(result, Kind::survey_noise));
    EXPECT_NEAR(result.scales.noise.ratio, 3.0, 0.3);
    EXPECT_LE(result.outliers.size(), 6U);  // sound targets
}

// Heights that scatter more widely than plan positions pass as one noise that fits both.
TEST(Diagnostics, OfNoiseAlongOneAxisNamesIt) {
    SimulatedSurvey s = survey_of(net(), prior, 11);
    const auto noise_found = [&] {
        return finding_of(identified(s.survey, prior).trust, Kind::survey_noise);
    };
    EXPECT_EQ(noise_found().reason, "");
    s.survey.noise_std.row(2) /= 2.4;
    const Trust::Finding found = noise_found();
    EXPECT_EQ(found.severity, Verdict::failed);
    EXPECT_THAT(found.reason, testing::HasSubstr("scatters along z by"));
    EXPECT_NEAR(found.value.value(), 2.4, 4.0 * 2.4 * found.std_dev.value());
    EXPECT_THAT(found.advice, testing::HasSubstr("each axis"));
}

TEST(Diagnostics, OfNoiseThatIsLessAlongOneAxisAdviseNoCommonOne) {
    SimulatedSurvey s = survey_of(net(), prior, 11);
    s.survey.noise_std.row(2) *= 3.0;
    const Trust::Finding found = finding_of(identified(s.survey, prior).trust, Kind::survey_noise);
    EXPECT_EQ(found.severity, Verdict::doubtful);
    EXPECT_FALSE(found.remedy.has_value());
    EXPECT_THAT(found.advice, testing::HasSubstr("each axis"));
}

// A survey of a net with clamps that were not given; noise, frame and boundary are not to blame.
TEST(Diagnostics, OfAMissingLoadNameItFirst) {
    CableNetData loaded = net().data();
    loaded.loads = Points::Zero(3, net().node_count());
    loaded.loads.row(2).setConstant(-30.0);
    const SimulatedSurvey s = survey_of(CableNet(loaded), prior, 12);
    for (const auto method : {IdentificationMethod::map, IdentificationMethod::balance}) {
        const Identification result = identified(s.survey, prior, method);
        const Trust::Finding& first = result.trust.findings.at(0);
        EXPECT_EQ(first.kind, Kind::missing_load) << first.reason;
        EXPECT_EQ(first.severity, Verdict::failed);
        EXPECT_GT(first.value.value(), 4.0 * first.std_dev.value());
        EXPECT_LT(result.detectable.load, 30.0);
    }
    EXPECT_FALSE(finds(identified(survey_of(net(), prior, 12).survey, prior), Kind::missing_load));
}

// A survey that stands too high is not one of a net with less weight.
TEST(Diagnostics, OfAMissingLoadNameWhatExplainsMoreFirst) {
    SimulatedSurvey s = survey_of(net(), prior, 12);
    s.survey.form.row(2).array() += 0.003;
    Identification result = identified(s.survey, prior);
    EXPECT_EQ(result.trust.findings.at(0).kind, Kind::survey_frame);
    const auto advice = [&] {
        return finding_of(trust_of(net(), s.survey, result), Kind::missing_load).advice;
    };
    result.load_check = {.force = -9.0, .std_dev = 1.0};
    EXPECT_EQ(advice(), "Look at the frame of the survey first: it explains more.");
    // Noise explains more, but may be the load's: another standard deviation is not the remedy.
    result.frame_check = {};
    result.prior_check.mean = 0.0;
    result.scales.noise = {.ratio = 1.8, .std_dev = 0.02};
    EXPECT_THAT(advice(), testing::HasSubstr("Check loads and weights"));
    for (const std::vector<FoundScale>& axes : {std::vector<FoundScale>(),
                                                {{.ratio = 1.0, .std_dev = 0.1},
                                                 {.ratio = 1.0, .std_dev = 0.1},
                                                 {.ratio = 2.5, .std_dev = 0.1}}}) {
        result.scales.noise_by_axis = axes;
        const Trust trust = trust_of(net(), s.survey, result);
        const Trust::Finding noise_found = finding_of(trust, Kind::survey_noise);
        EXPECT_EQ(trust.findings.at(0).kind, Kind::missing_load);
        EXPECT_FALSE(noise_found.remedy);
        EXPECT_THAT(noise_found.advice, testing::HasSubstr("missing load first"));
    }
}

// Another noise is not the remedy where something else explains more of what was found.
TEST(Diagnostics, AdvisesWhatExplainsMost) {
    const SimulatedSurvey s = survey_of(net(), prior, 1);
    Identification result = identified(s.survey, prior);
    result.scales.noise = {.ratio = 1.5, .std_dev = 0.02};
    const auto advice = [&] {
        return finding_of(trust_of(net(), s.survey, result), Kind::survey_noise);
    };
    EXPECT_EQ(advice().remedy, (Trust::Remedy{"noise", "0.75mm"}));
    result.frame_check = {.scale = 4.5e-4, .scale_std = 1e-4};  // significant, but less
    EXPECT_TRUE(advice().remedy);
    result.frame_check.scale = 40e-4;
    EXPECT_FALSE(advice().remedy);
    EXPECT_EQ(advice().advice, "Look at the scale of the survey first: it explains more.");
    result.frame_check = {.scale = 1e-7, .scale_std = 1e-9};  // does no harm, and is not named
    EXPECT_TRUE(advice().remedy);
    result.scales.noise = {.ratio = 2e-6, .std_dev = 0.02};  // a computed form
    EXPECT_FALSE(advice().remedy);
    EXPECT_THAT(advice().advice, testing::HasSubstr("give no noise"));
}

TEST(Diagnostics, OfNoiseCanBeLeftToTheSurvey) {
    SimulatedSurvey s = survey_of(net(), prior, 11);
    const int gross = s.survey.surveyed[40];
    s.survey.form(0, gross) += 0.05;
    for (const double wrong : {0.2, 5.0}) {
        Survey survey = s.survey;
        survey.noise_std *= wrong;
        const Identification result =
            test::identify_lengths(net(), survey, {.prior = prior, .estimate_noise = true});
        EXPECT_NEAR(wrong * result.noise_scale, 1.0, 0.1);
        ASSERT_EQ(result.outliers.size(), 1U);
        EXPECT_EQ(result.outliers[0].node, gross);
        EXPECT_EQ(result.trust.verdict(), Verdict::passed);
        EXPECT_GT(coverage(result, s.deviations), 0.9);
    }
}

TEST(Diagnostics, OfNoiseIsRefusedWhereTheSurveyDoesNotShowIt) {
    const CableNet small = hypar(2, 2);
    SimulatedSurvey s = simulate(small, prior, noise, 3);
    s.survey.frame_is_unknown = true;
    const Identification found = test::identify_lengths(small, s.survey, {.prior = prior});
    EXPECT_TRUE(finds(found, Kind::survey_noise));
    EXPECT_EQ(found.trust.verdict(), Verdict::passed);
    const IdentifyOptions options{.prior = prior, .estimate_noise = true};
    EXPECT_THROW(static_cast<void>(test::identify_lengths(small, s.survey, options)), SurveyError);
    s.survey.noise_std.setZero();
    s.survey.frame_is_unknown = false;
    EXPECT_THROW(static_cast<void>(test::identify_lengths(small, s.survey, options)),
                 std::invalid_argument);
}

TEST(Diagnostics, OfTheFrameFindItWithTheLengths) {
    const SimulatedSurvey s = survey_of(net(), prior, 12);
    const FrameOffset moved{.about = net().nodes().rowwise().mean(),
                            .translation = {0.003, -0.008, 0.002},
                            .translation_std = {},
                            .rotation = {5e-4, 0.0, -3e-4},
                            .rotation_std = {}};
    Survey elsewhere = s.survey;
    elsewhere.form += moved.motion_of(net().nodes());
    elsewhere.frame_is_unknown = true;
    for (const auto method : {IdentificationMethod::map, IdentificationMethod::balance}) {
        SCOPED_TRACE(to_string(method));
        const Identification before = identified(s.survey, prior, method);
        const Identification result = identified(elsewhere, prior, method);
        ASSERT_TRUE(result.frame_offset.has_value());
        const FrameOffset& found = *result.frame_offset;
        const Points at_supports = net().nodes()(Eigen::all, net().supports());
        const Points error = found.motion_of(at_supports) - moved.motion_of(at_supports);
        EXPECT_LT(error.cwiseAbs().maxCoeff(), 1.5e-3);
        EXPECT_GT(found.translation_std.minCoeff(), 1e-5);
        EXPECT_LT(found.translation_std.maxCoeff(), 1e-3);
        EXPECT_TRUE(result.outliers.empty());
        EXPECT_EQ(result.trust.verdict(), Verdict::passed);
        EXPECT_GT(coverage(result, s.deviations), 0.9);
        EXPECT_LT(result.residuals.maxCoeff(), 1.5 * before.residuals.maxCoeff());
    }
}

TEST(Diagnostics, OfTheFrameLeavesTensionsReported) {
    SimulatedSurvey s = survey_of(net(), prior, 14);
    const IdentifyOptions options{.prior = prior, .draws = 40};
    const Identification before = test::identify_lengths(net(), s.survey, options);
    s.survey.form.row(0).array() += 0.004;
    s.survey.frame_is_unknown = true;
    const Identification result = test::identify_lengths(net(), s.survey, options);
    ASSERT_EQ(result.drawn.tensions.size(), before.drawn.tensions.size()) << result.draws->reason;
    EXPECT_NEAR(result.drawn.mean_tension.mean, before.drawn.mean_tension.mean,
                4.0 * before.drawn.mean_tension.std_dev);
}

void measure_supports(Survey& survey) {
    for (const int node : net().supports()) {
        survey.supports.push_back({.node = node,
                                   .position = net().nodes().col(node),
                                   .noise_std = Eigen::Vector3d::Constant(noise)});
    }
}

TEST(MeasuredSupports, OfUncertainPlaceLeaveTensionsReported) {
    SimulatedSurvey s = survey_of(net(), prior, 15);
    measure_supports(s.survey);
    const Identification result = test::identify_lengths(
        net(), s.survey, {.prior = prior, .uncertain = uncertain({"supports:1mm"}), .draws = 20});
    EXPECT_EQ(result.drawn.tensions.size(), 664U) << result.draws->reason;
    EXPECT_LT(result.uncertain.front().std_dev, 0.6e-3);  // measured to 0.5 mm
}

TEST(MeasuredSupports, ShowTheFrameAndAreTestedThemselves) {
    SimulatedSurvey s = survey_of(net(), prior, 13);
    s.survey.frame_is_unknown = true;
    const Identification without = identified(s.survey, prior);
    measure_supports(s.survey);
    const Identification with = identified(s.survey, prior);
    EXPECT_LT(with.frame_offset->translation_std.maxCoeff(),
              0.9 * without.frame_offset->translation_std.maxCoeff());
    EXPECT_TRUE(with.outliers.empty());
    const int wrong = net().supports()[20];
    s.survey.supports[20].position.y() += 0.01;
    const Identification found = identified(s.survey, prior);
    ASSERT_EQ(found.outliers.size(), 1U);
    EXPECT_EQ(found.outliers[0].node, wrong);
    EXPECT_GT(coverage(found, s.deviations), 0.9);
}

}  // namespace of_diagnostics
