// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a conditional form, or an uncertainty of it, that is not Gaussian conditioning's,
// and against derivatives that are not those of the mean function.
#include "identification/form_conditioning.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "estimation/hypotheses.hpp"
#include "identification/mean_function.hpp"
#include "simulated_survey.hpp"
#include "support/finite_differences.hpp"
#include "survey/covariance.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/statics/form_sensitivity.hpp"

namespace taut {
namespace {

constexpr double no_test = 0.0;

class FormConditioning : public ::testing::Test {
protected:
    static LengthModel model_of(const CableNet& net) {
        const DataSet data = draw_samples(Sampler(net, {LengthPrior::Kind::uniform, 0.002}, 1), 60);
        return train_model(net, data, data.converged_in(0, 60));
    }

    [[nodiscard]] Survey survey(double noise) const {
        return test::simulate(m_net, m_model.prior, noise, 5).survey;
    }

    [[nodiscard]] ConditionedForm condition(const Survey& survey, double false_alarm_rate) const {
        return {m_net, m_before, survey, m_model.nominal_form, false_alarm_rate};
    }

    const CableNet m_net = hypar(3, 4);
    const LengthModel m_model = model_of(m_net);
    const FormPrior& m_before = m_model.form_prior;
    const Eigen::MatrixXd m_before_covariance =
        m_before.directions.transpose() * m_before.variances.asDiagonal() * m_before.directions;
};

TEST_F(FormConditioning, BeforeASurveyIsThePriorThroughTheStaticsAndWhatTheseMiss) {
    // Mean and covariance of many forms that were not trained on.
    const DataSet data = draw_samples(Sampler(m_net, m_model.prior, 77), 4000);
    const Eigen::VectorXd mean = data.form_deviations.rowwise().mean();
    const Eigen::MatrixXd centred = data.form_deviations.colwise() - mean;
    const Eigen::MatrixXd covariance = centred * centred.transpose() / 3999.0;
    const double spread = covariance.diagonal().cwiseSqrt().mean();
    EXPECT_LT((m_before.mean - mean).norm() / std::sqrt(mean.size()), 0.05 * spread);
    EXPECT_LT((m_before_covariance - covariance).norm(), 0.1 * covariance.norm());
}

TEST_F(FormConditioning, IsGaussianConditioning) {
    const Eigen::Index d = m_before.mean.size();
    const Eigen::MatrixXd gradients = Eigen::MatrixXd::Random(d, 5);
    for (const bool is_correlated : {false, true}) {  // (filled-in) and (by-factor)
        Survey partial = survey(0.0003);
        test::hide(m_net, partial, m_net.free_nodes()[4]);
        if (is_correlated) {
            partial.set_correlations(m_net.free_nodes()[6], {0.8, -0.3, 0.1});
        }
        const ConditionedForm after = condition(partial, no_test);
        Eigen::MatrixXd precision = Eigen::MatrixXd::Zero(d, d);
        for (const int node : partial.surveyed) {
            const Eigen::Index at = 3 * m_net.free_index(node);
            precision.block<3, 3>(at, at) =
                covariance_of({.std_dev = partial.noise_std.col(node),
                               .correlations = partial.correlations_of(node)})
                    .inverse();
        }
        const Eigen::MatrixXd before_inverse = m_before_covariance.inverse();
        const Eigen::MatrixXd covariance = (before_inverse + precision).inverse();
        const Eigen::VectorXd deviation =
            free_coordinates(m_net, partial.form) - m_model.nominal_form;
        const Eigen::VectorXd mean =
            covariance * (before_inverse * m_before.mean + precision * deviation);
        EXPECT_LT((after.mean() - mean).norm(), 1e-6 * mean.norm());
        const Eigen::VectorXd expected =
            (gradients.transpose() * covariance * gradients).diagonal();
        const Eigen::VectorXd variances = after.variances_along(m_before.directions * gradients);
        EXPECT_LT((variances - expected).norm(), 1e-6 * expected.norm());
    }
}

TEST_F(FormConditioning, OfAnExactSurveyWithAMissingNodeKeepsItsDigits) {
    Survey exact = survey(0.0);
    const int hidden = m_net.free_nodes()[4];
    test::hide(m_net, exact, hidden);
    const ConditionedForm after = condition(exact, no_test);
    // As if all others were known: C_uu - C_uo C_oo^-1 C_ou = (C^-1)_uu^-1.
    const Eigen::Index at = 3 * m_net.free_index(hidden);
    const Eigen::Matrix3d expected = m_before_covariance.inverse().block<3, 3>(at, at).inverse();
    const Eigen::VectorXd variances = after.variances_along(m_before.directions.middleCols<3>(at));
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(variances(axis) / expected(axis, axis), 1.0, 1e-4);
    }
    // The others are where they were surveyed.
    Eigen::VectorXd error =
        after.mean() - (free_coordinates(m_net, exact.form) - m_model.nominal_form);
    error.segment<3>(at).setZero();
    EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-7);
}

