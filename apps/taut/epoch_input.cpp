// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "epoch_input.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "command.hpp"
#include "taut/files/table_file.hpp"
#include "taut/io/adjustment_csv.hpp"
#include "taut/io/turned_csv.hpp"
#include "taut/survey/turned_net.hpp"

namespace taut::app {
namespace {

EpochFiles parse_epoch_files(const std::string& text) {
    if (std::filesystem::exists(text)) {
        return {.survey = text, .turned = {}, .loads = {}};
    }
    EpochFiles files;
    std::string* const parts[] = {&files.survey, &files.turned, &files.loads};
    size_t part = 0;
    for (const char character : text) {
        if (character != ':') {
            parts[part]->push_back(character);
        } else if (++part == std::size(parts)) {
            break;
        }
    }
    if (part == std::size(parts) || files.survey.empty() || (part > 0 && parts[part]->empty())) {
        throw std::invalid_argument(
            fmt::format("--epoch is '{}', expected a survey, and after colons the list of what was "
                        "turned before it and that of loads hung on the net: second.csv, "
                        "second.csv:turned.csv, second.csv::loads.csv",
                        text));
    }
    return files;
}

}  // namespace

void add_epoch_option(CLI::App& command, std::vector<EpochFiles>& epochs) {
    add_each_parsed(command, "--epoch", epochs, parse_epoch_files,
                    "A later survey of the same net and the list of what was turned before it: "
                    "second.csv:turned.csv, or second.csv where nothing was; and of loads that "
                    "hung on it then alone: second.csv::loads.csv. All surveys together determine "
                    "the lengths; the result is of the last without such loads. May be repeated")
        ->allow_extra_args(false)
        ->group(heading::input);
}

std::vector<Epoch> read_epochs(const CableNet& net, const Survey& first,
                               const std::vector<EpochFiles>& later, const SurveyOptions& options,
                               bool with_notes) {
    std::vector<Epoch> epochs{{.survey = first, .turned = {}}};
    std::vector<std::vector<EdgeTurned>> steps;
    for (const EpochFiles& files : later) {
        Epoch epoch;
        if (!files.turned.empty()) {
            epoch.turned = parse_turned(net, read_table(files.turned), files.turned);
        }
        steps.push_back(epoch.turned);
        if (!files.loads.empty()) {
            epoch.loads = parse_loads(net, read_table(files.loads), files.loads);
        }
        SurveyOptions of_epoch = options;
        of_epoch.survey = files.survey;
        epoch.survey =
            read_survey(turned_net(net, all_turned(steps)), files.survey, options.read_options());
        print_survey_notes(of_epoch, epoch.survey, with_notes);
        with_survey_of(files.survey, [&] { check_survey(net, epoch.survey); });
        epochs.push_back(std::move(epoch));
    }
    return epochs;
}

}  // namespace taut::app
