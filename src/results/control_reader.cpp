// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/control_reader.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "files/message.hpp"
#include "results/result_values.hpp"

namespace taut {
namespace {

void require_value(const JsonValue& parent, const char* key, int expected, const char* order) {
    const JsonValue value = member(parent, key);
    if (value.integer() != expected) {
        value.fail(fmt::format("is {}, expected {}: {}", value.integer(), expected, order));
    }
}

int read_trials_of(const JsonValue& round, const char* key, int trials) {
    const JsonValue value = member(round, key);
    if (value.integer() > trials) {
        value.fail(fmt::format("is {}, expected at most the {} trials", value.integer(), trials));
    }
    return value.integer();
}

/// @param last round
ControlResult::Strategy read_strategy(const JsonValue& value, int last, int trials) {
    ControlResult::Strategy strategy{.name = member(value, "strategy").text(), .rounds = {}};
    const JsonValue rounds = member(value, "rounds");
    const size_t count = static_cast<size_t>(last) + 1;
    rounds.require_array(count, fmt::format("one for each round from 0 to {}", last));
    for (int round = 0; round <= last; ++round) {
        const JsonValue after = rounds.at(round);
        require_value(after, "round", round, "rounds in their order");
        strategy.rounds.push_back({.normal_rmse = member(after, "normal_rmse").number(),
                                   .normal_rmse_of_trials = {},
                                   .broken_trials = read_trials_of(after, "broken_trials", trials),
                                   .turned = member(after, "turned").number(),
                                   .failed = read_trials_of(after, "failed", trials)});
    }
    const JsonValue states = member(value, "states");
    const size_t all = count * static_cast<size_t>(trials);
    states.require_array(all, fmt::format("one for each trial and round: {}", all));
    for (size_t i = 0; i < all; ++i) {
        const JsonValue state = states.at(i);
        const size_t round = i % count;
        require_value(state, "trial", static_cast<int>(i / count), "by trial, then round");
        require_value(state, "round", static_cast<int>(round), "by trial, then round");
        strategy.rounds[round].normal_rmse_of_trials.push_back(
            member(state, "normal_rmse").number());
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
