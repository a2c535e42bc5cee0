// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/exact_balance.hpp"

#include <fmt/core.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "estimation/length_likelihoods.hpp"
#include "estimation/linearised_statics.hpp"
#include "estimation/observations.hpp"
#include "estimation/slack_set.hpp"
#include "identification/completion.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// Bounds to the lengths that the form determines, in standard deviations of what stands for the
/// noise: wide enough to leave them free, and no wider than that, since variances are lost in
/// rounding errors where they are far below what was known before. The second is for lengths that
/// the form determines so badly that the first is not wide enough.
constexpr double narrow_bound = 1e2;
constexpr double wide_bound = 1e4;
constexpr double widest_part_of_bound = 3.0;

/// An exact form is met to rounding errors by the lengths that balance it. Where it is not, by more
/// than this part of an edge length, the intervals would be those of an exact survey around lengths
/// that are not.
constexpr double rounding_of_form = 1e-5;

/// The balance of a known form: linear in y, with 1/l_0 = (1 + y) / nominal.
class Balance {
public:
    Balance(const CableNet& net, const Points& form, const std::vector<bool>& slack)
        : m_forces(Eigen::VectorXd::Zero(Eigen::Index{3} * net.free_node_count())),
          m_matrix(m_forces.size(), net.interior_edge_count()) {
        Eigen::VectorXd node_stiffness = m_forces;
        Points forces = -net.loads();
        std::vector<Eigen::Triplet<double>> entries;
        int interior = 0;
        for (int e = 0; e < net.edge_count(); ++e) {
            const auto [s, t] = net.edges()[e];
            const bool is_interior =
                interior < net.interior_edge_count() && net.interior_edges()[interior] == e;
            const int column = is_interior ? interior++ : -1;
            if (slack[e]) {
                continue;
            }
            const Eigen::Vector3d vector = form.col(s) - form.col(t);
            const double axial = net.axial_stiffness()(e) / net.unstressed_lengths()(e);
            const Eigen::Vector3d force =
                axial * (1.0 - net.unstressed_lengths()(e) / vector.norm()) * vector;
            forces.col(s) += force;
            forces.col(t) -= force;
            for (const auto& [node, sign] : {std::pair{s, 1.0}, std::pair{t, -1.0}}) {
                const int row = 3 * net.free_index(node);
                if (row >= 0) {
                    node_stiffness.segment<3>(row).array() += axial;
                    for (int k = 0; is_interior && k < 3; ++k) {
                        entries.emplace_back(row + k, column, sign * axial * vector(k));
                    }
                }
            }
        }
        m_matrix.setFromTriplets(entries.begin(), entries.end());
        // Forces in terms of the move of their node, so that soft parts count as much as stiff
        // ones.
        const Eigen::VectorXd scale = node_stiffness.cwiseMax(1e-300).cwiseInverse();
        m_forces = scale.cwiseProduct(free_coordinates(net, forces));
        m_matrix = scale.asDiagonal() * m_matrix;
        Eigen::SparseMatrix<double> normal = m_matrix.transpose() * m_matrix;
        // Lengths that the forces do not show stay nominal.
        constexpr double smallest_part = 1e-13;
        m_shift = smallest_part * normal.diagonal().maxCoeff();
        for (Eigen::Index i = 0; i < normal.cols(); ++i) {
            normal.coeffRef(i, i) += m_shift;
        }
        m_factor.compute(normal);
    }

    /// y of least squares, by the normal equations and refinements, which bring back the digits
    /// that they lose.
    [[nodiscard]] Eigen::VectorXd solve() const {
        Eigen::VectorXd y = Eigen::VectorXd::Zero(m_matrix.cols());
        constexpr int passes = 3;
        for (int pass = 0; pass < passes; ++pass) {
            y -= m_factor.solve(m_matrix.transpose() * (m_forces + m_matrix * y));
        }
        return y;
    }

    /// Edges that have a part in a free state of self-stress, or are slack: the balance holds
    /// whatever their share of it. Each pass of inverse iteration takes most of what is not in the
    /// null space out of a vector that has a part in all of it.
    [[nodiscard]] std::vector<bool> undetermined() const {
        constexpr int passes = 4;
        constexpr double smallest_share = 1e-6;
        std::mt19937 random(1);
        Eigen::VectorXd share = Eigen::VectorXd::NullaryExpr(m_matrix.cols(), [&] {
            return std::uniform_real_distribution<double>(0.5, 1.0)(random) *
                   (random() % 2 == 0 ? 1.0 : -1.0);
        });
        for (int pass = 0; pass < passes; ++pass) {
            share = m_shift * m_factor.solve(share).eval();
        }
        std::vector<bool> result;
        for (const double s : share) {
            result.push_back(std::abs(s) > smallest_share);
        }
        return result;
    }

private:
    Eigen::VectorXd m_forces;  ///< at y = 0
    Eigen::SparseMatrix<double> m_matrix;
    double m_shift = 0.0;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_factor;  ///< of the normal equations
};

