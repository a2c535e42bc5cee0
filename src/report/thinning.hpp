// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

namespace taut::report {

/// Every n-th of many things, so that a drawing stays small: 0, n, 2 n, ...
struct Thinning {
    int count = 0;
    int step = 1;

    [[nodiscard]] bool thins() const { return step > 1; }
};

/// The smallest step that leaves at most `limit`, at least 1, of `count` things.
[[nodiscard]] constexpr Thinning thin_to(int count, int limit) {
    return {.count = count, .step = count > limit ? (count + limit - 1) / limit : 1};
}

}  // namespace taut::report
