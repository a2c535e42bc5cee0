// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Excel files: as a whole, and by their parts, which the fuzzer would not find behind their
// compression: between lines "--- NAME".

#include <map>

#include "files/xlsx_reader.hpp"
#include "fuzz.hpp"

namespace {

std::map<std::string, std::string> parts_of(std::string_view text) {
    constexpr std::string_view mark = "--- ";
    std::map<std::string, std::string> parts;
    while (text.starts_with(mark)) {
        text.remove_prefix(mark.size());
        const size_t name = std::min(text.find('\n'), text.size());
        const size_t end = std::min(text.find("\n--- ", name), text.size());
        parts[std::string(text.substr(0, name))] = text.substr(name, end - name);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace taut;
    const auto text = fuzz::text_of(data, size);
    const auto check = [](const TableFile& table) {
        fuzz::require(table.text.ends_with('\n') && table.text.find('\r') == std::string::npos);
    };
    fuzz::refuse_or_read([&] { check(read_xlsx(text, "survey.xlsx")); });
    fuzz::refuse_or_read([&] {
        const auto parts = parts_of(text);
        check(read_xlsx(
            [&](const std::string& name) {
                const auto found = parts.find(name);
                return found == parts.end() ? std::nullopt : std::optional(found->second);
            },
            "survey.xlsx"));
    });
    return 0;
}
