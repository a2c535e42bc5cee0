// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "words.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace taut::python {
namespace {

/// Options whose argument has another name, and commands, which have none. The longer ones first.
constexpr std::pair<std::string_view, std::string_view> other_words[] = {
    {"--noise estimate", "estimate_noise=True"},
    {"--epoch", "epochs"},
    {"--unknown", "unknowns"},
    {"--forces", "readings"},
    {"--names", "Survey.to_dataframe()"},
    {"taut import ", ""},
    {"taut sample ", ""},
};

bool is_letter(char c) {
    return c >= 'a' && c <= 'z';
}

/// Whether an option begins here; "--xml" is one of gama-local.
bool is_option(std::string_view text) {
    return text.size() > 2 && text.starts_with("--") && is_letter(text[2]) &&
           !text.starts_with("--xml");
}

}  // namespace

std::string in_python(std::string_view message) {
    std::string result;
    while (!message.empty()) {
        const auto* const other =
            std::find_if(std::begin(other_words), std::end(other_words),
                         [message](const auto& pair) { return message.starts_with(pair.first); });
        if (other != std::end(other_words)) {
            result += other->second;
            message.remove_prefix(other->first.size());
        } else if (is_option(message)) {
            message.remove_prefix(2);
            while (!message.empty() && (is_letter(message[0]) || message[0] == '-')) {
                result += message[0] == '-' ? '_' : message[0];
                message.remove_prefix(1);
            }
        } else {
            result += message[0];
            message.remove_prefix(1);
        }
    }
    return result;
}

std::vector<std::string> in_python(const std::vector<std::string>& messages) {
    std::vector<std::string> result;
    std::transform(messages.begin(), messages.end(), std::back_inserter(result),
                   [](const std::string& message) { return in_python(message); });
    return result;
}

}  // namespace taut::python
