// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/sampling/sampler.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include "numerics/memory_budget.hpp"
#include "numerics/parallel.hpp"
#include "sampling/uncertain_widths.hpp"
#include "shared_work.hpp"
#include "taut/numerical_error.hpp"
#include "taut/sampling/model_perturbation.hpp"
#include "taut/statics/form_sensitivity.hpp"

namespace taut {
namespace {

Equilibrium nominal_equilibrium(const CableNet& net) {
    Equilibrium nominal = solve_equilibrium(net);
    if (nominal.status == EquilibriumStatus::unstable) {
        throw NumericalError("the nominal net is not stable: struts give way");
    }
    if (!nominal.balanced()) {
        throw NumericalError(fmt::format(
            "the nominal net finds no equilibrium: {} N out of balance after {} iterations",
            nominal.out_of_balance, nominal.iterations));
    }
    return nominal;
}

void resize(DataSet& data, int count) {
    data.form_deviations.conservativeResize(Eigen::NoChange, count);
    data.length_deviations.conservativeResize(Eigen::NoChange, count);
    data.statuses.resize(count);
    data.slack_counts.resize(count);
}

/// Of so many samples: a data set that grows is for a moment there twice.
MemoryCharge charge_samples(const DataSet& data, int count) {
    return charge_numbers(
        2.0 * static_cast<double>(data.form_deviations.rows() + data.length_deviations.rows()) *
        count);
}

/// An empty data set of the same sizes.
DataSet without_samples(const DataSet& data) {
    DataSet part;
    part.nominal_form = data.nominal_form;
    part.form_deviations.resize(data.form_deviations.rows(), 0);
    part.length_deviations.resize(data.length_deviations.rows(), 0);
    return part;
}

void append(DataSet& data, const DataSet& part) {
    const int before = data.size();
    resize(data, before + part.size());
    data.form_deviations.rightCols(part.size()) = part.form_deviations;
    data.length_deviations.rightCols(part.size()) = part.length_deviations;
    std::ranges::copy(part.statuses, data.statuses.begin() + before);
    std::ranges::copy(part.slack_counts, data.slack_counts.begin() + before);
}

std::string packed_samples(DataSet& data) {
    Packer packer;
    packer(data.form_deviations, data.length_deviations, data.statuses, data.slack_counts);
    return packer.take();
}

void unpack_samples(const std::string& bytes, DataSet& data) {
    Unpacker{bytes}(data.form_deviations, data.length_deviations, data.statuses, data.slack_counts);
}

}  // namespace

struct Sampler::State {
    CableNet net;
    LengthPrior prior;
    std::uint64_t seed;
    std::vector<UncertainParameter> uncertain;
    Equilibrium nominal;
    FormSensitivity sensitivity;
    mutable PerThread<EquilibriumSolver> solvers;

    State(const CableNet& cable_net, const LengthPrior& with_prior, std::uint64_t with_seed,
          const std::vector<UncertainParameter>& with_uncertain)
        : net(cable_net),
          prior(with_prior),
          seed(with_seed),
          uncertain(with_uncertain),
          nominal(nominal_equilibrium(net)),
          sensitivity(net, nominal.unstressed_lengths, nominal.form),
          solvers([this] { return EquilibriumSolver(net); }) {}
    ~State() = default;
    // Not copied: the solvers refer to this net.
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    State(State&&) = delete;
    State& operator=(State&&) = delete;

    /// Of all that determines a sample except its index.
    [[nodiscard]] std::string fingerprint() const {
        std::string text = fmt::format("{} {} {}", net.fingerprint(), to_string(prior), seed);
        for (const UncertainParameter& parameter : uncertain) {
            text += ' ' + to_string(parameter);
        }
        return text;
    }

    /// Draws the uncertain parameters, too. A sample that is no valid net counts as not converged.
    [[nodiscard]] Equilibrium solve_drawn(int k, const Eigen::VectorXd& lengths,
                                          const Points& start) const {
        const ModelPerturbation drawn =
            draw_perturbation(net, uncertain, seed, static_cast<std::uint64_t>(k));
        try {
            const CableNet drawn_net = net_under(net, drawn, lengths);
            return EquilibriumSolver(drawn_net).solve(drawn_net.unstressed_lengths(), start);
        } catch (const NetError&) {
            return {.form = start};
        }
    }

