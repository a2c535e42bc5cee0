// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/draw_posterior.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "estimation/length_posterior.hpp"
#include "estimation/perturbed_draws.hpp"
#include "identification/drawn_summary.hpp"
#include "identification/stretch_lengths.hpp"
#include "statics/elastic_stretch.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// Distance of the mean of the draws from the estimate of each length, in its standard deviations,
/// over the edges.
struct LengthShift {
    double mean = 0.0;
    double rms = 0.0;  ///< without the scatter of so few draws
};

LengthShift length_shift(const Eigen::MatrixXd& deviations, const Identification& result) {
    LengthShift shift;
    const auto edges = static_cast<double>(result.edges.size());
    for (size_t i = 0; i < result.edges.size(); ++i) {
        const IdentifiedEdge& edge = result.edges[i];
        const double drawn = deviations.row(static_cast<Eigen::Index>(i)).mean();
        const double z = edge.std_dev > 0.0 ? (drawn - edge.length_deviation) / edge.std_dev : 0.0;
        shift.mean += z / edges;
        shift.rms += z * z / edges;
    }
    shift.rms = std::sqrt(std::max(0.0, shift.rms - 1.0 / static_cast<double>(deviations.cols())));
    return shift;
}

/// Why draws are not reliable; empty where they are.
std::string why_unreliable(const PerturbedDraws& drawn, const Eigen::MatrixXd& deviations,
                           const Identification& result, const CableNet& net) {
    if (!drawn.is_unreliable()) {
        // A small shift that all edges share is large for the mean tension.
        constexpr double largest_common_shift = 0.1;
        constexpr double largest_shift = 0.3;
        if ((net.is_linear() && !net.sags()) || drawn.is_refitted || deviations.cols() == 0) {
            return {};
        }
        const LengthShift shift = length_shift(deviations, result);
        if (std::abs(shift.mean) <= largest_common_shift && shift.rms <= largest_shift) {
            return {};
        }
        return fmt::format(
            "the tension laws bend too much within what this survey leaves open. The samples' "
            "lengths differ from those estimated by {:.2g} standard deviations RMS, {:+.2g} in the "
            "mean",
            shift.rms, shift.mean);
    }
    const double stretch = mean_stretch(net);
    double known = 0.0;
    for (const IdentifiedEdge& edge : result.edges) {
        known += edge.std_dev / static_cast<double>(result.edges.size());
    }
    const bool makes_no_way = drawn.is_of_chains && !std::isfinite(drawn.disagreement);
    if (stretch < known && (!drawn.is_of_chains || makes_no_way)) {
        return fmt::format(
            "this survey does not show which edges are slack. The cables stretch by {:.2g} mm in "
            "the mean, and their lengths are known to +-{:.2g} mm",
            1e3 * stretch, 1e3 * known);
    }
    std::vector<std::string> reasons;
    if (makes_no_way) {
        reasons.emplace_back("chains of samples make no way");
    } else if (drawn.differs()) {
        reasons.push_back(
            fmt::format("chains of samples differ, R-hat {:.3g}", drawn.disagreement));
    }
    if (drawn.lacks_draws() && !makes_no_way) {
        reasons.push_back(fmt::format("{} of {} samples found no equilibrium", drawn.left_out,
                                      drawn.count() + drawn.left_out));
    }
    if (drawn.departs() && drawn.count() > 0) {
        reasons.push_back(
            fmt::format("the samples miss equilibrium by {:.2g} standard deviations of {}",
                        drawn.departure, drawn.is_of_chains ? "their tensions" : "the survey"));
    }
    return fmt::format(
        "they depend too strongly on how slack the cables are, which this survey does not show "
        "({}). A closer survey, a narrower prior if it is true, or load cells would help",
        fmt::join(reasons, ", "));
}

ModelPerturbations perturbations_of(const CableNet& net,
                                    const std::vector<ModelPerturbation>& draws) {
    const auto collected = [&](Eigen::Index rows, const auto& of_draw) {
        Eigen::MatrixXd result(rows, std::ssize(draws));
        for (Eigen::Index k = 0; k < result.cols(); ++k) {
            result.col(k) = of_draw(draws[static_cast<size_t>(k)]);
        }
        return result.isZero(0.0) ? Eigen::MatrixXd() : result;
    };
    const Eigen::Index edges = net.edge_count();
    return {
        .stiffness = collected(edges, [](const ModelPerturbation& one) { return one.stiffness; }),
        .thermal = collected(edges, [](const ModelPerturbation& one) { return one.thermal; }),
        .supports = collected(std::ssize(net.supports()) * 3,
                              [&](const ModelPerturbation& one) {
                                  return Eigen::VectorXd(
                                      one.supports(Eigen::all, net.supports()).reshaped());
                              }),
        .loads =
            collected(Eigen::Index{3} * net.free_node_count(), [&](const ModelPerturbation& one) {
                return free_coordinates(net, one.loads * net.loads() + one.own_loads);
            })};
}

