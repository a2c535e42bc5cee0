// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/repeated_surveys.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace taut {
namespace {

struct FittedEpoch {
    const Survey& survey;
    const Identification& found;
};

Eigen::Array3d error_of(const FittedEpoch& epoch, int node) {
    return epoch.survey.form.col(node) - epoch.found.predicted.form.col(node);
}

/// (epoch-repeat): how far the errors of two surveys differ, with the same lengths, relative to
/// what they are: about 1. 0 where they have too few targets in common.
double difference_ratio(const FittedEpoch& a, const FittedEpoch& b) {
    constexpr int few = 8;
    const auto is_in_use = [](const FittedEpoch& epoch, int node) {
        return std::ranges::find(epoch.found.outliers, node, &Outlier::node) ==
               epoch.found.outliers.end();
    };
    std::vector<int> both;
    std::ranges::set_intersection(a.survey.surveyed, b.survey.surveyed, std::back_inserter(both));
    std::erase_if(both, [&](int node) { return !is_in_use(a, node) || !is_in_use(b, node); });
    if (std::ssize(both) < few) {
        return 0.0;
    }
    double of_difference = 0.0;
    double of_both = 0.0;
    for (const int node : both) {
        const Eigen::Array3d variances = a.survey.noise_std.col(node).array().square() +
                                         b.survey.noise_std.col(node).array().square();
        const Eigen::Array3d first = error_of(a, node);
        const Eigen::Array3d second = error_of(b, node);
        for (int axis = 0; axis < 3; ++axis) {
            if (variances(axis) > 0.0) {
                of_difference += std::pow(first(axis) - second(axis), 2) / variances(axis);
                of_both += (std::pow(first(axis), 2) + std::pow(second(axis), 2)) / variances(axis);
            }
        }
    }
    return of_both > 0.0 ? std::sqrt(of_difference / of_both) : 0.0;
}

}  // namespace

void add_repeats(Trust& trust, const EpochChain& chain) {
    constexpr double too_close = 0.7;
    for (int b = 1; b < chain.count(); ++b) {
        for (int a = 0; a < b; ++a) {
            const double difference =
                difference_ratio({.survey = chain.survey_at(a), .found = chain.found(a)},
                                 {.survey = chain.survey_at(b), .found = chain.found(b)});
            if (difference > 0.0 && difference < too_close) {
                trust.findings.push_back(
                    {.kind = Trust::Finding::Kind::repeated_survey,
                     .severity = Trust::Verdict::doubtful,
                     .value = difference,
                     .reason = fmt::format("Surveys {} and {} have the same errors: they differ by "
                                           "{:.2g} times what chance allows.",
                                           a + 1, b + 1, difference),
                     .advice =
                         "Check that they are two surveys. If so, errors of the targets "
                         "themselves are in both, and the second adds less than taut assumes."});
            }
        }
    }
}

}  // namespace taut
