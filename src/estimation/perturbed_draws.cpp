// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/perturbed_draws.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "estimation/feasible_descent.hpp"
#include "estimation/hamiltonian_chain.hpp"
#include "estimation/imagined_observations.hpp"
#include "estimation/marginal_mode.hpp"
#include "estimation/prestress_shift.hpp"
#include "numerics/parallel.hpp"
#include "numerics/random_numbers.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// Draws that decide whether a method is reliable.
constexpr int pilot_draws = 10;

constexpr double largest_departure = 0.3;
constexpr double most_left_out = 0.02;

constexpr double decrement_of_draw = 0.05;

constexpr double corner_of_draws = 0.3;  ///< as in fit()
constexpr double corner_of_chains = 0.01;
constexpr int fewest_chain_draws = 40;  ///< they show whether chains follow the exact law

/// Draws that are fitted come to their tension laws in stages, each from the one before it: laws
/// are blurred by these parts of the blur of the fit.
constexpr double blurs_of_draws[] = {1.0, 0.5, 0.25, 0.125};

/// What draws that are fitted cannot follow: only the stiffness of each edge.
LawBlur blur_of_fits(LawBlur blur) {
    blur.missed.setZero();
    return blur;
}

/// In units of the smallest standard deviation of the survey.
constexpr double small_step = 0.1;

double smallest_noise(const CableNet& net, const Observations& observations) {
    return 1.0 / std::sqrt(observations.weights(Eigen::all, net.free_nodes()).maxCoeff());
}

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

/// The form of a fit with every edge stretched at least as in the nominal form: a slack edge does
/// not find its way back to tension.
Iterate all_taut(const CableNet& net, const Iterate& fitted) {
    const Eigen::VectorXd stretch = edge_lengths(net, net.nodes()) - net.unstressed_lengths();
    const Eigen::VectorXd spans = edge_lengths(net, fitted.form) - net.unstressed_lengths();
    Iterate result = fitted;
    result.deviations = result.deviations.cwiseMin((spans - stretch)(net.interior_edges()).eval());
    return result;
}

/// Draws one after another, each from its own random numbers.
class Perturbation {
public:
    Perturbation(const LinearisedFit& fitted, const Observations& sites,
                 const PriorKnowledge& knowledge, std::uint64_t seed)
        : m_net(fitted.model().net()),
          m_model(fitted.model()),
          m_linearisation(fitted.linearisation),
          m_sites(sites),
          m_knowledge(knowledge),
          m_fitted(fitted.iterate),
          m_refit_model(m_model),
          m_all_taut(all_taut(m_net, fitted.iterate)),
          m_shifted(sites),
          m_seed(seed) {
        m_refit_model.slack = knowledge.as_seen(std::vector<bool>(m_net.edge_count(), false));
        m_refit_model.corner_width = corner_of_draws * smallest_noise(m_net, sites);
        m_refit_model.blur = blur_of_fits(m_model.blur);
        m_refit_model.release_tension_laws();
    }

