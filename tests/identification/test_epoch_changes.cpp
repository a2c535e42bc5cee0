// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against turns or cables not as given between two surveys without a finding, and false
// alarms for sound ones.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "identification/jobs.hpp"
#include "support/identify_lengths.hpp"
#include "taut/net/cable_runs.hpp"

namespace taut::of_epochs {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// A turn done the wrong way, or a cable that slipped.
TEST(Epochs, NameTheLengthThatChanged) {
    for (const bool is_slip : {false, true}) {
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            const std::vector<EdgeTurned> given = some_turns(seed);
            std::vector<EdgeTurned> done = given;
            Eigen::VectorXd slip = Eigen::VectorXd::Zero(net().interior_edge_count());
            int edge = given[3].edge;
            double change = 0.0;
            if (is_slip) {
                edge = net().interior_edges()[40];
                change = slip(40) = 8e-3;
            } else {
                done[3].stroke = given[3].stroke > 0.0 ? -5e-3 : 5e-3;
                change = done[3].stroke - given[3].stroke;
            }
            const Job job = job_of(seed, given, done, slip);
            const Identification result = test::identify_lengths(net(), job.epochs, with_prior());
            ASSERT_EQ(result.epochs.size(), 2U);
            const std::vector<LengthChange>& changes = result.epochs[1].changes;
            ASSERT_EQ(changes.size(), 1U) << seed;
            EXPECT_EQ(changes[0].edge, edge);
            EXPECT_NEAR(changes[0].change, change, 5.0 * changes[0].std_dev);
            EXPECT_NE(result.trust.verdict(), Trust::Verdict::passed);
            // What was turned is not to be added to the turns.
            EXPECT_THAT(result.trust.findings.front().reason,
                        HasSubstr(is_slip ? "changed by " : "is given as turned by "));
            if (is_slip) {
                EXPECT_THAT(result.trust.findings.front().reason, HasSubstr(net().edge_id(edge)));
            } else {
                EXPECT_TRUE(result.epochs[0].outliers.empty() && result.epochs[1].outliers.empty());
            }
            EXPECT_GT(test::coverage(result, job.deviations + slip), 0.9);  // as it is now
        }
    }
}

/// Two edges that follow each other along a cable, far from its ends, and the node between them.
struct Clamp {
    int before;
    int after;
    int node;
};

Clamp a_clamp() {
    const std::vector<int> run = cable_runs(net())[2];
    const int before = run[run.size() / 2 - 1];
    const int after = run[run.size() / 2];
    for (const int node : net().edges()[before]) {
        if (std::ranges::count(net().edges()[after], node) > 0) {
            return {.before = before, .after = after, .node = node};
        }
    }
    return {};
}

/// A slip of a clamp, or a target that went wrong along the cable: which of both is open, and
/// whichever it was, lengths are not surer than that.
TEST(Epochs, HoldWhetherAClampSlippedOrItsTargetIsWrong) {
    const Clamp clamp = a_clamp();
    for (const double distance : {8e-3, 15e-3}) {
        for (const bool is_slip : {false, true}) {
            for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                Eigen::VectorXd slip = Eigen::VectorXd::Zero(net().interior_edge_count());
                slip(net().interior_index(clamp.before)) = is_slip ? distance : 0.0;
                slip(net().interior_index(clamp.after)) = is_slip ? -distance : 0.0;
                const std::vector<EdgeTurned> turned = some_turns(seed);
                Job job = job_of(seed, turned, turned, slip);
                if (!is_slip) {
                    const auto [s, t] = net().edges()[clamp.after];
                    const int end = s == clamp.node ? t : s;
                    Points& form = job.epochs[1].survey.form;
                    form.col(clamp.node) +=
                        distance * (form.col(end) - form.col(clamp.node)).normalized();
                }
                IdentifyOptions options = with_prior();
                options.prior_exact = seed == 2;  // not over several priors
                const Identification result = test::identify_lengths(net(), job.epochs, options);
                const Eigen::VectorXd truth = job.deviations + slip;
                // The target is one of the survey, and left out.
                EXPECT_EQ(residuals_in_use(result, job.epochs[1].survey).size(),
                          std::ssize(job.epochs[1].survey.surveyed) - std::ssize(result.outliers));
                EXPECT_FALSE(test::finds(result, Trust::Finding::Kind::predicted_form));
                for (const int edge : {clamp.before, clamp.after}) {
                    const int i = net().interior_index(edge);
                    EXPECT_LT(std::abs(result.edges[i].length_deviation - truth(i)),
                              4.0 * result.edges[i].std_dev)
                        << distance << ' ' << is_slip << ' ' << seed << ' '
                        << result.trust.findings.front().reason;
                }
                if (is_slip) {
                    EXPECT_EQ(result.trust.verdict(), Trust::Verdict::doubtful)
                        << distance << ' ' << seed;
                }
            }
        }
    }
}

