// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a comparison that flatters: trials that differ in more than they say, failures
// that vanish, slack edges that are counted among what a form shows, coverage of other intervals.

#include "study/evaluation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>
#include <system_error>

#include "taut/design/builtin_nets.hpp"
#include "taut/numerical_error.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/statics/form_sensitivity.hpp"
#include "taut/statics/tensions.hpp"

namespace {

using namespace taut;

class Trials : public testing::Test {
protected:
    Trials() { Sampler(m_net, m_prior, 4).extend_to(m_data, 6); }

    [[nodiscard]] std::vector<Trial> simulated(const SurveyKind& kind,
                                               std::uint64_t seed = 1) const {
        return simulate_trials(m_net, m_data, m_samples, kind, seed);
    }

    /// Identifies the truth but for a known error of one edge, and says +- 1 mm.
    [[nodiscard]] Method planted(double error) const {
        return {.name = "planted", .identify = [this, error](const Trial& trial) {
                    Identification result{.method = "planted"};
                    for (int i = 0; i < m_net.interior_edge_count(); ++i) {
                        const double x = trial.deviations(i) + (i == 3 ? error : 0.0);
                        result.edges.push_back({.edge = m_net.interior_edges()[i],
                                                .length_deviation = x,
                                                .lower = x - 1e-3,
                                                .upper = x + 1e-3});
                    }
                    result.predicted.status = EquilibriumStatus::converged;
                    result.predicted.form = trial.form;
                    result.predicted.form(2, m_net.free_nodes()[0]) += 0.01;
                    return result;
                }};
    }

