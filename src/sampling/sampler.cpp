// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/sampling/sampler.hpp"

#include <fmt/core.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "taut/sampling/circumstances.hpp"
#include "taut/statics/form_sensitivity.hpp"

namespace taut {
namespace {

Equilibrium nominal_equilibrium(const CableNet& net) {
    Equilibrium nominal = solve_equilibrium(net);
    if (!nominal.balanced()) {
        throw std::runtime_error(fmt::format(
            "the nominal net finds no equilibrium: {} N out of balance after {} iterations",
            nominal.out_of_balance, nominal.iterations));
    }
    return nominal;
}

}  // namespace

struct Sampler::State {
    CableNet net;
    LengthLaw law;
    std::uint64_t seed;
    std::vector<Unknown> unknowns;
    Equilibrium nominal;
    FormSensitivity sensitivity;
    mutable tbb::enumerable_thread_specific<EquilibriumSolver> solvers;

    State(const CableNet& cable_net, const LengthLaw& with_law, std::uint64_t with_seed,
          const std::vector<Unknown>& with_unknowns)
        : net(cable_net),
          law(with_law),
          seed(with_seed),
          unknowns(with_unknowns),
          nominal(nominal_equilibrium(net)),
          sensitivity(net, net.unstressed_lengths(), nominal.form),
          solvers([this] { return EquilibriumSolver(net); }) {}
    ~State() = default;
    // The solvers are made of this net.
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    State(State&&) = delete;
    State& operator=(State&&) = delete;

    /// With what else is unknown drawn, too. A sample that leaves no net is none that converged.
    [[nodiscard]] Equilibrium solve_drawn(int k, const Eigen::VectorXd& lengths,
                                          const Points& start) const {
        const Circumstances drawn =
            draw_circumstances(net, unknowns, seed, static_cast<std::uint64_t>(k));
        try {
            const CableNet drawn_net = net_under(net, drawn, lengths);
            return EquilibriumSolver(drawn_net).solve(drawn_net.unstressed_lengths(), start);
        } catch (const NetError&) {
            return {.form = start};
        }
    }

    /// One pass of the loop of Algorithm 2.
    void draw(DataSet& data, int k) const {
        data.length_deviations.col(k) = draw_length_deviations(
            law, seed, static_cast<std::uint64_t>(k), net.interior_edge_count());
        const Eigen::VectorXd lengths = with_length_deviations(net, data.length_deviations.col(k));
        const Eigen::VectorXd predicted =
            data.nominal_form + sensitivity.apply(lengths - net.unstressed_lengths());
        const Equilibrium found =
            unknowns.empty() ? solvers.local().solve(lengths, with_free_coordinates(net, predicted))
                             : solve_drawn(k, lengths, with_free_coordinates(net, predicted));
        data.form_deviations.col(k) = free_coordinates(net, found.form) - data.nominal_form;
        data.statuses[k] = found.status;
        data.slack_counts[k] = static_cast<int>(found.slack_edges.size());
    }
};

Sampler::Sampler(const CableNet& net, const LengthLaw& law, std::uint64_t seed,
                 const std::vector<Unknown>& unknowns) {
    check_law(net, law);
    check_unknowns(net, unknowns);
    m_state = std::make_unique<State>(net, law, seed, unknowns);
}
Sampler::~Sampler() = default;

const Equilibrium& Sampler::nominal() const {
    return m_state->nominal;
}

DataSet Sampler::empty() const {
    const State& s = *m_state;
    return {.net_fingerprint = s.net.fingerprint(),
            .law = s.law,
            .seed = s.seed,
            .unknowns = s.unknowns,
            .nominal_form = free_coordinates(s.net, s.nominal.form),
            .form_deviations = Eigen::MatrixXd(3 * s.net.free_node_count(), 0),
            .length_deviations = Eigen::MatrixXd(s.net.interior_edge_count(), 0),
            .statuses = {},
            .slack_counts = {}};
}

void Sampler::draw_block(DataSet& data, int count, const Progress& progress) const {
    const int first = data.size();
    const auto resize = [&data](int n) {
        data.form_deviations.conservativeResize(Eigen::NoChange, n);
        data.length_deviations.conservativeResize(Eigen::NoChange, n);
        data.statuses.resize(n);
        data.slack_counts.resize(n);
    };
    resize(count);
    try {
        tbb::parallel_for(first, count, [&](int k) {
            if (progress.stopped()) {
                throw Interrupted();
            }
            // A thread that waits within takes no other sample up: the solver is this one's.
            tbb::this_task_arena::isolate([&] { m_state->draw(data, k); });
        });
    } catch (...) {
        resize(first);
        throw;
    }
}

void Sampler::extend(DataSet& data, int count, const Progress& progress,
                     const std::function<void()>& after_block) const {
    using Clock = std::chrono::steady_clock;
    int block = 16;
    while (data.size() < count) {
        progress("sampling", data.size(), count);
        const auto start = Clock::now();
        draw_block(data, std::min(count, data.size() + block), progress);
        if (after_block) {
            after_block();
        }
        // About a second each: long enough to copy little, short enough to tell and keep often.
        if (Clock::now() - start < std::chrono::milliseconds(500)) {
            block *= 2;
        }
    }
    progress("sampling", data.size(), data.size());
}

DataSet draw_samples(const Sampler& sampler, int count, const Progress& progress) {
    DataSet data = sampler.empty();
    sampler.extend(data, count, progress);
    return data;
}

}  // namespace taut
