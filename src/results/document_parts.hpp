// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "results/description.hpp"
#include "taut/results/control_files.hpp"
#include "taut/results/plan_files.hpp"
#include "taut/results/result_file.hpp"
#include "taut/study/comparison.hpp"

namespace taut {

/// A turning with its results.
struct ListedTurning {
    Turning turning;
    std::optional<double> turns;               ///< without sign; empty without a pitch
    std::optional<std::string_view> rotation;  ///< empty without a thread
    double reading_after = 0.0;  ///< unstressed length then, less the designed one [m]
    double tension_after = 0.0;  ///< when all is done [N]
};

/// The turnings of a plan, in the order of the work.
[[nodiscard]] std::vector<ListedTurning> listed_turnings(const PlanRecord& record);

/// The name of the support at an edge's end; empty where it has none.
[[nodiscard]] std::string support_id(const CableNet& net, int edge);

/// Simulated jobs, as they are saved.
struct ControlDocument {
    /// The means of a round.
    struct Round {
        int round = 0;
        ControlRecord::Round means;
    };
    struct Strategy {
        ControlStrategy strategy = ControlStrategy::truth;
        std::vector<Round> rounds;         ///< from 0
        std::vector<ControlState> states;  ///< by trial, then round
    };
    ControlSettings settings;
    std::vector<Strategy> strategies;
};

constexpr ControlStrategy last_of(ControlStrategy /*type*/) {
    return ControlStrategy::once;
}
constexpr ModelErrors last_of(ModelErrors /*type*/) {
    return ModelErrors::given;
}
constexpr TensionObstacle last_of(TensionObstacle /*type*/) {
    return TensionObstacle::turnbuckles;
}

// The documents, and their parts that are read again.

Description<Study> describe(const Study* type);
Description<Comparison> describe(const Comparison* type);
Description<ComparisonRow> describe(const ComparisonRow* type);
Description<PlanRecord> describe(const PlanRecord* type);
Description<PlanResult::Tension> describe(const PlanResult::Tension* type);
Description<ControlDocument> describe(const ControlDocument* type);
Description<ControlSettings> describe(const ControlSettings* type);
Description<ControlDocument::Strategy> describe(const ControlDocument::Strategy* type);
Description<ControlDocument::Round> describe(const ControlDocument::Round* type);
Description<ControlState> describe(const ControlState* type);

template <>
inline constexpr bool is_read<PlanResult::Tension> = true;
template <>
inline constexpr bool is_read<ControlState> = true;
template <>
inline constexpr bool is_read<ControlDocument::Round> = true;
template <>
inline constexpr bool is_read<ControlDocument::Strategy> = true;

/// Wall times of the parts of a study or comparison.
template <class T>
Description<T> seconds_of() {
    const auto of = [](double T::Seconds::* part) {
        return [part](const T& all) { return all.seconds.*part; };
    };
    using Seconds = typename T::Seconds;
    return Description<T>("seconds")
        .key("sampling", of(&Seconds::sampling), size)
        .key("training", of(&Seconds::training), size)
        .key("identification", of(&Seconds::identification), size)
        .key("total", of(&Seconds::total), size);
}

}  // namespace taut
