// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/surveys/text_encoding.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "files/plain_text.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

constexpr std::string_view mark_of_utf_8 = "\xEF\xBB\xBF";

unsigned char byte_at(std::string_view bytes, size_t i) {
    return static_cast<unsigned char>(bytes[i]);
}

void append_utf_8(std::string& text, std::uint32_t code) {
    const auto put = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0 | (code >> 6));
        put(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        put(0xE0 | (code >> 12));
        put(0x80 | ((code >> 6) & 0x3F));
        put(0x80 | (code & 0x3F));
    } else {
        put(0xF0 | (code >> 18));
        put(0x80 | ((code >> 12) & 0x3F));
        put(0x80 | ((code >> 6) & 0x3F));
        put(0x80 | (code & 0x3F));
    }
}

/// Whether all bytes are UTF-8: each lead byte followed by as many others as it says.
bool is_utf_8(std::string_view bytes) {
    for (size_t i = 0; i < bytes.size(); ++i) {
        const unsigned char lead = byte_at(bytes, i);
        const size_t behind = lead < 0x80                   ? 0
                              : lead >= 0xC2 && lead < 0xE0 ? 1
                              : lead >= 0xE0 && lead < 0xF0 ? 2
                              : lead >= 0xF0 && lead < 0xF5 ? 3
                                                            : bytes.size();
        if (i + behind >= bytes.size()) {
            return false;
        }
        for (const size_t last = i + behind; i < last; ++i) {
            if ((byte_at(bytes, i + 1) & 0xC0) != 0x80) {
                return false;
            }
        }
    }
    return true;
}

/// @param low index of the low byte in each pair: 0 for little endian
std::string from_utf_16(std::string_view bytes, size_t low, const std::string& file_name) {
    std::string text;
    text.reserve(bytes.size() / 2);
    const auto fail = [&] {
        throw InputError(file_name, std::to_string(1 + std::ranges::count(text, '\n')),
                         "holds half a character of UTF-16: is the file whole?");
    };
    if (bytes.size() % 2 != 0) {
        fail();
    }
    const auto unit = [&](size_t i) -> std::uint32_t {
        return byte_at(bytes, i + low) | (byte_at(bytes, i + 1 - low) << 8);
    };
    for (size_t i = 0; i < bytes.size(); i += 2) {
        std::uint32_t code = unit(i);
        if (code >= 0xD800 && code < 0xE000) {
            i += 2;
            const std::uint32_t second = code < 0xDC00 && i < bytes.size() ? unit(i) : 0;
            if (second < 0xDC00 || second >= 0xE000) {
                fail();
            }
            code = 0x10000 + ((code - 0xD800) << 10) + (second - 0xDC00);
        }
        append_utf_8(text, code);
    }
    return text;
}

std::string from_latin_1(std::string_view bytes) {
    // What CP-1252 has where Latin-1 has control characters.
    constexpr std::array<std::uint16_t, 32> windows{
        0x20AC, 0x81,   0x201A, 0x192,  0x201E, 0x2026, 0x2020, 0x2021, 0x2C6,  0x2030, 0x160,
        0x2039, 0x152,  0x8D,   0x17D,  0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
        0x2013, 0x2014, 0x2DC,  0x2122, 0x161,  0x203A, 0x153,  0x9D,   0x17E,  0x178};
    std::string text;
    text.reserve(bytes.size());
    for (size_t i = 0; i < bytes.size(); ++i) {
        const unsigned char byte = byte_at(bytes, i);
        append_utf_8(text, byte >= 0x80 && byte < 0xA0 ? windows[byte - 0x80] : byte);
    }
    return text;
}

/// Whether letters of UTF-16 without a byte order mark stand there: in the first pairs, one and the
/// same of both bytes is zero, mostly.
std::optional<size_t> low_byte_of_utf_16(std::string_view bytes) {
    constexpr size_t looked_at = 200;
    std::array<size_t, 2> zeros{};
    const size_t count = std::min(bytes.size() / 2 * 2, looked_at);
    for (size_t i = 0; i < count; ++i) {
        zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
    }
    for (const size_t low : {0U, 1U}) {
        if (zeros[low] == 0 && 4 * zeros[1 - low] > count && zeros[1 - low] > 0) {
            return low;
        }
    }
    return std::nullopt;
}

}  // namespace

DecodedText decode_text(std::string_view bytes, const std::string& file_name,
                        std::optional<TextEncoding> encoding) {
    constexpr std::string_view little = "\xFF\xFE";
    constexpr std::string_view big = "\xFE\xFF";
    const bool has_mark = bytes.starts_with(little) || bytes.starts_with(big);
    std::optional<size_t> low;
    if (!encoding || *encoding == TextEncoding::utf_16) {
        low = has_mark ? std::optional<size_t>(bytes.starts_with(little) ? 0 : 1)
                       : low_byte_of_utf_16(bytes);
        if (!low && encoding) {
            low = 0;
        }
    }
    DecodedText result;
    if (low) {
        result = {.text = from_utf_16(bytes.substr(has_mark ? 2 : 0), *low, file_name),
                  .encoding = TextEncoding::utf_16};
    } else if (encoding ? *encoding == TextEncoding::utf_8 : is_utf_8(bytes)) {
        result = {.text = std::string(bytes), .encoding = TextEncoding::utf_8};
        if (!is_utf_8(bytes)) {
            throw InputError(file_name, "",
                             "holds bytes that are no UTF-8, which is the given encoding");
        }
    } else {
        result = {.text = from_latin_1(bytes), .encoding = TextEncoding::latin_1};
    }
    if (result.text.starts_with(mark_of_utf_8)) {
        result.text.erase(0, mark_of_utf_8.size());
    }
    static_cast<void>(plain_text(result.text, file_name));
    return result;
}

}  // namespace taut
