// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "io/target_list.hpp"

#include <fmt/core.h>

#include "files/csv_reader.hpp"
#include "files/plain_text.hpp"
#include "taut/files/input_error.hpp"

namespace taut {

std::optional<std::vector<PlannedTarget>> parse_target_list(std::string_view text,
                                                            const std::string& file_name) {
    CsvReader reader(table_text(text, file_name), file_name);
    std::vector<PlannedTarget> targets;
    while (auto record = reader.next()) {
        if (record->fields.size() != 1) {
            if (targets.empty()) {
                return std::nullopt;
            }
            throw InputError(file_name, std::to_string(record->line),
                             fmt::format("has {} fields, expected the name of a node alone, as in "
                                         "the lines before",
                                         record->fields.size()));
        }
        targets.push_back({.id = std::move(record->fields[0]), .line = record->line});
    }
    if (targets.empty()) {
        throw InputError(file_name, "", "names no node, expected one a line, or a survey");
    }
    return targets;
}

}  // namespace taut
