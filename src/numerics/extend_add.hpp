// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "numerics/front.hpp"

namespace taut {

/// Adds to a front what a child's update has in some of its columns, below the diagonal.
///
/// @param update of the child, by columns: its lower triangle
/// @param places in the parent's front of the rows of the child, ascending
/// @param corner of the columns in the parent's front: place of the first row and column
void extend_add(const double* update, const std::vector<int>& places, Eigen::Index corner,
                FrontMatrix& columns, Parts parts);

/// The same read the other way: what a parent's matrix has at the rows of a child, into the last
/// rows and columns of a matrix, both triangles.
void take_rows(const FrontMatrix& parent, const std::vector<int>& places, FrontMatrix& child,
               Parts parts);

}  // namespace taut
