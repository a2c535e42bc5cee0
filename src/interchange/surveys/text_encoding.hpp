// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "taut/interchange/foreign_survey.hpp"

namespace taut {

/// The text of a file as UTF-8, and how it was written.
struct DecodedText {
    std::string text;  ///< UTF-8 without byte order mark and zero bytes
    TextEncoding encoding = TextEncoding::utf_8;
};

/// Decodes by the encoding given, else by the byte order mark, else UTF-16 where every second byte
/// is zero, UTF-8 where the bytes are that, and Latin-1 (as Windows writes it, CP-1252) where not.
/// @throws InputError with the line of a zero byte or of half a character
[[nodiscard]] DecodedText decode_text(std::string_view bytes, const std::string& file_name,
                                      std::optional<TextEncoding> encoding);

}  // namespace taut
