// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taut {

/// What a column of a table of points can be.
enum class TableColumn { id, running_number, x, y, z, sx, sy, sz, code };

inline constexpr size_t table_column_count = 9;

/// A field of a header: "Rechtswert [mm]".
struct ColumnTitle {
    std::optional<TableColumn> column;  ///< empty for one that is not understood
    std::optional<double> unit;         ///< [m]
};

/// Understands a field of a header, in English or German, in any case, with the unit in brackets or
/// behind a slash.
[[nodiscard]] ColumnTitle parse_column_title(std::string_view field);

/// Where the columns stand in a line.
struct TableLayout {
    std::optional<size_t> id;
    std::optional<size_t> code;
    std::array<size_t, 3> place{};                ///< of x, y, z
    std::optional<std::array<size_t, 3>> spread;  ///< of sx, sy, sz
    size_t count = 0;                             ///< of all columns, with those left out

    /// Fields that a line must have.
    [[nodiscard]] size_t needed() const;
    [[nodiscard]] bool uses(size_t column) const;
    /// "id, x, y, z, -, -", - for one that is left out.
    [[nodiscard]] std::string to_string() const;
};

/// The layout by the names of columns, SurveyFileOptions::columns.
[[nodiscard]] TableLayout layout_of_names(const std::vector<std::string>& names);

}  // namespace taut
