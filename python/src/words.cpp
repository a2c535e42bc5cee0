// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "words.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "taut/net/units.hpp"

namespace taut::python {
namespace {

/// Options whose argument has another name or kind, and commands, which have none. The longer ones
/// come first.
constexpr std::pair<std::string_view, std::string_view> other_words[] = {
    {"--supports and a file of their ids", "supports and their keys"},
    {"--supports boundary", "boundary=True"},
    {"--force-unit kN", "force_unit=1000"},
    {"--force-unit N", "force_unit=1"},
    {"--noise estimate", "estimate_noise=True"},
    {"--epoch", "epochs"},
    {"--names", "Survey.to_dataframe()"},
    {"taut import ", ""},
    {"taut sample ", ""},
};

/// Values of options that offer a choice.
constexpr std::array<std::string_view, 16> choices{
    "auto", "net", "supports", "name",  "place", "map", "gp",    "balance",
    "mm",   "cm",  "m",        "us-ft", "ft",    "in",  "utf-8", "none"};

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool is_letter(char c) {
    return c >= 'a' && c <= 'z';
}

/// Whether an option begins here. "--xml" is an option of gama-local.
bool is_option(std::string_view text) {
    return text.size() > 2 && text.starts_with("--") && is_letter(text[2]) &&
           !text.starts_with("--xml");
}

/// Takes the letters and dashes of an option's name, as an identifier.
std::string take_name(std::string_view& text) {
    std::string name;
    while (!text.empty() && (is_letter(text[0]) || text[0] == '-')) {
        name += text[0] == '-' ? '_' : text[0];
        text.remove_prefix(1);
    }
    return name;
}

/// Takes the value behind an option's name, "5mm" of " 5mm, or"; empty where there is none.
std::string_view take_value(std::string_view& text) {
    if (!text.starts_with(' ')) {
        return {};
    }
    std::string_view word = text.substr(1, text.find_first_of(" \n", 1) - 1);
    while (!word.empty() && std::string_view(",.;:)?").find(word.back()) != word.npos) {
        word.remove_suffix(1);
    }
    const bool is_value =
        !word.empty() && (is_digit(word[0]) || word.find_first_of(":,") != word.npos ||
                          std::ranges::find(choices, word) != choices.end());
    if (!is_value) {
        return {};
    }
    text.remove_prefix(1 + word.size());
    return word;
}

/// A length as a number of metres; any other text as it is.
std::string in_metres(std::string_view length) {
    try {
        return fmt::format("{:.6g}", parse_length(length));
    } catch (const std::invalid_argument&) {
        return std::string(length);
    }
}

/// "noise=0.0005", "prior='uniform:5mm'", "uncertain=['supports:3mm']".
std::string argument(const std::string& name, std::string_view value) {
    if (value.empty()) {
        return name;
    }
    if (name == "noise" && value == "estimate") {
        return "estimate_noise=True";
    }
    if (name == "noise") {
        return fmt::format("{}={}", name, in_metres(value));
    }
    if (name == "uncertain") {
        std::string list;
        for (const char c : value) {
            list += c == ' ' ? std::string("', '") : std::string(1, c);
        }
        return fmt::format("{}=['{}']", name, list);
    }
    return fmt::format("{}='{}'", name, value);
}

}  // namespace

std::string of_file_in_python(std::string_view message) {
    const size_t name = message.find(": ");
    return name == message.npos
               ? in_python(message)
               : std::string(message.substr(0, name)) + in_python(message.substr(name));
}

std::string in_python(std::string_view message) {
    std::string result;
    while (!message.empty()) {
        const bool begins_word =
            result.empty() || std::string_view(" (\n").find(result.back()) != std::string::npos;
        const auto* const other =
            std::find_if(std::begin(other_words), std::end(other_words),
                         [message](const auto& pair) { return message.starts_with(pair.first); });
        if (begins_word && other != std::end(other_words)) {
            message.remove_prefix(other->first.size());
            result += other->second;
        } else if (begins_word && is_option(message)) {
            message.remove_prefix(2);
            const std::string name = take_name(message);
            result += argument(name, take_value(message));
        } else {
            result += message[0];
            message.remove_prefix(1);
        }
    }
    return result;
}

std::string advice_in_python(const Trust::Finding& finding) {
    if (!finding.remedy) {
        return in_python(finding.advice);
    }
    const auto& [parameter, value] = *finding.remedy;
    return fmt::format("{} ({}).", finding.advice.substr(0, finding.advice.size() - 1),
                       argument(parameter, value));
}

std::vector<std::string> in_python(const std::vector<std::string>& messages) {
    std::vector<std::string> result;
    std::transform(messages.begin(), messages.end(), std::back_inserter(result),
                   [](const std::string& message) { return in_python(message); });
    return result;
}

}  // namespace taut::python
