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

/// Some of a sampler's samples. It cannot be extended as a data set; parts are put together by
/// Sampler::joined().
struct SamplePart {
    int first = 0;    ///< index of its first sample
    DataSet samples;  ///< the samples from there on
};

/// Algorithm 2 of the paper: draws length deviations and solves for the forms that follow, in
/// parallel on the threads of oneTBB. Each solve starts from the linear prediction r + (dr/dl_0)
/// dl_0. Holds a copy of the net, and a solver for each thread. One object serves several threads
/// at once, each with a data set of its own.
class TAUT_CORE_EXPORT Sampler {
public:
    /// Solves for the nominal form.
    /// @param uncertain drawn besides the lengths, which are the same with and without it
    /// @throws std::invalid_argument as check_prior(), check_uncertain_parameters()
    /// @throws std::runtime_error where the nominal net finds no equilibrium
    Sampler(const CableNet& net, const LengthPrior& prior, std::uint64_t seed,
            const std::vector<UncertainParameter>& uncertain = {});
    ~Sampler();
    Sampler(const Sampler&) = delete;
    Sampler& operator=(const Sampler&) = delete;
    Sampler(Sampler&&) = delete;
    Sampler& operator=(Sampler&&) = delete;

    /// Equilibrium of the net as designed: the reference of all form deviations. Lives as long as
    /// the sampler.
    [[nodiscard]] const Equilibrium& nominal() const;

    /// A data set of this sampler without samples.
    [[nodiscard]] DataSet no_samples() const;

    /// Adds samples to a data set until it holds `count`, in blocks of about a second. The result
    /// is the same, bit for bit, in one call or in many, on any number of threads.
    /// @param data of no_samples(), of this sampler or of one with the same net, prior, seed and
    ///   uncertain: not checked; no other thread may use it meanwhile
    /// @param count in all; nothing is drawn where there are as many already
    /// @param progress gets the stage "sampling" before each block and at the end
    /// @param after_block called after each block in the calling thread, of a process group by the
    ///   first process alone: to save the data set, say; what it throws ends the call
    /// @throws Interrupted where a stop was requested; the data set then holds whole blocks, and
    ///   can be extended again
    void extend_to(DataSet& data, int count, const Progress& progress = {},
                   const std::function<void()>& after_block = {}) const;

    /// Samples from `first` on, to draw them in several jobs.
    /// @param first 0 or more
    /// @param count 0 or more
    /// @throws std::invalid_argument for others
    /// @throws Interrupted where a stop was requested
    [[nodiscard]] SamplePart part(int first, int count, const Progress& progress = {}) const;

    /// The data set of all parts, in any order: bit for bit that of one call.
    /// @throws std::invalid_argument for a part of another net, prior, seed or uncertain, and where
    ///   samples between 0 and the last are missing, or there twice
    [[nodiscard]] DataSet joined(std::vector<SamplePart> parts) const;

private:
    void draw_block(DataSet& data, int first, int count, const Progress& progress) const;
    void draw_block_together(DataSet& data, int first, int count, const Progress& progress) const;

    struct State;
    std::unique_ptr<State> m_state;
};

/// The first `count` samples of a sampler.
/// @param progress as Sampler::extend_to()
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_CORE_EXPORT DataSet draw_samples(const Sampler& sampler, int count,
                                                    const Progress& progress = {});

}  // namespace taut
