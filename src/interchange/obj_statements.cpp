// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/obj_statements.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

#include "files/message.hpp"
#include "files/parse_number.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

/// What says nothing of nodes and edges.
constexpr std::array<std::string_view, 7> ignored{"vn", "vt", "vp", "s", "mtllib", "usemtl", "o"};
constexpr std::array<std::string_view, 5> known{"v", "l", "f", "g", "p"};

/// More than any net has, and more would take memory for nothing.
constexpr int most_statement_lines = 4'000'000;
constexpr size_t most_arguments = 100'000;

}  // namespace

void ObjStatement::fail(const std::string& what) const {
    throw InputError(file_name, std::to_string(line), what);
}

Eigen::Vector3d ObjStatement::position() const {
    if (arguments.size() < 3) {
        fail(fmt::format("has {} coordinates, expected 3", arguments.size()));
    }
    Eigen::Vector3d result;
    for (size_t k = 0; k < 3; ++k) {
        const auto number = parse_number(arguments[k]);
        if (!number) {
            fail(fmt::format("{} is {}, expected a finite number", "xyz"[k], quote(arguments[k])));
        }
        result(static_cast<Eigen::Index>(k)) = *number;
    }
    return result;
}

int ObjStatement::vertex(const std::string& argument, int count) const {
    int number = 0;
    const std::string text = argument.substr(0, argument.find('/'));
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number == 0 || number > count ||
        number < -count) {
        fail(fmt::format("names the vertex {}, expected 1 to {}, or -1 to -{} from the end",
                         quote(argument), count, count));
    }
    return number > 0 ? number - 1 : count + number;
}

void for_each_obj_statement(std::string_view text, const std::string& file_name,
                            const std::function<void(const ObjStatement&)>& take) {
    ObjStatement statement{.file_name = file_name, .line = 0, .keyword = "", .arguments = {}};
    while (!text.empty()) {
        const size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (++statement.line > most_statement_lines) {
            throw InputError(file_name, "",
                             fmt::format("has more than {} lines", most_statement_lines));
        }
        std::istringstream words{std::string(line.substr(0, line.find('#')))};
        if (!(words >> statement.keyword) ||
            std::ranges::find(ignored, statement.keyword) != ignored.end()) {
            continue;
        }
        if (std::ranges::find(known, statement.keyword) == known.end()) {
            statement.fail(fmt::format("starts with {}, expected v, l, f or another keyword of OBJ",
                                       quote(statement.keyword)));
        }
        statement.arguments.clear();
        for (std::string word; words >> word;) {
            if (statement.arguments.size() == most_arguments) {
                statement.fail(fmt::format("has more than {} words", most_arguments));
            }
            statement.arguments.push_back(word);
        }
        take(statement);
    }
}

}  // namespace taut