    /// This many draws; fewer where the first ones are unreliable.
    [[nodiscard]] PerturbedDraws run(int count, bool refit_all, const Progress& progress);
    /// This many draws by chains.
    [[nodiscard]] PerturbedDraws run_chains(int count, const Progress& progress) const;

private:
    struct Draw {
        Eigen::VectorXd deviations;
        Points form;
        Eigen::VectorXd tensions;
        std::optional<ModelPerturbation> perturbation;
        double squared_departure = 0.0;
        double squared_tension_departure = 0.0;  ///< of all edges [N2]
    };
    void add_draws(std::vector<std::optional<Draw>>& draws, int count, bool refit_all,
                   const Progress& progress) const;
    [[nodiscard]] PerturbedDraws collected(const std::vector<std::optional<Draw>>& draws,
                                           bool refit_all) const;
    struct Workspace {
        explicit Workspace(const CableNet& net) : solver(net) {}
        EquilibriumSolver solver;
        std::optional<Linearisation> last;  ///< of the fits
    };
    [[nodiscard]] std::optional<Draw> draw(int k, bool refit_all, Workspace& workspace) const;
    /// A fit to perturbed observations, and the tensions of all edges in it (m) [N].
    struct Fit {
        Iterate iterate;
        Eigen::VectorXd tensions;
    };
    [[nodiscard]] std::optional<Fit> followed(const Observations& observations) const;
    [[nodiscard]] std::optional<Fit> refitted(const Observations& observations,
                                              Workspace& workspace) const;
    /// What a draw is perturbed by, and the fit to it.
    struct Perturbed {
        Observations of_mean;
        Fit fit;
        bool is_refitted;
    };
    [[nodiscard]] std::optional<Perturbed> fit_of(RandomNumbers& random, bool refit_all,
                                                  Workspace& workspace) const;
    [[nodiscard]] const StaticsModel& model_of(bool refit) const {
        return refit ? m_refit_model : m_model;
    }
    [[nodiscard]] std::optional<Draw> completed(const Perturbed& found, RandomNumbers& random,
                                                Workspace& workspace) const;
    [[nodiscard]] double tension_departure(const std::vector<std::optional<Draw>>& draws) const;
    [[nodiscard]] std::vector<PerturbedFit> fits_with_determinants(bool refit_all,
                                                                   const Progress& progress) const;
    [[nodiscard]] Eigen::VectorXd move_sites(bool refit_all, const Progress& progress);
    [[nodiscard]] Observations moved_sites(const Iterate& shift) const;
    [[nodiscard]] Eigen::VectorXd own_lengths(Eigen::VectorXd deviations, bool refit_all) const;
    /// m_I, LawBlur::length_variances() [m2]
    [[nodiscard]] Eigen::VectorXd blur_variances(bool refit_all) const {
        const LawBlur& blur = refit_all ? m_refit_model.blur : m_model.blur;
        return blur.length_variances(m_net.interior_edge_count());
    }
    [[nodiscard]] Eigen::VectorXd separate_lengths(Iterate& drawn, const Eigen::VectorXd& tensions,
                                                   const Eigen::VectorXd& prior_mean,
                                                   const Eigen::VectorXd& blur, bool refit,
                                                   RandomNumbers& random) const;
    [[nodiscard]] std::vector<bool> slack_in(const Eigen::VectorXd& deviations,
                                             const Eigen::VectorXd& spans, bool refit) const;
    [[nodiscard]] double length_of_tension(int edge, double length, double tension,
                                           double own_stiffness,
                                           const Eigen::VectorXd& common) const;
    [[nodiscard]] ModelPerturbation drawn_perturbation(const Iterate& drawn,
                                                       const Eigen::VectorXd& own_stiffness) const;
    void hold_springs_as_loads(ModelPerturbation& perturbation, const Iterate& drawn,
                               const Points& form) const;
    [[nodiscard]] double squared_departure(const Iterate& drawn, const Eigen::VectorXd& tensions,
                                           const Points& form,
                                           const Eigen::VectorXd& tensions_in_balance) const;

    const CableNet& m_net;
    const StaticsModel& m_model;
    const Linearisation& m_linearisation;
    const Observations& m_sites;
    const PriorKnowledge& m_knowledge;
    const Iterate& m_fitted;
    StaticsModel m_refit_model;  ///< no edge carries pressure
    Iterate m_all_taut;
    Observations m_shifted;  ///< the sites, moved by move_sites()
    std::uint64_t m_seed;
};

/// Steps with the factor of the fit, each with the misfit and the forces at the result of the one
/// before; shorter ones where these overshoot. Nothing where they do not converge.
std::optional<Perturbation::Fit> Perturbation::followed(const Observations& observations) const {
    constexpr double slow_contraction = 0.7;
    constexpr double least_part = 0.1;
    const int most_steps = m_net.is_linear() ? 20 : 60;
    const double small = small_step * smallest_noise(m_net, m_sites);
    Iterate iterate = m_fitted;
    double before = std::numeric_limits<double>::infinity();
    double part = 1.0;
    for (int k = 0; k < most_steps; ++k) {
        const Iterate change = m_linearisation.step(iterate, observations);
        const double size = m_linearisation.size_of(change);
        if (!(size < slow_contraction * before)) {
            // On a linear net the draw is then fitted by itself.
            part *= 0.5;
            if (m_net.is_linear() || part < least_part || !std::isfinite(size)) {
                return std::nullopt;
            }
        }
        iterate = iterate.moved(change, part);
        if (size < small) {
            Eigen::VectorXd tensions = m_model.tensions(iterate);
            return Fit{std::move(iterate), std::move(tensions)};
        }
        before = size;
    }
    return std::nullopt;
}

