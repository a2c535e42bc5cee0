// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>

#include "files/message.hpp"
#include "results/document_parts.hpp"
#include "results/result_readers.hpp"
#include "results/result_values.hpp"

namespace taut {
namespace {

void require_value(const JsonValue& parent, const char* key, int value, int expected,
                   const char* order) {
    if (value != expected) {
        member(parent, key).fail(fmt::format("is {}, expected {}: {}", value, expected, order));
    }
}

void require_trials(const JsonValue& round, const char* key, int value, int trials) {
    if (value > trials) {
        member(round, key)
            .fail(fmt::format("is {}, expected at most the {} trials", value, trials));
    }
}

/// @param last round
ControlResult::Strategy read_strategy(const JsonValue& value, int last, int trials) {
    const auto saved = read<ControlDocument::Strategy>(value);
    ControlResult::Strategy strategy{.name = std::string(to_string(saved.strategy)), .rounds = {}};
    const JsonValue rounds = member(value, "rounds");
    const size_t count = static_cast<size_t>(last) + 1;
    rounds.require_array(count, fmt::format("one for each round from 0 to {}", last));
    for (size_t i = 0; i < count; ++i) {
        const auto& [round, means] = saved.rounds[i];
        require_value(rounds.at(i), "round", round, static_cast<int>(i), "rounds in their order");
        require_trials(rounds.at(i), "broken_trials", means.broken_trials, trials);
        require_trials(rounds.at(i), "failed", means.failed, trials);
        strategy.rounds.push_back({.normal_rmse = means.normal_rmse,
                                   .normal_rmse_of_trials = {},
                                   .broken_trials = means.broken_trials,
                                   .turned = means.turned,
                                   .failed = means.failed});
    }
    const JsonValue states = member(value, "states");
    const size_t all = count * static_cast<size_t>(trials);
    states.require_array(all, fmt::format("one for each trial and round: {}", all));
    for (size_t i = 0; i < all; ++i) {
        const ControlState& state = saved.states[i];
        constexpr const char* order = "by trial, then round";
        require_value(states.at(i), "trial", state.trial, static_cast<int>(i / count), order);
        require_value(states.at(i), "round", state.round, static_cast<int>(i % count), order);
        strategy.rounds[i % count].normal_rmse_of_trials.push_back(state.deviation.normal_rmse);
    }
    return strategy;
}

}  // namespace

ControlResult read_control(const JsonValue& root) {
    const JsonValue settings = member(root, "settings");
    const int last = member(settings, "rounds").integer();
    ControlResult result{.trials = member(settings, "trials").integer(), .strategies = {}};
    if (last < 1 || result.trials < 1) {
        settings.fail(fmt::format("has {} rounds and {} trials, expected at least one of both",
                                  last, result.trials));
    }
    for (const JsonValue& value : entries(root, "strategies")) {
        ControlResult::Strategy strategy = read_strategy(value, last, result.trials);
        if (std::ranges::find(result.strategies, strategy.name, &ControlResult::Strategy::name) !=
            result.strategies.end()) {
            member(value, "strategy")
                .fail(fmt::format("is {} again, expected each once", quote(strategy.name)));
        }
        result.strategies.push_back(std::move(strategy));
    }
    return result;
}

}  // namespace taut
