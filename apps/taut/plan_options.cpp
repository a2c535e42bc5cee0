// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "plan_options.hpp"

#include "command.hpp"
#include "taut/net/units.hpp"

namespace taut::app {

void add_turn_options(CLI::App& command, std::optional<TurnSize>& turn,
                      const std::string& step_help) {
    add_parsed(
        command, "--turn", turn,
        [](const std::string& text) { return TurnSize{.pitch = parse_length(text)}; },
        "Change of length by one turn, such as 5mm");
    // Read after --turn, which was added before it.
    command
        .add_option_function<std::string>(
            "--step",
            [&turn](const std::string& text) {
                if (turn) {
                    turn->smallest = parse_part_of_turn(text);
                }
            },
            step_help)
        ->needs("--turn");
}

}  // namespace taut::app
