// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/settling_files.hpp"

#include <algorithm>

#include "files/csv_field.hpp"
#include "results/result_parts.hpp"
#include "taut/version.hpp"

namespace taut {
namespace {

ResultJson outcome_json(const SettlingOutcome& outcome, const SettlingSettings& settings) {
    return {{"seed", settings.seed},
            {"survey", outcome.number},
            {"prior", outcome.prior.to_string()},
            {"noise", outcome.noise_std},
            {"hidden_nodes", outcome.hidden_nodes},
            {"gross_errors", outcome.gross_errors},
            {"slack_edges", outcome.slack_edges},
            {"settled", outcome.settled},
            {"seconds", outcome.seconds},
            {"inside", outcome.inside},
            {"tensions_told", outcome.tensions_told},
            {"tensions_inside", outcome.tensions_inside},
            {"called_slack", outcome.slack_called},
            {"called_slack_but_taut", outcome.taut_as_slack},
            {"called_taut_but_slack", outcome.slack_as_taut},
            {"message", outcome.message}};
}

ResultJson reliability_json(const SlackReliability& reliability) {
    ResultJson bins = ResultJson::array();
    for (const SlackReliability::Bin& bin : reliability.bins()) {
        bins.push_back({{"above", std::max(0.0, bin.above)},
                        {"up_to", bin.up_to},
                        {"edges", bin.edges},
                        {"slack", bin.slack},
                        {"told", bin.edges > 0 ? ResultJson(bin.told / bin.edges) : ResultJson()}});
    }
    return bins;
}

ResultJson record_json(const SettlingRecord& record, const SettlingSettings& settings) {
    ResultJson surveys = ResultJson::array();
    for (const SettlingOutcome& outcome : record.outcomes) {
        const ResultJson survey = outcome_json(outcome, settings);
        surveys.push_back(survey);
    }
    return {{"net", record.net},
            {"free_nodes", record.free_nodes},
            {"interior_edges", record.interior_edges},
            {"settled", record.settled()},
            {"median_seconds", record.median_seconds()},
            {"largest_seconds", record.largest_seconds()},
            {"coverage", record.settled() > 0 ? ResultJson(record.coverage()) : ResultJson()},
            {"slack_reliability", reliability_json(record.slack_reliability())},
            {"surveys", surveys}};
}

}  // namespace

std::string settling_to_json(const std::vector<SettlingRecord>& records,
                             const SettlingSettings& settings, const RunRecord& run) {
    ResultJson document{{"format", "taut-trials"},
                        {"version", 2},
                        {"program", "taut " + std::string(version())},
                        {"seed", settings.seed},
                        {"first", settings.first},
                        {"surveys", settings.surveys}};
    add_run(document, run);
    document["nets"] = ResultJson::array();
    for (const SettlingRecord& record : records) {
        document["nets"].push_back(record_json(record, settings));
    }
    return to_text(document);
}

std::string settling_to_csv(const std::vector<SettlingRecord>& records,
                            const SettlingSettings& settings) {
    std::string csv;
    for (const SettlingRecord& record : records) {
        const ResultJson document = record_json(record, settings);
        for (const ResultJson& survey : document["surveys"]) {
            std::string head = "net";
            std::string row = csv_field(record.net);
            for (const auto& [key, value] : survey.items()) {
                head += ',' + key;
                row += ',';
                row += value.is_string() ? csv_field(value.get<std::string>()) : value.dump();
            }
            if (csv.empty()) {
                csv = head + '\n';
            }
            csv += row + '\n';
        }
    }
    return csv;
}

}  // namespace taut
