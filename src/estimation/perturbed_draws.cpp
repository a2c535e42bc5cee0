// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/perturbed_draws.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "estimation/balanced_draw.hpp"
#include "estimation/determinant_shift.hpp"
#include "estimation/draw_fit.hpp"
#include "estimation/drawn_posterior.hpp"
#include "estimation/hamiltonian_chain.hpp"
#include "estimation/imagined_observations.hpp"
#include "estimation/marginal_mode.hpp"
#include "numerics/parallel.hpp"
#include "numerics/random_numbers.hpp"
#include "sampling/uncertain_widths.hpp"

namespace taut {
namespace {

/// Draws that decide whether a method is reliable.
constexpr int pilot_draws = 10;

constexpr double largest_departure = 0.3;
constexpr double most_left_out = 0.02;

constexpr double corner_of_chains = 0.01;
constexpr int fewest_chain_draws = 40;  ///< they show whether chains follow the exact law

using Draws = std::vector<std::optional<BalancedDraw>>;

/// Adds draws up to a number, each from its own random numbers.
/// @param progress reports each
/// @param fit_of gives the fit of the k-th, from its random numbers and the last linearisation
template <class FitOf>
void add_draws(Draws& draws, int count, const DrawnPosterior& posterior, const Progress& progress,
               const FitOf& fit_of) {
    struct Workspace {
        EquilibriumSolver solver;
        std::optional<Linearisation> last;
    };
    const auto first = static_cast<int>(draws.size());
    draws.resize(static_cast<size_t>(count));
    PerThread<Workspace> workspaces(
        [&] { return Workspace{.solver = EquilibriumSolver(posterior.net()), .last = {}}; });
    std::mutex reporting;
    int done = first;
    parallel_for(first, count, [&](int k) {
        progress.throw_if_stopped();
        // Isolated, so that a waiting thread starts no other draw with the same workspace.
        isolate([&] {
            Workspace& workspace = workspaces.local();
            RandomNumbers random(posterior.seed, static_cast<std::uint32_t>(k));
            if (const std::optional<DrawFit> fit = fit_of(k, random, workspace.last)) {
                draws[k] = balanced_draw(posterior, *fit, random, workspace.solver);
            }
        });
        const std::scoped_lock lock(reporting);
        progress("posterior samples", ++done, count);
    });
}

/// Coordinates and forces that were measured and are in use.
double observed_count(const DrawnPosterior& posterior) {
    const Observations& sites = posterior.sites;
    const auto places =
        (sites.weights(Eigen::all, posterior.net().free_nodes()).array() > 0.0).count();
    const auto forces = std::ranges::count_if(
        posterior.knowledge.forces.measurements,
        [&](const ForceMeasurement& one) { return sites.tension_weights(one.edge) > 0.0; });
    return static_cast<double>(places + forces);
}

PerturbedDraws collected(const DrawnPosterior& posterior, const Draws& draws, bool is_refitted) {
    const CableNet& net = posterior.net();
    const auto count =
        std::ranges::count_if(draws, [](const auto& one) { return one.has_value(); });
    PerturbedDraws result{.deviations = Eigen::MatrixXd(net.interior_edge_count(), count),
                          .forms = Eigen::MatrixXd(Eigen::Index{3} * net.free_node_count(), count),
                          .tensions = Eigen::MatrixXd(net.edge_count(), count),
                          .is_refitted = is_refitted,
                          .left_out = static_cast<int>(std::ssize(draws) - count)};
    double squares = 0.0;
    Eigen::Index k = 0;
    for (const auto& one : draws) {
        if (!one) {
            continue;
        }
        result.deviations.col(k) = one->deviations;
        result.forms.col(k) = free_coordinates(net, one->form);
        result.tensions.col(k) = one->tensions;
        if (one->perturbation) {
            result.perturbations.push_back(*one->perturbation);
        }
        squares += one->squared_departure;
        ++k;
    }
    result.departure =
        std::sqrt(squares / std::max(1.0, observed_count(posterior) * static_cast<double>(count)));
    return result;
}

/// Root mean square by which tensions in equilibrium differ from those of the samples, in standard
/// deviations of the draws.
/// @param tensions of the draws (m x draws) [N]
double tension_departure(const Draws& draws, const Eigen::MatrixXd& tensions) {
    if (tensions.cols() == 0) {
        return std::numeric_limits<double>::infinity();
    }
    double squares = 0.0;
    for (const auto& one : draws) {
        squares += one ? one->squared_tension_departure : 0.0;
    }
    return std::sqrt(squares / (tensions.colwise() - tensions.rowwise().mean()).squaredNorm());
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
    return net.interior_edge_count() <= most_edges && !net.has_struts() &&
           net.sliding_nodes().empty();
}

PerturbedDraws draw_by_chains(const LinearisedFit& fitted, const Observations& sites,
                              const PriorKnowledge& knowledge, int draws, std::uint64_t seed,
                              const Progress& progress) {
    const DrawnPosterior posterior(fitted, sites, knowledge, seed);
    StaticsModel model = posterior.tensile_model;
    model.corner_width = corner_of_chains * posterior.smallest_noise();
    model.blur.strain_stds *= blurs_of_draws.back();
    const int count = std::max(draws, fewest_chain_draws);
    const std::optional<ChainSamples> found = hamiltonian_samples(
        model, sites, knowledge.forces.taut, posterior.all_taut, count, seed, progress);
    Draws all;
    add_draws(all, found ? count : 0, posterior, progress,
              [&](int k, RandomNumbers& random, std::optional<Linearisation>&) {
                  const Iterate& iterate = found->iterates[static_cast<size_t>(k)];
                  Observations of_mean = with_mean_given(sites, model.prior_variances(sites),
                                                         iterate.deviations, random);
                  return std::optional(DrawFit{.iterate = iterate,
                                               .tensions = model.tensions(iterate),
                                               .prior_mean = std::move(of_mean.mean),
                                               .is_refitted = true});
              });
    const double departure = tension_departure(all, collected(posterior, all, true).tensions);
    all.resize(static_cast<size_t>(draws));
    PerturbedDraws result = collected(posterior, all, true);
    result.departure = departure;
    result.is_of_chains = true;
    result.disagreement = found ? found->disagreement : std::numeric_limits<double>::infinity();
    return result;
}

PerturbedDraws draw_by_perturbation(const LinearisedFit& fitted, const Observations& sites,
                                    const PriorKnowledge& knowledge, int draws, std::uint64_t seed,
                                    bool by_fits, const Progress& progress) {
    const DrawnPosterior posterior(fitted, sites, knowledge, seed);
    Draws all;
    const auto add = [&](int count, const Observations& from) {
        add_draws(all, count, posterior, progress,
                  [&](int, RandomNumbers& random, std::optional<Linearisation>& last) {
                      return fit_perturbed(posterior, from, by_fits, random, last);
                  });
        return collected(posterior, all, by_fits);
    };
    PerturbedDraws pilot = add(std::min(draws, pilot_draws), sites);
    if (pilot.is_unreliable()) {
        return pilot;
    }
    // Moved only where loads at nodes are uncertain: by measurement, docs/theory.md. Of more edges
    // the fit was moved.
    const CableNet& net = posterior.net();
    if (!(std_of(knowledge.uncertain, UncertainParameter::Kind::loads_each) > 0.0) ||
        net.interior_edge_count() >= fewest_for_marginal_mode) {
        return add(draws, sites);
    }
    ShiftedSites shifted = shifted_by_determinant(posterior, by_fits, progress);
    all.clear();
    PerturbedDraws result = add(draws, shifted.sites);
    result.length_shift = std::move(shifted.length_shift);
    return result;
}

}  // namespace taut
