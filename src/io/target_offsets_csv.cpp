// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/target_offsets_csv.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "files/csv_reader.hpp"
#include "files/message.hpp"
#include "files/plain_text.hpp"
#include "taut/files/input_error.hpp"
#include "taut/net/units.hpp"

namespace taut {

std::map<std::string, TargetOffset> parse_target_offsets(std::string_view text,
                                                         const std::string& file_name) {
    CsvReader reader(table_text(text, file_name), file_name);
    std::map<std::string, TargetOffset> offsets;
    size_t columns = 0;
    while (const auto record = reader.next()) {
        const auto& fields = record->fields;
        const auto fail = [&](const std::string& what) {
            throw InputError(file_name, std::to_string(record->line), what);
        };
        if (columns != 0 && fields.size() != columns) {
            fail(fmt::format("has {} fields, expected {} as in the lines before", fields.size(),
                             columns));
        }
        if (fields.size() != 2 && fields.size() != 3) {
            fail(fmt::format("has {} fields, expected target,offset[,std]", fields.size()));
        }
        const bool is_header = columns == 0 && fields[0] == "target" && fields[1] == "offset";
        columns = fields.size();
        if (is_header) {
            continue;
        }
        const auto length = [&](size_t column, const char* name) {
            try {
                return parse_length(fields[column]);
            } catch (const std::invalid_argument&) {
                fail(
                    fmt::format("{} is {}, expected a length as 3mm", name, quote(fields[column])));
            }
            return 0.0;
        };
        const TargetOffset offset{.offset = length(1, "offset"),
                                  .std = fields.size() == 3 ? length(2, "std") : 0.0};
        try {
            check_target_offset(offset);
        } catch (const std::invalid_argument& error) {
            fail(error.what());
        }
        if (!offsets.emplace(fields[0], offset).second) {
            fail(fmt::format("tells the offset of {} a second time", quote(fields[0])));
        }
    }
    if (offsets.empty()) {
        throw InputError(file_name, "", "holds no offset, expected lines target,offset[,std]");
    }
    return offsets;
}

}  // namespace taut
