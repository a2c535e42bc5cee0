// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against normal equations that are not those of the problem: a derivative, a weight or a
// sign that is wrong for supports, loads, common parameters or force measurements. The same problem
// is built here as one dense matrix, its derivatives by differences of forces written down once
// more.

#include "estimation/linearisation.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <tuple>

#include "estimation/hamiltonian_chain.hpp"
#include "estimation/imagined_observations.hpp"
#include "support/finite_differences.hpp"
#include "support/random_nets.hpp"
#include "taut/design/builtin_nets.hpp"

namespace {

using namespace taut;
using namespace taut::test;

constexpr int common_count = 4 + 2 * 3;  // and three places of each of two supports on a frame
// of parameters

CableNet loaded_net() {
    CableNetData data = hypar(2, 3).data();
    const auto edges = static_cast<int>(data.edges.size());
    data.loads = Points::Constant(3, data.nodes.cols(), 40.0);
    data.loads.row(2).setConstant(-150.0);
    data.expansion.setConstant(edges, 1.2e-5);
    data.expansion(0) = 0.0;
    data.groups["half"] = {0, 2, 5, 7, edges - 1};
    for (const int sign : {-1, 1}) {
        const int node = data.supports.back();
        data.supports.pop_back();
        const Eigen::Vector3d along = Eigen::Vector3d(1.0, 0.5 * sign, 0.3).normalized();
        data.elastic_supports.push_back(
            {.node = node,
             .stiffness = 2e5 * (Eigen::Matrix3d::Identity() + 3.0 * along * along.transpose()),
             .place = data.nodes.col(node) + 1e-3 * sign * Eigen::Vector3d::Ones()});
    }
    data.support_couplings = {
        {.first = 0,
         .second = 1,
         .stiffness = Eigen::Matrix3d{{6e4, 2e4, 0.0}, {-4e4, 5e4, 1e4}, {0.0, 2e4, -5e4}}}};
    return CableNet(std::move(data));
}

class Linearised : public testing::Test {
protected:
    Linearised() {
        Random random(3);
        m_iterate.form += uniform_points(random, m_net.node_count(), 2e-3);
        m_iterate.deviations = uniform_vector(random, m_iterate.deviations.size(), 1e-3);
        m_iterate.common = uniform_vector(random, common_count, 0.7);
        for (const int node : m_net.free_nodes()) {
            m_iterate.loads.col(node) = uniform_points(random, 1, 15.0);
        }
        for (size_t k = 1; k < m_net.free_nodes().size(); ++k) {  // the first is hidden
            m_observed.weights.col(m_net.free_nodes()[k]).setConstant(1.0 / 0.25e-6);
        }
        for (const int node : m_net.supports()) {
            m_observed.weights.col(node).setConstant(1e6);
        }
        m_observed.cross_weights = 0.4 * m_observed.weights;  // correlated coordinates
        m_observed.cross_weights.row(1) *= -1.0;
        m_observed.form += uniform_points(random, m_net.node_count(), 1e-3);
        for (const int node : m_net.free_nodes()) {
            m_observed.load_variance.col(node).setConstant(400.0);
            m_observed.load_mean.col(node) = uniform_points(random, 1, 5.0);
        }
        const int elastic = m_net.elastic_supports().front().node;
        m_observed.cross_load_variance = Points::Zero(3, m_net.node_count());
        m_observed.cross_load_variance.col(elastic) << 150.0, -80.0, 60.0;
        m_observed.common_mean = uniform_vector(random, common_count, 0.2);
        for (const int edge :
             {1, m_net.adjustable_edges().front()}) {  // the length of one is known
            m_observed.tension(edge) = 3e3;
            m_observed.tension_weights(edge) = 1.0 / (60.0 * 60.0);
            m_observed.tension_bias(edge, 2) = 150.0;
        }
        m_fit = linearised_fit(StaticsModel(m_net, m_uncertain), m_iterate, m_observed);
    }

    // All unknowns as one vector: places of all nodes, lengths, loads of free nodes, common ones.
    [[nodiscard]] Eigen::VectorXd together(const Iterate& it) const {
        Eigen::VectorXd x(m_size);
        x << it.form.reshaped(), it.deviations, it.loads(Eigen::all, m_net.free_nodes()).reshaped(),
            it.common;
        return x;
    }
    [[nodiscard]] Iterate apart(const Eigen::VectorXd& x) const {
        Iterate it = nominal_iterate(m_net, common_count);
        it.form = x.head(m_places).reshaped(3, m_net.node_count());
        it.deviations = x.segment(m_places, m_lengths);
        it.loads(Eigen::all, m_net.free_nodes()) =
            x.segment(m_places + m_lengths, m_loads).reshaped(3, m_net.free_node_count());
        it.common = x.tail(common_count);
        return it;
    }

