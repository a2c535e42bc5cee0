// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against frequencies of a time axis that is not that of the sensor.

#include "taut/survey/vibration_record.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

namespace taut {
namespace {

using testing::HasSubstr;

Eigen::VectorXd jittered_times(double part) {
    std::mt19937_64 engine(2);
    std::normal_distribution<double> normal;
    Eigen::VectorXd time(2000);
    for (Eigen::Index i = 0; i < time.size(); ++i) {
        time(i) = 7.0 + 0.01 * (static_cast<double>(i) + part * normal(engine));
    }
    return time;
}

Eigen::MatrixXd slow_sine(const Eigen::VectorXd& time) {
    return (2.0 * std::numbers::pi * 1.3 * time.array()).sin();
}

TEST(VibrationRecord, OfUnevenTimesIsInterpolatedToEvenOnes) {
    const Eigen::VectorXd time = jittered_times(0.1);
    const VibrationRecord record = evenly_sampled(time, slow_sine(time));
    EXPECT_TRUE(record.is_resampled);
    EXPECT_NEAR(record.jitter, 0.1 * std::sqrt(2.0), 0.01);
    EXPECT_NEAR(record.rate, 100.0, 1.0);
    const Eigen::VectorXd even =
        time(0) + Eigen::ArrayXd::LinSpaced(record.signals.rows(), 0.0,
                                            static_cast<double>(record.signals.rows() - 1)) /
                      record.rate;
    EXPECT_LT((record.signals - slow_sine(even)).cwiseAbs().maxCoeff(), 2e-3);
    EXPECT_NEAR(even.tail(1)(0), time.tail(1)(0), 0.011);
}

TEST(VibrationRecord, OfEvenTimesIsTakenAsItIs) {
    const Eigen::VectorXd time = jittered_times(1e-4);
    const VibrationRecord record = evenly_sampled(time, slow_sine(time));
    EXPECT_FALSE(record.is_resampled);
    EXPECT_EQ(record.signals, slow_sine(time));
    EXPECT_NEAR(record.rate, 100.0, 1e-3);
}

TEST(VibrationRecord, LeavesOutTheMagnitudeOfTheOtherColumns) {
    const Eigen::VectorXd time = jittered_times(0.0);
    Eigen::MatrixXd signals(time.size(), 3);
    signals << slow_sine(time), slow_sine(1.7 * time), Eigen::VectorXd::Zero(time.size());
    EXPECT_EQ(evenly_sampled(time, signals).signals.cols(), 3);
    signals.col(2) = signals.leftCols(2).rowwise().norm();
    const Eigen::MatrixXd found = evenly_sampled(time, signals).signals;
    ASSERT_EQ(found.cols(), 2);
    EXPECT_EQ(found, signals.leftCols(2));
}

TEST(VibrationRecord, NamesTheFirstSampleThatIsNone) {
    const Eigen::VectorXd time = jittered_times(0.0);
    const auto fault_with = [&](Eigen::Index i, double value) {
        Eigen::VectorXd changed = time;
        changed(i) = value;
        return record_fault(changed, slow_sine(time)).value_or(RecordFault{-1, ""});
    };
    EXPECT_FALSE(record_fault(time, slow_sine(time)));
    EXPECT_THAT(fault_with(9, time(8)).what, HasSubstr("expected more than"));
    EXPECT_EQ(fault_with(9, time(8)).sample, 9);
    EXPECT_EQ(fault_with(9, NAN).sample, 9);
    EXPECT_THAT(fault_with(1999, time(1999) + 0.05).what, HasSubstr("gap"));
    EXPECT_THAT(record_fault(1e3 * time, slow_sine(time))->what, HasSubstr("seconds"));
    EXPECT_THAT(record_fault(time.head(2), slow_sine(time).topRows(2))->what, HasSubstr("3"));
    Eigen::MatrixXd signals = slow_sine(time);
    signals(5, 0) = HUGE_VAL;
    EXPECT_EQ(record_fault(time, signals)->sample, 5);
    EXPECT_THROW(evenly_sampled(time, signals), std::invalid_argument);
    EXPECT_THROW(evenly_sampled(time, signals.topRows(7)), std::invalid_argument);
    EXPECT_THROW(evenly_sampled(time, Eigen::MatrixXd(2000, 0)), std::invalid_argument);
}

}  // namespace
}  // namespace taut