/// Beside a turnbuckle whose length is taken as exact.
TEST(Epochs, HoldWhereATargetIsWrongBesideATurnbuckle) {
    const int edge = net().adjustable_edges()[3];
    const auto [s, t] = net().edges()[edge];
    const int node = net().is_support(s) ? t : s;
    Job job = job_as_given(2, {});
    Points& form = job.epochs[1].survey.form;
    form.col(node) += 15e-3 * (form.col(s == node ? t : s) - form.col(node)).normalized();
    const Identification result = test::identify_lengths(net(), job.epochs, with_prior());
    EXPECT_EQ(result.status, IdentificationStatus::converged);
    EXPECT_GT(test::coverage(result, job.deviations), 0.9);
}

TEST(Epochs, AreRefusedWhereTheTurnsAreOfAnotherDay) {
    const Job job = job_of(1, some_turns(1), some_turns(2));
    const Identification result = test::identify_lengths(net(), job.epochs, with_prior());
    EXPECT_EQ(result.status, IdentificationStatus::survey_does_not_fit);
    EXPECT_THAT(result.message, HasSubstr("Check the turns given"));
}

TEST(Epochs, FailWhereAllTurnsAreALittleOff) {
    const std::vector<EdgeTurned> given = some_turns(1);
    std::vector<EdgeTurned> done = given;
    for (EdgeTurned& one : done) {
        one.stroke *= 1.15;  // a pitch given wrong
    }
    const Job job = job_of(1, given, done);
    const Identification result = test::identify_lengths(net(), job.epochs, with_prior());
    EXPECT_EQ(result.trust.verdict(), Trust::Verdict::failed);
    EXPECT_NEAR(result.epochs[1].stroke_factor, 1.15, 4.0 * result.epochs[1].stroke_factor_std);
}

TEST(Epochs, NameTheSignOfAFewTurnsRatherThanEach) {
    std::vector<EdgeTurned> given;
    std::vector<EdgeTurned> done;
    for (const size_t i : {1, 8, 15}) {
        const double stroke = i == 8 ? -5e-3 : 6e-3;
        given.push_back({.edge = net().adjustable_edges()[i], .stroke = stroke});
        done.push_back({.edge = net().adjustable_edges()[i], .stroke = -stroke});
    }
    const Identification result =
        test::identify_lengths(net(), job_of(1, given, done).epochs, with_prior());
    EXPECT_EQ(result.trust.verdict(), Trust::Verdict::failed);
    EXPECT_TRUE(result.epochs[1].changes.empty());
    EXPECT_NEAR(result.epochs[1].stroke_factor, -1.0, 4.0 * result.epochs[1].stroke_factor_std);
    EXPECT_THAT(result.trust.findings.front().reason, HasSubstr("times as far as given"));
}

TEST(Epochs, DoNotBlameAllTurnsForOne) {
    const IdentifyOptions options = with_prior(uncertain({"supports:1mm"}));
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const std::vector<EdgeTurned> given = some_turns(seed);
        std::vector<EdgeTurned> done = given;
        const auto largest = std::ranges::max_element(
            done, {}, [](const EdgeTurned& one) { return std::abs(one.stroke); });
        largest->stroke *= -1.0;
        const Identification result =
            test::identify_lengths(net(), job_of(seed, given, done).epochs, options);
        EXPECT_EQ(result.status, IdentificationStatus::converged) << result.message;
        EXPECT_NE(result.trust.verdict(), Trust::Verdict::passed) << seed;
        ASSERT_FALSE(result.epochs[1].changes.empty());
        EXPECT_EQ(result.epochs[1].changes[0].edge, largest->edge);
    }
}

