// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against intervals that leave out uncertain parameters.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include "identification/parameter_spread.hpp"
#include "identification/uncertain_nets.hpp"
#include "sampling/uncertain_widths.hpp"
#include "support/identify_lengths.hpp"
#include "taut/statics/frame.hpp"
#include "taut/statics/plausibility.hpp"

namespace of_forces {

/// The true value of an estimate.
double truth_of(const ModelPerturbation& c, const CableNet& net,
                const ParameterEstimate& estimate) {
    switch (estimate.parameter.kind) {
        case UncertainParameter::Kind::stiffness:
            return c.stiffness(0);
        case UncertainParameter::Kind::stiffness_each:
            return c.stiffness(estimate.edge);
        case UncertainParameter::Kind::temperature:
            return c.thermal(0) / net.data().expansion(0);
        case UncertainParameter::Kind::supports:
            return c.supports(estimate.axis, estimate.node);
        case UncertainParameter::Kind::adjustable:
            return c.adjustable(estimate.edge);
        case UncertainParameter::Kind::loads:
            return c.loads;
        case UncertainParameter::Kind::loads_each:
            return c.own_loads(estimate.axis, estimate.node);
        case UncertainParameter::Kind::support_stiffness:
            return c.support_stiffness;
        case UncertainParameter::Kind::forces:
        case UncertainParameter::Kind::mass:
        case UncertainParameter::Kind::test_loads:
        case UncertainParameter::Kind::creep:
        case UncertainParameter::Kind::slip:
            break;  // not drawn here
    }
    return 0.0;
}

class UncertainParameters : public testing::TestWithParam<std::vector<UncertainParameter>> {};

struct Count {
    int inside = 0;
    int all = 0;
    void add(bool is_inside) {
        inside += is_inside ? 1 : 0;
        ++all;
    }
    [[nodiscard]] double part() const { return static_cast<double>(inside) / all; }
};

TEST_P(UncertainParameters, AreInTheIntervalsOfLengthsAndTensions) {
    const std::vector<UncertainParameter> given = GetParam();
    const bool is_elastic = std_of(given, UncertainParameter::Kind::support_stiffness) > 0.0;
    const CableNet net = is_elastic ? on_springs(loaded_net()) : loaded_net();
    double lengths = 0.0;
    double tensions = 0.0;
    std::map<UncertainParameter::Kind, Count> of_parameters;
    constexpr int surveys = 16;
    for (int k = 0; k < surveys; ++k) {
        const Built truth = built(net, given, 100 + k);
        const Identification found =
            test::identify_lengths(net, truth.simulated.survey, options_with(given, 100));
        ASSERT_EQ(found.status, IdentificationStatus::converged) << found.message;
        lengths += coverage(found, truth.simulated.deviations) / surveys;
        ASSERT_FALSE(found.drawn.tensions.empty()) << found.draws->reason;
        tensions += tensions_held(found, truth.tensions) / (1.0 * surveys * net.edge_count());
        for (const ParameterEstimate& estimate : found.uncertain) {
            // The mixture over priors may be a little wider than each of its parts.
            EXPECT_LE(estimate.std_dev, 1.001 * estimate.prior_std);
            of_parameters[estimate.parameter.kind].add(
                std::abs(estimate.mean - truth_of(truth.perturbation, net, estimate)) <=
                half_interval_95 * estimate.std_dev);
        }
    }
    EXPECT_NEAR(lengths, 0.95, 0.03);
    EXPECT_NEAR(tensions, 0.95, 0.04);
    for (const auto& [kind, count] : of_parameters) {
        // 16 of a common one, far more of the others.
        EXPECT_GE(count.part(), count.all > 100 ? 0.92 : 0.75) << to_string(kind);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Map, UncertainParameters,
    testing::Values(uncertain({"supports:1mm"}), uncertain({"stiffness-each:3%"}),
                    uncertain({"adjustable:0.5mm"}), uncertain({"loads:20N"}),
                    uncertain({"stiffness:5%", "loads:10%"}),
                    uncertain({"supports:1mm", "support-stiffness:10%"}),
                    uncertain({"stiffness:5%", "supports:1mm", "temperature:15K",
                               "adjustable:0.5mm", "loads:20N"})));

/// The weight has the error of the mass, known loads have theirs, and all others that of loads.
TEST(Perturbation, GivesEachLoadOneError) {
    CableNetData data = loaded_net().data();
    data.mass = Eigen::VectorXd::Constant(std::ssize(data.edges), 2.0);
    const Points others = data.loads;
    Points known = Points::Zero(3, others.cols());
    known(2, loaded_net().free_nodes()[3]) = -500.0;
    data.loads += known;
    const CableNet net(data);
    const Points weight = net.loads() - data.loads;
    std::vector<ParameterEstimate> estimates;
    for (const char* given : {"loads:5%", "mass:3%", "test-loads:2%"}) {
        estimates.push_back({.parameter = uncertain({given})[0]});
    }
    estimates[0].mean = 0.05;
    estimates[1].mean = -0.02;
    estimates[2].mean = 0.03;
    const CableNet built =
        net_under(net, perturbation_of(net, estimates, known), net.unstressed_lengths());
    EXPECT_LT((built.loads() - 1.05 * others - 0.98 * weight - 1.03 * known).norm(), 1e-9);
}

TEST(Struts, AreIdentifiedWithTheCables) {
    const CableNet net = cable_dome();
    const auto given = uncertain({"stiffness:5%", "stiffness-each:5%", "adjustable:0.5mm"});
    double lengths = 0.0;
    Count of_cables;
    Count of_struts;
    Count mean;
    for (int k = 0; k < 16; ++k) {
        const Built truth = built(net, given, 300 + k);
        const Identification found =
            test::identify_lengths(net, truth.simulated.survey, options_with(given, 100));
        ASSERT_EQ(found.status, IdentificationStatus::converged) << found.message;
        EXPECT_EQ(found.trust.verdict(), Trust::Verdict::passed);
        lengths += coverage(found, truth.simulated.deviations) / 16;
        for (const IdentifiedEdge& edge : found.edges) {
            EXPECT_NE(edge.status, EdgeStatus::slack);
        }
        ASSERT_FALSE(found.drawn.tensions.empty()) << found.draws->reason;
        for (const DrawnTension& drawn : found.drawn.tensions) {
            (net.is_strut(drawn.edge) ? of_struts : of_cables)
                .add(holds(drawn.tension, truth.tensions(drawn.edge)));
            EXPECT_EQ(drawn.tension.upper < 0.0, net.is_strut(drawn.edge));
            EXPECT_EQ(drawn.slack_probability, 0.0);
        }
        mean.add(holds(found.drawn.mean_tension, mean_weights(net).dot(truth.tensions)));
    }
    EXPECT_NEAR(lengths, 0.95, 0.03);
    // The dome has one state of self-stress: in a survey almost all tensions are inside, or none.
    EXPECT_GE(of_cables.part(), 0.85);
    EXPECT_GE(of_struts.part(), 0.85);
    EXPECT_GE(mean.part(), 0.75);
}

TEST(Struts, MayBeMeasuredInCompression) {
    const CableNet net = cable_dome();
    const int strut = net.data().groups.at("strut")[4];
    const Built truth = built(net, {}, 9);
    IdentifyOptions options = options_with({}, 100);
    const auto std_of_strut = [&](const Identification& found) {
        return found.drawn.tensions[strut].tension.std_dev;
    };
    const double without =
        std_of_strut(test::identify_lengths(net, truth.simulated.survey, options));
    options.forces.measurements = {
        {.edge = strut, .tension = truth.tensions(strut), .std_dev = 0.2 * without}};
    const Identification found = test::identify_lengths(net, truth.simulated.survey, options);
    EXPECT_LT(std_of_strut(found), 0.3 * without);
    EXPECT_NEAR(found.drawn.tensions[strut].tension.mean, truth.tensions(strut), without);
    options.forces.measurements = {};
    options.forces.slack = {strut};
    EXPECT_THAT([&] { (void)test::identify_lengths(net, truth.simulated.survey, options); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("it is a strut")));
}

/// The same lengths, and standard deviations, but for such parts of these.
void expect_same_lengths(const Identification& found, const Identification& expected,
                         double of_lengths, double of_stds) {
    ASSERT_EQ(found.edges.size(), expected.edges.size());
    for (size_t i = 0; i < found.edges.size(); ++i) {
        const IdentifiedEdge& edge = expected.edges[i];
        EXPECT_NEAR(found.edges[i].length_deviation, edge.length_deviation,
                    of_lengths * edge.std_dev);
        EXPECT_NEAR(found.edges[i].std_dev, edge.std_dev, of_stds * edge.std_dev);
    }
}

TEST(ElasticSupports, MoveWithTheFrameOfTheSurvey) {
    const CableNet net = on_springs(loaded_net());
    const auto given = uncertain({"supports:1mm", "support-stiffness:10%"});
    Survey survey = built(net, given, 6).simulated.survey;
    survey.frame_is_unknown = true;
    const Identification found = test::identify_lengths(net, survey, options_with(given));
    const Eigen::Vector3d turn(1e-3, -2e-3, 1.5e-3);
    for (auto place : survey.form.colwise()) {
        place += turn.cross(Eigen::Vector3d(place)) + Eigen::Vector3d(4e-3, -3e-3, 6e-3);
    }
    const Identification moved = test::identify_lengths(net, survey, options_with(given));
    ASSERT_EQ(moved.status, IdentificationStatus::converged);
    expect_same_lengths(moved, found, 0.03, 0.01);
    EXPECT_LT((moved.tensions - found.tensions).cwiseAbs().maxCoeff(),
              2e-3 * found.tensions.mean());
    EXPECT_LT(moved.residuals.mean(), 2.0 * noise);
    for (size_t k = 0; k < found.uncertain.size(); ++k) {
        EXPECT_NEAR(moved.uncertain[k].mean, found.uncertain[k].mean,
                    0.03 * found.uncertain[k].std_dev);
    }
}

/// A third of the supports stand on one frame, on which each passes a part of its force on.
CableNet on_one_frame(const CableNet& rigid) {
    const CableNet springs = on_springs(rigid);
    FrameStiffness frame;
    for (const ElasticSupport& support : springs.elastic_supports()) {
        frame.supports.push_back(support.node);
    }
    const auto count = std::ssize(frame.supports);
    frame.stiffness.setZero(3 * count, 3 * count);
    for (Eigen::Index a = 0; a < count; ++a) {
        for (Eigen::Index b = 0; b < count; ++b) {
            const double part = a == b ? 1.0 : -0.9 / static_cast<double>(count);
            frame.stiffness.block<3, 3>(3 * a, 3 * b) =
                part * springs.elastic_supports()[0].stiffness;
        }
    }
    return on_frame(rigid, frame);
}

TEST(ElasticSupports, OnOneFrameAreInTheIntervalsOfLengthsTensionsAndStiffness) {
    const CableNet net = on_one_frame(loaded_net());
    ASSERT_GT(net.support_couplings().size(), 3U);
    const auto given = uncertain({"supports:1mm", "support-stiffness:10%"});
    double lengths = 0.0;
    double tensions = 0.0;
    Count of_factor;
    Count of_places;
    constexpr int surveys = 16;
    for (int k = 0; k < surveys; ++k) {
        const Built truth = built(net, given, 500 + k);
        const Identification found =
            test::identify_lengths(net, truth.simulated.survey, options_with(given, 100));
        ASSERT_EQ(found.status, IdentificationStatus::converged) << found.message;
        EXPECT_EQ(found.trust.verdict(), Trust::Verdict::passed);
        lengths += coverage(found, truth.simulated.deviations) / surveys;
        tensions += tensions_held(found, truth.tensions) / (1.0 * surveys * net.edge_count());
        // The net as identified has the form that was fitted.
        EXPECT_LT(found.residuals.mean(), 2.0 * noise);
        for (const ParameterEstimate& estimate : found.uncertain) {
            EXPECT_LE(estimate.std_dev, 1.001 * estimate.prior_std);
            (estimate.node >= 0 ? of_places : of_factor)
                .add(std::abs(estimate.mean - truth_of(truth.perturbation, net, estimate)) <=
                     half_interval_95 * estimate.std_dev);
        }
    }
    EXPECT_GE(of_places.part(), 0.92);
    EXPECT_NEAR(lengths, 0.95, 0.03);
    EXPECT_NEAR(tensions, 0.95, 0.04);
    EXPECT_GE(of_factor.part(), 0.75);
}

TEST(ElasticSupports, ThatStandFarFromTheirPlaceAreNamed) {
    const CableNet net = on_springs(loaded_net());
    const auto given = uncertain({"supports:1mm"});
    const int node = net.elastic_supports()[1].node;
    // Little: the place gives way. Much: the target there is left out, which may be right.
    for (const double shift : {0.0, 4e-3, 12e-3}) {
        CableNetData data = net.data();
        data.elastic_supports[1].place.x() += shift;
        const Survey survey = built(CableNet(data), given, 7).simulated.survey;
        const Identification found = test::identify_lengths(net, survey, options_with(given));
        EXPECT_EQ(found.trust.verdict(),
                  shift > 0.0 ? Trust::Verdict::doubtful : Trust::Verdict::passed);
        if (shift > 0.0) {
            EXPECT_EQ(found.trust.findings.front().kind,
                      shift < 10e-3 ? Trust::Finding::Kind::support : Trust::Finding::Kind::target);
            EXPECT_EQ(found.trust.findings.front().ids, std::vector{net.node_id(node)});
        }
    }
}

TEST(ElasticSupports, AreNoMissingCableWhereTheyStandUnloadedAtTheirNodes) {
    CableNetData data = hypar(5, 5).data();
    for (const int node : data.supports) {
        data.elastic_supports.push_back({.node = node,
                                         .stiffness = 1e7 * Eigen::Matrix3d::Identity(),
                                         .place = data.nodes.col(node)});
    }
    data.supports.clear();
    const CableNet net(std::move(data));
    EXPECT_TRUE(unit_warnings(net).empty());
    const Identification found =
        test::identify_lengths(net, simulate(net, prior, noise, 2).survey, options_with({}));
    EXPECT_EQ(found.trust.verdict(), Trust::Verdict::passed);
}

TEST(UncertainParameter, ThatIsAsGoodAsKnownChangesNothing) {
    const CableNet net = loaded_net();
    const Survey survey = built(net, {}, 3).simulated.survey;
    const Identification as_known = test::identify_lengths(net, survey, options_with({}));
    const auto all_but_known = uncertain(
        {"supports:0.0001mm", "stiffness:0.0001%", "adjustable:0.0001mm", "loads:0.0001N"});
    expect_same_lengths(test::identify_lengths(net, survey, options_with(all_but_known)), as_known,
                        0.02, 0.02);
}

// A form shows the ratio of tensions to loads: all tensions are as uncertain as the loads are.
TEST(UncertainParameter, LoadsOfASiteAreUncertain) {
    const CableNet net = loaded_net(-4000.0);
    CableNetData heavier = net.data();
    heavier.loads *= 1.05;
    const CableNet changed(std::move(heavier));
    const SimulatedSurvey s = simulate(changed, prior, noise, 3);
    const Eigen::VectorXd truth = true_tensions(changed, s);
    const auto inside = [&](const std::vector<UncertainParameter>& given) {
        IdentifyOptions options = options_with(given, 40);
        options.assume_site = given.empty();
        const Identification found = test::identify_lengths(net, s.survey, options);
        EXPECT_EQ(found.trust.verdict(), Trust::Verdict::passed);
        return tensions_held(found, truth);
    };
    EXPECT_GT(inside({}), 0.9 * net.edge_count());
    std::vector<UncertainParameter> exact = with_site_assumptions(net, {});
    std::erase_if(exact, [](const UncertainParameter& one) {
        return one.kind == UncertainParameter::Kind::loads;
    });
    EXPECT_LT(inside(exact), 0.8 * net.edge_count());
}

// Of a net without loads the form shows no level of all stiffnesses: it is reported as not
// observed, and a load cell shows it.
TEST(UncertainParameter, IsReportedAsNotObservedWhereNothingShowsIt) {
    const CableNet net = hypar(5, 5);
    const auto stiffness = uncertain({"stiffness:5%"});
    const Built truth = built(net, stiffness, 4);
    IdentifyOptions options = options_with(stiffness);
    const Identification by_form = test::identify_lengths(net, truth.simulated.survey, options);
    ASSERT_EQ(by_form.uncertain.size(), 1U);
    EXPECT_FALSE(by_form.uncertain[0].is_observed());
    EXPECT_NEAR(by_form.uncertain[0].std_dev, 0.05, 0.001);
    for (int edge = 0; edge < net.edge_count(); edge += 5) {
        const double tension = truth.tensions(edge);
        options.forces.measurements.push_back(
            {.edge = edge, .tension = tension, .std_dev = 0.005 * tension});
    }
    const Identification by_cells = test::identify_lengths(net, truth.simulated.survey, options);
    EXPECT_TRUE(by_cells.uncertain[0].is_observed());
    EXPECT_NEAR(by_cells.uncertain[0].mean, truth.perturbation.stiffness(0),
                3.0 * by_cells.uncertain[0].std_dev);
}

// Supports three times as far off as given leave too narrow intervals: their own estimates show it.
TEST(UncertainParameter, ThatIsWiderThanGivenShowsInItsSpread) {
    const CableNet net = loaded_net();
    const auto given = uncertain({"supports:1mm"});
    for (int seed = 0; seed < 5; ++seed) {
        const auto found_of = [&](const char* truth) {
            const Built built_net = built(net, uncertain({truth}), 40 + seed);
            return test::identify_lengths(net, built_net.simulated.survey, options_with(given));
        };
        EXPECT_NEAR(spread_ratio(found_of("supports:1mm").uncertain), 1.0, 0.4);
        // Single ones may be named in place of all.
        const Identification wider = found_of("supports:3mm");
        EXPECT_TRUE(spread_ratio(wider.uncertain) > 1.5 || !wider.boundary_outliers.empty());
        EXPECT_NE(wider.trust.verdict(), Trust::Verdict::passed);
    }
    EXPECT_EQ(spread_ratio({}), 0.0);
    // A single number of which the survey shows less than a twentieth says nothing.
    const auto ratio_shown = [](double part) {
        const std::vector<ParameterEstimate> one{
            {.mean = 0.5, .std_dev = std::sqrt(1.0 - part), .prior_std = 1.0}};
        return spread_ratio(one);
    };
    EXPECT_EQ(ratio_shown(0.04), 0.0);
    EXPECT_NEAR(ratio_shown(0.06), 0.5 / std::sqrt(0.06), 1e-9);
    // Of sixty numbers, a twentieth of the variance may be that of three of them.
    const auto contradicted = [](double mean, double part) {
        const std::vector<ParameterEstimate> many(
            60,
            {.mean = mean * std::sqrt(part), .std_dev = std::sqrt(1.0 - part), .prior_std = 1.0});
        return spreads_of(many).at(0).is_contradicted();
    };
    EXPECT_FALSE(contradicted(2.0, 0.05));  // chi squared of 3: 14.2 by chance
    EXPECT_TRUE(contradicted(2.4, 0.05));
    EXPECT_TRUE(contradicted(1.6, 0.5));
    EXPECT_FALSE(contradicted(1.4, 1.0));
}

}  // namespace of_forces