/// Edges that may be slack, as far as the survey shows, are known by their prior alone. Edges of
/// the slack set are slack: no length of the prior makes them taut.
void set_open_edges(Identification& result, const std::vector<LengthPrior>& priors,
                    const std::vector<bool>& slack_set) {
    for (size_t i = 0; i < result.edges.size(); ++i) {
        IdentifiedEdge& edge = result.edges[i];
        if (edge.status == EdgeStatus::slack && !slack_set[edge.edge]) {
            const LengthPosterior by_prior = posterior_of(priors[i], {});
            edge.length_deviation = by_prior.mean;
            edge.std_dev = by_prior.std_dev;
            edge.lower = by_prior.lower;
            edge.upper = by_prior.upper;
            edge.status = EdgeStatus::not_determined;
        }
    }
}

/// (drawn-means): whether the mean of refitted draws differs from the estimate by chance alone.
class ByChance {
public:
    ByChance(const Eigen::MatrixXd& deviations, const Identification& result) {
        constexpr double sure = 2.0;
        const LengthShift shift = length_shift(deviations, result);
        m_std = 1.0 / std::sqrt(static_cast<double>(deviations.cols()));
        m_of_all = std::abs(shift.mean) <= sure * m_std && shift.rms <= sure * m_std;
    }
    [[nodiscard]] bool differs(const IdentifiedEdge& edge, double drawn) const {
        constexpr double sure = 4.0;  // of many edges
        return m_of_all && std::abs(drawn - edge.length_deviation) <= sure * m_std * edge.std_dev;
    }

private:
    double m_std;
    bool m_of_all;
};

/// Sets the status of each interior edge, and its length where the draws are better than the
/// linearisation.
/// @param prior_stds of each interior edge (m_I) [m]
void set_drawn_edges(Identification& result, const Eigen::VectorXd& prior_stds) {
    const Eigen::MatrixXd& deviations = result.draws->length_deviations;
    const ByChance by_chance(deviations, result);
    for (size_t i = 0; i < result.edges.size(); ++i) {
        IdentifiedEdge& edge = result.edges[i];
        if (result.draws->is_refitted) {
            const Eigen::VectorXd drawn = deviations.row(static_cast<Eigen::Index>(i));
            const DrawnEstimate estimate = estimate_of(drawn);
            const double shift = by_chance.differs(edge, estimate.mean)
                                     ? edge.length_deviation - estimate.mean
                                     : 0.0;
            edge.length_deviation = estimate.mean + shift;
            edge.std_dev = estimate.std_dev;
            // No further out than the prior reaches, or a sample does.
            const double reach = std::max(result.length_prior.reach(), drawn.cwiseAbs().maxCoeff());
            edge.lower = std::min(std::max(estimate.lower, -reach) + shift, edge.length_deviation);
            edge.upper = std::max(std::min(estimate.upper, reach) + shift, edge.length_deviation);
        }
        const double slack = result.drawn.tensions[edge.edge].slack_probability;
        edge.status = status_of(prior_stds(static_cast<Eigen::Index>(i)),
                                {.std_dev = edge.std_dev, .slack_probability = slack});
    }
}

/// Moves the estimates of the lengths, within the bounds of their priors.
void move_lengths(Identification& result, const Eigen::VectorXd& shift,
                  const std::vector<LengthPrior>& priors) {
    for (size_t i = 0; i < result.edges.size(); ++i) {
        IdentifiedEdge& edge = result.edges[i];
        if (edge.status == EdgeStatus::slack) {
            continue;
        }
        const double bound = priors[i].kind == LengthPrior::Kind::uniform
                                 ? priors[i].scale
                                 : std::numeric_limits<double>::infinity();
        for (double* const value : {&edge.length_deviation, &edge.lower, &edge.upper}) {
            *value = std::clamp(*value + shift(static_cast<Eigen::Index>(i)),
                                std::min(-bound, *value), std::max(bound, *value));
        }
    }
}

/// Replaces the linearised covariances of the free nodes' places.
void set_drawn_covariances(Identification& result, const CableNet& net) {
    // Fewer draws show an axis of an ellipse to an eighth at best.
    constexpr int fewest_draws = 30;
    const Eigen::MatrixXd& forms = result.draws->forms;
    if (forms.cols() < fewest_draws || result.form_covariance.empty()) {
        return;
    }
    for (int i = 0; i < net.free_node_count(); ++i) {
        const auto places = forms.middleRows<3>(Eigen::Index{3} * i);
        const Eigen::Matrix3Xd deviations = places.colwise() - places.rowwise().mean();
        result.form_covariance[static_cast<size_t>(net.free_nodes()[i])] =
            deviations * deviations.transpose() / static_cast<double>(forms.cols() - 1);
    }
}

