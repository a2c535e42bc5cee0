// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against estimates that are not the posterior mean and intervals of tension that are too
// narrow: held to long chains of other code (tests/data/posterior_reference.json, made by
// benchmarks/reference/posterior_chains.py).

#include "taut/identification/posterior_draws.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "identification/drawn_summary.hpp"
#include "identification/simulated_survey.hpp"
#include "support/identify_lengths.hpp"
#include "support/json_numbers.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/tensions.hpp"

namespace {

using namespace taut;
using Json = nlohmann::json;
using test::points_of;
using test::vector_of;

/// A net and survey of the reference, and the results of its chains.
struct Reference {
    Json json;
    CableNet net;
    Survey survey;
    std::optional<LengthPrior> prior;  ///< empty: none was given
    bool prior_exact = false;

    explicit Reference(const Json& of) : json(of), net(net_of(of)) {
        survey = test::planned_survey(net, of.at("noise"), of.at("hidden").get<std::set<int>>());
        survey.form = points_of(of.at("survey"));
        prior_exact = of.contains("bound");
        const Json& bound = prior_exact ? of.at("bound") : of.at("given");
        if (!bound.is_null()) {
            prior = LengthPrior{LengthPrior::Kind::uniform, bound};
        }
    }

    static CableNet net_of(const Json& of) {
        CableNetData data;
        data.nodes = points_of(of.at("nodes"));
        for (const Json& edge : of.at("edges")) {
            data.edges.push_back({edge[0], edge[1]});
        }
        const auto free = of.at("free").get<std::vector<int>>();
        for (int node = 0; node < data.nodes.cols(); ++node) {
            if (!std::ranges::binary_search(free, node)) {
                data.supports.push_back(node);
            }
        }
        data.axial_stiffness = vector_of(of.at("axial_stiffness"));
        data.unstressed_lengths = vector_of(of.at("unstressed_lengths"));
        const auto interior = of.at("interior").get<std::vector<int>>();
        for (int edge = 0; edge < std::ssize(data.edges); ++edge) {
            if (!std::ranges::binary_search(interior, edge)) {
                data.adjustable.push_back(edge);
            }
        }
        return CableNet(data);
    }
};

std::vector<Reference> references() {
    std::ifstream stream(TAUT_TEST_DATA_DIR "/posterior_reference.json");
    std::vector<Reference> all;
    const Json file = Json::parse(stream);
    for (const Json& one : file.at("cases")) {
        all.emplace_back(one);
    }
    return all;
}

TEST(PosteriorDraws, AgreeWithLongChainsOfOtherCode) {
    for (const Reference& reference : references()) {
        SCOPED_TRACE(reference.json.at("name").get<std::string>());
        const Identification found = test::identify_lengths(
            reference.net, reference.survey,
            {.prior = reference.prior, .prior_exact = reference.prior_exact, .draws = 2000});
        ASSERT_EQ(found.status, IdentificationStatus::converged) << found.message;
        ASSERT_FALSE(found.drawn.tensions.empty()) << found.draws->reason;
        // What lengths have in common, (length-trend), is estimated to first order.
        const double of_mean = reference.prior_exact ? 0.15 : 0.25;
        const double of_end = reference.prior_exact ? 0.3 : 0.45;
        const Eigen::VectorXd mean = vector_of(reference.json.at("mean"));
        const Eigen::VectorXd std_dev = vector_of(reference.json.at("std"));
        for (Eigen::Index i = 0; i < mean.size(); ++i) {
            const Eigen::VectorXd drawn = found.draws->length_deviations.row(i);
            const DrawnEstimate estimate = estimate_of(drawn);
            EXPECT_NEAR(estimate.mean, mean(i), of_mean * std_dev(i)) << i;
            EXPECT_NEAR(estimate.std_dev / std_dev(i), 1.0, 0.15) << i;
            EXPECT_NEAR(found.edges[i].length_deviation, mean(i), of_mean * std_dev(i)) << i;
            EXPECT_NEAR(found.edges[i].std_dev / std_dev(i), 1.0, 0.15) << i;
        }
        if (!reference.prior_exact) {  // (prior-mixture)
            const double prior_std = reference.json.at("prior_std");
            const double prior_std_std = reference.json.at("prior_std_std");
            EXPECT_NEAR(found.prior.std_dev, prior_std, 0.45 * prior_std_std);
            EXPECT_NEAR(found.prior.std_std / prior_std_std, 1.0, 0.3);
            EXPECT_NEAR(found.prior.uniform_probability, reference.json.at("uniform_probability"),
                        0.25);
            const Eigen::VectorXd lowest = vector_of(reference.json.at("lower"));
            const Eigen::VectorXd highest = vector_of(reference.json.at("upper"));
            for (Eigen::Index i = 0; i < mean.size(); ++i) {
                EXPECT_NEAR(found.edges[i].lower, lowest(i), of_end * std_dev(i)) << i;
                EXPECT_NEAR(found.edges[i].upper, highest(i), of_end * std_dev(i)) << i;
            }
        }
        const Eigen::VectorXd tension = vector_of(reference.json.at("tension_mean"));
        const Eigen::VectorXd tension_std = vector_of(reference.json.at("tension_std"));
        const Eigen::VectorXd lower = vector_of(reference.json.at("tension_lower"));
        const Eigen::VectorXd upper = vector_of(reference.json.at("tension_upper"));
        const Eigen::VectorXd slack = vector_of(reference.json.at("slack_probability"));
        // Beyond what a slack edge spans a uniform prior is taken as normal. Tensions of such an
        // edge and of its neighbours hardly spread.
        const bool has_slack = slack.maxCoeff() > 0.1;
        const double least_spread = has_slack ? tension_std.mean() : 0.0;
        for (Eigen::Index e = 0; e < tension.size(); ++e) {
            const DrawnTension& of_edge = found.drawn.tensions[e];
            const double spread = std::max(tension_std(e), least_spread);
            EXPECT_NEAR(of_edge.tension.mean, tension(e), of_mean * spread) << e;
            EXPECT_NEAR(of_edge.tension.std_dev, tension_std(e), 0.15 * spread) << e;
            EXPECT_NEAR(of_edge.tension.lower, lower(e), of_end * spread) << e;
            EXPECT_NEAR(of_edge.tension.upper, upper(e), (has_slack ? 0.45 : of_end) * spread) << e;
            EXPECT_NEAR(of_edge.slack_probability, slack(e), slack(e) > 0.1 ? 0.1 : 0.05) << e;
        }
    }
}

// Means and intervals are of draws that are nets: lengths, form and tensions of one belong
// together.
TEST(PosteriorDraws, AreInEquilibrium) {
    const CableNet net = hypar(4, 5);
    const LengthPrior prior{LengthPrior::Kind::uniform, 2e-3};
    test::SimulatedSurvey s = test::simulate(net, prior, 5e-4, 3);
    test::hide(net, s.survey, net.free_nodes()[7]);
    const Identification found =
        test::identify_lengths(net, s.survey, {.prior = prior, .draws = 20});
    ASSERT_TRUE(found.draws);
    const PosteriorDraws& draws = *found.draws;
    ASSERT_EQ(draws.count(), 20);
    for (int k = 0; k < draws.count(); ++k) {
        const Eigen::VectorXd lengths = with_length_deviations(net, draws.length_deviations.col(k));
        const Points form = with_free_coordinates(net, draws.forms.col(k));
        EXPECT_LT(out_of_balance_forces(net, lengths, form).cwiseAbs().maxCoeff(),
                  1e-9 * draws.tensions.col(k).mean());
        EXPECT_TRUE(draws.tensions.col(k).isApprox(tensions_of(net, lengths, form), 1e-12));
    }
    ASSERT_EQ(found.drawn.missing.size(), 1U);
    const DrawnPlace& place = found.drawn.missing.front();
    const Eigen::Vector3d truth = s.truth.form.col(place.node);
    EXPECT_TRUE((place.lower.array() < truth.array()).all()) << truth;
    EXPECT_TRUE((truth.array() < place.upper.array()).all()) << truth;
}

// Cables that stretch by less than their lengths are known to: which of them are slack, and how
// tight the others, the form hardly shows. The intervals are wide, and hold.
TEST(PosteriorDraws, ShowHowLittleIsKnownOfWhatIsSlack) {
    const CableNet net = test::stiffened(hypar(6, 6), 10.0);
    const LengthPrior prior{LengthPrior::Kind::uniform, 2e-3};
    constexpr int surveys = 6;
    double lengths = 0.0;
    int tensions_inside = 0;
    int means_inside = 0;
    for (std::uint64_t seed = 0; seed < surveys; ++seed) {
        const auto s = test::simulate(net, prior, 5e-4, seed);
        const Identification found = test::identify_lengths(
            net, s.survey, {.prior = prior, .prior_exact = true, .draws = 200});
        ASSERT_EQ(found.draws.value().reason, "") << seed;
        const Eigen::VectorXd truth = test::true_tensions(net, s);
        tensions_inside += test::tensions_held(found, truth);
        const DrawnEstimate& mean = found.drawn.mean_tension;
        means_inside += test::holds(mean, mean_weights(net).dot(truth)) ? 1 : 0;
        EXPECT_GT(mean.upper - mean.lower, 0.4 * mean.mean) << seed;
        lengths += test::coverage(found, s.deviations) / surveys;
    }
    EXPECT_GE(tensions_inside, 0.92 * surveys * net.edge_count());
    EXPECT_GE(means_inside, surveys - 1);
    EXPECT_GE(lengths, 0.92);
}

TEST(PosteriorDraws, KeepCablesTautThatWereSeenToBe) {
    const CableNet net = test::stiffened(hypar(6, 6), 10.0);
    const LengthPrior prior{LengthPrior::Kind::uniform, 2e-3};
    const auto s = test::simulate(net, prior, 5e-4, 0);
    IdentifyOptions options{.prior = prior, .prior_exact = true, .draws = 100};
    const Identification unmarked = test::identify_lengths(net, s.survey, options);
    const Eigen::VectorXd truth = test::true_tensions(net, s);
    for (const int edge : net.interior_edges()) {
        const double slack = unmarked.drawn.tensions[static_cast<size_t>(edge)].slack_probability;
        if (truth(edge) > 0.0 && slack > 0.1 && options.forces.taut.size() < 5) {
            options.forces.taut.push_back(edge);
        }
    }
    ASSERT_EQ(options.forces.taut.size(), 5U);
    const Identification marked = test::identify_lengths(net, s.survey, options);
    ASSERT_EQ(marked.draws.value().reason, "");
    EXPECT_EQ(marked.draws->method, "Hamiltonian Monte Carlo");
    for (const int edge : options.forces.taut) {
        EXPECT_EQ(marked.drawn.tensions[static_cast<size_t>(edge)].slack_probability, 0.0) << edge;
    }
}

// Without a prior and with all that taut assumes on a site a few samples have to be fitted by
// themselves.
TEST(PosteriorDraws, ShowTensionsOfSoundSurveys) {
    const CableNet net = hypar(7, 7);
    const LengthPrior prior{LengthPrior::Kind::uniform, 3e-3};
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const auto s = test::simulate(net, prior, 5e-4, seed);
        const Identification found =
            test::identify_lengths(net, s.survey, {.assume_site = true, .draws = 100});
        EXPECT_EQ(found.draws.value().reason, "") << seed;
    }
}

