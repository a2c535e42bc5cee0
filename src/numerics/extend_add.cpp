// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/extend_add.hpp"

#include <algorithm>

namespace taut {
namespace {

/// Rows that are contiguous in a child's matrix and in its parent's.
struct Run {
    Eigen::Index begin = 0;  ///< in the child's
    Eigen::Index end = 0;
    Eigen::Index place = 0;  ///< of the first, in the parent's
};

std::vector<Run> runs_of(const std::vector<int>& places) {
    std::vector<Run> runs;
    for (Eigen::Index k = 0; k < std::ssize(places); ++k) {
        if (k == 0 || places[k] != places[k - 1] + 1) {
            runs.push_back({.begin = k, .end = k, .place = places[k]});
        }
        ++runs.back().end;
    }
    return runs;
}

}  // namespace

void extend_add(const double* update, const std::vector<int>& places, Eigen::Index corner,
                FrontMatrix& columns, Parts parts) {
    const auto q = std::ssize(places);
    const auto column_of = [&](Eigen::Index place) {
        return std::ranges::lower_bound(places, place) - places.begin();
    };
    const std::vector<Run> runs = runs_of(places);
    by_parts(parts, column_of(corner), column_of(corner + columns.cols()),
             [&](Eigen::Index from, Eigen::Index count) {
                 auto first = std::ranges::upper_bound(runs, from, {}, &Run::begin) - 1;
                 for (Eigen::Index b = from; b < from + count; ++b) {
                     first += b == first->end ? 1 : 0;
                     const double* const source = update + b * q;
                     double* const target = columns.col(places[b] - corner).data() - corner;
                     for (auto run = first; run != runs.end(); ++run) {
                         const Eigen::Index begin = std::max(b, run->begin);
                         double* const at = target + run->place - run->begin;
                         for (Eigen::Index a = begin; a < run->end; ++a) {
                             at[a] += source[a];
                         }
                     }
                 }
             });
}

void take_rows(const FrontMatrix& parent, const std::vector<int>& places, FrontMatrix& child,
               Parts parts) {
    const auto q = std::ssize(places);
    const Eigen::Index p = child.rows() - q;
    const std::vector<Run> runs = runs_of(places);
    by_parts(parts, 0, q, [&](Eigen::Index from, Eigen::Index count) {
        for (Eigen::Index b = from; b < from + count; ++b) {
            const double* const source = parent.col(places[b]).data();
            double* const target = child.col(p + b).data() + p;
            for (const Run& run : runs) {
                std::copy_n(source + run.place, run.end - run.begin, target + run.begin);
            }
        }
    });
}

}  // namespace taut
