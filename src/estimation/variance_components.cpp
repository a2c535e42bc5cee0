// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/variance_components.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace taut {
namespace {

constexpr int most_scalings = 12;
constexpr double converged_scale = 0.01;
constexpr double largest_scaling = 3.0;  // in one round
constexpr double least_scale = 0.1;      // of an axis: less is as good as exact

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
    [[nodiscard]] FoundScale found() const { return {.ratio = ratio(), .std_dev = ratio_std()}; }
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

/// Which scales of the noise are found with that of the lengths.
enum class NoiseScales { held, common, by_axis };

/// Standard deviations over those before, of coordinates along x, y and z, and of lengths; 0: not
/// shown.
struct Scales {
    Eigen::Array3d noise = Eigen::Array3d::Ones();
    double lengths = 1.0;
};

/// The factors that make each group as wide as its standard deviations.
Scales scaling_of(const std::array<Group, 3>& noise, const Group& lengths, NoiseScales scales) {
    Scales result{.lengths = lengths.scaling()};
    for (int axis = 0; axis < 3 && scales != NoiseScales::held; ++axis) {
        result.noise(axis) = (scales == NoiseScales::common ? sum(noise) : noise[axis]).scaling();
    }
    return result;
}

/// Repeats the linearised fit with scaled standard deviations until each group is as wide as they.
/// @param most bound of a scale by axis
Scales scaled_to_fit(LinearisedFit& fitted, Observations& observations,
                     const std::vector<bool>& left_out, NoiseScales scales,
                     double most = std::numeric_limits<double>::infinity()) {
    Scales result;
    const StaticsModel model = fitted.model();
    for (int round = 0; round < most_scalings; ++round) {
        const std::array<Group, 3> noise = noise_groups(fitted, observations);
        const Group lengths = length_group(fitted, observations, left_out);
        Scales by = scaling_of(noise, lengths, scales);
        if (scales == NoiseScales::by_axis) {
            by.noise = by.noise.max(least_scale / result.noise).min(most / result.noise);
        }
        const Scales before_scales = result;
        const bool is_shown = scales == NoiseScales::by_axis || sum(noise).ratio() > 0.0;
        result.noise *= by.noise * (is_shown ? 1.0 : 0.0);
        result.lengths *= lengths.ratio() > 0.0 ? by.lengths : 0.0;
        if (std::max((by.noise - 1.0).abs().maxCoeff(), std::abs(by.lengths - 1.0)) <
            converged_scale) {
            break;
        }
        const Observations before = observations;
        for (int node = 0; node < model.net().node_count(); ++node) {
            observations.scale_stds(node, by.noise);
        }
        for (int i = 0; i < observations.variance.size(); ++i) {
            observations.variance(i) *= left_out[i] ? 1.0 : by.lengths * by.lengths;
        }
        const Iterate at = fitted.iterate;
        std::optional<LinearisedFit> next = std::move(fitted).stepped(observations);
        if (!next) {
            fitted = linearised_fit(model, at, before);
            observations = before;
            result = before_scales;
            break;
        }
        fitted = *std::move(next);
    }
    return result;
}

/// Logarithm, up to a constant, for the linearisation whose step led to the fit.
double likelihood_of(const LinearisedFit& fitted, const Observations& observations) {
    const auto weights = observations.weights.array();
    return 0.5 * (weights > 0.0).select(weights.log(), 0.0).sum() -
           0.5 * observations.variance.array().log().sum() -
           fitted.model().objective(observations, fitted.iterate) -
           fitted.linearisation.half_log_determinant(observations);
}

/// (noise-axes): each axis with a scale of its own. Empty where these explain the survey no better
/// than a common one, or none than those up to 1.
/// @param fitted to the scales in common
/// @param common the scale of the noise there
std::vector<FoundScale> scales_by_axis(const LinearisedFit& fitted, const Observations& scaled,
                                       const std::vector<bool>& left_out, double common) {
    constexpr double by_chance = 6.9;  // once in a thousand surveys
    const std::array<Group, 3> groups = noise_groups(fitted, scaled);
    if (!std::ranges::all_of(groups, [](const Group& group) { return group.ratio() > 0.0; })) {
        return {};
    }
    const auto start = [&] { return linearised_fit(fitted.model(), fitted.iterate, scaled); };
    LinearisedFit free = start();
    const double of_common = likelihood_of(free, scaled);
    Observations observations = scaled;
    const Scales scales = scaled_to_fit(free, observations, left_out, NoiseScales::by_axis);
    const double likelihood = likelihood_of(free, observations);
    if (!(likelihood - of_common > by_chance)) {
        return {};
    }
    LinearisedFit bounded = start();
    observations = scaled;
    (void)scaled_to_fit(bounded, observations, left_out, NoiseScales::by_axis, 1.0 / common);
    const double gain = likelihood - likelihood_of(bounded, observations);
    if (!(gain > by_chance)) {
        return {};
    }
    const double statistic = significant_std * std::sqrt(gain / by_chance);
    std::vector<FoundScale> result;
    for (int axis = 0; axis < 3; ++axis) {
        const double ratio = common * scales.noise(axis);
        result.push_back(
            {.ratio = ratio,
             .std_dev = ratio > 1.0 ? (ratio - 1.0) / statistic : groups[axis].ratio_std()});
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
    const Group noise = sum(as_given);
    const Group lengths = length_group(fitted, observations, left_out);
    const Scales found = scaled_to_fit(fitted, observations, left_out, NoiseScales::common);
    VarianceComponents result{
        .noise = {.ratio = found.noise(0), .std_dev = noise.ratio_std()},
        .lengths = {.ratio = found.lengths, .std_dev = lengths.ratio_std()},
        .noise_by_axis = scales_by_axis(fitted, observations, left_out, found.noise(0))};
    const bool is_too_large = result.noise.ratio < 1.0 && result.noise.is_contradicted();
    const bool has_axes = !result.noise_by_axis.empty();
    if (!has_axes) {
        std::ranges::transform(as_given, std::back_inserter(result.noise_by_axis), &Group::found);
    }
    const bool is_of_axis = std::ranges::any_of(result.noise_by_axis, [](const FoundScale& axis) {
        return axis.ratio > 1.0 && axis.is_contradicted();
    });
    if (!is_too_large && (has_axes || !is_of_axis)) {
        return result;
    }
    Observations held = given;  // (held-noise)
    LinearisedFit again = linearised_fit(model, at, held);
    (void)scaled_to_fit(again, held, left_out, NoiseScales::held);
    const std::array<Group, 3> by_axis = noise_groups(again, held);
    if (!has_axes) {
        std::ranges::transform(by_axis, result.noise_by_axis.begin(), &Group::found);
    }
    const Group held_noise = sum(by_axis);
    constexpr double least = 0.1;
    const double statistic =
        held_noise.ratio() > 0.0 ? (1.0 - held_noise.ratio()) / held_noise.ratio_std() : 0.0;
    if (is_too_large && statistic < significant_std) {
        result.noise.std_dev = (1.0 - result.noise.ratio) / std::max(least, statistic);
    }
    return result;
}

}  // namespace taut