/// Where every turn is let go by itself, none is left for a factor.
TEST(Epochs, GiveNoFactorOfTurnsThatWereLetGo) {
    std::vector<EdgeTurned> given;
    std::vector<EdgeTurned> done;
    for (const size_t i : {1, 8}) {
        given.push_back({.edge = net().adjustable_edges()[i], .stroke = 6e-3});
        done.push_back(given.back());
    }
    done[0].stroke = -4e-3;
    done[1].stroke = 14e-3;
    const Identification result =
        test::identify_lengths(net(), job_of(1, given, done).epochs, with_prior());
    EXPECT_EQ(result.epochs[1].changes.size(), 2U);
    EXPECT_EQ(result.epochs[1].stroke_factor, 1.0);
    EXPECT_EQ(result.trust.verdict(), Trust::Verdict::doubtful);
}

/// The scatter of turns is taken into account where it is given, and estimated from all turns
/// together where it is not and no single turn stands out.
TEST(Epochs, EstimateTheScatterOfTurns) {
    for (const bool is_given : {true, false}) {
        const double actuator_std = is_given ? 1e-3 : 0.8e-3;
        double inside = 0.0;
        constexpr int jobs = 3;
        for (std::uint64_t seed = 1; seed <= jobs; ++seed) {
            const std::vector<EdgeTurned> given = some_turns(seed, is_given ? actuator_std : 0.0);
            std::vector<EdgeTurned> done = given;
            std::mt19937_64 random(seed + (is_given ? 50 : 60));
            std::normal_distribution<double> normal(0.0, actuator_std);
            for (EdgeTurned& one : done) {
                one.stroke += normal(random);
            }
            const Job job = job_of(seed, given, done);
            const Identification result = test::identify_lengths(net(), job.epochs, with_prior());
            const EpochResult& second = result.epochs[1];
            if (is_given) {
                EXPECT_NE(result.trust.verdict(), Trust::Verdict::failed)
                    << result.trust.findings[0].reason;
                EXPECT_EQ(result.uncertain.size(), given.size());
            } else {
                EXPECT_NE(result.trust.verdict(), Trust::Verdict::passed) << seed;
                EXPECT_GT(
                    second.excess_actuator_std + (second.changes.empty() ? 0.0 : actuator_std),
                    0.5 * actuator_std);
                EXPECT_LT(second.excess_actuator_std, 2.0 * actuator_std);
            }
            inside += test::coverage(result, job.deviations) / jobs;
        }
        EXPECT_GT(inside, 0.92);
    }
}

TEST(Epochs, NameTurnbucklesThatWereOffFromTheBeginning) {
    const std::vector<int>& adjustable = net().adjustable_edges();
    const std::vector<EdgeTurned> off{{.edge = adjustable[3], .stroke = 6e-3},
                                      {.edge = adjustable[28], .stroke = -6e-3}};
    const CableNet built = turned_net(net(), off);
    const test::SimulatedSurvey first = test::simulate(built, prior, noise, 5);
    const Identification result =
        test::identify_lengths(net(), surveyed_twice(built, first, 99), with_prior());
    std::vector<int> named;
    for (const LengthChange& change : result.epochs[0].changes) {
        named.push_back(change.edge);
        EXPECT_NEAR(std::abs(change.change), 6e-3, 5.0 * change.std_dev);
    }
    EXPECT_THAT(named, ::testing::UnorderedElementsAre(off[0].edge, off[1].edge));
    EXPECT_TRUE(result.epochs[1].changes.empty());
    EXPECT_EQ(result.trust.verdict(), Trust::Verdict::doubtful);
    EXPECT_EQ(result.trust.findings[0].kind, Trust::Finding::Kind::adjustable_edge);
    EXPECT_GT(test::coverage(result, first.deviations), 0.9);
}

