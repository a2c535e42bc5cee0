// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against advice that promises more than a measurement then gives, or passes over a better
// one.

#include "taut/identification/suggested_measurements.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <atomic>
#include <cmath>
#include <functional>

#include "identification/simulated_survey.hpp"
#include "support/finite_differences.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/predicted_precision.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace {

using namespace taut;
using test::uncertain;

constexpr double suggest_noise_std = 0.5e-3;
constexpr LengthPrior suggest_prior{LengthPrior::Kind::normal, 0.002};

/// The normal posterior of lengths, a factor of all stiffnesses (5 %), an error of all load cells
/// (1 %) and one of the load (2 %), by differences of equilibria.
class Reference {
public:
    Reference(const CableNet& net, const Survey& survey) : m_net(net), m_survey(survey) {
        const Eigen::Index count = net.interior_edge_count() + 3;
        Eigen::VectorXd precision = Eigen::VectorXd::Constant(
            count, 1.0 / (suggest_prior.std_dev() * suggest_prior.std_dev()));
        precision.tail(3) << 1.0 / (0.05 * 0.05), 1.0 / (0.01 * 0.01), 1.0 / (0.02 * 0.02);
        const Eigen::MatrixXd seen = rates([&](const Eigen::VectorXd& x) {
            return Eigen::VectorXd(form(x, -1, 0.0)(Eigen::all, survey.surveyed).reshaped());
        });
        m_information = Eigen::MatrixXd(precision.asDiagonal()) +
                        seen.transpose() * seen / (suggest_noise_std * suggest_noise_std);
        m_tensions = rates([&](const Eigen::VectorXd& x) { return tensions_at(x); });
    }

    /// The information of a measurement.
    [[nodiscard]] Eigen::MatrixXd of_cell(int edge) const {
        const double tension = nominal_tensions()(edge);
        Eigen::VectorXd row = m_tensions.row(edge);
        row(row.size() - 2) += tension;
        return row * row.transpose() / (0.02 * 0.02 * tension * tension);
    }
    [[nodiscard]] Eigen::MatrixXd of_target(int node) const {
        const Eigen::MatrixXd seen = rates(
            [&](const Eigen::VectorXd& x) { return Eigen::VectorXd(form(x, -1, 0.0).col(node)); });
        return seen.transpose() * seen / (suggest_noise_std * suggest_noise_std);
    }
    [[nodiscard]] Eigen::MatrixXd of_load(int node, double load) const {
        const Eigen::MatrixXd seen = rates([&](const Eigen::VectorXd& x) {
            return Eigen::VectorXd(form(x, node, load)(Eigen::all, m_survey.surveyed).reshaped());
        });
        return seen.transpose() * seen / (suggest_noise_std * suggest_noise_std);
    }

    /// Of the mean tension [N].
    [[nodiscard]] double std_with(const Eigen::MatrixXd& more) const {
        const Eigen::VectorXd mean = m_tensions.colwise().mean();
        return std::sqrt(mean.dot((m_information + more).ldlt().solve(mean)));
    }
    [[nodiscard]] double std_dev() const { return std_with(0.0 * m_information); }
    [[nodiscard]] Eigen::VectorXd nominal_tensions() const {
        return tensions_at(Eigen::VectorXd::Zero(m_information.cols()));
    }

private:
    [[nodiscard]] CableNet net_at(const Eigen::VectorXd& x, int node, double load) const {
        CableNetData data = m_net.data();
        data.axial_stiffness *= std::exp(x(x.size() - 3));
        data.loads = Points::Zero(3, m_net.node_count());
        if (node >= 0) {
            data.loads(2, node) = -load * (1.0 + x(x.size() - 1));
        }
        data.unstressed_lengths =
            with_length_deviations(m_net, x.head(m_net.interior_edge_count()));
        return CableNet(data);
    }
    [[nodiscard]] Points form(const Eigen::VectorXd& x, int node, double load) const {
        return solve_equilibrium(net_at(x, node, load)).form;
    }
    [[nodiscard]] Eigen::VectorXd tensions_at(const Eigen::VectorXd& x) const {
        const CableNet net = net_at(x, -1, 0.0);
        return tensions_of(net, net.unstressed_lengths(), solve_equilibrium(net).form);
    }
    [[nodiscard]] Eigen::MatrixXd rates(
        const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& f) const {
        return test::finite_differences(f, Eigen::VectorXd::Zero(m_net.interior_edge_count() + 3),
                                        1e-5);
    }