std::optional<Perturbation::Fit> Perturbation::refitted(const Observations& observations,
                                                        Workspace& workspace) const {
    // A sample that takes more is far from normal: chains can follow it.
    constexpr int most_before_chains = 60;
    const int most = can_be_chained(m_net) ? most_before_chains : most_descents;
    Iterate start = m_all_taut;
    StaticsModel model = m_refit_model;
    std::optional<Fit> found;
    for (const double part : blurs_of_draws) {
        model.blur.strain_stds = part * m_refit_model.blur.strain_stds;
        GaussNewtonResult fit = feasible_descent(model, observations, start, decrement_of_draw,
                                                 most, {}, std::move(workspace.last));
        workspace.last = std::move(fit.linearisation);
        if (!fit.converged) {
            break;
        }
        found = Fit{fit.iterate, model.tensions(fit.iterate)};
        start = std::move(fit.iterate);
        if (m_net.is_linear()) {
            break;
        }
    }
    return found;
}

/// Separates the drawn deviations into blur, (own-stiffness) and (blurred-law), and the edges' own
/// lengths. An edge with a tension law or a stiffness of its own gets the length with which it
/// carries its tension in the draw; a slack edge one of the prior longer than the form spans.
/// @param tensions of all edges in the draw (m) [N]
/// @param prior_mean of the length deviations (m_I) [m]
/// @param blur variances of the additional length deviations (m_I) [m2]
/// @return logarithm of each edge's own stiffness (m), (own-stiffness)
Eigen::VectorXd Perturbation::separate_lengths(Iterate& drawn, const Eigen::VectorXd& tensions,
                                               const Eigen::VectorXd& prior_mean,
                                               const Eigen::VectorXd& blur, bool refit,
                                               RandomNumbers& random) const {
    const Eigen::VectorXd lengths = edge_lengths(m_net, drawn.form);
    const Eigen::VectorXd spans =
        m_model.common.cold(lengths, drawn.common) - m_net.unstressed_lengths();
    const std::vector<bool> slack = slack_in(drawn.deviations, spans, refit);
    const Eigen::VectorXd& of_stiffness = m_model.blur.stiffness;
    Eigen::VectorXd own_stiffness = Eigen::VectorXd::Zero(m_net.edge_count());
    for (int i = 0; i < drawn.deviations.size(); ++i) {
        const int edge = m_net.interior_edges()[i];
        const LengthPrior& prior = m_knowledge.priors[i];
        double& deviation = drawn.deviations(i);
        if (of_stiffness.size() > 0 && of_stiffness(i) > 0.0) {
            const double part = of_stiffness(i) / (m_sites.variance(i) + blur(i));
            const double length = part * (deviation - prior_mean(i)) +
                                  std::sqrt((1.0 - part) * of_stiffness(i)) * random.normal();
            own_stiffness(edge) = m_model.own_stiffness_sign(edge, tensions(edge)) *
                                  m_model.own_stiffness_stds()(edge) * length /
                                  std::sqrt(of_stiffness(i));
            deviation -= length;
        }
        // Of a sag by a drawn mass, too: samples have that of the net.
        if (m_net.bent_law(edge) != nullptr
                ? tensions(edge) > 0.0
                : (own_stiffness(edge) != 0.0 || m_net.sags()) && !slack[edge]) {
            deviation = length_of_tension(edge, lengths(edge), tensions(edge), own_stiffness(edge),
                                          drawn.common) -
                        m_net.unstressed_lengths()(edge);
        }
        const double bound = prior.kind == LengthPrior::Kind::uniform
                                 ? prior.scale
                                 : std::numeric_limits<double>::infinity();
        if (slack[edge] && spans(edge) < bound) {
            deviation = slack_deviation(prior, spans(edge), random);
        }
    }
    return own_stiffness;
}

