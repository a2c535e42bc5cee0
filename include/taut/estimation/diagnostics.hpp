// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/sampling/length_prior.hpp"

namespace taut {

/// Deviations of more standard deviations than this are significant.
inline constexpr double significant_std = 4.0;
/// Common mean of the length deviations that does no harm, in standard deviations of their prior:
/// with 50,000 lengths it is known better than the linearisation is accurate.
inline constexpr double negligible_mean = 0.15;
/// Scale error of a survey that does no harm, by its effect at the node furthest out, in standard
/// deviations of the survey: large nets show smaller ones.
inline constexpr double negligible_scale = 0.25;

/// An estimated standard deviation relative to the given one.
struct TAUT_CORE_EXPORT FoundScale {
    double ratio = 1.0;    ///< estimated over given; 0 where the survey does not show it
    double std_dev = 0.0;  ///< of the ratio, if the given one is true

    /// Whether the ratio is significant: its probability is below 1 in 10,000 if the given one is
    /// true.
    [[nodiscard]] bool is_contradicted() const;
};

/// The scales of noise and lengths with which a survey fits.
struct VarianceComponents {
    FoundScale noise;    ///< of the standard deviations of surveyed coordinates
    FoundScale lengths;  ///< of the standard deviation of the prior
    /// Of the noise along x, y and z, (noise-axes) where these explain the survey better than a
    /// common scale. Else at the lengths as given, or as wide as they show where one is too large.
    /// Empty where not computed.
    std::vector<FoundScale> noise_by_axis;
};

/// Check of the prior by the lengths that a survey shows.
struct TAUT_CORE_EXPORT PriorCheck {
    LengthPrior checked;    ///< the prior of the fit
    int lengths = 0;        ///< that it rests on
    LengthPrior likeliest;  ///< of uniform, normal and bimodal, of any scale
    double gain = 0.0;      ///< of its log likelihood over that of the prior checked
    double mean = 0.0;      ///< that all deviations have in common [m]
    double mean_std = 0.0;  ///< of that, if it is none; 0: not tested [m]
    int outliers = 0;       ///< lengths outside the prior, where these are too many to be mis-cut

    /// Whether the mean is significant.
    [[nodiscard]] bool has_mean() const;
    /// Whether another prior is so much likelier that the one checked is not reliable.
    [[nodiscard]] bool is_contradicted() const;
    /// Whether chance cannot explain it.
    [[nodiscard]] bool is_untenable() const;
    /// Whether the likeliest prior is narrower: intervals by the one checked are then wider than
    /// needed.
    [[nodiscard]] bool is_too_wide() const;
};

/// How a survey as a whole would fit better than it does.
struct TAUT_CORE_EXPORT FrameCheck {
    double scale = 0.0;      ///< by which it is too large, relative
    double scale_std = 0.0;  ///< of that, if it is not; 0 where the survey does not show it
    /// Shift of the survey against the given frame, about the middle of the net; 0 where the frame
    /// was unknown [m].
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();  ///< about x, y and z, likewise [rad]
    double motion_statistic = 0.0;  ///< chi-squared of six degrees of freedom, if it does not

    /// Whether that is significant.
    [[nodiscard]] bool is_moved() const;
    /// Whether that is significant.
    [[nodiscard]] bool is_scaled() const;
};

/// How a survey would fit better with other loads.
struct TAUT_CORE_EXPORT LoadCheck {
    double force = 0.0;    ///< downwards at each free node, besides the net's [N]
    double std_dev = 0.0;  ///< of that, if there is none; 0 where the survey does not show it [N]

    /// Whether that is significant.
    [[nodiscard]] bool is_missing() const;
};

}  // namespace taut
