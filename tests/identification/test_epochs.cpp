// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against surveys that are put together wrong: a posterior that is not that of all of them,
// turns or cables not as given without a finding, false alarms for sound ones.
#include "taut/identification/epochs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "identification/simulated_survey.hpp"
#include "taut/adjustment/built_net.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace of_epochs {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr LengthPrior prior{LengthPrior::Kind::uniform, 0.005};
constexpr double noise = 0.5e-3;

const CableNet& net() {
    static const CableNet saddle = hypar(9, 9);
    return saddle;
}

Points points_of(const json& rows) {
    Points result(3, std::ssize(rows));
    for (size_t i = 0; i < rows.size(); ++i) {
        const auto row = rows[i].get<std::vector<double>>();
        result.col(static_cast<Eigen::Index>(i)) = Eigen::Vector3d::Map(row.data());
    }
    return result;
}

Eigen::VectorXd vector_of(const json& numbers) {
    const auto values = numbers.get<std::vector<double>>();
    return Eigen::VectorXd::Map(values.data(), std::ssize(values));
}

Survey survey_of(const CableNet& of, Points form, double std, const std::vector<int>& surveyed) {
    Survey survey{.form = std::move(form),
                  .noise_std = Points::Constant(3, of.node_count(), std),
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
    for (int e = 0; e < std::ssize(data.edges); ++e) {
        if (std::ranges::any_of(data.edges[e], [&](int node) {
                return std::ranges::find(data.supports, node) != data.supports.end();
            })) {
            data.adjustable.push_back(e);
        }
    }
    const CableNet small(data);
    std::vector<Epoch> epochs;
    for (const json& given : reference["epochs"]) {
        Epoch epoch{.survey = survey_of(small, points_of(given["form"]), reference["noise"],
                                        given["surveyed"].get<std::vector<int>>()),
                    .turned = {}};
        for (const json& one : given["turned"]) {
            epoch.turned.push_back(
                {.edge = one["edge"], .stroke = one["stroke"], .std = one["std"]});
        }
        epochs.push_back(std::move(epoch));
    }
    IdentifyOptions options;
    options.prior = LengthPrior{LengthPrior::Kind::normal, reference["law"]};
    options.prior_exact = true;
    const Identification result = identify_epochs(small, epochs, options);
    ASSERT_EQ(result.status, IdentificationStatus::converged);
    const Eigen::VectorXd expected = vector_of(reference["deviations"]);
    const Eigen::VectorXd stds = vector_of(reference["stds"]);
    ASSERT_EQ(std::ssize(result.edges), expected.size());
    for (size_t i = 0; i < result.edges.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        EXPECT_NEAR(result.edges[i].length_deviation, expected(k), 0.02 * stds(k));
        EXPECT_NEAR(result.edges[i].std, stds(k), 0.02 * stds(k));
    }
    const Points form = points_of(reference["last_form"]);
    EXPECT_LT((result.predicted.form - form).cwiseAbs().maxCoeff(), 2e-5);
}

/// A net as built, surveyed before and after some edges were turned.
struct Job {
    Eigen::VectorXd deviations;  ///< m_I, at first
    std::vector<Epoch> epochs;
};

std::vector<EdgeTurned> some_turns(std::uint64_t seed, double actuator_std = 0.0) {
    std::mt19937_64 random(seed);
    std::vector<EdgeTurned> turned;
    for (const int edge : net().adjustable_edges()) {
        if (random() % 2 == 0) {
            const double stroke = std::uniform_real_distribution<double>(-8e-3, 8e-3)(random);
            turned.push_back({.edge = edge, .stroke = stroke, .std = actuator_std});
        }
    }
    return turned;
}

/// @param done what was turned in truth; by default as given
/// @param slip change of interior lengths in between (m_I); empty: none
/// @param built the net with its true supports
Job job_of(std::uint64_t seed, const std::vector<EdgeTurned>& given,
           const std::vector<EdgeTurned>& done, const Eigen::VectorXd& slip = {},
           const CableNet& built = net()) {
    const test::SimulatedSurvey first = test::simulate(built, prior, noise, seed);
    const CableNet after = turned_net(built, done);
    test::SimulatedSurvey second =
        test::simulate(after, prior, noise, seed, [&](Eigen::VectorXd& deviations) {
            if (slip.size() > 0) {
                deviations += slip;
            }
        });
    // simulate() draws the same noise for the same seed.
    std::mt19937_64 random(seed + 1000);
    std::normal_distribution<double> normal(0.0, noise);
    second.survey.form = second.truth.form;
    for (const int node : net().free_nodes()) {
        for (int k = 0; k < 3; ++k) {
            second.survey.form(k, node) += normal(random);
        }
    }
    return {.deviations = first.deviations,
            .epochs = {{.survey = first.survey, .turned = {}},
                       {.survey = second.survey, .turned = given}}};
}

IdentifyOptions with_prior() {
    IdentifyOptions options;
    options.prior = prior;
    options.draws = 0;
    return options;
}

TEST(Epochs, DetermineMoreThanOneSurvey) {
    double alone = 0.0;  // root mean square errors
    double both = 0.0;
    double inside = 0.0;
    constexpr int jobs = 3;
    for (std::uint64_t seed = 1; seed <= jobs; ++seed) {
        const std::vector<EdgeTurned> turned = some_turns(seed);
        const Job job = job_of(seed, turned, turned);
        const Identification first = identify(net(), job.epochs[0].survey, with_prior());
        alone += std::sqrt(test::squared_error(first, job.deviations)) / jobs;
        const Identification result = identify_epochs(net(), job.epochs, with_prior());
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
    Survey again = first.survey;
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal(0.0, noise);
    for (const int node : dome.free_nodes()) {
        for (int k = 0; k < 3; ++k) {
            again.form(k, node) = first.truth.form(k, node) + normal(random);
        }
    }
    const auto mean_std_of_struts = [&](const Identification& found) {
        double sum = 0.0;
        int count = 0;
        for (const IdentifiedEdge& edge : found.edges) {
            sum += dome.is_strut(edge.edge) ? edge.std : 0.0;
            count += dome.is_strut(edge.edge) ? 1 : 0;
        }
        return sum / count;
    };
    const Identification alone = identify(dome, first.survey, with_prior());
    const std::vector<Epoch> epochs{{.survey = first.survey, .turned = {}},
                                    {.survey = again, .turned = {}}};
    const Identification both = identify_epochs(dome, epochs, with_prior());
    EXPECT_LT(mean_std_of_struts(both), 0.85 * mean_std_of_struts(alone));
}

/// What no survey shows stays uncertain, however many there are, and accuses nothing.
TEST(Epochs, DoNotAverageSupportsThatAreOff) {
    constexpr double off = 1e-3;
    IdentifyOptions options = with_prior();
    double inside_if_known = 0.0;
    double inside = 0.0;
    constexpr int jobs = 6;
    for (std::uint64_t seed = 1; seed <= jobs; ++seed) {
        std::mt19937_64 random(seed + 500);
        std::normal_distribution<double> normal(0.0, off);
        CableNetData data = net().data();
        for (const int node : net().supports()) {
            for (int axis = 0; axis < 3; ++axis) {
                data.nodes(axis, node) += normal(random);
            }
        }
        const std::vector<EdgeTurned> turned = some_turns(seed);
        const Job job = job_of(seed, turned, turned, {}, CableNet(std::move(data)));
        options.uncertain = {};
        options.prior_exact = true;
        inside_if_known +=
            test::coverage(identify_epochs(net(), job.epochs, options), job.deviations) / jobs;
        options.prior_exact = false;
        options.uncertain = {parse_uncertain_parameter("supports:1mm")};
        const Identification result = identify_epochs(net(), job.epochs, options);
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
    IdentifyOptions options = with_prior();
    options.draws = 100;
    options.assume_site = true;
    constexpr std::array<std::uint64_t, 3> seeds{1, 2, 3};
    double inside = 0.0;
    for (const std::uint64_t seed : seeds) {
        const test::SimulatedSurvey first = test::simulate(built, prior, noise, seed);
        const double mean =
            tensions(built, with_length_deviations(built, first.deviations), first.truth.form)
                .mean();
        const Identification found =
            identify_epochs(net(), job_of(seed, {}, {}, {}, built).epochs, options);
        const DrawnEstimate& drawn = found.drawn.mean_tension;
        ASSERT_GT(drawn.std, 0.0);
        EXPECT_LT(std::abs(drawn.mean - mean), 2.5 * drawn.std);
        inside += test::coverage(found, first.deviations) / std::ssize(seeds);
    }
    EXPECT_GT(inside, 0.9);
}

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
            const Identification result = identify_epochs(net(), job.epochs, with_prior());
            ASSERT_EQ(result.epochs.size(), 2U);
            const std::vector<LengthChange>& changes = result.epochs[1].changes;
            ASSERT_EQ(changes.size(), 1U) << seed;
            EXPECT_EQ(changes[0].edge, edge);
            EXPECT_NEAR(changes[0].change, change, 5.0 * changes[0].std);
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

TEST(Epochs, AreRefusedWhereTheTurnsAreOfAnotherDay) {
    const Job job = job_of(1, some_turns(1), some_turns(2));
    const Identification result = identify_epochs(net(), job.epochs, with_prior());
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
    const Identification result = identify_epochs(net(), job.epochs, with_prior());
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
        identify_epochs(net(), job_of(1, given, done).epochs, with_prior());
    EXPECT_EQ(result.trust.verdict(), Trust::Verdict::failed);
    EXPECT_TRUE(result.epochs[1].changes.empty());
    EXPECT_NEAR(result.epochs[1].stroke_factor, -1.0, 4.0 * result.epochs[1].stroke_factor_std);
    EXPECT_THAT(result.trust.findings.front().reason, HasSubstr("times as far as given"));
}

TEST(Epochs, DoNotBlameAllTurnsForOne) {
    IdentifyOptions options = with_prior();
    options.uncertain = {parse_uncertain_parameter("supports:1mm")};
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const std::vector<EdgeTurned> given = some_turns(seed);
        std::vector<EdgeTurned> done = given;
        const auto largest = std::ranges::max_element(
            done, {}, [](const EdgeTurned& one) { return std::abs(one.stroke); });
        largest->stroke *= -1.0;
        const Identification result =
            identify_epochs(net(), job_of(seed, given, done).epochs, options);
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
        identify_epochs(net(), job_of(1, given, done).epochs, with_prior());
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
            const Identification result = identify_epochs(net(), job.epochs, with_prior());
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
    std::mt19937_64 random(99);
    std::normal_distribution<double> normal(0.0, noise);
    std::vector<Epoch> epochs(2);
    for (Epoch& epoch : epochs) {
        epoch.survey = first.survey;
        epoch.survey.form =
            first.truth.form.unaryExpr([&](double place) { return place + normal(random); });
    }
    const Identification result = identify_epochs(net(), epochs, with_prior());
    std::vector<int> named;
    for (const LengthChange& change : result.epochs[0].changes) {
        named.push_back(change.edge);
        EXPECT_NEAR(std::abs(change.change), 6e-3, 5.0 * change.std);
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
    const Identification result = identify_epochs(net(), job.epochs, with_prior());
    for (const ParameterEstimate& estimate : result.uncertain) {
        EXPECT_NO_THROW(check_uncertain_parameters(net(), {estimate.parameter}));
    }
}

/// The same survey in other digits, and in another frame: its errors are in both.
TEST(Epochs, NameOneSurveyGivenTwice) {
    const std::vector<EdgeTurned> turned = some_turns(4);
    Job job = job_of(4, turned, turned);
    EXPECT_EQ(identify_epochs(net(), job.epochs, with_prior()).trust.verdict(),
              Trust::Verdict::passed);
    job.epochs[1].turned.clear();
    job.epochs[1].survey.form = job.epochs[0].survey.form.unaryExpr(
        [](double place) { return 1e-4 * std::round(1e4 * place); });
    EXPECT_EQ(identify_epochs(net(), job.epochs, with_prior()).trust.findings.back().kind,
              Trust::Finding::Kind::repeated_survey);
    job.epochs[1].survey.form.colwise() += Eigen::Vector3d(1e-3, -2e-3, 3e-3);
    for (Epoch& epoch : job.epochs) {
        epoch.survey.frame_is_unknown = true;
    }
    EXPECT_EQ(identify_epochs(net(), job.epochs, with_prior()).trust.findings.back().kind,
              Trust::Finding::Kind::repeated_survey);
}

TEST(Epochs, SayThatThePriorIsAnother) {
    const std::vector<EdgeTurned> turned = some_turns(2);
    const Job job = job_of(2, turned, turned);
    IdentifyOptions options = with_prior();
    options.prior = LengthPrior{LengthPrior::Kind::uniform, 1e-3};
    const Identification result = identify_epochs(net(), job.epochs, options);
    EXPECT_TRUE(result.contradicted_prior);
    EXPECT_NE(result.trust.verdict(), Trust::Verdict::passed);
    EXPECT_EQ(result.trust.findings[0].kind, Trust::Finding::Kind::prior);
    EXPECT_THAT(result.trust.findings[0].reason, HasSubstr("Survey 1: "));
    EXPECT_THAT(result.how, HasSubstr("that the first survey shows"));
    EXPECT_GT(test::coverage(result, job.deviations), 0.9);
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
        test::SimulatedSurvey second =
            test::simulate(turned_net(loose, tightened), prior, noise, seed);
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal(0.0, noise);
        second.survey.form =
            second.truth.form.unaryExpr([&](double place) { return place + normal(random); });
        const Identification result =
            identify_epochs(loose,
                            std::vector<Epoch>{{.survey = first.survey, .turned = {}},
                                               {.survey = second.survey, .turned = tightened}},
                            with_prior());
        ASSERT_EQ(result.status, IdentificationStatus::converged) << seed;
        for (size_t i = 0; i < result.edges.size(); ++i) {
            const IdentifiedEdge& edge = result.edges[i];
            if (std::ranges::find(first.truth.slack_edges, edge.edge) !=
                first.truth.slack_edges.end()) {
                const double truth = first.deviations(static_cast<Eigen::Index>(i));
                ++slack;
                known += edge.lower <= truth && truth <= edge.upper ? 1 : 0;
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
    std::mt19937_64 random(9);
    std::normal_distribution<double> normal(0.0, noise);
    Epoch second{.survey = first.survey, .turned = {}};
    second.survey.form =
        first.truth.form.unaryExpr([&](double place) { return place + normal(random); });
    const std::vector<Epoch> epochs{{.survey = first.survey, .turned = {}}, second};
    const Identification result = identify_epochs(fixed, epochs, with_prior());
    EXPECT_EQ(result.trust.verdict(), Trust::Verdict::passed);
    EXPECT_GT(test::coverage(result, first.deviations), 0.9);
    const Identification alone = identify(fixed, first.survey, with_prior());
    EXPECT_LT(test::squared_error(result, first.deviations),
              test::squared_error(alone, first.deviations));
}

/// A plan keeps its limits over these: adjustable lengths are drawn with interior ones, as widely
/// as they are known.
TEST(Epochs, DrawTurnsAndLengths) {
    const std::vector<EdgeTurned> turned = some_turns(6, 0.5e-3);
    const Job job = job_of(6, turned, turned);
    IdentifyOptions options = with_prior();
    options.draws = 200;
    const Identification result = identify_epochs(net(), job.epochs, options);
    ASSERT_TRUE(result.draws);
    const Eigen::MatrixXd& drawn = result.draws->adjustable_deviations;
    ASSERT_EQ(drawn.rows(), std::ssize(net().adjustable_edges()));
    ASSERT_EQ(drawn.cols(), result.draws->count());
    ASSERT_EQ(result.uncertain.size(), turned.size());
    double ratio = 0.0;
    for (const ParameterEstimate& one : result.uncertain) {
        const auto row = std::ranges::find(net().adjustable_edges(), one.edge) -
                         net().adjustable_edges().begin();
        const Eigen::VectorXd of_edge = drawn.row(row);
        const double std = std::sqrt((of_edge.array() - of_edge.mean()).square().mean());
        EXPECT_NEAR(of_edge.mean(), one.mean, 0.5 * one.std);
        ratio += std / one.std / static_cast<double>(result.uncertain.size());
    }
    EXPECT_NEAR(ratio, 1.0, 0.1);
    double of_lengths = 0.0;
    for (size_t i = 0; i < result.edges.size(); ++i) {
        const Eigen::VectorXd of_edge =
            result.draws->length_deviations.row(static_cast<Eigen::Index>(i));
        const double std = std::sqrt((of_edge.array() - of_edge.mean()).square().mean());
        of_lengths += std / result.edges[i].std / static_cast<double>(result.edges.size());
    }
    EXPECT_NEAR(of_lengths, 1.0, 0.1);
    const BuiltNet built = built_net_of(net(), result);
    EXPECT_EQ(built.length_draws.cols(), result.draws->count());
    const Eigen::VectorXd mean = built.length_draws.rowwise().mean();
    EXPECT_LT((mean - built.net.unstressed_lengths()).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(Epochs, MaySeeOtherTargetsInOtherFrames) {
    const std::vector<EdgeTurned> turned = some_turns(3);
    Job job = job_of(3, turned, turned);
    for (size_t i = 0; i < net().free_nodes().size(); ++i) {
        if (i % 3 != 2) {
            test::hide(net(), job.epochs[i % 3].survey, net().free_nodes()[i]);
        }
    }
    job.epochs[1].survey.form.colwise() += Eigen::Vector3d(3e-3, -2e-3, 1e-3);
    for (Epoch& epoch : job.epochs) {
        epoch.survey.frame_is_unknown = true;
    }
    const Identification result = identify_epochs(net(), job.epochs, with_prior());
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
    Points loads = Points::Zero(3, net().node_count());
    for (const int node : net().free_nodes()) {
        loads(2, node) = node % 3 == 0 ? -1500.0 : 0.0;
    }
    data.loads = loads;
    Job job = job_of(4, {}, {}, {}, built);
    job.epochs[1].survey.form =
        test::simulate(CableNet(data), prior, noise, 4).truth.form +
        (job.epochs[1].survey.form - test::simulate(built, prior, noise, 4).truth.form);
    IdentifyOptions options = with_prior();
    options.uncertain = {parse_uncertain_parameter("stiffness:10%")};
    const Identification unloaded =
        identify_epochs(net(), job_of(4, {}, {}, {}, built).epochs, options);
    job.epochs[1].loads = loads;
    const Identification loaded = identify_epochs(net(), job.epochs, options);
    ASSERT_EQ(loaded.status, IdentificationStatus::converged) << loaded.message;
    EXPECT_GT(unloaded.uncertain[0].std, 0.09);
    EXPECT_LT(loaded.uncertain[0].std, 0.04);
    EXPECT_NEAR(loaded.uncertain[0].mean, std::log(softer), 3.0 * loaded.uncertain[0].std);
    EXPECT_EQ(loaded.trust.verdict(), Trust::Verdict::passed);
    EXPECT_GT(loaded.epochs[1].load, 0.0);
    // It is of the net without that load, at the first survey.
    EXPECT_LT((loaded.predicted.form - job.epochs[0].survey.form).cwiseAbs().maxCoeff(), 5e-3);
}

/// What supports hide from two surveys does not cancel where a load turns the edges at them.
TEST(Epochs, AccuseNothingWhereSupportsAreOffUnderAKnownLoad) {
    IdentifyOptions options = with_prior();
    options.uncertain = {parse_uncertain_parameter("supports:1mm")};
    Points loads = Points::Zero(3, net().node_count());
    for (const int node : net().free_nodes()) {
        loads(2, node) = node % 5 == 0 ? -2000.0 : 0.0;
    }
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        std::mt19937_64 random(seed + 500);
        std::normal_distribution<double> normal(0.0, 1e-3);
        CableNetData data = net().data();
        for (const int node : net().supports()) {
            for (int axis = 0; axis < 3; ++axis) {
                data.nodes(axis, node) += normal(random);
            }
        }
        const CableNet built{CableNetData(data)};
        data.loads = loads;
        Job job = job_of(seed, {}, {}, {}, built);
        job.epochs[1].survey.form += test::simulate(CableNet(data), prior, noise, seed).truth.form -
                                     test::simulate(built, prior, noise, seed).truth.form;
        job.epochs[1].loads = loads;
        const Identification result = identify_epochs(net(), job.epochs, options);
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
    IdentifyOptions options = with_prior();
    options.uncertain = {parse_uncertain_parameter("mass:20%")};
    const Identification result = identify_epochs(heavy, job.epochs, options);
    ASSERT_EQ(result.status, IdentificationStatus::converged) << result.message;
    EXPECT_EQ(result.trust.verdict(), Trust::Verdict::passed);
    EXPECT_EQ(result.uncertain[0].parameter.name(), "mass");
}

TEST(Epochs, AKnownLoadThatIsNotGivenIsNamed) {
    CableNetData data = net().data();
    data.loads = Points::Zero(3, net().node_count());
    data.loads(2, net().free_nodes()[24]) = -1500.0;
    Job job = job_of(4, {}, {});
    job.epochs[1].survey.form += test::simulate(CableNet(data), prior, noise, 4).truth.form -
                                 test::simulate(net(), prior, noise, 4).truth.form;
    const Identification result = identify_epochs(net(), job.epochs, with_prior());
    EXPECT_NE(result.trust.verdict(), Trust::Verdict::passed);
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
    IdentifyOptions options;
    options.prior = prior;
    options.assume_site = true;
    options.uncertain = {parse_uncertain_parameter("creep:0.5%@rope")};
    int far = 0;
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Job job = job_of(seed, {}, {}, crept);
        const Identification found = identify_epochs(grouped, job.epochs, options);
        EXPECT_EQ(found.trust.verdict(), Trust::Verdict::passed) << found.trust.findings[0].reason;
        const auto creep =
            std::ranges::find(found.uncertain, UncertainParameter::Kind::creep,
                              [](const ParameterEstimate& one) { return one.parameter.kind; });
        ASSERT_NE(creep, found.uncertain.end());
        EXPECT_EQ(creep->parameter, options.uncertain[0]);
        EXPECT_LT(creep->std, 2e-3);
        far += std::abs(creep->mean - strain) > 2.0 * creep->std ? 1 : 0;
        EXPECT_NEAR(creep->mean, strain, 3.0 * creep->std);
        // Lengths are those of the first survey: the strain is beside them.
        EXPECT_GT(test::coverage(found, job.deviations), 0.85);
        // Not assumed, it is a small error of the lengths, and named where it is twice as large.
        IdentifyOptions without = options;
        without.uncertain.clear();
        EXPECT_GT(test::coverage(identify_epochs(grouped, job.epochs, without), job.deviations),
                  0.85);
        const Trust larger =
            identify_epochs(grouped, job_of(seed, {}, {}, 2.0 * crept).epochs, without).trust;
        ASSERT_EQ(larger.findings.size(), 1U);
        EXPECT_EQ(larger.findings[0].ids, std::vector<std::string>{"creep@rope"});
        EXPECT_NEAR(larger.findings[0].value.value(), 2.0 * strain, 3.0 * 1.5e-3);
        EXPECT_EQ(parse_uncertain_parameter(larger.findings[0].remedy->value).group, "rope");
        const Trust largest =
            identify_epochs(grouped, job_of(seed, {}, {}, 4.0 * crept).epochs, without).trust;
        EXPECT_NE(largest.verdict(), Trust::Verdict::passed);
        EXPECT_TRUE(std::ranges::any_of(largest.findings, [](const Trust::Finding& one) {
            return one.ids == std::vector<std::string>{"creep@rope"} && one.remedy->value.empty();
        }));
    }
    EXPECT_LE(far, 1);
    EXPECT_THAT([&] { (void)identify(grouped, job_of(1, {}, {}).epochs[0].survey, options); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("expected a second survey")));
    options.uncertain = {parse_uncertain_parameter("creep:0.9%@rope")};
    Job three = job_of(1, {}, {});
    three.epochs.push_back(job_of(2, {}, {}).epochs[1]);
    EXPECT_THAT([&] { (void)identify_epochs(grouped, three.epochs, options); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("more than 1 % in 3 surveys")));
}

TEST(Epochs, BlameAForceAndNoChangeOfLengths) {
    const Job job = job_of(3, {}, {}, {});
    IdentifyOptions options = with_prior();
    options.assume_site = true;
    const int edge = net().interior_edges()[60];
    const Identification without = identify_epochs(net(), job.epochs, options);
    const double tension = without.tensions(edge);
    options.forces.measurements = {{.edge = edge, .tension = 3.0 * tension, .std = 0.02 * tension}};
    const Identification found = identify_epochs(net(), job.epochs, options);
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
    std::mt19937_64 random(77);  // other noise than that of the second survey
    std::normal_distribution<double> normal(0.0, noise);
    for (const int node : job.epochs[2].survey.surveyed) {
        for (double& coordinate : job.epochs[2].survey.form.col(node)) {
            coordinate += normal(random);
        }
    }
    job.epochs[2].survey.noise_std *= std::sqrt(2.0);
    IdentifyOptions options;
    options.prior = prior;
    options.uncertain = {parse_uncertain_parameter("creep:0.5%")};
    const Identification found = identify_epochs(net(), job.epochs, options);
    ASSERT_EQ(found.status, IdentificationStatus::converged);
    EXPECT_NEAR(found.uncertain[0].mean, 2.5 * strain, 3.0 * found.uncertain[0].std);
    EXPECT_NEAR(found.uncertain[0].prior_std, std::sqrt(2.0) * 5e-3, 1e-9);
    EXPECT_EQ(found.uncertain[0].parameter, options.uncertain[0]);
}

TEST(Epochs, RefuseWhatIsNotForSeveralSurveys) {
    const std::vector<EdgeTurned> turned = some_turns(1);
    const Job job = job_of(1, turned, turned);
    const auto refused = [&](const std::vector<Epoch>& epochs, const IdentifyOptions& options) {
        return [=] { static_cast<void>(identify_epochs(net(), epochs, options)); };
    };
    EXPECT_THAT(refused({job.epochs[0]}, with_prior()),
                ThrowsMessage<std::invalid_argument>(HasSubstr("at least two surveys")));
    std::vector<Epoch> exact = job.epochs;
    exact[1].survey.noise_std.setZero();
    EXPECT_THAT(refused(exact, with_prior()), ThrowsMessage<EpochError>(HasSubstr("noise")));
    try {
        static_cast<void>(identify_epochs(net(), exact, with_prior()));
    } catch (const EpochError& error) {
        EXPECT_EQ(error.epoch(), 1U);
    }
    std::vector<Epoch> wrong = job.epochs;
    wrong[1].survey = wrong[0].survey;
    EXPECT_THAT(refused(wrong, with_prior()),
                ThrowsMessage<SurveyError>(HasSubstr("counted twice")));
    wrong = job.epochs;
    wrong[1].turned.push_back({.edge = net().interior_edges()[0], .stroke = 1e-3});
    EXPECT_THAT(refused(wrong, with_prior()),
                ThrowsMessage<std::invalid_argument>(HasSubstr("expected an adjustable one")));
    wrong = job.epochs;
    wrong[1].loads = Points::Constant(3, net().node_count(), 1.0);
    EXPECT_THAT(refused(wrong, with_prior()),
                ThrowsMessage<std::invalid_argument>(HasSubstr("none since without them")));
    wrong[1].turned.clear();
    wrong[1].loads = Points::Constant(3, 2, 1.0);
    EXPECT_THAT(refused(wrong, with_prior()),
                ThrowsMessage<std::invalid_argument>(HasSubstr("one finite force a node")));
    // Each less than a quarter of its length, and together more.
    wrong = job.epochs;
    wrong[1].turned = {
        {.edge = turned[0].edge, .stroke = 0.2 * net().unstressed_lengths()(turned[0].edge)}};
    wrong.push_back(wrong[1]);
    EXPECT_THAT(refused(wrong, with_prior()),
                ThrowsMessage<std::invalid_argument>(HasSubstr("until survey 3")));
}

}  // namespace of_epochs
}  // namespace taut