/// Slack edges (m) of a draw: of a separate fit those longer than they span, corrected by the
/// marks.
std::vector<bool> Perturbation::slack_in(const Eigen::VectorXd& deviations,
                                         const Eigen::VectorXd& spans, bool refit) const {
    if (!refit) {
        return m_model.slack;
    }
    std::vector<bool> slack(m_net.edge_count(), false);
    for (int i = 0; i < deviations.size(); ++i) {
        const int edge = m_net.interior_edges()[i];
        slack[edge] = m_net.can_be_slack(edge) && deviations(i) > spans(edge);
    }
    return m_knowledge.as_seen(std::move(slack));
}

/// Unstressed length at which an edge with this stiffness of its own carries this tension at this
/// length.
double Perturbation::length_of_tension(int edge, double length, double tension,
                                       double own_stiffness, const Eigen::VectorXd& common) const {
    const CommonParameters& uncertain = m_model.common;
    const double stiffness = uncertain.stiffness_factor(edge, common) * std::exp(own_stiffness);
    const TensionLaw* law = m_net.tension_law(edge);
    const double strain = law == nullptr ? tension / (stiffness * m_net.axial_stiffness()(edge))
                                         : law->stiffened(stiffness).strain_at(tension);
    return length / (1.0 + strain) / (1.0 + uncertain.thermal_strain(edge, common));
}

/// Model perturbation of a draw.
ModelPerturbation Perturbation::drawn_perturbation(const Iterate& drawn,
                                                   const Eigen::VectorXd& own_stiffness) const {
    ModelPerturbation result = unperturbed(m_net);
    const CommonParameters& common = m_model.common;
    for (int e = 0; e < m_net.edge_count(); ++e) {
        result.stiffness(e) = std::log(common.stiffness_factor(e, drawn.common)) + own_stiffness(e);
        result.thermal(e) = common.thermal_strain(e, drawn.common);
    }
    result.supports(Eigen::all, m_net.supports()) =
        (drawn.form - m_net.nodes())(Eigen::all, m_net.supports());
    result.own_loads = drawn.loads * m_model.load_factors(drawn).asDiagonal();
    result.support_stiffness = std::log(common.support_factor(drawn.common));
    for (const Points& change :
         {common.load_change(drawn.common),
          Points(common.support_factor(drawn.common) * common.frame_loads(drawn.common))}) {
        if (change.cols() > 0) {
            result.own_loads += change;
        }
    }
    return result;
}

/// (elastic-supports): samples hold what the frame and another stiffness of supports change as
/// loads on these, in the frame of the net.
void Perturbation::hold_springs_as_loads(ModelPerturbation& perturbation, const Iterate& drawn,
                                         const Points& form) const {
    const double factor = std::exp(std::exchange(perturbation.support_stiffness, 0.0));
    Points forces = elastic_forces(m_net, form);
    if (const Points by_frame = m_model.common.frame_loads(drawn.common); by_frame.cols() > 0) {
        forces -= by_frame;
        perturbation.own_loads -= factor * by_frame;
    }
    perturbation.own_loads += (1.0 - factor) * forces;
}

/// Squared distance of a form in equilibrium and its tensions from those of the draw, in standard
/// deviations of the observations.
double Perturbation::squared_departure(const Iterate& drawn, const Eigen::VectorXd& tensions,
                                       const Points& form,
                                       const Eigen::VectorXd& tensions_in_balance) const {
    double sum = m_sites.squared_norm(form - drawn.form);
    for (const ForceMeasurement& force : m_knowledge.forces.measurements) {
        const int e = force.edge;
        sum += m_sites.tension_weights(e) * std::pow(tensions_in_balance(e) - tensions(e), 2);
    }
    return sum;
}

std::optional<Perturbation::Perturbed> Perturbation::fit_of(RandomNumbers& random, bool refit_all,
                                                            Workspace& workspace) const {
    Observations of_mean = with_drawn_mean(m_shifted, random);
    const Observations again = perturbed(m_net, of_mean, blur_variances(refit_all), random);
    auto fit = refit_all ? std::nullopt : followed(again);
    const bool refit = !fit;
    if (refit && (refit_all || (m_net.is_linear() && can_be_fitted(m_net)))) {
        fit = refitted(again, workspace);
    }
    return fit ? std::optional(Perturbed{std::move(of_mean), *std::move(fit), refit})
               : std::nullopt;
}

