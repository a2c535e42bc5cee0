// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/station_tour.hpp"

#include <algorithm>
#include <numeric>

namespace taut {

std::vector<int> short_tour(const Eigen::Matrix3Xd& places) {
    std::vector<int> tour(static_cast<size_t>(places.cols()));
    std::iota(tour.begin(), tour.end(), 0);
    const auto distance = [&](int a, int b) { return (places.col(a) - places.col(b)).norm(); };
    for (size_t i = 0; i + 1 < tour.size(); ++i) {
        const auto rest = tour.begin() + static_cast<std::ptrdiff_t>(i) + 1;
        std::iter_swap(rest, std::min_element(rest, tour.end(), [&](int a, int b) {
                           return distance(tour[i], a) < distance(tour[i], b);
                       }));
    }
    const size_t n = tour.size();
    constexpr int most_rounds = 50;
    constexpr double gain = 1e-9;
    bool has_changed = n > 3;
    for (int round = 0; has_changed && round < most_rounds; ++round) {
        has_changed = false;
        for (size_t i = 0; i + 2 < n; ++i) {
            for (size_t j = i + 2; j < n; ++j) {
                const int next = tour[(j + 1) % n];
                const double now = distance(tour[i], tour[i + 1]) + distance(tour[j], next);
                const double turned = distance(tour[i], tour[j]) + distance(tour[i + 1], next);
                if (turned < now - gain) {
                    std::reverse(tour.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                 tour.begin() + static_cast<std::ptrdiff_t>(j) + 1);
                    has_changed = true;
                }
            }
        }
    }
    return tour;
}

}  // namespace taut
