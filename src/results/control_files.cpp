// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/control_files.hpp"

#include <fmt/core.h>

#include "files/csv_field.hpp"
#include "results/result_parts.hpp"
#include "taut/version.hpp"

namespace taut {
namespace {

ResultJson control_state_json(const ControlState& state) {
    return {{"trial", state.trial},
            {"round", state.round},
            {"mean", state.deviation.mean},
            {"max", state.deviation.max},
            {"normal_mean", state.deviation.normal_mean},
            {"normal_max", state.deviation.normal_max},
            {"normal_rmse", state.deviation.normal_rmse},
            {"least_tension", state.least_tension},
            {"most_tension", state.most_tension},
            {"broken", state.broken},
            {"worst_excess", state.worst_excess},
            {"turned", state.turned},
            {"failed", state.has_failed}};
}

ResultJson control_round_json(const ControlRecord& record, int round) {
    const ControlRecord::Round after = record.after(round);
    return {{"round", round},
            {"mean", after.mean},
            {"max", after.max},
            {"normal_mean", after.normal_mean},
            {"normal_max", after.normal_max},
            {"normal_rmse", after.normal_rmse},
            {"least_tension", after.least_tension},
            {"most_tension", after.most_tension},
            {"broken_trials", after.broken_trials},
            {"worst_excess", after.worst_excess},
            {"turned", after.turned},
            {"failed", after.failed}};
}

}  // namespace

std::string control_to_json(const std::vector<ControlRecord>& records, const CableNet& net,
                            const ControlSettings& settings, const RunRecord& run) {
    ResultJson strategies = ResultJson::array();
    for (const ControlRecord& record : records) {
        ResultJson rounds = ResultJson::array();
        for (int round = 0; round <= settings.rounds; ++round) {
            rounds.push_back(control_round_json(record, round));
        }
        ResultJson states = ResultJson::array();
        for (const ControlState& state : record.states) {
            states.push_back(control_state_json(state));
        }
        strategies.push_back(
            {{"strategy", to_string(record.strategy)}, {"rounds", rounds}, {"states", states}});
    }
    ResultJson uncertain = ResultJson::array();
    for (const UncertainParameter& one : settings.uncertain) {
        uncertain.push_back(one.to_string());
    }
    ResultJson document{
        {"format", "taut-control"},
        {"version", 2},
        {"program", "taut " + std::string(version())},
        {"net_fingerprint", net.fingerprint()},
        {"net", counts_json(net)},
        {"settings",
         {{"prior", settings.prior.to_string()},
          {"uncertain", std::move(uncertain)},
          {"noise", settings.noise_std},
          {"hidden", settings.hidden_part},
          {"actuator", settings.actuator_std},
          {"stroke", settings.stroke},
          {"least_tension", settings.least_tension},
          {"most_tension",
           settings.most_tension > 0.0 ? ResultJson(settings.most_tension) : ResultJson()},
          {"confidence", settings.confidence},
          {"step", settings.turn ? ResultJson(settings.turn->step()) : ResultJson()},
          {"draws", settings.draws},
          {"rounds", settings.rounds},
          {"trials", settings.trials},
          {"seed", settings.seed}}},
        {"strategies", strategies}};
    add_run(document, run);
    return to_text(document);
}

std::string control_to_csv(const std::vector<ControlRecord>& records) {
    std::string text;
    for (const ControlRecord& record : records) {
        for (const ControlState& state : record.states) {
            const ResultJson row = control_state_json(state);
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