/// (determinant): further fits than the draws.
std::vector<PerturbedFit> Perturbation::fits_with_determinants(bool refit_all,
                                                               const Progress& progress) const {
    constexpr int samples = 40;  // the mean of a normal number is then known to 0.16
    constexpr std::uint32_t other_than_draws = 0x40000000U;
    const Observations sites = with_leading_means(m_sites);
    std::vector<std::optional<PerturbedFit>> fits(samples);
    PerThread<Workspace> workspaces([this] { return Workspace(m_net); });
    parallel_for(0, samples, [&](int k) {
        if (progress.stopped()) {
            throw Interrupted();
        }
        isolate([&] {
            Workspace& workspace = workspaces.local();
            RandomNumbers random(m_seed, other_than_draws + static_cast<std::uint32_t>(k));
            std::optional<Perturbed> found = fit_of(random, refit_all, workspace);
            if (!found) {
                return;
            }
            workspace.last = linearise(model_of(found->is_refitted), found->fit.iterate, sites,
                                       std::move(workspace.last));
            if (workspace.last) {
                fits[k] = {.iterate = std::move(found->fit.iterate),
                           .mean_tension = mean_weights(m_net).dot(found->fit.tensions),
                           .half_log_determinant = workspace.last->half_log_determinant(sites)};
            }
        });
    });
    std::vector<PerturbedFit> result;
    for (auto& fit : fits) {
        if (fit) {
            result.push_back(*std::move(fit));
        }
    }
    return result;
}

/// (determinant)
/// @return by how much the estimates of the lengths must move, too (m_I); empty: not at all
Eigen::VectorXd Perturbation::move_sites(bool refit_all, const Progress& progress) {
    constexpr double large = 1.0;  // it changes the determinant's slope: once more, from there
    const auto shift = [&] { return prestress_shift(fits_with_determinants(refit_all, progress)); };
    std::optional<PrestressShift> found = shift();
    if (!found) {
        return {};
    }
    m_shifted = moved_sites(found->by);
    if (found->size < large) {
        return {};
    }
    if (std::optional<PrestressShift> again = shift()) {
        found = std::move(again);
        m_shifted = moved_sites(found->by);
    }
    return own_lengths(std::move(found->by.deviations), refit_all);
}

/// What of deviations are lengths, and not the stiffness of an edge, (own-stiffness) (m_I).
Eigen::VectorXd Perturbation::own_lengths(Eigen::VectorXd deviations, bool refit_all) const {
    const Eigen::VectorXd& of_stiffness = m_model.blur.stiffness;
    if (of_stiffness.size() > 0) {
        const Eigen::VectorXd all = m_sites.variance + blur_variances(refit_all);
        deviations.array() *= 1.0 - of_stiffness.array() / all.array();
    }
    return deviations;
}

/// All that is observed and assumed, moved so that fits move by this, to first order.
Observations Perturbation::moved_sites(const Iterate& shift) const {
    Observations result = m_sites;
    const Iterate at = m_fitted.moved(shift);
    result.form += shift.form;
    result.support_mean += m_model.support_deviations(at) - m_model.support_deviations(m_fitted);
    result.mean += shift.deviations;
    result.load_mean += shift.loads;
    result.common_mean += shift.common;
    result.tension += m_sites.measured(m_model.tensions(at), at.common) -
                      m_sites.measured(m_model.tensions(m_fitted), m_fitted.common);
    if (m_sites.evidence) {
        result.evidence_pull +=
            m_sites.evidence->information * shift.lengths_and_common(result.evidence_pull.size());
    }
    return result;
}

std::optional<Perturbation::Draw> Perturbation::draw(int k, bool refit_all,
                                                     Workspace& workspace) const {
    RandomNumbers random(m_seed, static_cast<std::uint32_t>(k));
    const std::optional<Perturbed> found = fit_of(random, refit_all, workspace);
    return found ? completed(*found, random, workspace) : std::nullopt;
}