/// Sets what follows from reliable draws.
void summarise(Identification& result, const CableNet& net, const Survey& survey,
               const Eigen::VectorXd& prior_stds) {
    result.drawn = summary_of(*result.draws, net, survey.missing);
    set_drawn_covariances(result, net);
    set_drawn_edges(result, prior_stds);
}

}  // namespace

void draw_posterior(Identification& result, const CableNet& net, const CableNet& fit_net,
                    const Survey& survey, const PriorKnowledge& knowledge,
                    const LinearisedFit& fitted, const Observations& sites,
                    const PosteriorSettings& settings, const Progress& progress) {
    if (settings.count == 0 || result.status != IdentificationStatus::converged) {
        return;
    }
    const auto draw = [&](bool by_fits) {
        return draw_by_perturbation(fitted, sites, knowledge, settings.count, settings.seed,
                                    by_fits, progress);
    };
    const bool has_all_lengths = fit_net.interior_edge_count() > net.interior_edge_count();
    const Eigen::VectorXd slid = fit_net.unstressed_lengths() - net.unstressed_lengths();
    const auto of_edges = [&](const std::vector<int>& edges,
                              const Eigen::MatrixXd& deviations) -> Eigen::MatrixXd {
        return deviations(edges, Eigen::all).colwise() + slid(edges);
    };
    const auto interior = [&](const Eigen::MatrixXd& deviations) -> Eigen::MatrixXd {
        return has_all_lengths ? of_edges(net.interior_edges(), deviations)
                               : deviations.colwise() + slid(net.interior_edges());
    };
    PerturbedDraws drawn = draw(false);
    std::string reason = why_unreliable(drawn, interior(drawn.deviations), result, net);
    if (!reason.empty() && can_be_fitted(fit_net)) {
        drawn = draw(true);
        reason = why_unreliable(drawn, interior(drawn.deviations), result, net);
    }
    if (!reason.empty() && settings.by_chains && can_be_chained(fit_net)) {
        drawn = draw_by_chains(fitted, sites, knowledge, settings.count, settings.seed, progress);
        reason = why_unreliable(drawn, interior(drawn.deviations), result, net);
    }
    PosteriorDraws draws{.length_deviations = interior(drawn.deviations),
                         .adjustable_deviations = {},
                         .perturbations = perturbations_of(fit_net, drawn.perturbations),
                         .forms = std::move(drawn.forms),
                         .tensions = std::move(drawn.tensions),
                         .seed = settings.seed,
                         .method = drawn.is_of_chains  ? "Hamiltonian Monte Carlo"
                                   : drawn.is_refitted ? "a fit each to a perturbed survey"
                                   : drawn.length_shift.size() > 0
                                       ? "perturbation of the fit, moved to the posterior mean"
                                       : "perturbation of the fit",
                         .is_refitted = drawn.is_refitted,
                         .reason = std::move(reason)};
    if (has_all_lengths) {
        draws.adjustable_deviations = of_edges(net.adjustable_edges(), drawn.deviations);
    }
    std::vector<LengthPrior> priors = interior_priors(net, knowledge);
    for (size_t i = 0; i < priors.size() && !result.stretches.empty(); ++i) {
        const double before = std_before(result, net.interior_edges()[i], priors[i].std_dev());
        if (before != priors[i].std_dev()) {
            priors[i] = {LengthPrior::Kind::normal, before};
        }
    }
    const bool is_reliable = draws.reason.empty() && draws.count() > 0;
    result.draws = std::move(draws);
    if (!is_reliable) {
        result.form_covariance.clear();
        set_open_edges(result, priors, fitted.model().slack);
        return;  // no interval rather than a wrong one
    }
    if (drawn.length_shift.size() > 0) {
        move_lengths(
            result,
            has_all_lengths ? drawn.length_shift(net.interior_edges()).eval() : drawn.length_shift,
            priors);
    }
    Eigen::VectorXd prior_stds(std::ssize(priors));
    std::ranges::transform(priors, prior_stds.begin(), &LengthPrior::std_dev);
    summarise(result, net, survey, prior_stds);
}

void set_summary_of_draws(Identification& result, const CableNet& net, const Survey& survey,
                          double prior_std) {
    result.drawn = {};
    if (result.draws->reason.empty() && result.draws->count() > 0) {
        Eigen::VectorXd before(std::ssize(result.edges));
        std::ranges::transform(result.edges, before.begin(), [&](const IdentifiedEdge& one) {
            return std_before(result, one.edge, prior_std);
        });
        summarise(result, net, survey, before);
    } else {
        result.form_covariance.clear();
    }
}

}  // namespace taut
