// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "numerics/front.hpp"

namespace taut {

/// Adds a child's update to some columns of its parent's front, below the diagonal.
/// @param update of the child, by columns: its lower triangle
/// @param places in the parent's front of the rows of the child, ascending
/// @param corner of the columns in the parent's front: place of the first row and column
void extend_add(const double* update, const std::vector<int>& places, Eigen::Index corner,
                FrontMatrix& columns, Parts parts);

/// The reverse of extend_add(): copies the entries of a parent's matrix at the rows of a child into
/// the last rows and columns of a matrix, both triangles.
void take_rows(const FrontMatrix& parent, const std::vector<int>& places, FrontMatrix& child,
               Parts parts);

}  // namespace taut
