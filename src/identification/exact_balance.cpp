// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/exact_balance.hpp"

#include <fmt/core.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "identification/conditioned_statics.hpp"
#include "identification/outcome.hpp"
#include "identification/survey_fit.hpp"
#include "identification/survey_knowledge.hpp"
#include "taut/statics/energy.hpp"

namespace taut {
namespace {

/// Bounds to the lengths in standard deviations of what stands for the noise: wide enough to leave
/// them free, and no wider than that, since variances are lost in rounding errors where they are
/// far below what was known before. A length that the first does not narrow down is given the
/// second.
constexpr std::array exact_bounds{1e2, 1e4};

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
            const auto [s, t] = net.edges()[static_cast<size_t>(e)];
            const bool is_interior = interior < net.interior_edge_count() &&
                                     net.interior_edges()[static_cast<size_t>(interior)] == e;
            const int column = is_interior ? interior++ : -1;
            if (slack[static_cast<size_t>(e)]) {
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
    }

    /// y of least squares, by the normal equations and one refinement, which brings back the digits
    /// that they lose.
    [[nodiscard]] Eigen::VectorXd solve() const {
        Eigen::SparseMatrix<double> normal = m_matrix.transpose() * m_matrix;
        // Lengths that the forces do not show stay nominal.
        constexpr double smallest_part = 1e-13;
        const double shift = smallest_part * normal.diagonal().maxCoeff();
        for (Eigen::Index i = 0; i < normal.cols(); ++i) {
            normal.coeffRef(i, i) += shift;
        }
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(normal);
        Eigen::VectorXd y = Eigen::VectorXd::Zero(m_matrix.cols());
        constexpr int passes = 3;
        for (int pass = 0; pass < passes; ++pass) {
            y -= factor.solve(m_matrix.transpose() * (m_forces + m_matrix * y));
        }
        return y;
    }

private:
    Eigen::VectorXd m_forces;  ///< at y = 0
    Eigen::SparseMatrix<double> m_matrix;
};

Eigen::VectorXd balanced_deviations(const CableNet& net, const Points& form,
                                    const std::vector<bool>& slack) {
    const Eigen::VectorXd y = Balance(net, form, slack).solve();
    Eigen::VectorXd deviations(y.size());
    for (Eigen::Index i = 0; i < y.size(); ++i) {
        const int edge = net.interior_edges()[static_cast<size_t>(i)];
        if (!(1.0 + y(i) > 0.0)) {
            throw std::runtime_error(
                fmt::format("the forces at the surveyed form balance with no positive length of "
                            "edge '{}': is the noise too large for this method?",
                            net.edge_id(edge)));
        }
        deviations(i) = -net.unstressed_lengths()(edge) * y(i) / (1.0 + y(i));
    }
    return deviations;
}

/// What the balance at an exact form tells of each length.
std::vector<LengthLikelihood> exact_likelihoods(const CableNet& net, ConditionedStatics& statics,
                                                const Survey& survey, const Guess& balanced) {
    const Points noise = reckoned_noise(net, survey);
    const std::vector<bool> none_left_out(static_cast<size_t>(net.node_count()), false);
    std::vector<LengthLikelihood> result;
    for (const double bound : exact_bounds) {
        Knowledge knowledge =
            knowledge_of(net, survey, noise, none_left_out, bound * noise.maxCoeff());
        knowledge.mean = balanced.deviations;
        if (!statics.linearise(balanced, knowledge)) {
            throw std::runtime_error("the statics of the net are singular at the surveyed form");
        }
        statics.invert();
        const auto found = likelihoods(net, statics, knowledge, balanced);
        result.resize(found.size());
        for (size_t i = 0; i < found.size(); ++i) {
            if (std::isinf(result[i].std)) {
                result[i] = found[i];
            }
        }
        if (std::ranges::none_of(result, [](const auto& r) { return std::isinf(r.std); })) {
            break;
        }
    }
    return result;
}

}  // namespace

bool is_exact_and_complete(const CableNet& net, const Survey& survey) {
    return survey.missing.empty() &&
           static_cast<int>(survey.surveyed.size()) == net.free_node_count() &&
           (survey.noise_std.cols() == 0 ||
            survey.noise_std(Eigen::all, survey.surveyed).isZero(0.0));
}

Identification identify_by_exact_balance(const CableNet& net, const Survey& survey,
                                         const LengthLaw& law) {
    Guess balanced = surveyed_guess(
        net, survey, std::vector<bool>(static_cast<size_t>(net.node_count()), false));
    ConditionedStatics statics(net);
    statics.set_slack(slack_by_form(net, balanced, law));
    balanced.deviations = balanced_deviations(net, balanced.form, statics.slack());
    Identification result;
    complete(result, net, survey, law, exact_likelihoods(net, statics, survey, balanced),
             balanced.form);
    return result;
}

}  // namespace taut