/// Brings a fit to exact equilibrium, with a length and a stiffness for each edge.
std::optional<Perturbation::Draw> Perturbation::completed(const Perturbed& found,
                                                          RandomNumbers& random,
                                                          Workspace& workspace) const {
    const Fit* const fit = &found.fit;
    Iterate drawn = fit->iterate;
    const Eigen::VectorXd own_stiffness =
        separate_lengths(drawn, fit->tensions, found.of_mean.mean,
                         blur_variances(found.is_refitted), found.is_refitted, random);
    const Eigen::VectorXd lengths = with_length_deviations(m_net, drawn.deviations);
    if (!(lengths.minCoeff() > 0.0) || !drawn.form.allFinite()) {
        return std::nullopt;
    }
    Draw result;
    const auto balance = [&](EquilibriumSolver& solver, const CableNet& net,
                             const Eigen::VectorXd& l_0) {
        const Equilibrium found = solver.solve(l_0, drawn.form);
        result.form = found.form;
        result.tensions = tensions(net, l_0, found.form);
        return found.balanced();
    };
    if (m_knowledge.uncertain.empty() && m_model.common.count() == 0) {
        if (!balance(workspace.solver, m_net, lengths)) {
            return std::nullopt;
        }
    } else {
        try {
            result.perturbation = drawn_perturbation(drawn, own_stiffness);
            const CableNet net = net_under(m_net, *result.perturbation, lengths);
            EquilibriumSolver solver(net);
            if (!balance(solver, net, net.unstressed_lengths())) {
                return std::nullopt;
            }
            result.perturbation->supports -= m_model.common.frame_motion(drawn.common);
            hold_springs_as_loads(*result.perturbation, drawn, result.form);
        } catch (const NetError&) {
            return std::nullopt;  // a length that is no longer positive
        }
    }
    result.squared_departure =
        squared_departure(fit->iterate, fit->tensions, result.form, result.tensions);
    result.squared_tension_departure = (result.tensions - fit->tensions).squaredNorm();
    result.deviations = std::move(drawn.deviations);
    return result;
}

void Perturbation::add_draws(std::vector<std::optional<Draw>>& draws, int count, bool refit_all,
                             const Progress& progress) const {
    const auto first = static_cast<int>(draws.size());
    draws.resize(count);
    PerThread<Workspace> workspaces([this] { return Workspace(m_net); });
    parallel_for(first, count, [&](int k) {
        if (progress.stopped()) {
            throw Interrupted();
        }
        // Isolated, so that a waiting thread starts no other draw with the same workspace.
        isolate([&] { draws[k] = draw(k, refit_all, workspaces.local()); });
    });
}

PerturbedDraws Perturbation::collected(const std::vector<std::optional<Draw>>& draws,
                                       bool refit_all) const {
    std::vector<const Draw*> found;
    found.reserve(draws.size());
    for (const auto& one : draws) {
        if (one) {
            found.push_back(&*one);
        }
    }
    const auto count = std::ssize(found);
    PerturbedDraws result{
        .deviations = Eigen::MatrixXd(m_net.interior_edge_count(), count),
        .forms = Eigen::MatrixXd(Eigen::Index{3} * m_net.free_node_count(), count),
        .tensions = Eigen::MatrixXd(m_net.edge_count(), count),
        .is_refitted = refit_all,
        .left_out = static_cast<int>(std::ssize(draws) - count)};
    double squares = 0.0;
    for (Eigen::Index k = 0; k < count; ++k) {
        result.deviations.col(k) = found[k]->deviations;
        result.forms.col(k) = free_coordinates(m_net, found[k]->form);
        result.tensions.col(k) = found[k]->tensions;
        if (found[k]->perturbation) {
            result.perturbations.push_back(*found[k]->perturbation);
        }
        squares += found[k]->squared_departure;
    }
    const auto places = (m_sites.weights(Eigen::all, m_net.free_nodes()).array() > 0.0).count();
    const auto forces = std::ranges::count_if(
        m_knowledge.forces.measurements,
        [this](const ForceMeasurement& one) { return m_sites.tension_weights(one.edge) > 0.0; });
    const auto observed = static_cast<double>(places + forces);
    result.departure = std::sqrt(squares / std::max(1.0, observed * static_cast<double>(count)));
    return result;
}

