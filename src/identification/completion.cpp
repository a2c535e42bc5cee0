// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/completion.hpp"

#include <fmt/core.h>

#include <utility>

#include "identification/parameter_spread.hpp"
#include "net/sliding_nodes.hpp"
#include "taut/net/units.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {

void set_snooping(Identification& result, const Survey& survey, const Hypotheses& hypotheses,
                  std::vector<Outlier> outliers, bool contradicts_too_many) {
    result.outliers = std::move(outliers);
    result.outlier_threshold = hypotheses.is_active(Hypotheses::Family::targets)
                                   ? hypotheses.threshold(Suspect::target)
                                   : 0.0;
    result.noise_ratio = hypotheses.noise_ratio;
    if (contradicts_too_many) {
        result.status = IdentificationStatus::survey_does_not_fit;
        const bool is_by_digits =
            survey.rounding_std > 0.0 && survey.largest_noise_std() < 1.01 * survey.rounding_std;
        result.message = fmt::format(
            "{} of {} targets contradict the others. Check net, loads, frame, prior and the "
            "standard deviation of the survey ({:.3g} mm{})",
            result.outliers.size(), survey.surveyed.size() + survey.supports.size(),
            1e3 * survey.largest_noise_std(),
            is_by_digits ? ", from the digits of the coordinates alone: give that of the "
                           "instrument, or let taut estimate it"
                         : "");
    }
}

void set_edges(Identification& result, const CableNet& net, const std::vector<LengthPrior>& priors,
               const std::vector<LengthLikelihood>& likelihoods) {
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[i];
        const LengthPosterior posterior = posterior_of(priors[i], likelihoods[i]);
        result.edges.push_back({.edge = edge,
                                .nominal = net.unstressed_lengths()(edge),
                                .length_deviation = posterior.mean,
                                .std_dev = posterior.std_dev,
                                .lower = posterior.lower,
                                .upper = posterior.upper,
                                .status = status_of(priors[i].std_dev(), posterior)});
    }
}

void predict_form(Identification& result, const CableNet& net, const Survey& survey,
                  const Points& start, const Points& test_loads) {
    Eigen::VectorXd lengths = net.unstressed_lengths();
    for (const IdentifiedEdge& e : result.edges) {
        lengths(e.edge) += e.length_deviation;
        if (!(lengths(e.edge) > 0.0)) {
            result.status = IdentificationStatus::survey_does_not_fit;
            result.message = fmt::format(
                "the survey gives edge '{}' the unstressed length {:.4g} m. Check that it is of "
                "this net and in its frame, and give its standard deviation",
                net.edge_id(e.edge), lengths(e.edge));
            return;
        }
    }
    const auto balance = [&](const CableNet& free, const Eigen::VectorXd& l_0) {
        const CableNet identified = clamped(free);  // lengths are those after sliding
        result.predicted = EquilibriumSolver(identified).solve(l_0, start);
        // Lengths that leave the net nearly slack: nodes are loose, and the forces left there are
        // negligible.
        constexpr double negligible = 1e-7;
        if (result.predicted.status == EquilibriumStatus::iteration_limit &&
            result.predicted.out_of_balance <=
                negligible * taut::tensions_of(net, net.unstressed_lengths(), net.nodes())
                                 .cwiseAbs()
                                 .mean()) {
            result.predicted.status = EquilibriumStatus::slack_mechanism;
        }
        result.tensions =
            tensions_of(identified, result.predicted.unstressed_lengths, result.predicted.form);
    };
    if (result.uncertain.empty() && !result.frame_offset && result.boundary_outliers.empty()) {
        balance(net, lengths);
    } else {
        ModelPerturbation perturbation = perturbation_of(net, result.uncertain, test_loads);
        for (const BoundaryOutlier& outlier : result.boundary_outliers) {
            if (outlier.kind == BoundaryOutlier::Kind::support) {
                perturbation.supports.col(outlier.index) += outlier.deviation;
            } else {
                lengths(outlier.index) += outlier.deviation.x();
            }
        }
        if (result.frame_offset) {
            const Points motion = result.frame_offset->motion_of(net.nodes());
            perturbation.supports(Eigen::all, net.supports()) += motion(Eigen::all, net.supports());
            for (const auto& [node, stiffness, place] : net.elastic_supports()) {
                perturbation.supports.col(node) += result.frame_offset->motion_of(place).col(0);
            }
        }
        const CableNet identified = net_under(net, perturbation, lengths);
        balance(identified, identified.unstressed_lengths());
    }
    const Eigen::MatrixXd differences =
        (result.predicted.form - survey.form)(Eigen::all, survey.surveyed);
    result.residuals = differences.colwise().norm().transpose();
    if (!result.predicted.balanced() && result.status == IdentificationStatus::converged) {
        result.status = IdentificationStatus::no_equilibrium;
        result.message =
            result.predicted.status == EquilibriumStatus::unstable
                ? "with the identified lengths the equilibrium is not stable: struts give way"
                : fmt::format(
                      "the identified lengths find no equilibrium: {:.4g} N out of balance "
                      "after {} iterations",
                      result.predicted.out_of_balance, result.predicted.iterations);
    }
}

}  // namespace taut
