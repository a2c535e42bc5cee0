// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/number_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace taut::report {
namespace {

std::string with_minus(const std::string& text) {
    return text.starts_with('-') ? "−" + text.substr(1) : text;
}

std::string superscript(int exponent) {
    constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "⁻" : "";
    for (const char digit : fmt::format("{}", std::abs(exponent))) {
        text += digits[digit - '0'];
    }
    return text;
}

}  // namespace

std::string number_text(double value) {
    if (!std::isfinite(value)) {
        return "–";
    }
    if (value == 0.0) {
        return "0";
    }
    // Rounded first: 9.996 has two digits before the point.
    const std::string rounded = fmt::format("{:.2e}", value);
    const std::size_t e = rounded.find('e');
    const int exponent = std::stoi(rounded.substr(e + 1));
    if (exponent < -3 || exponent > 5) {
        return with_minus(rounded.substr(0, e)) + "×10" + superscript(exponent);
    }
    return with_minus(fmt::format("{:.{}f}", value, std::max(0, 2 - exponent)));
}

std::string short_number(double value) {
    const std::string text = number_text(value);
    const std::size_t times = std::min(text.find("×"), text.size());
    std::string mantissa = text.substr(0, times);
    if (mantissa.find('.') != std::string::npos) {
        mantissa.erase(mantissa.find_last_not_of('0') + 1);
        mantissa.erase(mantissa.find_last_not_of('.') + 1);
    }
    return mantissa + text.substr(times);
}

std::string millimetres(double metres) {
    return number_text(1e3 * metres);
}

std::string percent(double part) {
    return number_text(1e2 * part);
}

std::string counted(int count, const std::string& noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace taut::report