    /// T of all edges.
    [[nodiscard]] Eigen::VectorXd edge_tensions(const Eigen::VectorXd& x) const {
        const Iterate it = apart(x);
        Eigen::VectorXd l_0 = with_length_deviations(m_net, it.deviations);
        Eigen::VectorXd stiffness = m_net.axial_stiffness();
        for (const int edge : m_net.data().groups.at("half")) {
            stiffness(edge) *= std::exp(0.05 * it.common(0));
        }
        l_0 =
            l_0.cwiseProduct((1.0 + 15.0 * it.common(1) * m_net.data().expansion.array()).matrix());
        Eigen::VectorXd result(m_net.edge_count());
        for (int e = 0; e < m_net.edge_count(); ++e) {
            const auto [s, t] = m_net.edges()[e];
            result(e) = stiffness(e) * ((it.form.col(s) - it.form.col(t)).norm() / l_0(e) - 1.0);
        }
        return result;
    }

    /// Out-of-balance forces of the free nodes.
    [[nodiscard]] Eigen::VectorXd imbalance(const Eigen::VectorXd& x) const {
        const Iterate it = apart(x);
        const Eigen::VectorXd tension = edge_tensions(x);
        Points forces = -(1.0 + 0.1 * it.common(2)) * m_net.loads() - it.loads;
        const double factor = std::exp(0.1 * it.common(3));
        Points shifts = Points::Zero(3, m_net.node_count());
        for (size_t i = 0; i < 2; ++i) {  // places in the order of their nodes, by 1 mm
            const ElasticSupport& support = m_net.elastic_supports()[1 - i];
            shifts.col(support.node) = it.form.col(support.node) - support.place -
                                       1e-3 * it.common.segment<3>(4 + 3 * static_cast<int>(i));
        }
        for (const auto& [node, stiffness, place] : m_net.elastic_supports()) {
            const Eigen::Vector3d error = it.loads.col(node);
            forces.col(node) += factor * (stiffness * shifts.col(node) - error) + error;
        }
        const SupportCoupling& frame = m_net.support_couplings().front();
        const ElasticSupport& one = m_net.elastic_supports()[0];
        const ElasticSupport& other = m_net.elastic_supports()[1];
        forces.col(one.node) += factor * frame.stiffness * shifts.col(other.node);
        forces.col(other.node) += factor * frame.stiffness.transpose() * shifts.col(one.node);
        for (int e = 0; e < m_net.edge_count(); ++e) {
            const auto [s, t] = m_net.edges()[e];
            const Eigen::Vector3d u = (it.form.col(s) - it.form.col(t)).normalized();
            forces.col(s) += tension(e) * u;
            forces.col(t) -= tension(e) * u;
        }
        return forces(Eigen::all, m_net.free_nodes()).reshaped();
    }