    /// One pass of the loop of Algorithm 2: sample k, into a column.
    void draw(DataSet& data, Eigen::Index column, int k) const {
        data.length_deviations.col(column) = draw_length_deviations(
            prior, seed, static_cast<std::uint64_t>(k), net.interior_edge_count());
        const Eigen::VectorXd lengths =
            with_length_deviations(net, data.length_deviations.col(column));
        const Eigen::VectorXd predicted =
            data.nominal_form + sensitivity.apply(lengths - net.unstressed_lengths());
        const Equilibrium found =
            uncertain.empty()
                ? solvers.local().solve(lengths, with_free_coordinates(net, predicted))
                : solve_drawn(k, lengths, with_free_coordinates(net, predicted));
        data.form_deviations.col(column) = free_coordinates(net, found.form) - data.nominal_form;
        data.statuses[column] = found.status;
        data.slack_counts[column] = static_cast<int>(found.slack_edges.size());
    }
};

Sampler::Sampler(const CableNet& net, const LengthPrior& prior, std::uint64_t seed,
                 const std::vector<UncertainParameter>& uncertain) {
    check_prior(net, prior);
    check_for_one_survey(net, uncertain);
    m_state = std::make_unique<State>(net, prior, seed, uncertain);
}
Sampler::~Sampler() = default;

const Equilibrium& Sampler::nominal() const {
    return m_state->nominal;
}

DataSet Sampler::no_samples() const {
    const State& s = *m_state;
    return {.net_fingerprint = s.net.fingerprint(),
            .prior = s.prior,
            .seed = s.seed,
            .uncertain = s.uncertain,
            .nominal_form = free_coordinates(s.net, s.nominal.form),
            .form_deviations = Eigen::MatrixXd(3 * s.net.free_node_count(), 0),
            .length_deviations = Eigen::MatrixXd(s.net.interior_edge_count(), 0),
            .statuses = {},
            .slack_counts = {}};
}

void Sampler::draw_block(DataSet& data, int first, int count, const Progress& progress) const {
    const int before = data.size();
    resize(data, before + count);
    try {
        parallel_for(0, count, [&](int i) {
            if (progress.stopped()) {
                throw Interrupted();
            }
            // Isolated, so that a thread that waits inside starts no other sample with its solver.
            isolate([&] { m_state->draw(data, Eigen::Index{before} + i, first + i); });
        });
    } catch (...) {
        resize(data, before);
        throw;
    }
}

void Sampler::draw_block_together(DataSet& data, int first, int count,
                                  const Progress& progress) const {
    const auto begin = [count](int rank) {
        return static_cast<int>(std::int64_t{count} * rank / process_group().size());
    };
    const int mine = begin(process_group().rank());
    DataSet part = without_samples(data);
    draw_block(part, first + mine, begin(process_group().rank() + 1) - mine, progress);
    for (const std::string& bytes :
         process_group().gather(packed_samples(part), Receivers::first)) {
        unpack_samples(bytes, part);
        append(data, part);
    }
}

void Sampler::extend_to(DataSet& data, int count, const Progress& progress,
                        const std::function<void()>& after_block) const {
    using Clock = std::chrono::steady_clock;
    require_same("net, prior, seed or uncertain", m_state->fingerprint());
    const MemoryCharge charge = charge_samples(data, count);
    int done = broadcast(data.size());
    int block = 16 * process_group().size();
    while (done < count) {
        progress("sampling", done, count);
        const auto start = Clock::now();
        const int next = std::min(block, count - done);
        if (process_group().size() == 1) {
            draw_block(data, done, next, progress);
        } else {
            draw_block_together(data, done, next, progress);
        }
        done += next;
        if (after_block && process_group().is_first()) {
            after_block();
        }
        // About a second each: long enough to copy little, short enough to report and save often.
        if (broadcast(Clock::now() - start < std::chrono::milliseconds(500))) {
            block *= 2;
        }
    }
    progress("sampling", done, done);
}

SamplePart Sampler::part(int first, int count, const Progress& progress) const {
    if (first < 0 || count < 0 || count > std::numeric_limits<int>::max() - first) {
        throw std::invalid_argument(
            fmt::format("{} samples from sample {} on, expected both at least 0 and the last below "
                        "2^31",
                        count, first));
    }
    SamplePart part{.first = first, .samples = no_samples()};
    const MemoryCharge charge = charge_samples(part.samples, count);
    progress("sampling", 0, count);
    draw_block(part.samples, first, count, progress);
    progress("sampling", count, count);
    return part;
}

DataSet Sampler::joined(std::vector<SamplePart> parts) const {
    std::ranges::stable_sort(parts, {}, &SamplePart::first);
    DataSet data = no_samples();
    MemoryCharge charge;
    for (const auto& [first, samples] : parts) {
        if (samples.net_fingerprint != data.net_fingerprint || samples.prior != data.prior ||
            samples.seed != data.seed || samples.uncertain != data.uncertain ||
            samples.form_deviations.rows() != data.form_deviations.rows() ||
            samples.length_deviations.rows() != data.length_deviations.rows() ||
            samples.length_deviations.cols() != samples.size() ||
            std::ssize(samples.statuses) != samples.size() ||
            std::ssize(samples.slack_counts) != samples.size()) {
            throw std::invalid_argument(fmt::format(
                "the part from sample {} on is of another net, prior, seed or uncertain", first));
        }
        if (samples.size() > 0 && first != data.size()) {
            throw std::invalid_argument(fmt::format(
                "the parts have sample {} {}, expected each sample from 0 to the last once",
                std::min(first, data.size()), first < data.size() ? "twice" : "nowhere"));
        }
        charge = {};
        charge = charge_samples(data, data.size() + samples.size());
        append(data, samples);
    }
    return data;
}

DataSet draw_samples(const Sampler& sampler, int count, const Progress& progress) {
    DataSet data = sampler.no_samples();
    sampler.extend_to(data, count, progress);
    if (process_group().size() > 1) {
        unpack_samples(process_group().gather(packed_samples(data), Receivers::all).front(), data);
    }
    return data;
}

}  // namespace taut
