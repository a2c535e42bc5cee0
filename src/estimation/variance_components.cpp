// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/variance_components.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace taut {
namespace {

constexpr int most_scalings = 12;
constexpr double converged_scale = 0.01;
constexpr double largest_scaling = 3.0;  // in one round

/// Observations with a common scale: the sum of their squared standardised residuals, and their
/// redundancy.
struct Group {
    double squares = 0.0;
    double redundancy = 0.0;

    /// With less than this only chance decides.
    static constexpr double least_redundancy = 5.0;
    [[nodiscard]] double ratio() const {
        return redundancy > least_redundancy ? std::sqrt(std::max(0.0, squares) / redundancy) : 0.0;
    }
    [[nodiscard]] double ratio_std() const {
        return redundancy > least_redundancy ? 1.0 / std::sqrt(2.0 * redundancy) : 0.0;
    }
    [[nodiscard]] double scaling() const {
        const double found = ratio();
        return found > 0.0 ? std::clamp(found, 1.0 / largest_scaling, largest_scaling) : 1.0;
    }
    [[nodiscard]] FoundScale found() const { return {.ratio = ratio(), .std = ratio_std()}; }
};

/// Of the coordinates along x, y and z.
std::array<Group, 3> noise_groups(const LinearisedFit& fitted, const Observations& observations) {
    std::array<Group, 3> groups;
    for (const int node : fitted.model().net().free_nodes()) {
        if (observations.weights.col(node).maxCoeff() <= 0.0) {
            continue;
        }
        const Eigen::Vector3d residual =
            observations.form.col(node) - fitted.iterate.form.col(node);
        const Eigen::Matrix3d S = observations.weight(node);
        const Eigen::Vector3d weighted = S * residual;
        const Eigen::Matrix3d& C = fitted.covariance.places[node];
        for (int k = 0; k < 3; ++k) {
            groups[k].squares += residual(k) * weighted(k);
            groups[k].redundancy += 1.0 - S.row(k).dot(C.col(k));
        }
    }
    return groups;
}

Group sum(const std::array<Group, 3>& groups) {
    Group all;
    for (const Group& group : groups) {
        all.squares += group.squares;
        all.redundancy += group.redundancy;
    }
    return all;
}

/// Of the taut edges: a slack one does not show its length.
Group length_group(const LinearisedFit& fitted, const Observations& observations,
                   const std::vector<bool>& left_out) {
    Group group;
    const CableNet& net = fitted.model().net();
    const Eigen::VectorXd& variances = fitted.covariance.lengths;
    for (int i = 0; i < variances.size(); ++i) {
        const double prior = observations.variance(i);
        if (left_out[i] || fitted.model().slack[net.interior_edges()[i]] || !(variances(i) > 0.0)) {
            continue;
        }
        const double deviation = fitted.iterate.deviations(i) - observations.mean(i);
        group.squares += deviation * deviation / prior;
        group.redundancy += std::max(0.0, 1.0 - variances(i) / prior);
    }
    return group;
}

/// Repeats the linearised fit with scaled standard deviations until each group is as wide as they.
/// @param noise_too else the scale of the noise is kept
VarianceComponents scaled_to_fit(LinearisedFit& fitted, Observations& observations,
                                 const std::vector<bool>& left_out, bool noise_too) {
    VarianceComponents result;
    const StaticsModel model = fitted.model();
    for (int round = 0; round < most_scalings; ++round) {
        const Group noise = sum(noise_groups(fitted, observations));
        const Group lengths = length_group(fitted, observations, left_out);
        if (round == 0) {
            result.noise.std = noise.ratio_std();
            result.lengths.std = lengths.ratio_std();
        }
        const double noise_scaling = noise_too ? noise.scaling() : 1.0;
        const double length_scaling = lengths.scaling();
        result.noise.ratio *= noise.ratio() > 0.0 ? noise_scaling : 0.0;
        result.lengths.ratio *= lengths.ratio() > 0.0 ? length_scaling : 0.0;
        if (std::max(std::abs(noise_scaling - 1.0), std::abs(length_scaling - 1.0)) <
            converged_scale) {
            break;
        }
        const Observations before = observations;
        for (int node = 0; node < model.net().node_count(); ++node) {
            observations.scale_weight(node, 1.0 / (noise_scaling * noise_scaling));
        }
        for (int i = 0; i < observations.variance.size(); ++i) {
            observations.variance(i) *= left_out[i] ? 1.0 : length_scaling * length_scaling;
        }
        const Iterate at = fitted.iterate;
        std::optional<LinearisedFit> next = std::move(fitted).stepped(observations);
        if (!next) {
            fitted = linearised_fit(model, at, before);
            break;
        }
        fitted = *std::move(next);
    }
    return result;
}

}  // namespace

VarianceComponents estimate_components(LinearisedFit& fitted, Observations& observations,
                                       const std::vector<bool>& left_out) {
    const StaticsModel model = fitted.model();
    const Iterate at = fitted.iterate;
    const Observations given = observations;
    const std::array<Group, 3> as_given = noise_groups(fitted, observations);
    VarianceComponents result = scaled_to_fit(fitted, observations, left_out, true);
    std::ranges::transform(as_given, std::back_inserter(result.noise_by_axis), &Group::found);
    const bool is_too_large = result.noise.ratio < 1.0 && result.noise.is_contradicted();
    const bool is_of_axis = std::ranges::any_of(result.noise_by_axis, [](const FoundScale& axis) {
        return axis.ratio > 1.0 && axis.is_contradicted();
    });
    if (!is_too_large && !is_of_axis) {
        return result;
    }
    Observations held = given;  // (held-noise)
    LinearisedFit again = linearised_fit(model, at, held);
    (void)scaled_to_fit(again, held, left_out, false);
    const std::array<Group, 3> by_axis = noise_groups(again, held);
    std::ranges::transform(by_axis, result.noise_by_axis.begin(), &Group::found);
    const Group noise = sum(by_axis);
    constexpr double least = 0.1;
    const double statistic = noise.ratio() > 0.0 ? (1.0 - noise.ratio()) / noise.ratio_std() : 0.0;
    if (is_too_large && statistic < significant_std) {
        result.noise.std = (1.0 - result.noise.ratio) / std::max(least, statistic);
    }
    return result;
}

}  // namespace taut
