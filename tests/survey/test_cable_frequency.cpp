// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a fundamental that is wrong and sure: an octave, a hum, chance.

#include "taut/survey/cable_frequency.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "survey/mode_numbers.hpp"
#include "survey/welch_spectrum.hpp"

namespace taut {
namespace {

using testing::HasSubstr;

VibrationRecord noise_alone(double seconds, std::uint64_t seed = 1, double rate = 200.0) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(0.0, 0.1);
    return {.rate = rate,
            .signals = Eigen::MatrixXd::NullaryExpr(static_cast<Eigen::Index>(rate * seconds), 1,
                                                    [&] { return normal(engine); })};
}

/// Adds an oscillation that is struck now and then, and dies out unless it is not damped.
void add(VibrationRecord& record, double frequency, double amplitude, double damping = 0.002) {
    std::mt19937_64 engine(7);
    std::exponential_distribution<double> pauses(0.3);
    const double turn = 2.0 * std::numbers::pi * frequency;
    double struck = 0.0;
    double next = 1.0;
    for (Eigen::Index i = 0; i < record.signals.rows(); ++i) {
        const double time = static_cast<double>(i) / record.rate;
        if (time >= next && damping > 0.0) {
            struck = next;
            next += pauses(engine);
        }
        record.signals(i) += amplitude * std::exp(-damping * turn * (time - struck)) *
                             std::cos(turn * (time - struck));
    }
}

/// Of a stiff string of which these modes are seen.
VibrationRecord string(double f0, double inharmonicity, const std::vector<int>& modes,
                       double seconds = 60.0, std::uint64_t seed = 1) {
    VibrationRecord record = noise_alone(seconds, seed);
    for (const int n : modes) {
        add(record, n * f0 * std::sqrt(1.0 + inharmonicity * n * n), 0.2);
    }
    return record;
}

std::vector<int> modes_of(const CableFrequency& found) {
    std::vector<int> modes;
    for (const FrequencyPeak& peak : found.peaks) {
        modes.push_back(peak.mode);
    }
    return modes;
}

TEST(CableFrequency, IsThatOfTheStringWithModesMissingAndAForeignPeak) {
    const double f1 = 4.87 * std::sqrt(1.0 + 3e-4);
    int within = 0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        VibrationRecord record = string(4.87, 3e-4, {1, 2, 4, 5, 7}, 60.0, seed);
        add(record, 50.0, 0.2, 0.0);
        const CableFrequency found = cable_frequency(record);
        ASSERT_TRUE(found.fundamental) << found.message;
        EXPECT_EQ(modes_of(found), (std::vector{1, 2, 4, 5, 7, 0}));
        EXPECT_NEAR(found.fundamental->frequency, f1, 2e-3 * f1);
        EXPECT_NEAR(found.fundamental->inharmonicity, 3e-4, 1e-4);
        EXPECT_LT(found.fundamental->misfit, 2e-3);
        EXPECT_LT(found.fundamental->std_dev, 3e-3 * f1);
        within +=
            std::abs(found.fundamental->frequency - f1) < 2.0 * found.fundamental->std_dev ? 1 : 0;
    }
    EXPECT_GE(within, 26);
}

TEST(CableFrequency, OfASensorInTheMiddleIsNoOctave) {
    for (const std::vector<int>& modes : {std::vector{1, 3, 5, 7}, {2, 3, 4, 5}, {1, 2, 3}}) {
        const CableFrequency found = cable_frequency(string(6.1, 0.0, modes));
        ASSERT_TRUE(found.fundamental) << found.message;
        EXPECT_EQ(modes_of(found), modes);
    }
}

TEST(CableFrequency, OfNoiseAndDriftIsNone) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        VibrationRecord record = noise_alone(30.0, seed);
        if (seed % 2 == 0) {
            for (Eigen::Index i = 1; i < record.signals.rows(); ++i) {
                record.signals(i) += record.signals(i - 1);
            }
        }
        const CableFrequency found = cable_frequency(record);
        EXPECT_FALSE(found.fundamental) << found.fundamental->frequency;
        EXPECT_NE(found.message, "");
        EXPECT_LT(found.peaks.size(), 3U);
    }
}

TEST(CableFrequency, OfPeaksThatSeveralExplainIsNoneUntilItsRangeIsGiven) {
    VibrationRecord single = noise_alone(60.0);
    add(single, 10.0, 0.2);
    EXPECT_THAT(cable_frequency(single).message, HasSubstr("explains 3 peaks"));
    EXPECT_EQ(cable_frequency(single, FrequencyRange{8.0, 12.0}).fundamental->modes,
              std::vector{1});
    EXPECT_EQ(cable_frequency(single, FrequencyRange{4.0, 6.0}).fundamental->modes, std::vector{2});
    EXPECT_THAT(cable_frequency(single, FrequencyRange{6.0, 9.0}).message, HasSubstr("no fund"));
    EXPECT_FALSE(cable_frequency(string(5.0, 0.0, {1, 2})).fundamental);

    VibrationRecord beating = string(5.0, 0.0, {1, 2, 3, 4});
    for (int n = 1; n <= 4; ++n) {
        add(beating, 5.25 * n, 0.2);
    }
    const CableFrequency both = cable_frequency(beating);
    EXPECT_FALSE(both.fundamental);
    EXPECT_THAT(both.message, HasSubstr("equally well"));
    EXPECT_NEAR(cable_frequency(beating, FrequencyRange{4.8, 5.1}).fundamental->frequency, 5.0,
                0.025);
}