TEST_F(FormConditioning, TestsATargetAgainstWhatAllOthersLetExpect) {
    Survey wrong = survey(0.0003);
    const int node = m_net.free_nodes()[7];
    wrong.form(1, node) += 0.01;
    const ConditionedForm after = condition(wrong, 0.001);
    ASSERT_EQ(after.outliers().size(), 1U);
    EXPECT_EQ(after.outliers()[0].node, node);
    EXPECT_NEAR(after.outliers()[0].distance, 0.01, 0.002);

    // The form is that of the survey without it.
    Survey without = wrong;
    test::hide(m_net, without, node);
    const ConditionedForm expected = condition(without, no_test);
    EXPECT_LT((after.mean() - expected.mean()).norm(), 1e-10);
}

// Beside a gross error sound targets stand out, too.
TEST_F(FormConditioning, ReadmitsWhatFitsOnceOthersAreRejected) {
    size_t found = 0;
    for (int k = 0; k < 50; ++k) {
        Survey wrong = test::simulate(m_net, m_model.prior, 0.0003, 100 + k).survey;
        const int first = m_net.free_nodes()[k % 12];
        const int second = m_net.free_nodes()[(5 * k + 3) % 12];
        wrong.form(k % 3, first) += 0.02;
        wrong.form(k % 3, second) += 0.02;
        const ConditionedForm after = condition(wrong, 0.001);
        for (const Outlier& outlier : after.outliers()) {
            EXPECT_TRUE(outlier.node == first || outlier.node == second) << "survey " << k;
            EXPECT_GT(outlier.statistic, after.hypotheses().threshold(Suspect::target));
        }
        EXPECT_FALSE(after.hypotheses().has_too_many(Hypotheses::Family::targets))
            << "survey " << k;
        found += after.outliers().size();
    }
    EXPECT_GT(found, 90U);  // of 100
}

TEST_F(FormConditioning, RaisesFalseAlarmsAsOftenAsStated) {
    constexpr int surveys = 400;
    int alarms = 0;
    double ratio = 0.0;
    for (int k = 0; k < surveys; ++k) {
        const Survey good = test::simulate(m_net, m_model.prior, 0.0003, 100 + k).survey;
        const ConditionedForm after = condition(good, 0.1);
        alarms += after.outliers().empty() ? 0 : 1;
        ratio += after.hypotheses().noise_ratio / surveys;
    }
    // 40 expected; five standard deviations about it.
    EXPECT_GT(alarms, 10);
    EXPECT_LT(alarms, 70);
    EXPECT_NEAR(ratio, 1.0, 0.1);
}

TEST_F(FormConditioning, MeanFunctionsHaveTheGradientsOfTheirDifferenceQuotients) {
    const Eigen::VectorXd at = 0.01 * Eigen::VectorXd::Random(m_model.nominal_form.size());
    const Eigen::MatrixXd expected = test::finite_differences(
        [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
            return mean_values(m_net, MeanFunction::geometry, m_model.nominal_form, x).col(0);
        },
        at, 1e-4);
    const Eigen::MatrixXd gradient =
        mean_rates(m_net, MeanFunction::geometry, m_model.nominal_form).asDiagonal() *
        length_gradient(m_net, with_free_coordinates(m_net, m_model.nominal_form + at));
    EXPECT_LT((gradient - expected).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_TRUE(mean_rates(m_net, MeanFunction::zero, m_model.nominal_form).isZero(0.0));
}

TEST_F(FormConditioning, TheGeometricMeanIsThatOfNominalStrain) {
    const Eigen::VectorXd at = 0.01 * Eigen::VectorXd::Random(m_model.nominal_form.size());
    const Eigen::VectorXd mean =
        mean_values(m_net, MeanFunction::geometry, m_model.nominal_form, at).col(0);
    for (int i = 0; i < m_net.interior_edge_count(); ++i) {
        const int edge = m_net.interior_edges()[i];
        const auto [s, t] = m_net.edges()[edge];
        const auto length = [&](const Eigen::VectorXd& deviation) {
            const Points form = with_free_coordinates(m_net, m_model.nominal_form + deviation);
            return (form.col(s) - form.col(t)).norm();
        };
        const double nominal = m_net.unstressed_lengths()(edge);
        const double strain = length(Eigen::VectorXd::Zero(at.size())) / nominal - 1.0;
        EXPECT_NEAR(mean(i), length(at) / (1.0 + strain) - nominal, 1e-15);
    }
}

}  // namespace
}  // namespace taut