// Strands that bed in: over the flat part of their tension law a line at the fit leads astray.
TEST(PosteriorDraws, FollowTensionLawsThatBend) {
    const CableNet net = steel_roof();
    const LengthPrior prior{LengthPrior::Kind::uniform, 2e-3};
    const auto s = test::simulate(net, prior, 5e-4, 1);
    const Identification found =
        test::identify_lengths(net, s.survey, {.prior = prior, .assume_site = true, .draws = 60});
    ASSERT_EQ(found.draws.value().reason, "");
    EXPECT_TRUE(found.draws->is_refitted);
    EXPECT_GE(test::tensions_held(found, test::true_tensions(net, s)), 0.85 * net.edge_count());
    EXPECT_GE(test::coverage(found, s.deviations), 0.9);
}

TEST(PosteriorDraws, AreTheSameFromTheSameSeedWithAnyNumberOfThreads) {
    const CableNet net = hypar(3, 4);
    const LengthPrior prior{LengthPrior::Kind::normal, 2e-3};
    const auto s = test::simulate(net, prior, 5e-4, 1);
    const auto draws = [&](std::uint64_t seed) {
        return test::identify_lengths(net, s.survey, {.prior = prior, .draws = 10, .seed = seed})
            .draws->length_deviations;
    };
    const Eigen::MatrixXd by_all_threads = draws(1);
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(draws(1), by_all_threads);
    EXPECT_NE(draws(2), by_all_threads);
}

