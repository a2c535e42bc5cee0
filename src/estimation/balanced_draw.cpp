// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/balanced_draw.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "net/sliding_nodes.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// What the length deviations of a draw stand for.
struct DrawnLengths {
    Eigen::VectorXd deviations;     ///< of the edges' lengths between their nodes (m_I) [m]
    Eigen::VectorXd own_stiffness;  ///< logarithm of each edge's own factor, (own-stiffness) (m)
};

/// A length drawn from the prior, but longer than the form spans, if the prior has any.
double slack_deviation(const LengthPrior& prior, double slack_from, RandomNumbers& random) {
    constexpr int most_attempts = 1000;
    for (int trial = 0; trial < most_attempts; ++trial) {
        if (const double deviation = prior.draw(random.uniform()); deviation > slack_from) {
            return deviation;
        }
    }
    return slack_from;
}

/// Slack edges (m) of a draw: of a separate fit those longer than they span, corrected by the
/// marks.
/// @param spans length deviations with which edges would be as long as they span (m) [m]
std::vector<bool> slack_in(const DrawnPosterior& posterior, const DrawFit& fit,
                           const Eigen::VectorXd& spans) {
    if (!fit.is_refitted) {
        return posterior.fit.model().slack;
    }
    const CableNet& net = posterior.net();
    std::vector<bool> slack(net.edge_count(), false);
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[i];
        slack[edge] = net.can_be_slack(edge) && fit.iterate.deviations(i) > spans(edge);
    }
    return posterior.knowledge.as_seen(std::move(slack));
}

/// Unstressed length at which an edge with this stiffness of its own carries this tension at this
/// length [m].
double length_of_tension(const StaticsModel& model, int edge, double length, double tension,
                         double own_stiffness, const Eigen::VectorXd& common) {
    const CableNet& net = model.net();
    const double stiffness = model.common.stiffness_factor(edge, common) * std::exp(own_stiffness);
    const TensionLaw* law = net.tension_law(edge);
    const double strain = law == nullptr ? tension / (stiffness * net.axial_stiffness()(edge))
                                         : law->stiffened(stiffness).strain_at(tension);
    return model.common.cold(edge, length / (1.0 + strain), common);
}

/// Separates the deviations of a draw into blur, (own-stiffness) and (blurred-law), and the edges'
/// own lengths. An edge with a tension law or a stiffness of its own gets the length with which it
/// carries its tension in the draw; a slack edge one of the prior longer than the form spans.
DrawnLengths separated_lengths(const DrawnPosterior& posterior, const DrawFit& fit,
                               RandomNumbers& random) {
    const CableNet& net = posterior.net();
    const StaticsModel& model = posterior.fit.model();
    const Eigen::VectorXd& common = fit.iterate.common;
    const Eigen::VectorXd lengths = edge_lengths(net, fit.iterate.form);
    const Eigen::VectorXd spans = model.common.cold(lengths, common) - net.unstressed_lengths();
    const std::vector<bool> slack = slack_in(posterior, fit, spans);
    const Eigen::VectorXd blur = posterior.blur_variances(fit.is_refitted);
    const Eigen::VectorXd& of_stiffness = model.blur.stiffness;
    DrawnLengths result{.deviations = fit.iterate.deviations,
                        .own_stiffness = Eigen::VectorXd::Zero(net.edge_count())};
    for (int i = 0; i < result.deviations.size(); ++i) {
        const int edge = net.interior_edges()[i];
        const double tension = fit.tensions(edge);
        double& own_stiffness = result.own_stiffness(edge);
        double& deviation = result.deviations(i);
        if (of_stiffness.size() > 0 && of_stiffness(i) > 0.0) {
            const double part = of_stiffness(i) / (posterior.sites.variance(i) + blur(i));
            const double length = part * (deviation - fit.prior_mean(i)) +
                                  std::sqrt((1.0 - part) * of_stiffness(i)) * random.normal();
            own_stiffness = model.own_stiffness_sign(edge, tension) *
                            model.own_stiffness_stds()(edge) * length / std::sqrt(of_stiffness(i));
            deviation -= length;
        }
        // Of a sag by a drawn mass, too: samples have that of the net.
        if (net.bent_law(edge) != nullptr ? tension > 0.0
                                          : (own_stiffness != 0.0 || net.sags()) && !slack[edge]) {
            deviation =
                length_of_tension(model, edge, lengths(edge), tension, own_stiffness, common) -
                net.unstressed_lengths()(edge);
        }
        const LengthPrior& prior = posterior.knowledge.priors[i];
        const double bound = prior.kind == LengthPrior::Kind::uniform
                                 ? prior.scale
                                 : std::numeric_limits<double>::infinity();
        if (slack[edge] && spans(edge) < bound) {
            deviation = slack_deviation(prior, spans(edge), random);
        }
        deviation += model.common.slip(edge, common);
    }
    return result;
}

