// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/vibration_record.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "survey/median.hpp"

namespace taut {
namespace {

Eigen::VectorXd time_steps(const Eigen::VectorXd& time) {
    return time.tail(time.size() - 1) - time.head(time.size() - 1);
}

Eigen::MatrixXd without_column(const Eigen::MatrixXd& matrix, Eigen::Index column) {
    Eigen::MatrixXd rest(matrix.rows(), matrix.cols() - 1);
    rest << matrix.leftCols(column), matrix.rightCols(rest.cols() - column);
    return rest;
}

/// Phone apps write |a| beside a_x, a_y and a_z.
Eigen::MatrixXd without_magnitude(const Eigen::MatrixXd& signals) {
    constexpr double tolerance = 1e-3;  // of numbers that were rounded
    for (Eigen::Index c = signals.cols() - 1; c >= 0 && signals.cols() > 2; --c) {
        const Eigen::MatrixXd others = without_column(signals, c);
        const Eigen::VectorXd magnitude = others.rowwise().norm();
        if ((signals.col(c) - magnitude).norm() <= tolerance * magnitude.norm()) {
            return others;
        }
    }
    return signals;
}

}  // namespace

std::optional<RecordFault> record_fault(const Eigen::VectorXd& time,
                                        const Eigen::MatrixXd& signals) {
    constexpr double longest_gap = 5.0;  // median steps; fewer lost samples are interpolated
    constexpr double lowest_rate = 5.0;
    constexpr double highest_rate = 1e6;
    for (Eigen::Index i = 0; i < time.size(); ++i) {
        if (!std::isfinite(time(i)) || !signals.row(i).allFinite()) {
            return RecordFault{i, "holds a number that is not finite"};
        }
        if (i > 0 && !(time(i) > time(i - 1))) {
            return RecordFault{i, fmt::format("time is {:.9g} s, expected more than the {:.9g} s "
                                              "of the sample before",
                                              time(i), time(i - 1))};
        }
    }
    if (time.size() < 3) {
        return RecordFault{std::max<Eigen::Index>(time.size() - 1, 0),
                           "is the last sample, expected at least 3"};
    }
    const Eigen::VectorXd steps = time_steps(time);
    const double step = median_of(steps);
    if (!(step * lowest_rate <= 1.0 && step * highest_rate >= 1.0)) {
        return RecordFault{1, fmt::format("the median time step is {:.3g} s, expected 1e-6 s to "
                                          "0.2 s: are the times in seconds?",
                                          step)};
    }
    for (Eigen::Index i = 0; i < steps.size(); ++i) {
        if (steps(i) > longest_gap * step) {
            return RecordFault{
                i + 1, fmt::format("time is {:.3g} s after the sample before, a gap of more than "
                                   "{:g} median steps of {:.3g} s: take the part before or behind",
                                   steps(i), longest_gap, step)};
        }
    }
    return std::nullopt;
}

VibrationRecord evenly_sampled(const Eigen::VectorXd& time, const Eigen::MatrixXd& signals) {
    if (signals.rows() != time.size() || signals.cols() < 1) {
        throw std::invalid_argument(
            fmt::format("the signals are {} x {}, expected a row for each of {} times",
                        signals.rows(), signals.cols(), time.size()));
    }
    if (const auto fault = record_fault(time, signals)) {
        throw std::invalid_argument(fmt::format("sample {}: {}", fault->sample, fault->what));
    }
    constexpr double exact = 0.01;  // of a step
    const Eigen::MatrixXd linear = without_magnitude(signals);
    const Eigen::VectorXd steps = time_steps(time);
    const double mean_step = steps.mean();
    VibrationRecord record{.rate = 1.0 / mean_step,
                           .signals = linear,
                           .jitter = (steps.array() - mean_step).matrix().norm() /
                                     (mean_step * std::sqrt(static_cast<double>(steps.size())))};
    const Eigen::VectorXd even =
        Eigen::VectorXd::LinSpaced(time.size(), time(0), time(time.size() - 1));
    if ((time - even).cwiseAbs().maxCoeff() <= exact * mean_step) {
        return record;
    }
    const double step = median_of(steps);
    const auto count = 1 + static_cast<Eigen::Index>((time(time.size() - 1) - time(0)) / step);
    record.rate = 1.0 / step;
    record.is_resampled = true;
    record.signals.resize(count, linear.cols());
    for (Eigen::Index i = 0, before = 0; i < count; ++i) {
        const double at = time(0) + static_cast<double>(i) * step;
        while (before + 2 < time.size() && time(before + 1) <= at) {
            ++before;
        }
        const double part = (at - time(before)) / (time(before + 1) - time(before));
        record.signals.row(i) = (1.0 - part) * linear.row(before) + part * linear.row(before + 1);
    }
    return record;
}

}  // namespace taut