    const CableNet m_net = hypar(3, 4);
    const LengthPrior m_prior{LengthPrior::Kind::uniform, 0.002};
    const std::vector<int> m_samples{1, 2, 4, 5};
    DataSet m_data = Sampler(m_net, m_prior, 4).no_samples();
};

TEST_F(Trials, AreTheSamplesAndExactSurveysOfThem) {
    const std::vector<Trial> trials = simulated({});
    ASSERT_EQ(trials.size(), 4U);
    for (size_t k = 0; k < trials.size(); ++k) {
        EXPECT_EQ(trials[k].deviations, m_data.length_deviations.col(m_samples[k]));
        const Eigen::VectorXd form = m_data.nominal_form + m_data.form_deviations.col(m_samples[k]);
        EXPECT_EQ(free_coordinates(m_net, trials[k].form), form);
        EXPECT_EQ(trials[k].survey.form, trials[k].form);
        EXPECT_EQ(trials[k].survey.surveyed, m_net.free_nodes());
    }
}

TEST_F(Trials, OfTwoNoisesDifferInTheSizeOfTheirNoiseAlone) {
    const auto exact = simulated({});
    const auto one = simulated({.noise_std = 1e-4});
    const auto two = simulated({.noise_std = 2e-4});
    for (size_t k = 0; k < one.size(); ++k) {
        const Points noise = one[k].survey.form - exact[k].survey.form;
        const Points twice = two[k].survey.form - exact[k].survey.form;
        EXPECT_GT(noise.cwiseAbs().maxCoeff(), 1e-5);
        EXPECT_LT((twice - 2.0 * noise).cwiseAbs().maxCoeff(), 1e-15);
        EXPECT_EQ(two[k].survey.noise_std(1, m_net.free_nodes()[2]), 2e-4);
        EXPECT_EQ(one[k].deviations, two[k].deviations);
    }
    EXPECT_NE(one[0].survey.form - exact[0].survey.form, one[1].survey.form - exact[1].survey.form);
    EXPECT_NE(simulated({.noise_std = 1e-4}, 2)[0].survey.form, one[0].survey.form);
}

TEST_F(Trials, HideThePartOfTheNodesThatTheirKindSays) {
    for (const Trial& trial : simulated({.noise_std = 1e-4, .hidden_part = 0.25})) {
        EXPECT_EQ(trial.survey.missing.size(), 3U);
        EXPECT_EQ(trial.survey.surveyed.size(), 9U);
    }
}

TEST_F(Trials, KnowWhichInteriorEdgesAreSlack) {
    const LengthPrior wide{LengthPrior::Kind::uniform, 0.02};
    const Sampler sampler(m_net, wide, 4);
    DataSet data = sampler.no_samples();
    sampler.extend_to(data, 20);
    int slack = 0;
    for (const Trial& trial : simulate_trials(m_net, data, data.converged_in(0, 20), {}, 1)) {
        const Eigen::VectorXd tension =
            tensions_of(m_net, with_length_deviations(m_net, trial.deviations), trial.form);
        for (int i = 0; i < m_net.interior_edge_count(); ++i) {
            EXPECT_EQ(trial.slack[i], tension(m_net.interior_edges()[i]) == 0.0);
            slack += trial.slack[i] ? 1 : 0;
        }
    }
    EXPECT_GT(slack, 5);
}

TEST_F(Trials, AreEvaluatedByTheErrorsAndIntervalsOfTheMethod) {
    const auto trials = simulated({});
    const int m = m_net.interior_edge_count();
    const MethodResult inside = evaluate(m_net, planted(5e-4), trials).result;
    EXPECT_EQ(inside.name, "planted");
    EXPECT_EQ(inside.surveys, 4);
    EXPECT_EQ(inside.failed, 0);
    EXPECT_NEAR(inside.errors.mse, 25e-8 / m, 1e-15);
    EXPECT_NEAR(inside.mse_of_taut, 25e-8 / m, 1e-15);
    EXPECT_NEAR(inside.errors.mean(3), -5e-4, 1e-15);
    EXPECT_EQ(inside.coverage, 1.0);
    EXPECT_NEAR(inside.form_error.max, 0.01, 1e-15);
    EXPECT_NEAR(inside.form_error.mean, 0.01 / m_net.free_node_count(), 1e-15);
    EXPECT_GT(inside.seconds, 0.0);
    const MethodResult outside = evaluate(m_net, planted(2e-3), trials).result;
    EXPECT_DOUBLE_EQ(outside.coverage, (m - 1.0) / m);
}

TEST_F(Trials, LeaveSlackEdgesOutOfTheErrorOfTautOnes) {
    auto trials = simulated({});
    for (Trial& trial : trials) {
        trial.slack[3] = true;
    }
    const MethodResult result = evaluate(m_net, planted(5e-4), trials).result;
    EXPECT_EQ(result.mse_of_taut, 0.0);
    EXPECT_GT(result.errors.mse, 0.0);
}

TEST_F(Trials, CountFailuresAndLeaveThemOutOfAllNumbers) {
    const auto trials = simulated({});
    const Method good = planted(5e-4);
    Method method = good;
    method.identify = [&](const Trial& trial) -> Identification {
        if (trial.survey.form == trials[1].survey.form) {
            throw NumericalError("no such luck");
        }
        Identification result = good.identify(trial);
        if (trial.survey.form == trials[2].survey.form) {
            result.status = IdentificationStatus::iteration_limit;
            result.edges[0].length_deviation = 1e3;
        }
        return result;
    };
    for (const bool uses_all_threads : {false, true}) {
        method.uses_all_threads = uses_all_threads;
        const Evaluation evaluation = evaluate(m_net, method, trials);
        EXPECT_EQ(evaluation.result.surveys, 4);
        EXPECT_EQ(evaluation.result.failed, 2);
        EXPECT_EQ(evaluation.result.identified(), 2);
        EXPECT_EQ(evaluation.result.first_failure, "no such luck");
        EXPECT_NEAR(evaluation.result.errors.mse, 25e-8 / m_net.interior_edge_count(), 1e-15);
        EXPECT_TRUE(evaluation.identifications[0].has_value());
        EXPECT_FALSE(evaluation.identifications[1].has_value());
        EXPECT_FALSE(evaluation.identifications[2].has_value());
    }
    method.identify = [](const Trial&) -> Identification { throw std::invalid_argument("never"); };
    const MethodResult none = evaluate(m_net, method, trials).result;
    EXPECT_EQ(none.failed, 4);
    EXPECT_EQ(none.first_failure, "never");
}

TEST_F(Trials, EndWhereTheMachineFails) {
    Method method = planted(5e-4);
    method.identify = [](const Trial&) -> Identification {
        throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
    };
    EXPECT_THROW(evaluate(m_net, method, simulated({})), std::system_error);
}

TEST_F(Trials, CountFormsOutOfBalanceAndLeaveThemOutOfTheFormError) {
    const auto trials = simulated({});
    const Method good = planted(0.0);
    Method method = good;
    method.identify = [&](const Trial& trial) {
        Identification result = good.identify(trial);
        if (trial.survey.form == trials[0].survey.form) {
            result.predicted.status = EquilibriumStatus::iteration_limit;
            result.predicted.form.setConstant(7.0);
        }
        return result;
    };
    const MethodResult result = evaluate(m_net, method, trials).result;
    EXPECT_EQ(result.failed, 0);
    EXPECT_EQ(result.forms_not_converged, 1);
    EXPECT_NEAR(result.form_error.max, 0.01, 1e-15);
}

TEST_F(Trials, HaveTheMeanVarianceAtTheTruthAsTheirBound) {
    auto trials = simulated({.noise_std = 5e-4, .hidden_part = 0.2});
    for (Trial& trial : trials) {
        trial.slack.assign(trial.slack.size(), true);
        trial.slack[0] = false;
    }
    trials.back().slack[1] = false;
    // The textbook's (J' S J + I / prior.std_dev()^2)^-1 at each trial's truth.
    const double precision_of_prior = std::pow(m_prior.std_dev(), -2);
    double mean = 0.0;
    double mean_of_taut = 0.0;
    for (const Trial& trial : trials) {
        const Eigen::MatrixXd J =
            FormSensitivity(m_net, with_length_deviations(m_net, trial.deviations), trial.form)
                .columns(m_net.interior_edges());
        Eigen::VectorXd weights = Eigen::VectorXd::Zero(J.rows());
        for (const int node : trial.survey.surveyed) {
            weights.segment<3>(3 * m_net.free_index(node)).setConstant(std::pow(5e-4, -2));
        }
        Eigen::MatrixXd precision = J.transpose() * weights.asDiagonal() * J;
        precision.diagonal().array() += precision_of_prior;
        const Eigen::VectorXd variances = precision.inverse().diagonal();
        mean += variances.mean() / 4.0;
        // Five edges are taut: the first of each trial, and the second of the last.
        mean_of_taut += variances(0) / 5.0;
        mean_of_taut += trial.slack[1] ? 0.0 : variances(1) / 5.0;
    }
    const auto best = cramer_rao_bound(m_net, m_prior, trials);
    ASSERT_TRUE(best);
    EXPECT_NEAR(best->mse, mean, 1e-6 * mean);
    EXPECT_NEAR(best->mse_of_taut, mean_of_taut, 1e-6 * mean_of_taut);
}

TEST_F(Trials, AreStoppedWhereThatIsRequested) {
    const auto trials = simulated({});
    Method method = planted(0.0);
    method.uses_all_threads = true;
    int tried = 0;
    const auto identify = method.identify;
    method.identify = [&](const Trial& trial) {
        ++tried;
        return identify(trial);
    };
    const Progress progress{.stop_requested = [&] { return tried > 0; }};
    EXPECT_THROW((void)evaluate(m_net, method, trials, progress), Interrupted);
    EXPECT_EQ(tried, 1);
}

}  // namespace
