// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/target_offsets_csv.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "files/csv_table.hpp"
#include "files/message.hpp"
#include "taut/net/units.hpp"

namespace taut {

std::map<std::string, TargetOffset> parse_target_offsets(std::string_view text,
                                                         const std::string& file_name) {
    const CsvTable table(text, file_name, {.names = {"target", "offset", "std"}, .optional = 1},
                         "holds no offset");
    std::map<std::string, TargetOffset> offsets;
    for (const CsvRecord& row : table.rows()) {
        const auto length = [&](size_t column) {
            try {
                return parse_length(table.text(row, column));
            } catch (const std::invalid_argument&) {
                table.refuse(row, column, "a length as 3mm");
            }
        };
        const TargetOffset offset{.offset = length(1), .std_dev = table.has(2) ? length(2) : 0.0};
        try {
            check_target_offset(offset);
        } catch (const std::invalid_argument& error) {
            table.fail(row, error.what());
        }
        const std::string& target = table.text(row, 0);
        if (!offsets.emplace(target, offset).second) {
            table.fail(row, fmt::format("gives the offset of {} a second time", quote(target)));
        }
    }
    return offsets;
}

}  // namespace taut
