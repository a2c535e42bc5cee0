// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "taut/net/cable_net.hpp"
#include "taut/progress.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {

/// Algorithm 2 of the paper: draws length deviations and solves for the forms that follow, in
/// parallel on the threads of oneTBB. Each solve starts from the linear prediction r + (dr/dl_0)
/// dl_0.
class Sampler {
public:
    /// Solves for the nominal form.
    /// @param unknowns what is drawn besides the lengths; the lengths are the same with and without
    /// @throws std::invalid_argument as check_law(), check_unknowns()
    /// @throws std::runtime_error where the nominal net finds no equilibrium
    Sampler(const CableNet& net, const LengthLaw& law, std::uint64_t seed,
            const std::vector<Unknown>& unknowns = {});
    ~Sampler();
    Sampler(const Sampler&) = delete;
    Sampler& operator=(const Sampler&) = delete;
    Sampler(Sampler&&) = delete;
    Sampler& operator=(Sampler&&) = delete;

    /// Of the net as designed: the reference of all form deviations.
    [[nodiscard]] const Equilibrium& nominal() const;

    /// A data set of this net, law, seed and unknowns without samples.
    [[nodiscard]] DataSet empty() const;

    /// Adds samples to a data set that this sampler made, until it holds `count`, in blocks of
    /// about a second. The outcome is the same, bit for bit, in one call or in many, on any number
    /// of threads.
    /// @param progress told of the stage "sampling" before each block and at the end
    /// @param after_block called where the data set has got a block more: to keep it, say
    /// @throws Interrupted where a stop was requested; the data set then holds whole blocks, and
    ///   can be extended again
    void extend(DataSet& data, int count, const Progress& progress = {},
                const std::function<void()>& after_block = {}) const;

private:
    void draw_block(DataSet& data, int count, const Progress& progress) const;

    struct State;
    std::unique_ptr<State> m_state;
};

/// The first `count` samples of a sampler.
/// @throws Interrupted where a stop was requested
[[nodiscard]] DataSet draw_samples(const Sampler& sampler, int count,
                                   const Progress& progress = {});

}  // namespace taut