    const CableNet m_net = loaded_net();
    const std::vector<UncertainParameter> m_uncertain{
        parse_uncertain_parameter("supports:1mm"),
        parse_uncertain_parameter("stiffness:5%@half"),
        parse_uncertain_parameter("temperature:15K"),
        parse_uncertain_parameter("loads:20N"),
        parse_uncertain_parameter("loads:10%"),
        parse_uncertain_parameter("support-stiffness:10%")};
    const Eigen::Index m_places = 3 * m_net.node_count();
    const Eigen::Index m_lengths = m_net.interior_edge_count();
    const Eigen::Index m_loads = 3 * m_net.free_node_count();
    const Eigen::Index m_size = m_places + m_lengths + m_loads + common_count;
    Iterate m_iterate = nominal_iterate(m_net, common_count);
    Observations m_observed = nothing_observed(m_net, 0.002, common_count);
    std::optional<LinearisedFit> m_fit;
};

/// The dense system [Q A'; A 0], with Q the weights and A the derivative of the forces.
class Dense : public Linearised {
protected:
    Dense() {
        const Eigen::VectorXd x = together(m_iterate);
        // Forces are linear in loads: one step does for metres, newtons and numbers.
        m_rates = finite_differences([this](const auto& at) { return imbalance(at); }, x, 1e-5);
        m_tension_rates =
            finite_differences([this](const auto& at) { return edge_tensions(at); }, x, 1e-5);
        m_measured_rates = m_tension_rates;
        m_measured_rates.rightCols<common_count>() += m_observed.tension_bias;
        Eigen::VectorXd weights(m_size);
        weights << m_observed.weights.reshaped(), m_observed.variance.cwiseInverse(),
            Eigen::VectorXd::Constant(m_loads, 1.0 / 400.0), Eigen::VectorXd::Ones(common_count);
        Iterate means = m_iterate;
        means.form = m_observed.form;
        means.deviations = m_observed.mean;
        means.loads = m_observed.load_mean;
        means.common = m_observed.common_mean;
        const Eigen::VectorXd misfit =
            m_observed.tension - edge_tensions(x) - m_observed.tension_bias * m_iterate.common;
        const auto constraints = m_rates.rows();
        m_matrix.setZero(m_size + constraints, m_size + constraints);
        m_matrix.topLeftCorner(m_size, m_size) = m_measured_rates.transpose() *
                                                 m_observed.tension_weights.asDiagonal() *
                                                 m_measured_rates;
        m_matrix.topLeftCorner(m_size, m_size).diagonal() += weights;
        Eigen::MatrixXd of_places = Eigen::MatrixXd(weights.asDiagonal());
        for (int node = 0; node < m_net.node_count(); ++node) {
            const Eigen::Vector3d cross = m_observed.cross_weights.col(node);
            for (const auto& [i, k, of_both] :
                 {std::tuple(0, 1, cross(0)), {0, 2, cross(1)}, {1, 2, cross(2)}}) {
                of_places(3 * node + i, 3 * node + k) = of_both;
                of_places(3 * node + k, 3 * node + i) = of_both;
                m_matrix(3 * node + i, 3 * node + k) += of_both;
                m_matrix(3 * node + k, 3 * node + i) += of_both;
            }
        }
        for (int k = 0; k < m_net.free_node_count(); ++k) {
            const Eigen::Index at = m_places + m_lengths + 3 * k;
            const Eigen::Matrix3d of_load =
                m_observed.load_covariance(m_net.free_nodes()[k]).inverse();
            m_matrix.block<3, 3>(at, at) += of_load - of_places.block<3, 3>(at, at);
            of_places.block<3, 3>(at, at) = of_load;
        }
        m_matrix.bottomLeftCorner(constraints, m_size) = m_rates;
        m_matrix.topRightCorner(m_size, constraints) = m_rates.transpose();
        m_right_side.resize(m_size + constraints);
        m_right_side << of_places * (together(means) - x) +
                            m_measured_rates.transpose() *
                                m_observed.tension_weights.cwiseProduct(misfit),
            -imbalance(x);
        m_covariance = m_matrix.inverse().topLeftCorner(m_size, m_size);
    }