    const CableNet& m_net;
    const Survey& m_survey;
    Eigen::MatrixXd m_information;
    Eigen::MatrixXd m_tensions;
};

TEST(SuggestedMeasurements, AreTheBestOnesOfAllByDifferencesOfEquilibria) {
    const CableNet net = hypar(3, 3);
    const Survey survey =
        test::planned_survey(net, suggest_noise_std, {net.free_nodes()[4], net.free_nodes()[0]});
    const Reference reference(net, survey);
    SuggestOptions options{.load = 150.0, .most = 3, .assume_site = false};
    const MeasurementSuggestions found =
        suggested_measurements(net, solve_equilibrium(net).form, survey, suggest_prior, {},
                               uncertain({"stiffness:5%", "forces:1%", "test-loads:2%"}), options);
    ASSERT_EQ(found.steps.size(), 3u);
    EXPECT_NEAR(found.std_dev, reference.std_dev(), 1e-3 * found.std_dev);

    std::vector<Eigen::MatrixXd> all;
    for (int e = 0; e < net.edge_count(); ++e) {
        all.push_back(reference.of_cell(e));
    }
    for (const int node : survey.missing) {
        all.push_back(reference.of_target(node));
    }
    for (const int node : net.free_nodes()) {
        all.push_back(reference.of_load(node, options.load));
    }
    double best_of_one = found.std_dev;
    double best_of_two = found.std_dev;
    for (size_t i = 0; i < all.size(); ++i) {
        best_of_one = std::min(best_of_one, reference.std_with(all[i]));
        for (size_t k = 0; k < i; ++k) {
            best_of_two = std::min(best_of_two, reference.std_with(all[i] + all[k]));
        }
    }
    EXPECT_NEAR(found.steps[0].remaining_std, best_of_one, 2e-3 * best_of_one);
    EXPECT_NEAR(found.steps[1].remaining_std, best_of_two, 0.05 * best_of_two);

    Eigen::MatrixXd so_far = 0.0 * all.front();
    for (const SuggestedMeasurement& step : found.steps) {
        so_far += step.kind == MeasurementKind::load_cell ? reference.of_cell(step.edge)
                  : step.kind == MeasurementKind::target  ? reference.of_target(step.node)
                                                          : reference.of_load(step.node, 150.0);
        EXPECT_NEAR(step.remaining_std, reference.std_with(so_far), 2e-3 * step.remaining_std)
            << to_string(step.kind);
    }
}

TEST(SuggestedMeasurements, EndWhenTheyAreToStop) {
    const CableNet net = hypar(3, 3);
    std::atomic<int> asked = 0;
    EXPECT_THROW((void)suggested_measurements(
                     net, solve_equilibrium(net).form, test::planned_survey(net, suggest_noise_std),
                     suggest_prior, {}, {}, {}, {.stop_requested = [&] { return ++asked > 9; }}),
                 Interrupted);
}

TEST(SuggestedMeasurements, OfEachKindGiveWhatTheyPromise) {
    const CableNet net = hypar(3, 3);
    const Survey survey = test::planned_survey(net, suggest_noise_std, {net.free_nodes()[4]});
    const Reference reference(net, survey);
    const auto first_of = [&](MeasurementKind kind) {
        SuggestOptions options{.load = 150.0, .most = 1, .assume_site = false};
        for (const MeasurementKind other :
             {MeasurementKind::load_cell, MeasurementKind::target, MeasurementKind::load}) {
            options.costs[other] = other == kind ? 1.0 : 1e6;
        }
        return suggested_measurements(net, solve_equilibrium(net).form, survey, suggest_prior, {},
                                      uncertain({"stiffness:5%", "forces:1%", "test-loads:2%"}),
                                      options)
            .steps.at(0);
    };
    const SuggestedMeasurement cell = first_of(MeasurementKind::load_cell);
    EXPECT_EQ(cell.kind, MeasurementKind::load_cell);
    EXPECT_NEAR(cell.expected, reference.nominal_tensions()(cell.edge), 1e-3 * cell.expected);
    EXPECT_NEAR(cell.remaining_std, reference.std_with(reference.of_cell(cell.edge)),
                2e-3 * cell.remaining_std);
    const SuggestedMeasurement load = first_of(MeasurementKind::load);
    EXPECT_EQ(load.kind, MeasurementKind::load);
    EXPECT_EQ(load.expected, 150.0);
    EXPECT_NEAR(load.remaining_std, reference.std_with(reference.of_load(load.node, 150.0)),
                2e-3 * load.remaining_std);
}

