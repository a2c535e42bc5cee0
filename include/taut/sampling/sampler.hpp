// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/progress.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {

/// Some of a sampler's samples. Not a data set: what has other samples than the first cannot be
/// extended, and is to be joined.
struct SamplePart {
    int first = 0;    ///< index of its first sample
    DataSet samples;  ///< these alone
};

/// Algorithm 2 of the paper: draws length deviations and solves for the forms that follow, in
/// parallel on the threads of oneTBB. Each solve starts from the linear prediction r + (dr/dl_0)
/// dl_0. Holds a copy of the net, and solvers for the threads that drew. One object serves several
/// threads at once, each with a data set of its own.
class TAUT_CORE_EXPORT Sampler {
public:
    /// Solves for the nominal form.
    /// @param uncertain what is drawn besides the lengths; the lengths are the same with and
    /// without
    /// @throws std::invalid_argument as check_prior(), check_uncertain_parameters()
    /// @throws std::runtime_error where the nominal net finds no equilibrium
    Sampler(const CableNet& net, const LengthPrior& prior, std::uint64_t seed,
            const std::vector<UncertainParameter>& uncertain = {});
    ~Sampler();
    Sampler(const Sampler&) = delete;
    Sampler& operator=(const Sampler&) = delete;
    Sampler(Sampler&&) = delete;
    Sampler& operator=(Sampler&&) = delete;

    /// Of the net as designed: the reference of all form deviations. Lives as long as the sampler.
    [[nodiscard]] const Equilibrium& nominal() const;

    /// A data set of this net, prior, seed and uncertain without samples.
    [[nodiscard]] DataSet empty() const;

    /// Adds samples to a data set that this sampler made, until it holds `count`, in blocks of
    /// about a second. The outcome is the same, bit for bit, in one call or in many, on any number
    /// of threads.
    /// @param data made by empty() of this sampler, or one of the same net, prior, seed and
    /// uncertain,
    ///   which is not checked; in no other thread's use meanwhile
    /// @param count in all; no more than there are: nothing is drawn
    /// @param progress told of the stage "sampling" before each block and at the end
    /// @param after_block called in the calling thread, of a team by the first process alone, where
    ///   the data set has got a block more: to keep it, say; what it throws ends the call
    /// @throws Interrupted where a stop was requested; the data set then holds whole blocks, and
    ///   can be extended again
    void extend(DataSet& data, int count, const Progress& progress = {},
                const std::function<void()>& after_block = {}) const;

    /// Some of the samples, for those who share them out: to the tasks of a scheduler, say.
    /// @param first 0 or more, @param count 0 or more
    /// @throws std::invalid_argument for another, @throws Interrupted where a stop was requested
    [[nodiscard]] SamplePart part(int first, int count, const Progress& progress = {}) const;

    /// The data set of all parts, in whatever order: bit for bit that of one call.
    /// @throws std::invalid_argument for a part of another net, prior, seed or uncertain, and where
    ///   samples between 0 and the last are missing, or told twice
    [[nodiscard]] DataSet joined(std::vector<SamplePart> parts) const;

private:
    void draw_block(DataSet& data, int first, int count, const Progress& progress) const;
    void draw_block_together(DataSet& data, int first, int count, const Progress& progress) const;

    struct State;
    std::unique_ptr<State> m_state;
};

/// The first `count` samples of a sampler.
/// @param progress as Sampler::extend()
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_CORE_EXPORT DataSet draw_samples(const Sampler& sampler, int count,
                                                    const Progress& progress = {});

}  // namespace taut