TEST(Epochs, AreNoWiderUncertainThanAnEdgeMayBe) {
    const std::vector<EdgeTurned> done{{.edge = net().adjustable_edges()[3], .stroke = -12e-3}};
    const Job job = job_of(7, {}, done, Eigen::VectorXd::Zero(net().interior_edge_count()));
    const Identification result = test::identify_lengths(net(), job.epochs, with_prior());
    for (const ParameterEstimate& estimate : result.uncertain) {
        EXPECT_NO_THROW(check_uncertain_parameters(net(), {estimate.parameter}));
    }
}

/// The same survey in other digits, and in another frame: its errors are in both.
TEST(Epochs, NameOneSurveyGivenTwice) {
    Job job = job_as_given(4, some_turns(4));
    EXPECT_EQ(test::identify_lengths(net(), job.epochs, with_prior()).trust.verdict(),
              Trust::Verdict::passed);
    job.epochs[1].turned.clear();
    job.epochs[1].survey.form = job.epochs[0].survey.form.unaryExpr(
        [](double place) { return 1e-4 * std::round(1e4 * place); });
    EXPECT_EQ(test::identify_lengths(net(), job.epochs, with_prior()).trust.findings.back().kind,
              Trust::Finding::Kind::repeated_survey);
    job.epochs[1].survey.form.colwise() += Eigen::Vector3d(1e-3, -2e-3, 3e-3);
    for (Epoch& epoch : job.epochs) {
        epoch.survey.frame_is_unknown = true;
    }
    EXPECT_EQ(test::identify_lengths(net(), job.epochs, with_prior()).trust.findings.back().kind,
              Trust::Finding::Kind::repeated_survey);
}

TEST(Epochs, SayThatThePriorIsAnother) {
    const Job job = job_as_given(2, some_turns(2));
    const Identification result = test::identify_lengths(
        net(), job.epochs, {.prior = LengthPrior{LengthPrior::Kind::uniform, 1e-3}});
    EXPECT_TRUE(result.contradicted_prior);
    EXPECT_NE(result.trust.verdict(), Trust::Verdict::passed);
    EXPECT_EQ(result.trust.findings[0].kind, Trust::Finding::Kind::prior);
    EXPECT_THAT(result.trust.findings[0].reason, HasSubstr("Survey 1: "));
    EXPECT_THAT(result.description, HasSubstr("that the first survey shows"));
    EXPECT_GT(test::coverage(result, job.deviations), 0.9);
}