/// Length deviations (m_I) from y; an edge that balances with no positive length is told.
struct BalancedDeviations {
    Eigen::VectorXd deviations;
    int impossible_edge = -1;
};

BalancedDeviations balanced_deviations(const CableNet& net, const Balance& balance) {
    const Eigen::VectorXd y = balance.solve();
    BalancedDeviations result{.deviations = Eigen::VectorXd(y.size())};
    for (Eigen::Index i = 0; i < y.size(); ++i) {
        const int edge = net.interior_edges()[i];
        if (!(1.0 + y(i) > 0.0)) {
            result.impossible_edge = edge;
            return result;
        }
        result.deviations(i) = -net.unstressed_lengths()(edge) * y(i) / (1.0 + y(i));
    }
    return result;
}

/// What an exact form tells of each length, on top of its balance.
class ExactForm {
public:
    ExactForm(const CableNet& net, const Survey& survey, const LengthLaw& law)
        : m_net(net),
          m_survey(survey),
          m_noise(with_noise_floor(net, survey)),
          m_none_rejected(net.node_count(), false),
          m_balanced({.form = survey.form, .deviations = {}}),
          m_statics(net) {
        m_statics.set_slack(slack_by_form(net, m_balanced, law));
        const Balance balance(net, m_balanced.form, m_statics.slack());
        const BalancedDeviations balanced = balanced_deviations(net, balance);
        m_balanced.deviations = balanced.deviations;
        m_impossible_edge = balanced.impossible_edge;
        m_undetermined = balance.undetermined();
    }

    ExactForm(const ExactForm&) = delete;
    ExactForm& operator=(const ExactForm&) = delete;

    /// An edge that balances with no positive length; -1 where there is none.
    [[nodiscard]] int impossible_edge() const { return m_impossible_edge; }
    [[nodiscard]] const Points& form() const { return m_balanced.form; }

    [[nodiscard]] std::vector<LengthLikelihood> likelihoods(const LengthLaw& law) {
        const double unit = m_noise.maxCoeff();
        auto result = likelihoods_within(narrow_bound * unit);
        const auto replace = [&](double bound, const auto& applies) {
            std::vector<size_t> edges;
            for (size_t i = 0; i < result.size(); ++i) {
                const auto edge = static_cast<size_t>(m_net.interior_edges()[i]);
                if (!m_statics.slack()[edge] && applies(i)) {
                    edges.push_back(i);
                }
            }
            if (!edges.empty()) {
                const auto found = likelihoods_within(bound);
                for (const size_t i : edges) {
                    result[i] = found[i];
                }
            }
        };
        replace(wide_bound * unit, [&](size_t i) {
            return !m_undetermined[i] && result[i].std > widest_part_of_bound * narrow_bound * unit;
        });
        replace(law.std(), [&](size_t i) { return m_undetermined[i]; });
        return result;
    }

private:
    /// With a normal prior of this standard deviation around the balance, taken out again.
    [[nodiscard]] std::vector<LengthLikelihood> likelihoods_within(double length_std) {
        Observations observations = observe(m_net, m_survey, m_noise, m_none_rejected, length_std);
        observations.mean = m_balanced.deviations;
        if (!m_statics.linearise(m_balanced, observations)) {
            throw std::runtime_error(
                "the statics of the net are singular at the surveyed form: are net and law right?");
        }
        m_statics.invert();
        return length_likelihoods(m_net, m_statics, observations, m_balanced);
    }

    const CableNet& m_net;
    const Survey& m_survey;
    Points m_noise;
    std::vector<bool> m_none_rejected;
    Iterate m_balanced;
    LinearisedStatics m_statics;
    std::vector<bool> m_undetermined;  ///< m_I
    int m_impossible_edge = -1;
};

}  // namespace

Identification identify_by_exact_balance(const CableNet& net, const Survey& survey,
                                         const LengthLaw& law) {
    ExactForm exact(net, survey, law);
    Identification result{.method = "balance", .law = law};
    if (const int edge = exact.impossible_edge(); edge >= 0) {
        result.status = IdentificationStatus::survey_does_not_fit;
        result.message = fmt::format(
            "the forces at the surveyed form balance with no positive length of edge '{}': is the "
            "survey exact?",
            net.edge_id(edge));
        return result;
    }
    complete(result, net, survey, law, exact.likelihoods(law), exact.form());
    const double miss = std::sqrt(result.residuals.cwiseAbs2().mean());
    if (result.status == IdentificationStatus::converged &&
        miss > rounding_of_form * edge_lengths(net, net.nodes()).mean()) {
        result.status = IdentificationStatus::survey_not_exact;
        result.message = fmt::format(
            "is taken for exact, but no lengths of the law {} give its form: those found miss it "
            "by {:.3g} mm RMS. Tell its noise, or another law",
            law.to_string(), 1e3 * miss);
    }
    return result;
}

}  // namespace taut