/// What a draw changes besides lengths; the stiffness of supports as a factor of its own.
/// @param own_stiffness DrawnLengths::own_stiffness
ModelPerturbation drawn_perturbation(const StaticsModel& model, const Iterate& drawn,
                                     const Eigen::VectorXd& own_stiffness) {
    const CableNet& net = model.net();
    const CommonParameters& common = model.common;
    ModelPerturbation result = unperturbed(net);
    for (int e = 0; e < net.edge_count(); ++e) {
        result.stiffness(e) = std::log(common.stiffness_factor(e, drawn.common)) + own_stiffness(e);
        result.thermal(e) = common.thermal_strain(e, drawn.common);
    }
    result.supports(Eigen::all, net.supports()) =
        (drawn.form - net.nodes())(Eigen::all, net.supports());
    result.own_loads = drawn.loads * model.load_factors(drawn).asDiagonal();
    result.support_stiffness = std::log(common.support_factor(drawn.common));
    for (const Points& change :
         {common.load_change(drawn.common),
          Points(common.support_factor(drawn.common) * common.frame_loads(drawn.common)),
          Points(common.support_factor(drawn.common) * common.place_loads(drawn.common))}) {
        if (change.cols() > 0) {
            result.own_loads += change;
        }
    }
    return result;
}

/// (elastic-supports): samples hold what the frame and another stiffness of supports change as
/// loads on these, in the frame of the net.
/// @param form in equilibrium under the perturbation (3 x n) [m]
void hold_springs_as_loads(ModelPerturbation& perturbation, const StaticsModel& model,
                           const Iterate& drawn, const Points& form) {
    const double factor = std::exp(std::exchange(perturbation.support_stiffness, 0.0));
    Points forces = elastic_forces(model.net(), form);
    if (const Points by_frame = model.common.frame_loads(drawn.common); by_frame.cols() > 0) {
        forces -= by_frame;
        perturbation.own_loads -= factor * by_frame;
    }
    perturbation.own_loads += (1.0 - factor) * forces;
}

double squared_departure(const DrawnPosterior& posterior, const DrawFit& fit,
                         const BalancedDraw& balanced) {
    double sum = posterior.sites.squared_norm(balanced.form - fit.iterate.form);
    for (const ForceMeasurement& force : posterior.knowledge.forces.measurements) {
        const int e = force.edge;
        sum += posterior.sites.tension_weights(e) *
               std::pow(balanced.tensions(e) - fit.tensions(e), 2);
    }
    return sum;
}

/// Sets form and tensions; false where there is no equilibrium.
/// @param lengths unstressed (m) [m]
bool balance(EquilibriumSolver& solver, const CableNet& net, const Eigen::VectorXd& lengths,
             const Points& start, BalancedDraw& result) {
    const Equilibrium found = solver.solve(lengths, start);
    result.form = found.form;
    result.tensions = tensions_of(net, found.unstressed_lengths, found.form);
    return found.balanced();
}

}  // namespace

std::optional<BalancedDraw> balanced_draw(const DrawnPosterior& posterior, const DrawFit& fit,
                                          RandomNumbers& random, EquilibriumSolver& solver) {
    const CableNet& net = posterior.net();
    const StaticsModel& model = posterior.fit.model();
    const Iterate& drawn = fit.iterate;
    const DrawnLengths found = separated_lengths(posterior, fit, random);
    const Eigen::VectorXd lengths = with_length_deviations(net, found.deviations);
    if (!(lengths.minCoeff() > 0.0) || !drawn.form.allFinite()) {
        return std::nullopt;
    }
    BalancedDraw result;
    result.deviations = found.deviations;
    if (posterior.knowledge.uncertain.empty() && model.common.count() == 0) {
        if (!balance(solver, net, lengths, drawn.form, result)) {
            return std::nullopt;
        }
    } else {
        try {
            ModelPerturbation perturbation = drawn_perturbation(model, drawn, found.own_stiffness);
            const CableNet as_drawn = clamped(net_under(net, perturbation, lengths));
            EquilibriumSolver own_solver(as_drawn);
            if (!balance(own_solver, as_drawn, as_drawn.unstressed_lengths(), drawn.form, result)) {
                return std::nullopt;
            }
            perturbation.supports -= model.common.frame_motion(drawn.common);
            hold_springs_as_loads(perturbation, model, drawn, result.form);
            result.perturbation = std::move(perturbation);
        } catch (const NetError&) {
            return std::nullopt;  // a length that is no longer positive
        }
    }
    result.squared_departure = squared_departure(posterior, fit, result);
    result.squared_tension_departure = (result.tensions - fit.tensions).squaredNorm();
    return result;
}

}  // namespace taut