TEST(PosteriorDraws, EndIntervalsAtOrderStatistics) {
    // Of 199 values 0 .. 198 in any order the fifth from either end.
    Eigen::VectorXd values(199);
    for (int k = 0; k < 199; ++k) {
        values(k) = (83 * k) % 199;
    }
    const DrawnEstimate estimate = estimate_of(values);
    EXPECT_DOUBLE_EQ(estimate.mean, 99.0);
    EXPECT_NEAR(estimate.lower, 4.0, 1e-9);
    EXPECT_NEAR(estimate.upper, 194.0, 1e-9);
}

TEST(PosteriorDraws, OfFewAreNoSurerThanANormalDistributionLetsThemBe) {
    // 0 .. 9: t of nine degrees of freedom is 2.262157.
    const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(10, 0.0, 9.0);
    const double half = 2.262157 * std::sqrt(82.5 / 9.0) * std::sqrt(1.1);
    EXPECT_NEAR(estimate_of(values).lower, 4.5 - half, 1e-5);
    EXPECT_NEAR(estimate_of(values).upper, 4.5 + half, 1e-5);
    const CableNet net = hypar(2, 2);
    EXPECT_EQ(tension_of(net, 0, values).lower, 0.0);
}

TEST(PosteriorDraws, OneOrBelowZeroOrTooManyForMemoryAreRefused) {
    const Reference reference = references().front();
    EXPECT_THROW(check_draws(reference.net, -1), std::invalid_argument);
    EXPECT_THROW(check_draws(reference.net, 1'000'000'000'000), std::invalid_argument);
    EXPECT_THROW(check_draws(reference.net, 1), std::invalid_argument);
    EXPECT_NO_THROW(check_draws(reference.net, 0));
    EXPECT_NO_THROW(check_draws(reference.net, 2));
    EXPECT_THROW((void)test::identify_lengths(reference.net, reference.survey, {.draws = -1}),
                 std::invalid_argument);
}

}  // namespace