TEST(SuggestedMeasurements, OfTargetsLowerTheUncertaintyOfTheForm) {
    const CableNet net = hypar(4, 4);
    const std::vector<int> hidden{net.free_nodes()[5], net.free_nodes()[10]};
    const Points form = solve_equilibrium(net).form;
    const MeasurementSuggestions found = suggested_measurements(
        net, form, test::planned_survey(net, suggest_noise_std, {hidden.begin(), hidden.end()}),
        suggest_prior, {}, {},
        {.quantity = SoughtQuantity::form,
         .costs = {{MeasurementKind::load, 100.0}},
         .most = 2,
         .assume_site = false});
    ASSERT_EQ(found.steps.size(), 2u);
    std::vector<int> nodes{found.steps[0].node, found.steps[1].node};
    std::ranges::sort(nodes);
    EXPECT_EQ(nodes, hidden);
    const MeasurementSuggestions whole = suggested_measurements(
        net, form, test::planned_survey(net, suggest_noise_std), suggest_prior, {}, {},
        {.quantity = SoughtQuantity::form, .assume_site = false});
    EXPECT_NEAR(found.steps[1].remaining_std, whole.std_dev, 1e-6 * whole.std_dev);
}

TEST(SuggestedMeasurements, NeedAMassForFrequencies) {
    CableNetData data = hypar(3, 3).data();
    const auto kinds_of = [](const CableNet& net) {
        const MeasurementSuggestions found = suggested_measurements(
            net, solve_equilibrium(net).form, test::planned_survey(net, suggest_noise_std),
            suggest_prior, {}, uncertain({"stiffness:5%"}),
            {.costs = {{MeasurementKind::frequency, 0.01}}, .free_length_std = 1e-3});
        std::vector<MeasurementKind> kinds;
        for (const SuggestedMeasurement& step : found.steps) {
            kinds.push_back(step.kind);
        }
        return std::pair(kinds, found.left_out);
    };
    const auto [without, why] = kinds_of(CableNet(data));
    EXPECT_THAT(without, testing::Not(testing::Contains(MeasurementKind::frequency)));
    EXPECT_THAT(why, testing::ElementsAre(
                         testing::StartsWith("frequencies and sags: the net has no mass")));
    data.mass = Eigen::VectorXd::Constant(std::ssize(data.edges), 0.05);
    EXPECT_THAT(kinds_of(CableNet(data)).first, testing::Contains(MeasurementKind::frequency));
}

TEST(SuggestedMeasurements, OfAnEdgeComeOnce) {
    const CableNet net = hypar(3, 3);
    const MeasurementSuggestions found = suggested_measurements(
        net, solve_equilibrium(net).form, test::planned_survey(net, suggest_noise_std),
        suggest_prior, {.measurements = {{.edge = 3, .tension = 4000.0, .std_dev = 80.0}}},
        uncertain({"stiffness:5%"}),
        {.quantity = SoughtQuantity::worst_tension,
         .costs = {{MeasurementKind::load, 100.0}},
         .most = 100});
    std::vector<int> edges;
    for (const SuggestedMeasurement& step : found.steps) {
        if (step.edge >= 0) {
            edges.push_back(step.edge);
        }
        EXPECT_LT(step.remaining_std, found.std_dev);
    }
    EXPECT_THAT(edges, testing::Not(testing::Contains(3)));
    EXPECT_GE(edges.size(), 2U);
    std::ranges::sort(edges);
    EXPECT_EQ(std::ranges::adjacent_find(edges), edges.end());
}

TEST(SuggestedMeasurements, RefuseWhatMakesNoSense) {
    const CableNet net = hypar(3, 3);
    const auto refuse = [&](const SuggestOptions& options) {
        EXPECT_THROW(static_cast<void>(suggested_measurements(
                         net, net.nodes(), test::planned_survey(net, suggest_noise_std),
                         suggest_prior, {}, {}, options)),
                     std::invalid_argument);
    };
    refuse({.costs = {{MeasurementKind::sag, 0.0}}});
    refuse({.load = -1.0});
    refuse({.frequency_std = -0.1});
    refuse({.free_length_std = -0.1});
    refuse({.most = 0});
    const CableNet large = hypar(40, 40);
    EXPECT_THROW(static_cast<void>(suggested_measurements(
                     large, large.nodes(), test::planned_survey(large, suggest_noise_std),
                     suggest_prior, {}, {})),
                 std::invalid_argument);
    EXPECT_THROW(static_cast<void>(parse_measurement_kind("cell")), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(parse_sought_quantity("")), std::invalid_argument);
}

}  // namespace