/// (hamiltonian)
PerturbedDraws Perturbation::run_chains(int count, const Progress& progress) const {
    StaticsModel model = m_refit_model;
    model.corner_width = corner_of_chains * smallest_noise(m_net, m_sites);
    model.blur.strain_stds *= *std::rbegin(blurs_of_draws);
    const int drawn = std::max(count, fewest_chain_draws);
    const std::optional<ChainSamples> found = hamiltonian_samples(
        model, m_sites, m_knowledge.forces.taut, m_all_taut, drawn, m_seed, progress);
    std::vector<std::optional<Draw>> draws(static_cast<size_t>(found ? drawn : 0));
    PerThread<Workspace> workspaces([this] { return Workspace(m_net); });
    parallel_for(0, static_cast<int>(draws.size()), [&](int k) {
        isolate([&] {
            RandomNumbers random(m_seed, static_cast<std::uint32_t>(k));
            const Iterate& iterate = found->iterates[static_cast<size_t>(k)];
            draws[k] =
                completed({.of_mean = with_mean_given(m_sites, model.prior_variances(m_sites),
                                                      iterate.deviations, random),
                           .fit = {.iterate = iterate, .tensions = model.tensions(iterate)},
                           .is_refitted = true},
                          random, workspaces.local());
        });
    });
    const double departure = tension_departure(draws);
    draws.resize(static_cast<size_t>(count));
    PerturbedDraws result = collected(draws, true);
    result.departure = departure;
    result.is_of_chains = true;
    result.disagreement = found ? found->disagreement : std::numeric_limits<double>::infinity();
    return result;
}

/// Root mean square by which tensions in equilibrium differ from those of the samples, in standard
/// deviations of the draws.
double Perturbation::tension_departure(const std::vector<std::optional<Draw>>& draws) const {
    const Eigen::MatrixXd tensions = collected(draws, true).tensions;
    if (tensions.cols() == 0) {
        return std::numeric_limits<double>::infinity();
    }
    double squares = 0.0;
    for (const auto& one : draws) {
        squares += one ? one->squared_tension_departure : 0.0;
    }
    return std::sqrt(squares / (tensions.colwise() - tensions.rowwise().mean()).squaredNorm());
}

PerturbedDraws Perturbation::run(int count, bool refit_all, const Progress& progress) {
    std::vector<std::optional<Draw>> draws;
    add_draws(draws, std::min(count, pilot_draws), refit_all, progress);
    PerturbedDraws pilot = collected(draws, refit_all);
    if (pilot.is_unreliable()) {
        return pilot;
    }
    Eigen::VectorXd length_shift;
    // Only where loads at nodes are uncertain: by measurement, docs/theory.md. Of more edges the
    // fit was moved.
    if (std_of(m_knowledge.uncertain, UncertainParameter::Kind::loads_each) > 0.0 &&
        m_net.interior_edge_count() < fewest_for_marginal_mode) {
        length_shift = move_sites(refit_all, progress);
        draws.clear();
    }
    add_draws(draws, count, refit_all, progress);
    PerturbedDraws result = collected(draws, refit_all);
    result.length_shift = std::move(length_shift);
    return result;
}

}  // namespace

bool PerturbedDraws::lacks_draws() const {
    return left_out > std::max(1.0, most_left_out * static_cast<double>(count() + left_out));
}

bool PerturbedDraws::departs() const {
    return !(departure <= largest_departure);
}

bool PerturbedDraws::differs() const {
    return !(disagreement < ChainSamples::agreed);
}

bool can_be_fitted(const CableNet& net) {
    constexpr int most_edges = 5000;
    return net.interior_edge_count() <= most_edges;
}

bool can_be_chained(const CableNet& net) {
    constexpr int most_edges = 400;
    return net.interior_edge_count() <= most_edges && !net.has_struts();
}

PerturbedDraws draw_by_chains(const LinearisedFit& fitted, const Observations& sites,
                              const PriorKnowledge& knowledge, int draws, std::uint64_t seed,
                              const Progress& progress) {
    return Perturbation(fitted, sites, knowledge, seed).run_chains(draws, progress);
}

PerturbedDraws draw_by_perturbation(const LinearisedFit& fitted, const Observations& sites,
                                    const PriorKnowledge& knowledge, int draws, std::uint64_t seed,
                                    bool by_fits, const Progress& progress) {
    return Perturbation(fitted, sites, knowledge, seed).run(draws, by_fits, progress);
}

}  // namespace taut
