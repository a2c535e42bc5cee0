// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/outcome.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "taut/statics/tensions.hpp"

namespace taut {

std::vector<LengthLikelihood> likelihoods(const CableNet& net, const ConditionedStatics& statics,
                                          const Knowledge& knowledge, const Guess& fitted) {
    const Eigen::VectorXd variances = statics.length_variances();
    const Eigen::VectorXd extension_variances = statics.extension_variances();
    const Eigen::VectorXd lengths = edge_lengths(net, fitted.form);
    std::vector<LengthLikelihood> result;
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[i];
        // At loose nodes the variances can be lost in rounding errors: then nothing is told.
        const bool is_told = variances(i) > 0.0;
        LengthLikelihood likelihood =
            is_told ? without_prior(knowledge.mean(i), std::sqrt(knowledge.variance(i)),
                                    fitted.deviations(i), std::sqrt(variances(i)))
                    : LengthLikelihood();
        likelihood.slack_from = lengths(edge) - net.unstressed_lengths()(edge);
        if (statics.slack()[edge]) {
            likelihood.extension = -std::numeric_limits<double>::infinity();
        } else {
            const double extension = likelihood.slack_from - fitted.deviations(i);
            likelihood.extension =
                extension_variances(i) > 0.0
                    ? extension / std::sqrt(extension_variances(i))
                    : std::copysign(std::numeric_limits<double>::infinity(), extension);
        }
        result.push_back(likelihood);
    }
    return result;
}

void complete(Identification& result, const CableNet& net, const Survey& survey,
              const LengthLaw& law, const std::vector<LengthLikelihood>& likelihoods,
              const Points& start) {
    Eigen::VectorXd deviations(net.interior_edge_count());
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[i];
        const LengthPosterior posterior = posterior_of(law, likelihoods[i]);
        deviations(i) = posterior.mean;
        result.edges.push_back({.edge = edge,
                                .nominal = net.unstressed_lengths()(edge),
                                .length_deviation = posterior.mean,
                                .std = posterior.std,
                                .lower = posterior.lower,
                                .upper = posterior.upper,
                                .status = status_of(law, posterior)});
    }
    predict_form(result, net, survey, deviations, start);
}

Eigen::VectorXd residuals_in_use(const Identification& result, const Survey& survey) {
    std::vector<int> in_use;
    for (int i = 0; i < static_cast<int>(survey.surveyed.size()); ++i) {
        const int node = survey.surveyed[i];
        if (std::ranges::find(result.outliers, node, &Outlier::node) == result.outliers.end()) {
            in_use.push_back(i);
        }
    }
    return result.residuals(in_use);
}

void predict_form(Identification& result, const CableNet& net, const Survey& survey,
                  const Eigen::VectorXd& deviations, const Points& start) {
    result.predicted = EquilibriumSolver(net).solve(with_length_deviations(net, deviations), start);
    if (!result.predicted.balanced()) {
        throw std::runtime_error(fmt::format(
            "the identified lengths find no equilibrium: {:.4g} N out of balance after {} "
            "iterations",
            result.predicted.out_of_balance, result.predicted.iterations));
    }
    const Eigen::MatrixXd differences =
        (result.predicted.form - survey.form)(Eigen::all, survey.surveyed);
    result.residuals = differences.colwise().norm().transpose();
}

}  // namespace taut
