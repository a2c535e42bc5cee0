// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "estimation/prior_knowledge.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/progress.hpp"
#include "taut/sampling/model_perturbation.hpp"

namespace taut {

/// Draws of the posterior, each in exact equilibrium.
struct PerturbedDraws {
    Eigen::MatrixXd deviations;  ///< m_I x draws [m]
    Eigen::MatrixXd forms;       ///< 3 n_I x draws [m]
    Eigen::MatrixXd tensions;    ///< m x draws, of all edges [N]
    /// Deviations from the net besides lengths, one a draw; empty where there can be none.
    std::vector<ModelPerturbation> perturbations;
    bool is_refitted = false;  ///< each by a fit of its own, not by the linearisation at the fit
    /// By how much all of them are moved off the fit, (determinant), where that is far (m_I): the
    /// estimates of the lengths must be, too; empty: not far [m].
    Eigen::VectorXd length_shift = {};
    /// Root mean square distance of the forms in equilibrium from those drawn, over surveyed
    /// coordinates and draws, in standard deviations of the survey; force measurements likewise. Of
    /// chains: that of the tensions, in standard deviations of all draws.
    double departure = 0.0;
    int left_out = 0;           ///< draws that found no fit or no equilibrium
    bool is_of_chains = false;  ///< of Markov chains; is_refitted holds, too
    double disagreement = 1.0;  ///< of the chains, ChainSamples

    /// Whether more than one draw, and more than 2 %, were left out.
    [[nodiscard]] bool lacks_draws() const;
    /// Whether the departure is above 0.3.
    [[nodiscard]] bool departs() const;
    /// Whether the chains disagree, ChainSamples::agreed.
    [[nodiscard]] bool differs() const;
    /// Whether any of these is so: then the draws are not of this posterior.
    [[nodiscard]] bool is_unreliable() const { return lacks_draws() || departs() || differs(); }
    [[nodiscard]] int count() const { return static_cast<int>(tensions.cols()); }
};

/// Draws by perturbation, docs/theory.md (perturbed): the fit to observations with new noise and
/// priors with new means, both drawn, is a draw of the posterior (G. Papandreou & A. L. Yuille,
/// Gaussian sampling by local perturbations, NIPS 2010). Where the statics are nearly linear over
/// the posterior, a few solutions with the factor of the fit suffice. With by_fits, and on linear
/// nets that are not too large where these do not contract, draws are fitted by themselves with
/// edges that carry no pressure and with their own tension laws (randomise-then-optimise, J. M.
/// Bardsley, A. Solonen, H. Haario & M. Laine, SIAM J. Sci. Comput. 36 (2014) A1895-A1910).
/// Instead of weights, all draws are moved by the mean that weights would give them,
/// docs/theory.md (determinant).
/// Lengths of slack edges follow the prior beyond the form. Those of taut ones may lie a little
/// outside its bounds, like the normal distributions with its mean and variance: truncated there,
/// tensions would be too certain. The result does not depend on the number of threads.
/// @param sites with the prior that the fit was made with
/// @throws Interrupted
[[nodiscard]] PerturbedDraws draw_by_perturbation(const LinearisedFit& fitted,
                                                  const Observations& sites,
                                                  const PriorKnowledge& knowledge, int draws,
                                                  std::uint64_t seed, bool by_fits,
                                                  const Progress& progress = {});

/// Draws by Hamiltonian Monte Carlo, docs/theory.md (hamiltonian): of posteriors that are too far
/// from normal for perturbation. Otherwise as draw_by_perturbation().
[[nodiscard]] PerturbedDraws draw_by_chains(const LinearisedFit& fitted, const Observations& sites,
                                            const PriorKnowledge& knowledge, int draws,
                                            std::uint64_t seed, const Progress& progress = {});

/// Whether chains take some minutes at most, and the form is the only one: up to 400 edges whose
/// lengths are uncertain, no struts.
[[nodiscard]] bool can_be_chained(const CableNet& net);

/// Whether draws are fitted by themselves in a minute: up to 5000 interior edges.
[[nodiscard]] bool can_be_fitted(const CableNet& net);

}  // namespace taut