/// The strain that interior edges gain between two surveys.
TEST(Epochs, FindTheCreepOfRopes) {
    constexpr double strain = 4e-3;
    Eigen::VectorXd crept = Eigen::VectorXd::Zero(net().interior_edge_count());
    CableNetData data = net().data();
    for (int i = 0; i < net().interior_edge_count(); i += 2) {
        const int edge = net().interior_edges()[static_cast<size_t>(i)];
        crept(i) = strain * net().unstressed_lengths()(edge);
        data.groups["rope"].push_back(edge);
    }
    const CableNet grouped(data);
    IdentifyOptions options{
        .prior = prior, .uncertain = uncertain({"creep:0.5%@rope"}), .assume_site = true};
    int far = 0;
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Job job = job_of(seed, {}, {}, crept);
        const Identification found = test::identify_lengths(grouped, job.epochs, options);
        EXPECT_EQ(found.trust.verdict(), Trust::Verdict::passed) << found.trust.findings[0].reason;
        const auto creep =
            std::ranges::find(found.uncertain, UncertainParameter::Kind::creep,
                              [](const ParameterEstimate& one) { return one.parameter.kind; });
        ASSERT_NE(creep, found.uncertain.end());
        EXPECT_EQ(creep->parameter, options.uncertain[0]);
        EXPECT_LT(creep->std_dev, 2e-3);
        far += std::abs(creep->mean - strain) > 2.0 * creep->std_dev ? 1 : 0;
        EXPECT_NEAR(creep->mean, strain, 3.0 * creep->std_dev);
        // Lengths are those of the first survey: the strain is beside them.
        EXPECT_GT(test::coverage(found, job.deviations), 0.85);
        // Not assumed, it is a small error of the lengths, and named where it is twice as large.
        IdentifyOptions without = options;
        without.uncertain.clear();
        EXPECT_GT(
            test::coverage(test::identify_lengths(grouped, job.epochs, without), job.deviations),
            0.85);
        const Trust larger =
            test::identify_lengths(grouped, job_of(seed, {}, {}, 2.0 * crept).epochs, without)
                .trust;
        ASSERT_EQ(larger.findings.size(), 1U);
        EXPECT_EQ(larger.findings[0].ids, std::vector<std::string>{"creep@rope"});
        EXPECT_NEAR(larger.findings[0].value.value(), 2.0 * strain, 3.0 * 1.5e-3);
        EXPECT_EQ(parse_uncertain_parameter(larger.findings[0].remedy->value).group, "rope");
        const Trust largest =
            test::identify_lengths(grouped, job_of(seed, {}, {}, 4.0 * crept).epochs, without)
                .trust;
        EXPECT_NE(largest.verdict(), Trust::Verdict::passed);
        EXPECT_TRUE(std::ranges::any_of(largest.findings, [](const Trust::Finding& one) {
            return one.ids == std::vector<std::string>{"creep@rope"} && one.remedy->value.empty();
        }));
    }
    EXPECT_LE(far, 1);
    EXPECT_THAT(
        [&] { (void)test::identify_lengths(grouped, job_of(1, {}, {}).epochs[0].survey, options); },
        ThrowsMessage<std::invalid_argument>(HasSubstr("expected a second survey")));
    options.uncertain = {parse_uncertain_parameter("creep:0.9%@rope")};
    Job three = job_of(1, {}, {});
    three.epochs.push_back(job_of(2, {}, {}).epochs[1]);
    EXPECT_THAT([&] { (void)test::identify_lengths(grouped, three.epochs, options); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("more than 1 % in 3 surveys")));
}

TEST(Epochs, BlameAForceAndNoChangeOfLengths) {
    const Job job = job_of(3, {}, {}, {});
    IdentifyOptions options{.prior = prior, .assume_site = true};
    const int edge = net().interior_edges()[60];
    const Identification without = test::identify_lengths(net(), job.epochs, options);
    const double tension = without.tensions(edge);
    options.forces.measurements = {
        {.edge = edge, .tension = 3.0 * tension, .std_dev = 0.02 * tension}};
    const Identification found = test::identify_lengths(net(), job.epochs, options);
    ASSERT_EQ(found.force_outliers.size(), 1U);
    ASSERT_EQ(found.trust.findings.size(), 1U) << found.trust.findings[0].reason;
    EXPECT_EQ(found.trust.findings[0].kind, Trust::Finding::Kind::force_measurement);
    EXPECT_NEAR(found.epochs[1].change_ratio, without.epochs[1].change_ratio, 1e-3);
}

/// A third survey has had twice the time: a walk of which each step is as wide.
TEST(Epochs, LetCreepGoOn) {
    constexpr double strain = 3e-3;
    const Eigen::VectorXd lengths = net().unstressed_lengths()(net().interior_edges());
    Job job = job_of(5, {}, {}, strain * lengths);
    job.epochs.push_back(job_of(5, {}, {}, 2.5 * strain * lengths).epochs[1]);
    // Other noise than that of the second survey.
    test::add_noise(job.epochs[2].survey.form, job.epochs[2].survey.surveyed, noise, 77);
    job.epochs[2].survey.noise_std *= std::sqrt(2.0);
    const IdentifyOptions options = with_prior(uncertain({"creep:0.5%"}));
    const Identification found = test::identify_lengths(net(), job.epochs, options);
    ASSERT_EQ(found.status, IdentificationStatus::converged);
    EXPECT_NEAR(found.uncertain[0].mean, 2.5 * strain, 3.0 * found.uncertain[0].std_dev);
    EXPECT_NEAR(found.uncertain[0].prior_std, std::sqrt(2.0) * 5e-3, 1e-9);
    EXPECT_EQ(found.uncertain[0].parameter, options.uncertain[0]);
}

}  // namespace taut::of_epochs