    Eigen::MatrixXd m_rates;
    Eigen::MatrixXd m_tension_rates;
    Eigen::MatrixXd m_measured_rates;
    Eigen::MatrixXd m_matrix;
    Eigen::VectorXd m_right_side;
    Eigen::MatrixXd m_covariance;
};

void expect_near(const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected) {
    EXPECT_LT((found - expected).norm(), 1e-5 * expected.norm());
}

TEST_F(Dense, TheStepIsThatOfTheWholeProblem) {
    const Eigen::VectorXd expected = m_matrix.partialPivLu().solve(m_right_side).head(m_size);
    const Iterate step = m_fit->linearisation.step(m_iterate, m_observed);
    const Iterate exact = apart(expected);
    expect_near(step.form, exact.form);
    expect_near(step.deviations, exact.deviations);
    expect_near(step.loads, exact.loads);
    expect_near(step.common, exact.common);
}

TEST_F(Dense, TheCovariancesAreThoseOfTheWholeProblem) {
    for (int node = 0; node < m_net.node_count(); ++node) {
        expect_near(m_fit->covariance.places[node], m_covariance.block<3, 3>(3 * node, 3 * node));
    }
    expect_near(m_fit->covariance.lengths, m_covariance.diagonal().segment(m_places, m_lengths));
    const Eigen::Index loads = m_places + m_lengths;
    for (int k = 0; k < m_net.free_node_count(); ++k) {
        expect_near(m_fit->covariance.loads[m_net.free_nodes()[k]],
                    m_covariance.block<3, 3>(loads + 3 * k, loads + 3 * k));
    }
    expect_near(m_fit->covariance.common,
                m_covariance.bottomRightCorner<common_count, common_count>());
}

TEST_F(Dense, TheVariancesOfTensionsAndTheirMeanAreThoseOfTheWholeProblem) {
    const Eigen::MatrixXd of_tensions =
        m_tension_rates * m_covariance * m_tension_rates.transpose();
    expect_near(m_fit->covariance.tensions, of_tensions.diagonal());
    expect_near(m_fit->linearisation.covariances_with(
                    Eigen::VectorXd::Constant(m_net.edge_count(), 1.0 / m_net.edge_count())),
                of_tensions.rowwise().mean());
}

TEST_F(Dense, TheVariancesOfForceMeasurementsHoldWhatTheyShare) {
    const Eigen::MatrixXd of_measured =
        m_measured_rates * m_covariance * m_measured_rates.transpose();
    expect_near(m_fit->covariance.measured, of_measured.diagonal());
    const Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(m_net.edge_count(), 0.5, 2.0);
    EXPECT_NEAR(m_fit->linearisation.measured_variance(weights), weights.dot(of_measured * weights),
                1e-5 * weights.dot(of_measured * weights));
}

TEST_F(Dense, TheDeterminantChangesAsThatOfTheWholeProblem) {
    std::vector<int> free_places;
    for (const int node : m_net.free_nodes()) {
        free_places.insert(free_places.end(), {3 * node, 3 * node + 1, 3 * node + 2});
    }
    m_observed.mean_root = Eigen::MatrixXd::Constant(m_lengths, 2, 1e-3);
    m_observed.mean_root.col(1) = Eigen::VectorXd::LinSpaced(m_lengths, -2e-3, 2e-3);
    // The precision of all, and of the two numbers behind the means of the lengths.
    const Eigen::MatrixXd root = m_observed.mean_root;
    const Eigen::MatrixXd pulls = m_observed.variance.cwiseInverse().asDiagonal() * root;
    const auto by_all = [&](const Eigen::VectorXd& x) {
        const Eigen::MatrixXd rates =
            finite_differences([this](const auto& at) { return imbalance(at); }, x, 1e-5);
        Eigen::MatrixXd measured =
            finite_differences([this](const auto& at) { return edge_tensions(at); }, x, 1e-5);
        measured.rightCols<common_count>() += m_observed.tension_bias;
        const auto weights = m_observed.tension_weights.asDiagonal();
        const Eigen::Index count = m_size + 2 + rates.rows();
        Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(count, count);
        whole.topLeftCorner(m_size, m_size) =
            m_matrix.topLeftCorner(m_size, m_size) -
            m_measured_rates.transpose() * weights * m_measured_rates +
            measured.transpose() * weights * measured;
        whole.block(m_places, m_size, m_lengths, 2) = -pulls;
        whole.block(m_size, m_places, 2, m_lengths) = -pulls.transpose();
        whole.block<2, 2>(m_size, m_size) = Eigen::Matrix2d::Identity() + root.transpose() * pulls;
        whole.bottomLeftCorner(rates.rows(), m_size) = rates;
        whole.topRightCorner(m_size, rates.rows()) = rates.transpose();
        const auto log_of = [](const Eigen::MatrixXd& matrix) {
            return matrix.partialPivLu().matrixLU().diagonal().array().abs().log().sum();
        };
        return 0.5 * log_of(whole) - log_of(rates(Eigen::all, free_places));
    };
    Iterate other = m_iterate;
    other.form += 1e-3 * Points::Random(3, m_net.node_count());
    other.deviations.array() -= 1.5e-3;
    const auto found = linearise(StaticsModel(m_net, m_uncertain), other, m_observed);
    ASSERT_TRUE(found);
    const double expected = by_all(together(other)) - by_all(together(m_iterate));
    EXPECT_NEAR(found->half_log_determinant(m_observed) -
                    m_fit->linearisation.half_log_determinant(m_observed),
                expected, 1e-4 * std::abs(expected));
    EXPECT_GT(std::abs(expected), 0.01);
}

TEST_F(Dense, TheSquaredNormHoldsAllThatIsObserved) {
    const Iterate step = m_fit->linearisation.step(m_iterate, m_observed);
    const Eigen::VectorXd dx = together(step);
    EXPECT_NEAR(m_fit->linearisation.squared_norm(m_observed, step),
                dx.dot(m_matrix.topLeftCorner(m_size, m_size) * dx),
                1e-5 * m_fit->linearisation.squared_norm(m_observed, step));
}

/// Samples of chains under the exact statics, where these are all but linear: a wrong derivative
/// makes the steps tiny, and a wrong metric the spread.
class Chains : public Linearised {
protected:
    Chains() {
        for (Points* const weights : {&m_observed.weights, &m_observed.cross_weights}) {
            *weights *= 400.0;
        }
        m_observed.variance /= 400.0;
        m_observed.load_variance /= 400.0;
        m_observed.cross_load_variance /= 400.0;
        m_observed.support_weights(Eigen::all, m_net.supports()).setConstant(3e8);
        m_iterate = nominal_iterate(m_net, common_count);
        Observations loose = m_observed;  // the form takes up what is out of balance
        for (Points* const weights : {&loose.weights, &loose.cross_weights}) {
            *weights *= 1e-6;
        }
        for (int k = 0; k < 10; ++k) {
            loose = satisfied(m_model, loose, m_iterate);
            m_iterate =
                m_iterate.moved(linearise(m_model, m_iterate, loose)->step(m_iterate, loose));
        }
        m_observed = satisfied(m_model, m_observed, m_iterate);
        m_model.corner_width = 1e-6;
    }

