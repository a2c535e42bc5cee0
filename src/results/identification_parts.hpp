// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/description.hpp"
#include "taut/results/result_file.hpp"

namespace taut {

// The parts of a saved identification.

Description<Trust> describe(const Trust* type);
Description<Trust::Remedy> describe(const Trust::Remedy* type);
Description<Trust::Finding> describe(const Trust::Finding* type);
Description<DetectableErrors> describe(const DetectableErrors* type);
Description<FoundScale> describe(const FoundScale* type);
Description<FrameCheck> describe(const FrameCheck* type);
Description<LoadCheck> describe(const LoadCheck* type);
Description<Outlier> describe(const Outlier* type);
Description<ForceOutlier> describe(const ForceOutlier* type);
Description<ForceBias> describe(const ForceBias* type);
Description<LengthOutlier> describe(const LengthOutlier* type);
Description<BoundaryOutlier> describe(const BoundaryOutlier* type);
Description<PriorNode> describe(const PriorNode* type);
Description<CommonDeviation> describe(const CommonDeviation* type);
Description<PriorEstimate> describe(const PriorEstimate* type);
Description<ParameterEstimate> describe(const ParameterEstimate* type);
Description<Assumption> describe(const Assumption* type);
Description<IdentifiedEdge> describe(const IdentifiedEdge* type);
Description<StretchLength> describe(const StretchLength* type);
Description<LengthCovariance> describe(const LengthCovariance* type);
Description<DrawnEstimate> describe(const DrawnEstimate* type);
Description<DrawnTension> describe(const DrawnTension* type);
Description<DrawnPlace> describe(const DrawnPlace* type);
Description<PosteriorDraws> describe(const PosteriorDraws* type);
Description<IdentificationResult::Residual> describe(const IdentificationResult::Residual* type);
Description<UnmatchedPoint> describe(const UnmatchedPoint* type);
Description<ControlResidual> describe(const ControlResidual* type);
Description<Registration> describe(const Registration* type);
Description<FrameOffset> describe(const FrameOffset* type);
Description<EdgeTurned> describe(const EdgeTurned* type);
Description<LengthChange> describe(const LengthChange* type);
Description<EpochResult> describe(const EpochResult* type);
Description<Identification> describe(const Identification* type);

template <>
inline constexpr bool is_read<IdentifiedEdge> = true;
template <>
inline constexpr bool is_read<IdentificationResult::Residual> = true;
template <>
inline constexpr bool is_read<ParameterEstimate> = true;
template <>
inline constexpr bool is_read<EdgeTurned> = true;
template <>
inline constexpr bool is_read<FrameOffset> = true;
template <>
inline constexpr bool is_read<Trust::Finding> = true;
template <>
inline constexpr bool is_read<Trust::Remedy> = true;

/// 3 x k as k points.
[[nodiscard]] std::vector<Eigen::Vector3d> columns_of(const Points& points);

/// x, y, z of a standard deviation.
[[nodiscard]] inline Rule point_of_sizes() {
    return Rule::list_of(size, 3);
}

// Names of edges and nodes, empty for -1.

template <class T>
auto edge_id_if_any(int T::* edge) {
    return [edge](const T& value, const Context& c) {
        return value.*edge < 0 ? std::nullopt : std::optional(c.net->edge_id(value.*edge));
    };
}

template <class T>
auto node_id_if_any(int T::* node) {
    return [node](const T& value, const Context& c) {
        return value.*node < 0 ? std::nullopt : std::optional(c.net->node_id(value.*node));
    };
}

}  // namespace taut
