// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/welch_spectrum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace taut {
namespace {

/// Enough to see how far peaks scatter over time; more take memory for nothing.
constexpr int most_groups = 16;

Eigen::VectorXd without_trend(const Eigen::VectorXd& values) {
    const Eigen::VectorXd centred = values.array() - values.mean();
    const Eigen::VectorXd line = Eigen::VectorXd::LinSpaced(values.size(), -1.0, 1.0);
    return centred - line * (line.dot(centred) / line.squaredNorm());
}

}  // namespace

WelchSpectrum welch_spectrum(const VibrationRecord& record, Eigen::Index segment) {
    const Eigen::Index hop = segment - segment / 2;
    const auto segments = static_cast<int>(1 + (record.signals.rows() - segment) / hop);
    const auto padded =
        static_cast<Eigen::Index>(std::bit_ceil(static_cast<std::uint64_t>(2 * segment)));
    const Eigen::VectorXd window =
        0.5 - (2.0 * std::numbers::pi / static_cast<double>(segment) *
               Eigen::ArrayXd::LinSpaced(segment, 0.0, static_cast<double>(segment - 1)))
                      .cos() *
                  0.5;
    // Both halves of the spectrum in one: of 0 Hz and of half the rate there is one.
    const double scale = 2.0 / (record.rate * window.squaredNorm() * segments);
    WelchSpectrum spectrum{.step = record.rate / static_cast<double>(padded),
                           .resolution = record.rate / static_cast<double>(segment),
                           .segments = segments};
    spectrum.groups.setZero(padded / 2 + 1, std::min(segments, most_groups));
    Eigen::FFT<double> transform;
    Eigen::VectorXd values = Eigen::VectorXd::Zero(padded);
    Eigen::VectorXcd transformed;
    for (int k = 0; k < segments; ++k) {
        auto group =
            spectrum.groups.col(static_cast<Eigen::Index>(k) * spectrum.groups.cols() / segments);
        for (const auto& column : record.signals.colwise()) {
            values.head(segment) =
                without_trend(column.segment(k * hop, segment)).cwiseProduct(window);
            transform.fwd(transformed, values);
            group += scale * transformed.head(group.size()).cwiseAbs2();
        }
    }
    spectrum.groups.row(0) *= 0.5;
    spectrum.groups.bottomRows(1) *= 0.5;
    spectrum.density = spectrum.groups.rowwise().sum();
    return spectrum;
}

}  // namespace taut
