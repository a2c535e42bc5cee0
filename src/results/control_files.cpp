// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/control_files.hpp"

#include <fmt/core.h>

#include "files/csv_field.hpp"
#include "results/document_parts.hpp"
#include "results/result_parts.hpp"

namespace taut {
Description<ControlState> describe(const ControlState* /*type*/) {
    using State = ControlState;
    return Description<State>("control_state", "The true net of a trial after a round.")
        .key("trial", &State::trial)
        .key("round", &State::round)
        .key("mean", TAUT_VALUE(it.deviation.mean), size)
        .key("max", TAUT_VALUE(it.deviation.max), size)
        .key("normal_mean", TAUT_VALUE(it.deviation.normal_mean), size)
        .key("normal_max", TAUT_VALUE(it.deviation.normal_max), size)
        .key(
            "normal_rmse", [](auto& state) -> auto& { return state.deviation.normal_rmse; }, size)
        .key("least_tension", &State::least_tension)
        .key("most_tension", &State::most_tension)
        .key("broken", &State::broken, "Edges that break a limit.")
        .key("worst_excess", &State::worst_excess, size)
        .key("turned", &State::turned, size)
        .key("failed", &State::has_failed);
}

Description<ControlDocument::Round> describe(const ControlDocument::Round* /*type*/) {
    using Round = ControlDocument::Round;
    using Means = ControlRecord::Round;
    const auto mean = [](auto Means::* of) {
        return [of](auto& round) -> auto& { return round.means.*of; };
    };
    return Description<Round>("control_round",
                              "The true nets after a round; round 0 is as built. Distances are "
                              "from the target over the free nodes, and along its normal [m].")
        .key("round", &Round::round)
        .key("mean", mean(&Means::mean), size)
        .key("max", mean(&Means::max), size, "The most in any trial.")
        .key("normal_mean", mean(&Means::normal_mean), size)
        .key("normal_max", mean(&Means::normal_max), size)
        .key("normal_rmse", mean(&Means::normal_rmse), size, "Over nodes and trials.")
        .key("least_tension", mean(&Means::least_tension), "In any trial [N].")
        .key("most_tension", mean(&Means::most_tension), "In any trial [N].")
        .key("broken_trials", mean(&Means::broken_trials), "Trials in which a limit is broken.")
        .key("worst_excess", mean(&Means::worst_excess), size, "Over a limit, relative to it.")
        .key("turned", mean(&Means::turned), size, "Sum of |stroke|, mean over the trials [m].")
        .key("failed", mean(&Means::failed),
             "Trials in which identification or plan failed: nothing was turned.");
}

Description<ControlDocument::Strategy> describe(const ControlDocument::Strategy* /*type*/) {
    using Strategy = ControlDocument::Strategy;
    return Description<Strategy>("control_strategy")
        .key("strategy", &Strategy::strategy, "Strategy of the plans.")
        .key("rounds", &Strategy::rounds, "Over the trials, from round 0.")
        .key("states", &Strategy::states, "By trial, then round.");
}

Description<ControlSettings> describe(const ControlSettings* /*type*/) {
    using Settings = ControlSettings;
    return Description<Settings>()
        .key("prior", &Settings::prior, "Of the true length deviations.")
        .newer("uncertain", &Settings::uncertain,
               R"(What else differs in each net: ["stiffness:5%"]; missing in files of 0.2.)")
        .key("noise", &Settings::noise_std, size, "Std of a surveyed coordinate [m].")
        .key("hidden", &Settings::hidden_part, part, "Part of the free nodes not surveyed.")
        .key("actuator", &Settings::actuator_std, size,
             "Standard deviation of a stroke from the planned one [m].")
        .key("stroke", &Settings::stroke, size, "Of a turnbuckle, either way [m].")
        .key("least_tension", &Settings::least_tension, size, "[N].")
        .key("most_tension", TAUT_VALUE(when(it.most_tension > 0.0, it.most_tension)), size,
             "Null: no limit [N].")
        .key("confidence", &Settings::confidence, part,
             "Required probability of keeping limits, of plans on identified lengths.")
        .key("step", TAUT_VALUE(when(it.turn.has_value(), it.turn.value_or(TurnSize()).step())),
             size, "By the smallest part of a turn; null: any [m].")
        .key("draws", &Settings::draws, "Of each identification.")
        .key("rounds", &Settings::rounds)
        .key("trials", &Settings::trials, "Nets that are built.")
        .key("seed", &Settings::seed);
}

Description<ControlDocument> describe(const ControlDocument* /*type*/) {
    using Document = ControlDocument;
    const Rule strategies = Rule::list_of(description_of<Document::Strategy>().rule());
    auto result = document<Document>(
        "control",
        "Result of taut control: simulated jobs of surveys and turns under several strategies.");
    result.newer("net_fingerprint", TAUT_VALUE(c.net->fingerprint()))
        .key("net", [](const Document&, const Context& c) -> const CableNet& { return *c.net; })
        .key("settings", &Document::settings)
        .key("strategies", &Document::strategies, strategies.not_empty());
    return add_run(result);
}

std::string control_to_json(const std::vector<ControlRecord>& records, const CableNet& net,
                            const ControlSettings& settings, const RunRecord& run) {
    ControlDocument document{.settings = settings, .strategies = {}};
    for (const ControlRecord& record : records) {
        document.strategies.push_back(
            {.strategy = record.strategy, .rounds = {}, .states = record.states});
        for (int round = 0; round <= settings.rounds; ++round) {
            document.strategies.back().rounds.push_back(
                {.round = round, .means = record.after(round)});
        }
    }
    return to_text(json_of(document, {.net = &net, .run = &run}));
}

std::string control_to_csv(const std::vector<ControlRecord>& records) {
    std::string text;
    for (const ControlRecord& record : records) {
        for (const ControlState& state : record.states) {
            const ResultJson row = json_of(state, {});
            if (text.empty()) {
                text = "strategy";
                for (const auto& [key, value] : row.items()) {
                    text += fmt::format(",{}", key);
                }
                text += '\n';
            }
            text += csv_field(std::string(to_string(record.strategy)));
            for (const auto& [key, value] : row.items()) {
                text += fmt::format(",{}", value.dump());
            }
            text += '\n';
        }
    }
    return text;
}

}  // namespace taut
