// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/json_parse.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "files/message.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

using nlohmann::json;

/// The destructor of a value, and whoever walks it, goes as deep as the value does.
constexpr size_t deepest = 64;

/// Memory that a value takes, however short its text: 16 bytes and the growth of its list; more for
/// an entry of an object, a node of a tree; more for a list or an object. A net of 10^6 nodes takes
/// some 0.6 GB.
constexpr size_t bytes_of_value = 24;
constexpr size_t bytes_of_member = 96;
constexpr size_t bytes_of_container = 64;
constexpr size_t most_bytes = 1'500'000'000;

std::string line_and_column(std::string_view text, size_t offset) {
    const std::string_view before = text.substr(0, offset);
    const size_t line_start = before.rfind('\n') + 1;  // 0 where there is none
    return fmt::format("{}:{}", 1 + std::ranges::count(before, '\n'), 1 + offset - line_start);
}

/// The reason out of the parser's message: "[json.exception.parse_error.101] parse error at line 1,
/// column 2: <reason>; last read: '<all of the last token>'; expected <token>".
std::string reason_of(std::string_view message) {
    const size_t column = message.find("column ");
    const size_t start = message.find(": ", column == std::string_view::npos ? 0 : column);
    if (start != std::string_view::npos) {
        message.remove_prefix(start + 2);
    }
    const size_t expected = message.rfind("; expected ");
    const size_t last_read = message.find("; last read: ");
    std::string reason(message.substr(0, std::min(expected, last_read)));
    if (expected != std::string_view::npos) {
        reason += message.substr(expected);
    }
    return reason;
}

/// Builds the value out of the parser's events, refusing what the parser itself lets pass.
class Builder : public nlohmann::json_sax<json> {
public:
    Builder(std::string_view text, const std::string& file_name)
        : m_text(text), m_file_name(file_name) {}
    ~Builder() override = default;
    // The open levels point into the root.
    Builder(const Builder&) = delete;
    Builder& operator=(const Builder&) = delete;
    Builder(Builder&&) = delete;
    Builder& operator=(Builder&&) = delete;

    json take() { return std::move(m_root); }

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t& /*text*/) override {
        return add(value);
    }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t& /*value*/) override { return false; }

    bool start_object(std::size_t /*size*/) override { return open(json::object()); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t /*size*/) override { return open(json::array()); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        m_levels.back().key = name;
        if (m_levels.back().value->contains(name)) {
            fail(fmt::format("the key {} comes twice", quote(name)));
        }
        return true;
    }

    bool parse_error(std::size_t position, const std::string& last_token,
                     const nlohmann::detail::exception& error) override {
        constexpr int number_overflow = 406;
        if (error.id == number_overflow) {
            fail(fmt::format("the number {} is too large for a double", quote(last_token)));
        }
        throw InputError(m_file_name,
                         line_and_column(m_text, std::min(position - 1, m_text.size())),
                         "is no JSON: " + reason_of(error.what()));
    }

private:
    struct Level {
        json* value;      ///< an array or object that is not closed yet
        std::string key;  ///< of the member that is being read, if an object
    };

    /// The value that is being read.
    [[nodiscard]] std::string pointer() const {
        json::json_pointer pointer;
        for (const Level& level : m_levels) {
            if (level.value->is_object()) {
                pointer /= level.key;
            } else {
                // An array or object in an array is in its place while it is being read.
                const bool holds_next = &level != &m_levels.back();
                pointer /= level.value->size() - (holds_next ? 1 : 0);
            }
        }
        return pointer.to_string();
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(m_file_name, pointer(), what);
    }

    template <typename Value>
    bool add(Value&& value) {
        place(std::forward<Value>(value));
        return true;
    }

    json& place(json value) {
        const bool is_member = !m_levels.empty() && m_levels.back().value->is_object();
        m_bytes += is_member ? bytes_of_member : bytes_of_value;
        m_bytes += value.is_structured() ? bytes_of_container : 0;
        if (m_bytes > most_bytes) {
            throw InputError(m_file_name, "",
                             fmt::format("holds so many values that they take more than {} GB of "
                                         "memory",
                                         1e-9 * static_cast<double>(most_bytes)));
        }
        if (m_levels.empty()) {
            m_root = std::move(value);
            return m_root;
        }
        json& parent = *m_levels.back().value;
        if (parent.is_array()) {
            parent.push_back(std::move(value));
            return parent.back();
        }
        return parent[m_levels.back().key] = std::move(value);
    }

    bool open(json value) {
        if (m_levels.size() == deepest) {
            fail(fmt::format("is nested deeper than {} levels", deepest));
        }
        m_levels.push_back({.value = &place(std::move(value)), .key = {}});
        return true;
    }

    bool close() {
        m_levels.pop_back();
        return true;
    }

    std::string_view m_text;
    const std::string& m_file_name;
    json m_root;
    size_t m_bytes = 0;  ///< of all values yet
    std::vector<Level> m_levels;
};

}  // namespace

json parse_json(std::string_view text, const std::string& file_name) {
    if (text.empty()) {
        throw InputError(file_name, "", "is empty, expected JSON");
    }
    if (text.starts_with("\x89HDF")) {
        throw InputError(file_name, "", "is an HDF5 file, expected JSON");
    }
    // The parser takes a zero byte for the end, and would not see what follows.
    if (const size_t zero = text.find('\0'); zero != std::string_view::npos) {
        throw InputError(file_name, line_and_column(text, zero), "is a zero byte, expected text");
    }
    Builder builder(text, file_name);
    json::sax_parse(text.begin(), text.end(), &builder);
    return builder.take();
}

}  // namespace taut