    /// Holds samples to the covariance of the linearisation, under another prior if they differ.
    void expect_samples_of(const Observations& observations, const Observations& linearised) {
        constexpr int count = 600;
        Iterate best = m_iterate;
        for (int k = 0; k < 8; ++k) {
            best = best.moved(linearise(m_model, best, linearised)->step(best, linearised));
        }
        const auto samples = hamiltonian_samples(m_model, observations, {}, best, count, 3);
        ASSERT_TRUE(samples);
        EXPECT_GT(samples->step, 0.2);
        EXPECT_GT(samples->acceptance, 0.6);
        EXPECT_LT(samples->disagreement, 1.1);
        Eigen::MatrixXd drawn(m_size, count);
        for (int k = 0; k < count; ++k) {
            drawn.col(k) = together(samples->iterates[static_cast<size_t>(k)]);
        }
        const Eigen::VectorXd means = drawn.rowwise().mean();
        const Eigen::VectorXd off = means - together(best);
        const Eigen::VectorXd variances =
            (drawn.colwise() - means).rowwise().squaredNorm() / (count - 1);
        const Covariance covariance = linearised_fit(m_model, best, linearised).covariance;
        Iterate expected = nominal_iterate(m_net, common_count);
        for (int node = 0; node < m_net.node_count(); ++node) {
            expected.form.col(node) = covariance.places[node].diagonal();
            expected.loads.col(node) = covariance.loads[node].diagonal();
        }
        expected.deviations = covariance.lengths;
        expected.common = covariance.common.diagonal();
        const Eigen::VectorXd stds = together(expected).cwiseSqrt();
        for (Eigen::Index i = 0; i < m_size; ++i) {
            EXPECT_NEAR(std::sqrt(variances(i)) / stds(i), 1.0, 0.2) << i;
            EXPECT_LT(std::abs(off(i)), 0.25 * stds(i)) << i;
        }
    }

    std::vector<UncertainParameter> m_narrow = [this] {
        std::vector<UncertainParameter> result = m_uncertain;
        for (UncertainParameter& one : result) {
            one.std_dev /= 20.0;
        }
        return result;
    }();
    StaticsModel m_model{m_net, m_narrow};
};

TEST_F(Chains, HaveTheMomentsOfAnAllButLinearProblem) {
    expect_samples_of(m_observed, m_observed);
}

TEST_F(Chains, HaveThoseOfPriorMeansInCommon) {  // (length-trend): of one edge, a wider prior
    Observations wider = m_observed;
    wider.variance(1) *= 5.0;
    m_observed.mean_root = Eigen::MatrixXd::Zero(m_lengths, 1);
    m_observed.mean_root(1, 0) = 2.0 * std::sqrt(m_observed.variance(1));
    expect_samples_of(m_observed, wider);
}

}  // namespace
