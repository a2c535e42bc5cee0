// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {

/// The data set D of the paper (Algorithm 2) in deviations from the nominal net: pairs of form
/// deviation and length deviation (section 5: f maps one to the other).
struct TAUT_CORE_EXPORT DataSet {
    std::string net_fingerprint;                ///< CableNet::fingerprint() of the nominal net
    LengthPrior prior;                          ///< of the length deviations
    std::uint64_t seed = 1;                     ///< that all samples follow from
    std::vector<UncertainParameter> uncertain;  ///< what was drawn besides the lengths
    Eigen::VectorXd nominal_form;               ///< r_I of the nominal net (3 n_I) [m]
    Eigen::MatrixXd form_deviations;    ///< r_I - nominal, one column a sample (3 n_I x n) [m]
    Eigen::MatrixXd length_deviations;  ///< of the interior edges (m_I x n) [m]
    std::vector<EquilibriumStatus> statuses;  ///< n
    std::vector<int> slack_counts;            ///< slack edges in each sample (n)

    /// n, the number of samples.
    [[nodiscard]] int size() const { return static_cast<int>(form_deviations.cols()); }
    /// Samples with at least one slack edge.
    [[nodiscard]] int with_slack() const;
    /// Samples whose forces do not balance: not used for training.
    [[nodiscard]] int not_converged() const;
    /// Indices in [first, last) of the samples whose forces balance. Slack mechanisms are among
    /// them. The places of their loose nodes are one choice of many, but always the one that the
    /// solver finds from the linear prediction; all other nodes are as good as in any sample.
    /// @throws std::out_of_range for a first below 0, or a last beyond the samples
    [[nodiscard]] std::vector<int> converged_in(int first, int last) const;
};

/// Checks that length deviations of a net can be drawn from a prior.
/// @throws std::invalid_argument where the net has no interior edge, as LengthPrior::check(), and
///   where the prior's reach is not below the shortest interior unstressed length (both are named),
///   or the prior is so narrow that rounding errors hide it
TAUT_CORE_EXPORT void check_prior(const CableNet& net, const LengthPrior& prior);

/// The length deviations of one sample (m_I) [m]. They depend on the prior, the seed and the
/// sample's index alone, not on other samples, threads or runs.
/// @param count m_I, 0 or more
/// @throws std::invalid_argument as LengthPrior::check(), and for a negative count
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd draw_length_deviations(const LengthPrior& prior,
                                                                      std::uint64_t seed,
                                                                      std::uint64_t sample,
                                                                      Eigen::Index count);

}  // namespace taut
