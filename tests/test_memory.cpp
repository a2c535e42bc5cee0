// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards with_memory(): what a call takes for its large arrays is within its limit, on all threads,
// and given back. That it is most of what a call takes: tests/python/test_memory.py.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "identification/simulated_survey.hpp"
#include "numerics/buffer.hpp"
#include "numerics/parallel.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/gp/fit.hpp"
#include "taut/identification/identify.hpp"
#include "taut/memory.hpp"
#include "taut/sampling/sampler.hpp"

namespace taut {
namespace {

constexpr double megabyte = 1e6;

/// Whether the work is refused within so much memory, and done within eight times as much.
void expect_between(double bytes, const std::function<void()>& work) {
    EXPECT_THROW(with_memory(bytes, work), MemoryLimitExceeded);
    EXPECT_NO_THROW(with_memory(8.0 * bytes, work));
}

TEST(WithMemory, LimitsWhatIsLarge) {
    const CableNet net = hypar(20, 20);
    const test::SimulatedSurvey simulated = test::simulate(net, LengthPrior(), 5e-4, 3);
    const auto identify_with = [&](int draws) {
        (void)identify(net, simulated.survey, {.prior_exact = true, .draws = draws});
    };
    expect_between(2.0 * megabyte, [&] { identify_with(0); });      // factor and inverse
    expect_between(30.0 * megabyte, [&] { identify_with(1000); });  // posterior samples
    expect_between(2.0 * megabyte, [&] {
        DataSet data = Sampler(net, LengthPrior(), 1).no_samples();
        Sampler(net, LengthPrior(), 1).extend_to(data, 200);
    });
    const Eigen::MatrixXd inputs = Eigen::MatrixXd::Random(2, 300);
    const Eigen::MatrixXd outputs = (inputs.row(0) + inputs.row(1)).array().sin().transpose();
    expect_between(2.0 * megabyte, [&] { (void)gp::fit(inputs, outputs); });  // spectra
    expect_between(0.5 * megabyte,
                   [&] { (void)gp::fit(inputs, outputs, {.most_decomposed = 100, .rank = 50}); });
}

TEST(WithMemory, ChangesNoResult) {
    const CableNet net = hypar(4, 4);
    const test::SimulatedSurvey simulated = test::simulate(net, LengthPrior(), 5e-4, 3);
    const auto lengths = [&] { return identify(net, simulated.survey).draws->length_deviations; };
    EXPECT_EQ(with_memory(1e9, lengths), lengths());
}

TEST(WithMemory, CountsWhatThreadsTake) {
    constexpr size_t count = 125'000;  // 1 MB
    const auto make = [] {
        std::vector<Buffer> buffers(8);
        parallel_for(size_t{0}, buffers.size(), [&](size_t k) { buffers[k] = Buffer(count); });
    };
    EXPECT_THROW(with_memory(7.5 * megabyte, make), MemoryLimitExceeded);
    EXPECT_NO_THROW(with_memory(8.5 * megabyte, make));
}

TEST(WithMemory, GivesBackWhatWasTaken) {
    constexpr size_t count = 125'000;
    with_memory(1.5 * megabyte, [&] {
        for (int k = 0; k < 3; ++k) {
            const Buffer one(count);
            EXPECT_THROW(Buffer{count}, MemoryLimitExceeded);
        }
        Buffer moved(count);
        Buffer to = std::move(moved);
        EXPECT_THROW(Buffer{count}, MemoryLimitExceeded);
        to = Buffer();
        EXPECT_NO_THROW(Buffer{count});
    });
    Buffer outlives;
    with_memory(1.5 * megabyte, [&] { outlives = Buffer(count); });
    EXPECT_NO_THROW(Buffer(10 * count));
}

TEST(WithMemory, HoldsInsideAnother) {
    constexpr size_t count = 125'000;
    const auto make = [] { const Buffer one(count); };
    EXPECT_THROW(with_memory(0.5 * megabyte, [&] { with_memory(9.0 * megabyte, make); }),
                 MemoryLimitExceeded);
    EXPECT_THROW(with_memory(9.0 * megabyte, [&] { with_memory(0.5 * megabyte, make); }),
                 MemoryLimitExceeded);
    with_memory(1.5 * megabyte, [&] {
        EXPECT_THROW(with_memory(0.5 * megabyte, make), MemoryLimitExceeded);
        EXPECT_NO_THROW(make());  // what the inner one refused, the outer one did not keep
    });
}

TEST(WithMemory, SaysWhatIsNeeded) {
    try {
        with_memory(megabyte, [] { const Buffer one(1 << 20); });
        FAIL() << "nothing was thrown";
    } catch (const MemoryLimitExceeded& error) {
        EXPECT_STREQ(error.what(),
                     "not enough memory: the call needs 8 MiB or more, and may take 0.95367 MiB");
        EXPECT_EQ(error_code(error), ErrorCode::out_of_memory);
    }
    EXPECT_THROW(with_memory(0.0, [] {}), std::invalid_argument);
}

}  // namespace
}  // namespace taut
