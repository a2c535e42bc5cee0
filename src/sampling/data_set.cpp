// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/sampling/data_set.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <random>
#include <stdexcept>

namespace taut {

int DataSet::with_slack() const {
    return static_cast<int>(std::ranges::count_if(slack_counts, [](int n) { return n > 0; }));
}

int DataSet::not_converged() const {
    return static_cast<int>(std::ranges::count_if(statuses, std::not_fn(is_balanced)));
}

std::vector<int> DataSet::converged_in(int first, int last) const {
    if (first < 0 || last > std::ssize(statuses)) {
        throw std::out_of_range(fmt::format("samples {} to {}, expected within 0 to {}", first,
                                            last, std::ssize(statuses)));
    }
    std::vector<int> result;
    for (int k = first; k < last; ++k) {
        if (is_balanced(statuses[k])) {
            result.push_back(k);
        }
    }
    return result;
}

void check_prior(const CableNet& net, const LengthPrior& prior) {
    if (net.interior_edge_count() == 0) {
        throw std::invalid_argument("the net has no interior edge: there is no length to identify");
    }
    prior.check();
    const double shortest = net.unstressed_lengths()(net.interior_edges()).minCoeff();
    if (prior.reach() >= shortest) {
        throw std::invalid_argument(
            fmt::format("the prior {} reaches deviations of {:.4g} mm, expected less than the "
                        "shortest interior unstressed length, {:.4g} mm",
                        to_string(prior), 1e3 * prior.reach(), 1e3 * shortest));
    }
    constexpr double rounding_error = 1e-9;
    if (prior.std_dev() < rounding_error * shortest) {
        throw std::invalid_argument(fmt::format(
            "the prior {} is lost in rounding errors, expected deviations of at least {:.1g} mm",
            to_string(prior), 1e3 * rounding_error * shortest));
    }
}

Eigen::VectorXd draw_length_deviations(const LengthPrior& prior, std::uint64_t seed,
                                       std::uint64_t sample, Eigen::Index count) {
    prior.check();
    if (count < 0) {
        throw std::invalid_argument(fmt::format("{} deviations, expected at least 0", count));
    }
    // The C++ standard specifies the numbers of the engine and the seed sequence to the bit, but
    // not those of its distributions. So the prior draws from 52 random bits, at the middle of
    // their cell. With 53 bits the middle of the last cell would be rounded to 1.
    const auto half = [](std::uint64_t word, int shift) {
        return static_cast<std::uint32_t>(word >> shift);
    };
    std::seed_seq sequence{half(seed, 0), half(seed, 32), half(sample, 0), half(sample, 32)};
    std::mt19937_64 engine(sequence);
    Eigen::VectorXd deviations(count);
    for (double& deviation : deviations) {
        deviation = prior.draw((static_cast<double>(engine() >> 12U) + 0.5) * 0x1p-52);
    }
    return deviations;
}

}  // namespace taut
