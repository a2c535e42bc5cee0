// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/core.hpp"
#include "taut/sampling/length_prior.hpp"

namespace taut {

/// Chance explains no more than so many standard deviations.
inline constexpr double significant_std = 4.0;
/// A mean of all length deviations that does no harm, in standard deviations of their prior: of
/// 50,000 lengths the linearised mean is known to less than it is right.
inline constexpr double negligible_mean = 0.15;
/// A scale of a survey that does no harm, at the node furthest out, in standard deviations of the
/// survey: large nets show such.
inline constexpr double negligible_scale = 0.25;

/// A scale that a survey shows, of what was told.
struct TAUT_CORE_EXPORT FoundScale {
    double ratio = 1.0;  ///< found over told; 0 where the survey does not show it
    double std = 0.0;    ///< of the ratio, if what was told is true

    /// Beyond chance: the probability of that is below 1 in 10,000 where what was told is true.
    [[nodiscard]] bool is_contradicted() const;
};

/// The scales by which noise and lengths together fit what a survey shows.
struct VarianceComponents {
    FoundScale noise;    ///< of the standard deviations of surveyed coordinates
    FoundScale lengths;  ///< of the standard deviation of the prior
};

/// What the lengths that a survey shows tell of their prior.
struct TAUT_CORE_EXPORT PriorCheck {
    LengthPrior checked;    ///< the prior reckoned with
    int lengths = 0;        ///< that it rests on
    LengthPrior likeliest;  ///< of uniform, normal and bimodal, of any scale
    double gain = 0.0;      ///< of its log likelihood over that of the prior checked
    double mean = 0.0;      ///< that all deviations have in common [m]
    double mean_std = 0.0;  ///< of that, if it is none [m]
    int outliers = 0;       ///< lengths outside the prior, where these are too many to be mis-cut

    /// Whether the mean is none that chance would give.
    [[nodiscard]] bool has_mean() const;
    /// Whether another prior is so much likelier that the one checked is not to be relied on.
    [[nodiscard]] bool is_contradicted() const;
    /// Whether no chance explains that.
    [[nodiscard]] bool is_untenable() const;
    /// Whether the likeliest prior is narrower: intervals by the one checked then hold more than
    /// they need to.
    [[nodiscard]] bool is_too_wide() const;
};

/// How a survey as a whole would fit better than it does.
struct TAUT_CORE_EXPORT FrameCheck {
    double scale = 0.0;      ///< by which it is too large, relative
    double scale_std = 0.0;  ///< of that, if it is not; 0 where the survey does not show it
    /// By which the survey lies off the frame that was told, about the middle of the net [m, rad];
    /// 0 where the frame was unknown.
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();  ///< about x, y and z, likewise [rad]
    double motion_statistic = 0.0;  ///< chi-squared of six degrees of freedom, if it does not

    /// Beyond chance.
    [[nodiscard]] bool is_moved() const;
    /// Beyond chance.
    [[nodiscard]] bool is_scaled() const;
};

}  // namespace taut