TEST(CableFrequency, OfARangeThatThePeaksContradictHasAWarning) {
    const VibrationRecord record = string(6.1, 0.0, {1, 2, 3, 4});
    EXPECT_TRUE(cable_frequency(record, FrequencyRange{5.0, 7.0}).warnings.empty());
    const CableFrequency octave = cable_frequency(record, FrequencyRange{2.5, 3.5});
    ASSERT_EQ(octave.warnings.size(), 1U);
    EXPECT_THAT(octave.warnings[0], HasSubstr("outside of the range"));
}

TEST(CableFrequency, OfTheMainsIsNone) {
    VibrationRecord hum = noise_alone(60.0, 1, 1000.0);
    for (const double frequency : {50.0, 100.0, 150.0, 200.0}) {
        add(hum, frequency, 0.2, 0.0);
    }
    EXPECT_THAT(cable_frequency(hum).message, HasSubstr("mains"));
    EXPECT_TRUE(cable_frequency(hum, FrequencyRange{45.0, 55.0}).fundamental);
}

TEST(CableFrequency, OfTooFewPeriodsIsNone) {
    VibrationRecord record = noise_alone(12.0);
    add(record, 2.2, 0.2);
    EXPECT_THAT(cable_frequency(record, FrequencyRange{0.6, 0.8}).message, HasSubstr("periods"));
}

TEST(CableFrequency, OfBadArgumentsIsRefused) {
    const auto words = [](const VibrationRecord& record,
                          const std::optional<FrequencyRange>& range = {}) -> std::string {
        try {
            static_cast<void>(cable_frequency(record, range));
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    const VibrationRecord good = noise_alone(10.0);
    EXPECT_EQ(words(good), "");
    VibrationRecord bad = good;
    bad.rate = 0.0;
    EXPECT_THAT(words(bad), HasSubstr("rate"));
    bad = good;
    bad.signals(3) = NAN;
    EXPECT_THAT(words(bad), HasSubstr("not finite"));
    bad.signals.setConstant(9.81);
    EXPECT_THAT(words(bad), HasSubstr("constant"));
    EXPECT_THAT(words(noise_alone(1.0)), HasSubstr("200 samples"));
    EXPECT_THAT(words(good, FrequencyRange{5.0, 4.0}), HasSubstr("the lower first"));
    EXPECT_THAT(words(good, FrequencyRange{0.0, 4.0}), HasSubstr("positive"));
    EXPECT_THAT(words(good, FrequencyRange{1.0, HUGE_VAL}), HasSubstr("range"));
}

TEST(WelchSpectrum, HasThePowerOfASineAndOfNoise) {
    VibrationRecord record = noise_alone(100.0);
    const double noise_density = 2.0 * 0.01 / record.rate;
    const WelchSpectrum of_noise = welch_spectrum(record, 1000);
    EXPECT_NEAR(of_noise.density.mean(), noise_density, 0.03 * noise_density);
    EXPECT_LT((of_noise.groups.rowwise().sum() - of_noise.density).norm(), 1e-12);
    add(record, 20.0, 3.0, 0.0);
    const WelchSpectrum spectrum = welch_spectrum(record, 1000);
    EXPECT_EQ(spectrum.segments, 39);
    EXPECT_NEAR((spectrum.density - of_noise.density).sum() * spectrum.step, 4.5, 0.05);
}

TEST(WelchSpectrum, HoldsPowerInTheGroupsOfItsTime) {
    VibrationRecord record = noise_alone(100.0);
    add(record, 20.0, 3.0, 0.0);
    record.signals.topRows(record.signals.rows() * 3 / 4).setZero();
    const WelchSpectrum spectrum = welch_spectrum(record, 1000);
    EXPECT_EQ(spectrum.groups.leftCols(11).maxCoeff(), 0.0);
    EXPECT_GT(spectrum.groups.rightCols(3).colwise().sum().minCoeff(), 0.0);
}

TEST(ModeNumbers, FitTheStiffStringExactly) {
    std::vector<FrequencyPeak> peaks;
    for (const int n : {1, 2, 3, 5, 8}) {
        peaks.push_back({.frequency = 3.0 * n * std::sqrt(1.0 + 2e-3 * n * n), .std_dev = 1e-3});
    }
    const auto found = number_modes(peaks, {.lowest = 0.1, .highest = 50.0}, false);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].modes, (std::vector{1, 2, 3, 5, 8}));
    EXPECT_NEAR(found[0].frequency, peaks[0].frequency, 1e-9);
    EXPECT_NEAR(found[0].inharmonicity, 2e-3, 1e-9);
    EXPECT_GT(found[0].std_dev, 1e-3);
    EXPECT_LT(found[0].std_dev, 3e-3);
}

}  // namespace
}  // namespace taut
