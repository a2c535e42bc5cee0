// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace taut::report {

// Numbers as the page shows them: a true minus sign, and a dash for what is not finite.

/// Three significant digits, at least to the last digit before the point: "0.0123", "4.56", "1234",
/// "1.70×10⁻⁸".
[[nodiscard]] std::string number_text(double value);

/// The same without zeros at the end of a fraction, for what is set or was published: "1.7×10⁻⁸".
[[nodiscard]] std::string short_number(double value);

/// A length in millimetres, without the unit. @param metres [m]
[[nodiscard]] std::string millimetres(double metres);

/// A part of one in per cent, without the sign.
[[nodiscard]] std::string percent(double part);

/// A count with its noun: "1 edge", "536 edges".
[[nodiscard]] std::string counted(int count, const std::string& noun);

}  // namespace taut::report
