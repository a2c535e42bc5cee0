// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against surveys that are put together wrong: a posterior that is not that of all of them.
#include "taut/identification/epochs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "identification/jobs.hpp"
#include "sampling/uncertain_widths.hpp"
#include "support/identify_lengths.hpp"
#include "support/json_numbers.hpp"
#include "taut/adjustment/built_net.hpp"

namespace taut::of_epochs {

using nlohmann::json;
using test::points_of;
using test::vector_of;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Survey survey_of(const CableNet& of, Points form, double std_dev,
                 const std::vector<int>& surveyed) {
    Survey survey{.form = std::move(form),
                  .noise_std = Points::Constant(3, of.node_count(), std_dev),
                  .surveyed = surveyed,
                  .missing = {}};
    std::ranges::set_difference(of.free_nodes(), surveyed, std::back_inserter(survey.missing));
    return survey;
}

TEST(Epochs, AreThoseOfOneLeastSquaresProblem) {
    const json reference = json::parse(std::ifstream(TAUT_TEST_DATA_DIR "/epochs_reference.json"));
    CableNetData data;
    data.nodes = points_of(reference["nodes"]);
    data.supports = reference["supports"].get<std::vector<int>>();
    data.edges = reference["edges"].get<std::vector<Edge>>();
    data.unstressed_lengths = vector_of(reference["nominal"]);
    data.axial_stiffness = Eigen::VectorXd::Constant(std::ssize(data.edges),
                                                     reference["axial_stiffness"].get<double>());
    data.adjustable = edges_at_supports(data.edges, data.supports);
    const CableNet small(data);
    std::vector<Epoch> epochs;
    for (const json& given : reference["epochs"]) {
        Epoch epoch{.survey = survey_of(small, points_of(given["form"]), reference["noise"],
                                        given["surveyed"].get<std::vector<int>>()),
                    .turned = {}};
        for (const json& one : given["turned"]) {
            epoch.turned.push_back(
                {.edge = one["edge"], .stroke = one["stroke"], .std_dev = one["std"]});
        }
        epochs.push_back(std::move(epoch));
    }
    const Identification result = test::identify_lengths(
        small, epochs,
        {.prior = LengthPrior{LengthPrior::Kind::normal, reference["law"]}, .prior_exact = true});
    ASSERT_EQ(result.status, IdentificationStatus::converged);
    const Eigen::VectorXd expected = vector_of(reference["deviations"]);
    const Eigen::VectorXd stds = vector_of(reference["stds"]);
    ASSERT_EQ(std::ssize(result.edges), expected.size());
    for (size_t i = 0; i < result.edges.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        EXPECT_NEAR(result.edges[i].length_deviation, expected(k), 0.02 * stds(k));
        EXPECT_NEAR(result.edges[i].std_dev, stds(k), 0.02 * stds(k));
    }
    const Points form = points_of(reference["last_form"]);
    EXPECT_LT((result.predicted.form - form).cwiseAbs().maxCoeff(), 2e-5);
}

TEST(Epochs, DetermineMoreThanOneSurvey) {
    double alone = 0.0;  // root mean square errors
    double both = 0.0;
    double inside = 0.0;
    constexpr int jobs = 3;
    for (std::uint64_t seed = 1; seed <= jobs; ++seed) {
        const Job job = job_as_given(seed, some_turns(seed));
        const Identification first =
            test::identify_lengths(net(), job.epochs[0].survey, with_prior());
        alone += std::sqrt(test::squared_error(first, job.deviations)) / jobs;
        const Identification result = test::identify_lengths(net(), job.epochs, with_prior());
        EXPECT_EQ(result.trust.verdict(), Trust::Verdict::passed)
            << result.trust.findings[0].reason;
        ASSERT_EQ(result.epochs.size(), 2U);
        EXPECT_NEAR(result.epochs[1].change_ratio, 1.0, 0.3);
        EXPECT_TRUE(result.epochs[1].changes.empty());
        both += std::sqrt(test::squared_error(result, job.deviations)) / jobs;
        inside += test::coverage(result, job.deviations) / jobs;
    }
    EXPECT_LT(both, 0.8 * alone);
    EXPECT_GT(inside, 0.92);
    EXPECT_LT(inside, 0.98);
}

TEST(Epochs, SayMoreOfCompressedStrutsToo) {
    const CableNet dome = cable_dome();
    const test::SimulatedSurvey first = test::simulate(dome, prior, noise, 5);
    const auto mean_std_of_struts = [&](const Identification& found) {
        double sum = 0.0;
        int count = 0;
        for (const IdentifiedEdge& edge : found.edges) {
            sum += dome.is_strut(edge.edge) ? edge.std_dev : 0.0;
            count += dome.is_strut(edge.edge) ? 1 : 0;
        }
        return sum / count;
    };
    const Identification alone = test::identify_lengths(dome, first.survey, with_prior());
    const Identification both =
        test::identify_lengths(dome, surveyed_twice(dome, first, 7), with_prior());
    EXPECT_LT(mean_std_of_struts(both), 0.85 * mean_std_of_struts(alone));
}

/// What no survey shows stays uncertain, however many there are, and accuses nothing.
TEST(Epochs, DoNotAverageSupportsThatAreOff) {
    double inside_if_known = 0.0;
    double inside = 0.0;
    constexpr int jobs = 6;
    for (std::uint64_t seed = 1; seed <= jobs; ++seed) {
        const std::vector<EdgeTurned> turned = some_turns(seed);
        const Job job = job_of(seed, turned, turned, {}, CableNet(on_moved_supports(seed + 500)));
        const Identification if_known =
            test::identify_lengths(net(), job.epochs, {.prior = prior, .prior_exact = true});
        inside_if_known += test::coverage(if_known, job.deviations) / jobs;
        const IdentifyOptions options = with_prior(uncertain({"supports:1mm"}));
        const Identification result = test::identify_lengths(net(), job.epochs, options);
        EXPECT_EQ(result.trust.verdict(), Trust::Verdict::passed)
            << result.trust.findings[0].reason;
        EXPECT_EQ(result.uncertain.front().parameter, options.uncertain.front());
        inside += test::coverage(result, job.deviations) / jobs;
    }
    EXPECT_LT(inside_if_known, 0.8);
    EXPECT_GT(inside, 0.9);
}

/// All are twice as far off as taut assumes of each, which surveys hardly show.
TEST(Epochs, DoNotTakeTurnbucklesAsExact) {
    CableNetData data = net().data();
    for (const int edge : net().adjustable_edges()) {
        data.unstressed_lengths(edge) += 1e-3;
    }
    const CableNet built(std::move(data));
    const IdentifyOptions options{.prior = prior, .assume_site = true, .draws = 100};
    constexpr std::array<std::uint64_t, 3> seeds{1, 2, 3};
    double inside = 0.0;
    for (const std::uint64_t seed : seeds) {
        const test::SimulatedSurvey first = test::simulate(built, prior, noise, seed);
        const double mean = test::true_tensions(built, first).mean();
        const Identification found =
            test::identify_lengths(net(), job_of(seed, {}, {}, {}, built).epochs, options);
        const DrawnEstimate& drawn = found.drawn.mean_tension;
        ASSERT_GT(drawn.std_dev, 0.0);
        EXPECT_LT(std::abs(drawn.mean - mean), 2.5 * drawn.std_dev);
        inside += test::coverage(found, first.deviations) / std::ssize(seeds);
    }
    EXPECT_GT(inside, 0.9);
}

/// A cable that is slack at one survey has no length there but a bound, which must not be held
/// against the survey that shows it.
TEST(Epochs, TakeCablesThatWereSlackAtOneSurvey) {
    int slack = 0;
    int known = 0;
    for (std::uint64_t seed = 1; slack < 6; ++seed) {
        std::vector<EdgeTurned> tightened;
        std::vector<EdgeTurned> let_out;
        for (const int edge : net().adjustable_edges()) {
            tightened.push_back({.edge = edge, .stroke = -6e-3});
            let_out.push_back({.edge = edge, .stroke = 2e-3});
        }
        const CableNet loose = turned_net(net(), let_out);
        const test::SimulatedSurvey first = test::simulate(loose, prior, noise, seed);
        if (first.truth.slack_edges.empty()) {
            continue;
        }
        const Survey second = test::surveyed_again(
            loose, test::simulate(turned_net(loose, tightened), prior, noise, seed), noise,
            seed + 1000);
        const Identification result =
            test::identify_lengths(loose,
                                   std::vector<Epoch>{{.survey = first.survey, .turned = {}},
                                                      {.survey = second, .turned = tightened}},
                                   with_prior());
        ASSERT_EQ(result.status, IdentificationStatus::converged) << seed;
        for (size_t i = 0; i < result.edges.size(); ++i) {
            const IdentifiedEdge& edge = result.edges[i];
            if (std::ranges::find(first.truth.slack_edges, edge.edge) !=
                first.truth.slack_edges.end()) {
                ++slack;
                known += test::holds(edge, first.deviations(static_cast<int>(i))) ? 1 : 0;
            }
        }
    }
    EXPECT_GE(known, slack - 1);
}

TEST(Epochs, NeedNoAdjustableEdges) {
    CableNetData data = net().data();
    data.adjustable.clear();
    data.thread.clear();
    const CableNet fixed{data};
    const test::SimulatedSurvey first = test::simulate(fixed, prior, noise, 1);
    const Identification result =
        test::identify_lengths(fixed, surveyed_twice(fixed, first, 9), with_prior());
    EXPECT_EQ(result.trust.verdict(), Trust::Verdict::passed);
    EXPECT_GT(test::coverage(result, first.deviations), 0.9);
    const Identification alone = test::identify_lengths(fixed, first.survey, with_prior());
    EXPECT_LT(test::squared_error(result, first.deviations),
              test::squared_error(alone, first.deviations));
}

/// A plan keeps its limits over these: adjustable lengths are drawn with interior ones, as widely
/// as they are known.
TEST(Epochs, DrawTurnsAndLengths) {
    const std::vector<EdgeTurned> turned = some_turns(6, 0.5e-3);
    const Identification result = test::identify_lengths(net(), job_as_given(6, turned).epochs,
                                                         {.prior = prior, .draws = 200});
    const auto std_of = [](const Eigen::VectorXd& values) {
        return std::sqrt((values.array() - values.mean()).square().mean());
    };
    ASSERT_TRUE(result.draws);
    const Eigen::MatrixXd& drawn = result.draws->adjustable_deviations;
    ASSERT_EQ(drawn.rows(), std::ssize(net().adjustable_edges()));
    ASSERT_EQ(drawn.cols(), result.draws->count());
    ASSERT_EQ(result.uncertain.size(), turned.size());
    double ratio = 0.0;
    for (const ParameterEstimate& one : result.uncertain) {
        const auto row = std::ranges::find(net().adjustable_edges(), one.edge) -
                         net().adjustable_edges().begin();
        EXPECT_NEAR(drawn.row(row).mean(), one.mean, 0.5 * one.std_dev);
        ratio +=
            std_of(drawn.row(row)) / one.std_dev / static_cast<double>(result.uncertain.size());
    }
    EXPECT_NEAR(ratio, 1.0, 0.1);
    Eigen::VectorXd of_lengths =
        test::of_edges(result.edges, &IdentifiedEdge::std_dev).cwiseInverse();
    for (Eigen::Index i = 0; i < of_lengths.size(); ++i) {
        of_lengths(i) *= std_of(result.draws->length_deviations.row(i));
    }
    EXPECT_NEAR(of_lengths.mean(), 1.0, 0.1);
    const BuiltNet built = built_net_of(net(), result);
    EXPECT_EQ(built.length_draws.cols(), result.draws->count());
    const Eigen::VectorXd mean = built.length_draws.rowwise().mean();
    EXPECT_LT((mean - built.net.unstressed_lengths()).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(Epochs, MaySeeOtherTargetsInOtherFrames) {
    Job job = job_as_given(3, some_turns(3));
    for (size_t i = 0; i < net().free_nodes().size(); ++i) {
        if (i % 3 != 2) {
            test::hide(net(), job.epochs[i % 3].survey, net().free_nodes()[i]);
        }
    }
    job.epochs[1].survey.form.colwise() += Eigen::Vector3d(3e-3, -2e-3, 1e-3);
    for (Epoch& epoch : job.epochs) {
        epoch.survey.frame_is_unknown = true;
    }
    const Identification result = test::identify_lengths(net(), job.epochs, with_prior());
    ASSERT_EQ(result.status, IdentificationStatus::converged);
    ASSERT_TRUE(result.frame_offset);
    EXPECT_NEAR(result.frame_offset->translation.x(), 3e-3,
                5.0 * result.frame_offset->translation_std.x());
    EXPECT_NEAR(result.epochs[0].frame_offset->translation.x(), 0.0,
                5.0 * result.epochs[0].frame_offset->translation_std.x());
    EXPECT_GT(test::coverage(result, job.deviations), 0.9);
}

// The form alone does not show how stiff all cables are; how it gives way under a known load does.
TEST(Epochs, AKnownLoadShowsTheStiffness) {
    constexpr double softer = 0.9;
    CableNetData data = net().data();
    data.axial_stiffness *= softer;
    const CableNet built{CableNetData(data)};
    data.loads = loads_on_every(3, 1500.0);
    Job job = job_of(4, {}, {}, {}, built);
    const IdentifyOptions options = with_prior(uncertain({"stiffness:10%"}));
    const Identification unloaded = test::identify_lengths(net(), job.epochs, options);
    job.epochs[1].survey.form += move_under(data, built, 4);
    job.epochs[1].loads = data.loads;
    const Identification loaded = test::identify_lengths(net(), job.epochs, options);
    ASSERT_EQ(loaded.status, IdentificationStatus::converged) << loaded.message;
    EXPECT_GT(unloaded.uncertain[0].std_dev, 0.09);
    EXPECT_LT(loaded.uncertain[0].std_dev, 0.04);
    EXPECT_NEAR(loaded.uncertain[0].mean, std::log(softer), 3.0 * loaded.uncertain[0].std_dev);
    EXPECT_EQ(loaded.trust.verdict(), Trust::Verdict::passed);
    EXPECT_GT(loaded.epochs[1].load, 0.0);
    // It is of the net without that load, at the first survey.
    EXPECT_LT((loaded.predicted.form - job.epochs[0].survey.form).cwiseAbs().maxCoeff(), 5e-3);
}

/// What supports hide from two surveys does not cancel where a load turns the edges at them.
TEST(Epochs, AccuseNothingWhereSupportsAreOffUnderAKnownLoad) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        CableNetData data = on_moved_supports(seed + 500);
        const CableNet built{CableNetData(data)};
        data.loads = loads_on_every(5, 2000.0);
        Job job = job_of(seed, {}, {}, {}, built);
        job.epochs[1].survey.form += move_under(data, built, seed);
        job.epochs[1].loads = data.loads;
        const Identification result =
            test::identify_lengths(net(), job.epochs, with_prior(uncertain({"supports:1mm"})));
        EXPECT_EQ(result.trust.verdict(), Trust::Verdict::passed)
            << result.trust.findings[0].reason;
    }
}

// Turns and loads leave edges their mass: it may be uncertain, and frequencies need it.
TEST(Epochs, KeepTheMassesOfTheNet) {
    CableNetData data = net().data();
    data.mass = Eigen::VectorXd::Constant(std::ssize(data.edges), 0.5);
    const CableNet heavy{CableNetData(data)};
    const std::vector<EdgeTurned> turned = some_turns(4);
    const Job job = job_of(4, turned, turned, {}, heavy);
    const Identification result =
        test::identify_lengths(heavy, job.epochs, with_prior(uncertain({"mass:20%"})));
    ASSERT_EQ(result.status, IdentificationStatus::converged) << result.message;
    EXPECT_EQ(result.trust.verdict(), Trust::Verdict::passed);
    EXPECT_EQ(to_string(result.uncertain[0].parameter.kind), "mass");
}

TEST(Epochs, AKnownLoadThatIsNotGivenIsNamed) {
    CableNetData data = net().data();
    data.loads = Points::Zero(3, net().node_count());
    data.loads(2, net().free_nodes()[24]) = -1500.0;
    Job job = job_of(4, {}, {});
    job.epochs[1].survey.form += move_under(data, net(), 4);
    const Identification result = test::identify_lengths(net(), job.epochs, with_prior());
    EXPECT_NE(result.trust.verdict(), Trust::Verdict::passed);
}

/// @param change of a sound job
template <class Error = std::invalid_argument>
void expect_refused(const std::function<void(std::vector<Epoch>&)>& change, const char* words) {
    std::vector<Epoch> epochs = job_as_given(1, some_turns(1)).epochs;
    change(epochs);
    EXPECT_THAT([&] { static_cast<void>(test::identify_lengths(net(), epochs, with_prior())); },
                ThrowsMessage<Error>(HasSubstr(words)));
}

TEST(Epochs, RefuseWhatIsNotForSeveralSurveys) {
    using Epochs = std::vector<Epoch>;
    expect_refused([](Epochs& all) { all.pop_back(); }, "at least two surveys");
    const auto make_exact = [](Epochs& all) { all[1].survey.noise_std.setZero(); };
    expect_refused<EpochError>(make_exact, "noise");
    std::vector<Epoch> exact = job_as_given(1, some_turns(1)).epochs;
    make_exact(exact);
    try {
        static_cast<void>(test::identify_lengths(net(), exact, with_prior()));
    } catch (const EpochError& error) {
        EXPECT_EQ(error.epoch(), 1U);
    }
    expect_refused<SurveyError>([](Epochs& all) { all[1].survey = all[0].survey; },
                                "counted twice");
    expect_refused(
        [](Epochs& all) {
            all[1].turned.push_back({.edge = net().interior_edges()[0], .stroke = 1e-3});
        },
        "expected an adjustable one");
    expect_refused([](Epochs& all) { all[1].loads = Points::Constant(3, net().node_count(), 1.0); },
                   "none since without them");
    expect_refused(
        [](Epochs& all) {
            all[1].turned.clear();
            all[1].loads = Points::Constant(3, 2, 1.0);
        },
        "one finite force a node");
    // Each less than a quarter of its length, and together more.
    expect_refused(
        [](Epochs& all) {
            const int edge = all[1].turned[0].edge;
            all[1].turned = {{.edge = edge, .stroke = 0.2 * net().unstressed_lengths()(edge)}};
            all.push_back(all[1]);
        },
        "until survey 3");
}

}  // namespace taut::of_epochs
